/* SPDX-License-Identifier: MIT */
/* A group of variants through time, a block of steps after the other. */
#include "batch/batch.h"

#include <string.h>

/* A variant's way through a group. */
typedef struct passenger {
    int32_t variant;
    bool rides;   /* in its lane                             */
    bool leaves;  /* the stepper takes it                    */
    bool started; /* it goes on from `step`                  */
    int64_t step;
} passenger;

typedef struct group {
    trk_batch_worker *worker;
    trk_lanes *lanes;
    int32_t count; /* passengers; the other lanes repeat one */
    passenger passenger[TRK_LANES_WIDEST];
} group;

/* Put numbers of one variant into its lane. */
static void spread(const trk_lanes *s, int64_t count, const double *from, int32_t lane, double *to)
{
    for (int64_t k = 0; k < count; k++)
        to[k * s->width + lane] = from[k];
}

static bool any_load(const trk_batch_worker *worker, int64_t count)
{
    bool any = false;
    for (int64_t k = 0; k < count; k++)
        any = any || worker->load[k] != 0;
    return any;
}

static const trk_excitation *excitation_of(const group *g, int32_t lane)
{
    int32_t k = lane < g->count ? lane : 0;
    return g->worker->batch->excitations[g->passenger[k].variant];
}

/* Road and loads of a block; an excitation that all share is evaluated once. */
static void drive(group *g, int64_t first, int64_t count)
{
    const trk_batch_worker *worker = g->worker;
    trk_lanes *s = g->lanes;
    double *height = s->by_lane, *velocity = height + TRK_LANES_BLOCK * s->roads * s->width,
           *load = velocity + TRK_LANES_BLOCK * s->roads * s->width;
    s->shared = true;
    for (int32_t l = 1; l < g->count; l++)
        s->shared = s->shared && excitation_of(g, l) == excitation_of(g, 0);
    s->height = s->shared ? worker->height : height;
    s->velocity = s->shared ? worker->velocity : velocity;
    s->load = s->shared ? worker->load : load;
    s->loaded = false;
    for (int32_t l = 0; l < (s->shared ? 1 : s->width); l++) {
        if (l == 0 || excitation_of(g, l) != excitation_of(g, l - 1)) {
            trk_batch_drive(worker, excitation_of(g, l), first, count);
            s->loaded = s->loaded || any_load(worker, count * s->ports);
        }
        if (s->shared)
            break;
        spread(s, count * s->roads, worker->height, l, height);
        spread(s, count * s->roads, worker->velocity, l, velocity);
        spread(s, count * s->ports, worker->load, l, load);
    }
}

/* Hand recorded samples of a lane to the sink, closed up to the length they have. */
static void flush(group *g, int32_t lane, int64_t first)
{
    const trk_batch *batch = g->worker->batch;
    const trk_lanes *s = g->lanes;
    double *values = s->recorded + (int64_t)lane * s->sensors * TRK_LANES_BLOCK;
    if (s->samples == 0)
        return;
    for (int32_t j = 1; j < s->sensors && s->samples < TRK_LANES_BLOCK; j++)
        memmove(values + j * s->samples, values + (int64_t)j * TRK_LANES_BLOCK,
                (size_t)s->samples * sizeof *values);
    passenger *p = &g->passenger[lane];
    if (batch->sink(batch->sink_user, p->variant, first, s->samples, values)) {
        trk_batch_end_by_sink(g->worker, p->variant, first);
        p->rides = false;
    }
}

static bool is_finite(const trk_lanes *s, int32_t lane)
{
    double sum = 0;
    for (int32_t i = 0; i < s->n; i++) {
        int32_t k = i * s->width + lane;
        sum += 0 * s->x[k] + 0 * s->v[k] + 0 * s->a[k];
    }
    return sum == 0;
}

