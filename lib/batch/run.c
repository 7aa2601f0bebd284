/* SPDX-License-Identifier: MIT */
/* A batch from its arguments to its statuses: all memory, then all threads. */
#include "batch/batch.h"

#include <string.h>

enum { STEPPER_MARGIN = 65536 };

/*
 * Memory for the stepper of any variant: twice that of the first which can be created, since
 * rows may have a few entries more or less where numbers are zero.
 */
static trk_status measure_stepper(const trk_batch *batch, size_t *out_size)
{
    trk_arena arena = {.parent = batch->context};
    trk_status status = TRK_E_ARGUMENT;
    *out_size = 0;
    for (int32_t k = 0; status != TRK_OK && k < batch->count; k++) {
        trk_newmark *stepper = NULL;
        arena.used = 0;
        status = trk_arena_enter(&arena);
        if (status == TRK_OK)
            status = trk_newmark_create(arena.context, batch->models[k], &batch->newmark, &stepper);
        trk_newmark_destroy(stepper);
        trk_arena_leave(&arena);
        if (arena.used > *out_size)
            *out_size = arena.used;
        if (status == TRK_E_MEMORY)
            return trk_fail(batch->context, status, "trk_batch_run: out of memory for a stepper");
    }
    return TRK_OK;
}

/* That, or what filling a lane takes. */
static trk_status measure(const trk_batch *batch, size_t *out_size)
{
    const trk_model *model = batch->models[0];
    trk_status status = measure_stepper(batch, out_size);
    size_t n = (size_t)model->n, links = (size_t)model->links.count,
           filling =
               (4 * n * n + 4 * n + 2 * links * n) * sizeof(double) + links * sizeof(trk_link_law);
    *out_size = 2 * *out_size + STEPPER_MARGIN + (batch->kernel ? filling : 0);
    return status;
}

static void worker_free(trk_batch_worker *worker)
{
    trk_context *context = worker->batch->context;
    trk_lanes_destroy(worker->lanes);
    void *blocks[] = {worker->arena.block, worker->height, worker->velocity, worker->load,
                      worker->values,      worker->row,    worker->kept,     worker->message};
    for (size_t k = 0; k < sizeof blocks / sizeof *blocks; k++)
        trk_free(context, blocks[k]);
}

static trk_status worker_create(trk_batch_worker *worker, trk_batch *batch, size_t arena_size)
{
    trk_context *context = batch->context;
    const trk_model *model = batch->models[0];
    int32_t width = batch->kernel ? batch->kernel->width : 0;
    int64_t roads = trk_model_count(model, TRK_PART_ROAD);
    *worker = (trk_batch_worker){.batch = batch, .failed = batch->count};
    worker->arena.size = arena_size;
    worker->arena.block = trk_new(context, (int64_t)arena_size, 1);
    worker->height = trk_new(context, TRK_LANES_BLOCK * roads, sizeof(double));
    worker->velocity = trk_new(context, TRK_LANES_BLOCK * roads, sizeof(double));
    worker->load = trk_new(context, (int64_t)TRK_LANES_BLOCK * model->ports.count, sizeof(double));
    worker->values = trk_new(context, (int64_t)TRK_LANES_BLOCK * batch->sensors, sizeof(double));
    worker->row = trk_new(context, model->sensors.count, sizeof(double));
    worker->kept = trk_new(context, (int64_t)width * 2 * model->n, sizeof(double));
    worker->message = trk_new(context, TRK_BATCH_MESSAGE, 1);
    if (!worker->arena.block || !worker->height || !worker->velocity || !worker->load ||
        !worker->values || !worker->row || !worker->kept || !worker->message)
        return TRK_E_MEMORY;
    if (!batch->kernel)
        return TRK_OK;
    return trk_lanes_create(context, model, &batch->newmark, batch->options.record_every,
                            batch->sensors, batch->sensor, width, &worker->lanes);
}

static void *work(void *worker)
{
    trk_batch_work(worker);
    return NULL;
}

/* The calling thread is worker 0. A thread that the system refuses is missed by nobody. */
static void run_threads(trk_batch_worker *workers, int32_t count)
{
    int32_t started = 1;
    while (started < count &&
           pthread_create(&workers[started].thread, NULL, work, &workers[started]) == 0)
        started++;
    trk_batch_work(&workers[0]);
    for (int32_t k = 1; k < started; k++)
        pthread_join(workers[k].thread, NULL);
}

/* Status and message of the whole out of those of the variants. */
static trk_status conclude(trk_batch *batch, const trk_batch_worker *workers, int32_t count)
{
    const trk_batch_worker *first = &workers[0];
    for (int32_t k = 1; k < count; k++)
        if (workers[k].failed < first->failed)
            first = &workers[k];
    if (batch->progress && !atomic_load(&batch->cancelled))
        (void)batch->progress(batch->progress_user, 1);
    if (atomic_load(&batch->cancelled))
        return trk_fail(batch->context, TRK_E_CANCELLED, "trk_batch_run: cancelled by the caller");
    if (first->failed == batch->count)
        return TRK_OK;
    return trk_fail(batch->context, batch->status[first->failed], "trk_batch_run: variant %d: %s",
                    first->failed, first->message);
}

