/* SPDX-License-Identifier: MIT */
/* One variant with the stepper: systems that do not fit the lanes, steps that do not converge there. */
#include "batch/batch.h"

/* One run; next_sample counts what the sink has. */
typedef struct solo {
    trk_batch_worker *worker;
    int32_t variant;
    trk_newmark *stepper;
    int64_t next_sample, waiting; /* waiting: samples in the block of values */
} solo;

static void record(solo *r)
{
    const trk_batch_worker *worker = r->worker;
    const trk_batch *batch = worker->batch;
    trk_newmark_read_sensors(r->stepper, worker->row);
    for (int32_t k = 0; k < batch->sensors; k++)
        worker->values[(int64_t)k * TRK_LANES_BLOCK + r->waiting] = worker->row[batch->sensor[k]];
    r->waiting++;
}

/* Hand over what waits, closed up to the length it has. */
static bool flush(solo *r)
{
    const trk_batch *batch = r->worker->batch;
    double *values = r->worker->values;
    if (r->waiting == 0)
        return true;
    for (int64_t k = 1; k < batch->sensors && r->waiting < TRK_LANES_BLOCK; k++)
        for (int64_t j = 0; j < r->waiting; j++)
            values[k * r->waiting + j] = values[k * TRK_LANES_BLOCK + j];
    if (batch->sink(batch->sink_user, r->variant, r->next_sample, r->waiting, values)) {
        trk_batch_end_by_sink(r->worker, r->variant, r->next_sample);
        return false;
    }
    r->next_sample += r->waiting;
    r->waiting = 0;
    return true;
}

static trk_status advance(solo *r, int64_t first, int64_t count)
{
    const trk_batch_worker *worker = r->worker;
    const trk_batch *batch = worker->batch;
    const trk_excitation *excitation = batch->excitations[r->variant];
    int32_t roads = trk_excitation_roads(excitation), ports = trk_excitation_ports(excitation);
    trk_batch_drive(worker, excitation, first, count);
    for (int64_t k = 0; k < count; k++) {
        trk_status status =
            trk_newmark_step(r->stepper, worker->height + k * roads, worker->velocity + k * roads,
                             worker->load + k * ports);
        if (status != TRK_OK)
            return status;
        if ((first + k + 1) % batch->options.record_every == 0)
            record(r);
    }
    return TRK_OK;
}

/* Ends the variant itself if it does not go through. */
static void go(solo *r, int64_t first)
{
    trk_batch *batch = r->worker->batch;
    for (int64_t done = first; done < batch->steps; done += TRK_LANES_BLOCK) {
        int64_t left = batch->steps - done, count = left < TRK_LANES_BLOCK ? left : TRK_LANES_BLOCK;
        trk_status status = advance(r, done, count);
        if (!flush(r)) /* what was recorded in front of a failure is good */
            return;
        if (status != TRK_OK) {
            trk_batch_end(r->worker, r->variant, status,
                          trk_context_message(r->worker->arena.context));
            return;
        }
        if (!trk_batch_account(r->worker, count) && done + count < batch->steps) {
            trk_batch_end(r->worker, r->variant, TRK_E_CANCELLED, "cancelled by the caller");
            return;
        }
    }
    batch->status[r->variant] = TRK_OK;
}

static trk_status start(solo *r, trk_batch_origin origin)
{
    trk_batch_worker *worker = r->worker;
    const trk_batch *batch = worker->batch;
    trk_status status = trk_newmark_create(worker->arena.context, batch->models[r->variant],
                                           &batch->newmark, &r->stepper);
    if (status != TRK_OK)
        return status;
    trk_batch_drive(worker, batch->excitations[r->variant], origin.step - 1, 1);
    double time = batch->options.start + (double)origin.step * batch->newmark.step;
    return trk_newmark_set_state(r->stepper, time, origin.q, origin.v, worker->height,
                                 worker->velocity, worker->load);
}

void trk_batch_run_alone(trk_batch_worker *worker, int32_t variant, trk_batch_origin origin)
{
    solo r = {.worker = worker, .variant = variant};
    if (origin.q)
        r.next_sample = origin.step / worker->batch->options.record_every + 1;
    trk_status status = trk_arena_enter(&worker->arena);
    if (status == TRK_OK)
        status = start(&r, origin);
    if (status == TRK_OK && !origin.q)
        record(&r);
    if (status != TRK_OK)
        trk_batch_end(worker, variant, status, trk_context_message(worker->arena.context));
    else if (flush(&r))
        go(&r, origin.step);
    trk_newmark_destroy(r.stepper);
    trk_arena_leave(&worker->arena);
}
