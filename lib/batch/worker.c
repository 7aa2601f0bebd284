/* SPDX-License-Identifier: MIT */
/* What each thread does, and what all of them tell. */
#include "batch/batch.h"

void trk_batch_drive(const trk_batch_worker *worker, const trk_excitation *excitation,
                     int64_t first, int64_t count)
{
    const trk_batch *batch = worker->batch;
    double step = batch->newmark.step;
    trk_excitation_evaluate(excitation, count, batch->options.start + (double)(first + 1) * step,
                            step, worker->height, worker->velocity, worker->load);
}

bool trk_batch_account(trk_batch_worker *worker, int64_t steps)
{
    trk_batch *batch = worker->batch;
    unsigned long long before = atomic_fetch_add_explicit(
        &batch->advanced, (unsigned long long)steps, memory_order_relaxed);
    if (worker->calls_progress && batch->progress) {
        double all = (double)batch->steps * batch->count,
               fraction = ((double)before + (double)steps) / all;
        if (fraction >= batch->next_report && fraction < 1) {
            batch->next_report = fraction + 0.01;
            if (batch->progress(batch->progress_user, fraction))
                atomic_store_explicit(&batch->cancelled, 1, memory_order_relaxed);
        }
    }
    return !atomic_load_explicit(&batch->cancelled, memory_order_relaxed);
}

void trk_batch_end(trk_batch_worker *worker, int32_t variant, trk_status status, const char *cause)
{
    worker->batch->status[variant] = status;
    if (variant >= worker->failed)
        return;
    worker->failed = variant;
    trk_format(worker->message, TRK_BATCH_MESSAGE, "%s", cause);
}

void trk_batch_end_by_sink(trk_batch_worker *worker, int32_t variant, int64_t sample)
{
    char cause[TRK_BATCH_MESSAGE];
    trk_format(cause, sizeof cause, "cancelled by the sink at sample %lld", (long long)sample);
    trk_batch_end(worker, variant, TRK_E_CANCELLED, cause);
}

void trk_batch_work(trk_batch_worker *worker)
{
    trk_batch *batch = worker->batch;
    int32_t width = batch->kernel ? batch->kernel->width : 1;
    for (;;) {
        int32_t first = atomic_fetch_add_explicit(&batch->next, width, memory_order_relaxed);
        if (first >= batch->count)
            return;
        int32_t count = batch->count - first < width ? batch->count - first : width;
        if (atomic_load_explicit(&batch->cancelled, memory_order_relaxed))
            for (int32_t k = first; k < first + count; k++)
                trk_batch_end(worker, k, TRK_E_CANCELLED, "cancelled by the caller");
        else if (batch->kernel)
            trk_batch_run_group(worker, first, count);
        else
            trk_batch_run_alone(worker, first, (trk_batch_origin){0, NULL, NULL});
    }
}