static trk_status run(trk_batch *batch)
{
    int32_t width = batch->kernel ? batch->kernel->width : 1,
            groups = (batch->count - 1) / width + 1, count = batch->options.threads, made = 0;
    if (count > groups)
        count = groups;
    trk_batch_worker *workers = trk_new(batch->context, count, sizeof *workers);
    if (!workers)
        return TRK_E_MEMORY;
    size_t arena_size;
    trk_status status = measure(batch, &arena_size);
    while (status == TRK_OK && made < count)
        status = worker_create(&workers[made++], batch, arena_size);
    if (status == TRK_OK) {
        workers[0].calls_progress = true;
        if (batch->progress && batch->progress(batch->progress_user, 0))
            atomic_store(&batch->cancelled, 1);
        run_threads(workers, count);
        status = conclude(batch, workers, count);
    }
    while (made > 0)
        worker_free(&workers[--made]);
    trk_free(batch->context, workers);
    return status;
}

/* The sensors of the options, all without. */
static trk_status list_sensors(trk_batch *batch)
{
    const trk_batch_options *o = &batch->options;
    const trk_model *model = batch->models[0];
    batch->sensors = o->sensor_count ? o->sensor_count : model->sensors.count;
    for (int32_t k = 0; k < o->sensor_count; k++)
        if (o->sensors[k] < 1 || o->sensors[k] > model->sensors.count)
            return trk_fail(batch->context, TRK_E_ARGUMENT,
                            "trk_batch_options: sensors[%d] is %d; '%s' has 1 to %d", k,
                            o->sensors[k], trk_model_name(model), model->sensors.count);
    batch->sensor = trk_new(batch->context, batch->sensors, sizeof *batch->sensor);
    if (!batch->sensor)
        return TRK_E_MEMORY;
    for (int32_t k = 0; k < batch->sensors; k++)
        batch->sensor[k] = o->sensor_count ? o->sensors[k] - 1 : k;
    return TRK_OK;
}

trk_status trk_batch_run_with(int32_t kernel, trk_context *context, int32_t count,
                              const trk_model *const *models,
                              const trk_excitation *const *excitations,
                              const trk_newmark_options *newmark, const trk_batch_options *options,
                              trk_batch_sink sink, void *sink_user, trk_progress progress,
                              void *progress_user, trk_status *out_status)
{
    TRK_REQUIRE(context, context, "trk_batch_run");
    TRK_REQUIRE(context, models, "trk_batch_run");
    TRK_REQUIRE(context, excitations, "trk_batch_run");
    TRK_REQUIRE(context, sink, "trk_batch_run");
    if (count < 1 || count > INT32_MAX / 2)
        return trk_fail(context, TRK_E_ARGUMENT, "trk_batch_run: count is %d; 1 to %d is needed",
                        count, INT32_MAX / 2);
    trk_batch batch = {.context = context,
                       .count = count,
                       .models = models,
                       .excitations = excitations,
                       .sink = sink,
                       .sink_user = sink_user,
                       .progress = progress,
                       .progress_user = progress_user};
    trk_status status = trk_batch_read_options(context, newmark, options, &batch.newmark,
                                               &batch.options, &batch.steps);
    if (status == TRK_OK)
        status = trk_batch_check_structure(&batch);
    if (status == TRK_OK)
        status = list_sensors(&batch);
    if (status != TRK_OK)
        return status;
    if (trk_lanes_fit(models[0], &batch.newmark))
        batch.kernel = trk_lanes_find_kernel(kernel, models[0]);
    batch.status = trk_new(context, count, sizeof *batch.status);
    if (!batch.status) {
        trk_free(context, batch.sensor);
        return TRK_E_MEMORY;
    }
    for (int32_t k = 0; k < count; k++)
        batch.status[k] = TRK_E_MEMORY; /* the only reason why no thread would take it */
    status = run(&batch);
    if (out_status)
        memcpy(out_status, batch.status, (size_t)count * sizeof *out_status);
    trk_free(context, batch.status);
    trk_free(context, batch.sensor);
    return status;
}

trk_status trk_batch_run(trk_context *context, int32_t count, const trk_model *const *models,
                         const trk_excitation *const *excitations,
                         const trk_newmark_options *newmark, const trk_batch_options *options,
                         trk_batch_sink sink, void *sink_user, trk_progress progress,
                         void *progress_user, trk_status *out_status)
{
    return trk_batch_run_with(TRK_BATCH_KERNEL_BEST, context, count, models, excitations, newmark,
                              options, sink, sink_user, progress, progress_user, out_status);
}