/* Lanes that did not come through the block leave; nothing of it has reached their sinks. */
static void settle(group *g, int64_t step, int64_t first_sample)
{
    const trk_lanes *s = g->lanes;
    int32_t n = s->n;
    for (int32_t l = 0; l < g->count; l++) {
        passenger *p = &g->passenger[l];
        if (!p->rides)
            continue;
        if (s->failed[l] != 0 || !is_finite(s, l)) {
            double *q = g->worker->kept + (int64_t)l * 2 * n;
            trk_lanes_get_kept(s, l, q, q + n);
            p->rides = false;
            p->leaves = p->started = true;
            p->step = step;
        } else {
            flush(g, l, first_sample);
        }
    }
}

static int32_t riding(const group *g)
{
    int32_t count = 0;
    for (int32_t l = 0; l < g->count; l++)
        count += g->passenger[l].rides;
    return count;
}

static void ride(group *g)
{
    trk_batch *batch = g->worker->batch;
    trk_lanes *s = g->lanes;
    batch->kernel->record_now(s);
    for (int32_t l = 0; l < g->count; l++)
        if (g->passenger[l].rides)
            flush(g, l, 0);
    for (int64_t done = 0; done < batch->steps && riding(g) > 0; done += TRK_LANES_BLOCK) {
        int64_t left = batch->steps - done, count = left < TRK_LANES_BLOCK ? left : TRK_LANES_BLOCK;
        drive(g, done, count);
        trk_lanes_keep(s);
        batch->kernel->advance(s, count);
        settle(g, done, done / batch->options.record_every + 1);
        if (trk_batch_account(g->worker, count * riding(g)) || done + count == batch->steps)
            continue;
        for (int32_t l = 0; l < g->count; l++) {
            if (g->passenger[l].rides || g->passenger[l].leaves)
                trk_batch_end(g->worker, g->passenger[l].variant, TRK_E_CANCELLED,
                              "cancelled by the caller");
            g->passenger[l].rides = g->passenger[l].leaves = false;
        }
    }
}

/* Fill the lanes; passengers that do not fit leave at once. */
static void board(group *g)
{
    trk_batch_worker *worker = g->worker;
    const trk_batch *batch = worker->batch;
    trk_lanes *s = g->lanes;
    int32_t first = -1;
    trk_lanes_start(s, batch->models[g->passenger[0].variant]);
    for (int32_t l = 0; l < g->count; l++) {
        passenger *p = &g->passenger[l];
        bool fits = false;
        trk_batch_drive(worker, batch->excitations[p->variant], -1, 1);
        trk_status status = trk_arena_enter(&worker->arena);
        if (status == TRK_OK)
            status = trk_lanes_fill(s, l, worker->arena.context, batch->models[p->variant],
                                    worker->height, worker->velocity, worker->load, &fits);
        trk_arena_leave(&worker->arena);
        p->rides = fits && status == TRK_OK;
        p->leaves = !p->rides; /* the stepper says what is wrong, if anything is */
        if (p->rides && first < 0)
            first = l;
    }
    for (int32_t l = 0; first >= 0 && l < s->width; l++)
        if (l >= g->count || !g->passenger[l].rides)
            trk_lanes_copy(s, first, l);
}

static void run(group *g)
{
    board(g);
    if (riding(g) > 0) {
        drive(g, -1, 1);
        ride(g);
    }
    for (int32_t l = 0; l < g->count; l++) {
        const passenger *p = &g->passenger[l];
        const double *q = g->worker->kept + (int64_t)l * 2 * g->lanes->n;
        if (p->leaves)
            trk_batch_run_alone(g->worker, p->variant,
                                p->started ? (trk_batch_origin){p->step, q, q + g->lanes->n}
                                           : (trk_batch_origin){0, NULL, NULL});
        else if (p->rides)
            g->worker->batch->status[p->variant] = TRK_OK;
    }
}

void trk_batch_run_group(trk_batch_worker *worker, int32_t first, int32_t count)
{
    const trk_model *const *models = worker->batch->models;
    bool done[TRK_LANES_WIDEST] = {false};
    for (int32_t k = 0; k < count; k++) {
        group g = {.worker = worker, .lanes = worker->lanes};
        for (int32_t l = k; l < count; l++)
            if (!done[l] && trk_lanes_alike(models[first + k], models[first + l])) {
                g.passenger[g.count++].variant = first + l;
                done[l] = true;
            }
        if (g.count > 0)
            run(&g);
    }
}
