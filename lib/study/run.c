/* SPDX-License-Identifier: MIT */
/* Cases in chunks through trk_batch_run(), their samples reduced on the way. */
#include "study/reduce.h"

#include <stdatomic.h>

enum { CASES_A_THREAD = 16, MOST_MEMORY = 128 << 20 };

static const trk_study_run_options defaults = {
    .struct_size = sizeof defaults, .threads = 1, .shard = 1, .shards = 1};

void trk_study_run_options_init(trk_study_run_options *options, size_t struct_size)
{
    trk_write_defaults(options, struct_size, &defaults, sizeof defaults);
}

/* Room for a Fourier transform; there are as many as threads, one is always free. */
typedef struct scratch {
    atomic_flag busy;
    double *buffer[2];
} scratch;

/* A run of some cases. */
typedef struct work {
    trk_study *study;
    trk_study_run_options options;
    trk_batch_options batch;
    int32_t *sensors;   /* of the channels                                          */
    int32_t chunk;      /* most cases at a time                                     */
    int64_t *number;    /* of the cases of this chunk, length chunk                 */
    int32_t count;      /* of them                                                  */
    int32_t *place;     /* in this chunk, of a variant of the batch: some models fail */
    trk_model **models; /* length chunk, like the next three                         */
    const trk_excitation **excitations;
    trk_status *status;
    trk_reduction *reductions; /* chunk x channels                                */
    scratch *scratches;        /* length threads, if there is a PSD               */
    double *parameters, *density, *values;
    trk_progress progress;
    void *user;
    int64_t done, total; /* cases */
} work;

static trk_status check(trk_context *context, const trk_study_run_options *o)
{
    static const char what[] = "trk_study_run_options";
    if (o->threads < 1 || o->threads > 65536)
        return trk_fail(context, TRK_E_RANGE, "%s: threads is %d, expected 1 to 65536", what,
                        o->threads);
    if (o->chunk < 0)
        return trk_fail(context, TRK_E_RANGE, "%s: chunk is %d, expected >= 0", what, o->chunk);
    if (o->shard < 1 || o->shard > o->shards)
        return trk_fail(context, TRK_E_RANGE,
                        "%s: shard is %d of %d, expected 1 to the number of shards", what, o->shard,
                        o->shards);
    return TRK_OK;
}

static void free_work(work *w)
{
    const trk_study *study = w->study;
    trk_context *context = study->context;
    for (int32_t k = 0; w->reductions && k < w->chunk; k++)
        trk_reduction_free(study, w->reductions + (int64_t)k * study->channel_count);
    for (int32_t t = 0; w->scratches && t < w->options.threads; t++) {
        trk_free(context, w->scratches[t].buffer[0]);
        trk_free(context, w->scratches[t].buffer[1]);
    }
    trk_free(context, w->scratches);
    trk_free(context, w->reductions);
    trk_free(context, w->sensors);
    trk_free(context, w->number);
    trk_free(context, w->place);
    trk_free(context, w->models);
    trk_free(context, w->excitations);
    trk_free(context, w->status);
    trk_free(context, w->parameters);
    trk_free(context, w->density);
    trk_free(context, w->values);
}

/* Cases that fit into memory at a time. */
static int32_t choose_chunk(const work *w)
{
    int64_t chunk = w->options.chunk;
    if (chunk == 0) {
        const int64_t fit = MOST_MEMORY / trk_reduction_size(w->study);
        chunk = (int64_t)CASES_A_THREAD * w->options.threads;
        chunk = chunk < fit ? chunk : fit;
    }
    chunk = chunk < w->total ? chunk : w->total;
    return chunk > 1 ? (int32_t)chunk : 1;
}

static trk_status allocate_scratches(work *w)
{
    trk_context *context = w->study->context;
    const trk_welch_plan *plan = &w->study->plan;
    w->scratches = trk_new(context, w->options.threads, sizeof *w->scratches);
    w->density = trk_new(context, plan->settings.length, sizeof *w->density);
    if (!w->scratches || !w->density)
        return TRK_E_MEMORY;
    for (int32_t t = 0; t < w->options.threads; t++) {
        atomic_flag_clear(&w->scratches[t].busy);
        for (int i = 0; i < 2; i++) {
            w->scratches[t].buffer[i] =
                trk_new(context, trk_real_fft_buffer(plan->fft), sizeof(double));
            if (!w->scratches[t].buffer[i])
                return TRK_E_MEMORY;
        }
    }
    return TRK_OK;
}

static trk_status allocate(work *w)
{
    trk_study *study = w->study;
    trk_context *context = study->context;
    w->chunk = choose_chunk(w);
    if (w->options.threads > w->chunk)
        w->options.threads = w->chunk;
    w->sensors = trk_new(context, study->channel_count, sizeof *w->sensors);
    w->number = trk_new(context, w->chunk, sizeof *w->number);
    w->place = trk_new(context, w->chunk, sizeof *w->place);
    w->models = trk_new(context, w->chunk, sizeof *w->models);
    w->excitations = trk_new(context, w->chunk, sizeof *w->excitations);
    w->status = trk_new(context, w->chunk, sizeof *w->status);
    w->parameters = trk_new(context, trk_study_parameters(study), sizeof *w->parameters);
    w->values = trk_new(context, trk_study_outputs(study), sizeof *w->values);
    w->reductions =
        trk_new(context, (int64_t)w->chunk * study->channel_count, sizeof *w->reductions);
    if (!w->sensors || !w->number || !w->place || !w->models || !w->excitations || !w->status ||
        !w->parameters || !w->values || !w->reductions)
        return TRK_E_MEMORY;
    for (int32_t c = 0; c < study->channel_count; c++)
        w->sensors[c] = study->channels[c].sensor;
    w->batch.sensors = w->sensors;
    w->batch.sensor_count = study->channel_count;
    trk_status status = TRK_OK;
    for (int32_t k = 0; status == TRK_OK && k < w->chunk; k++)
        status = trk_reduction_create(study, w->reductions + (int64_t)k * study->channel_count);
    return status == TRK_OK && study->psd ? allocate_scratches(w) : status;
}

static trk_status start(work *w, const char *function, const trk_study_run_options *options)
{
    trk_context *context = w->study->context;
    w->options = defaults;
    trk_status status =
        trk_read_options(context, "trk_study_run_options", options, &w->options, sizeof w->options);
    if (status == TRK_OK)
        status = check(context, &w->options);
    if (status == TRK_OK)
        status = trk_study_prepare(w->study, function);
    if (status != TRK_OK)
        return status;
    trk_batch_options_init(&w->batch, sizeof w->batch);
    w->batch.duration = w->study->options.duration;
    w->batch.start = w->study->options.start;
    w->batch.record_every = w->study->options.record_every;
    return TRK_OK;
}

/* A trk_batch_sink: called by any thread, one variant by one thread at a time. */
static int32_t take_samples(void *user, int32_t variant, int64_t first, int64_t count,
                            const double *values)
{
    work *w = user;
    const trk_study *study = w->study;
    trk_reduction *reductions = w->reductions + (int64_t)w->place[variant] * study->channel_count;
    scratch *s = NULL;
    for (int32_t t = 0; study->psd && !s; t = (t + 1) % w->options.threads)
        if (!atomic_flag_test_and_set_explicit(&w->scratches[t].busy, memory_order_acquire))
            s = &w->scratches[t];
    trk_reduction_push(study, reductions, first, count, values, s ? s->buffer : NULL);
    if (s)
        atomic_flag_clear_explicit(&s->busy, memory_order_release);
    return 0;
}

static int32_t report(void *user, double fraction)
{
    const work *w = user;
    const double done = (double)w->done + fraction * w->count;
    return w->progress ? w->progress(w->user, done / (double)w->total) : 0;
}

/* Keep a result. why: what the log hears of a failure. */
static trk_status keep(work *w, int64_t number, trk_status status, const double *values,
                       const char *why)
{
    trk_study *study = w->study;
    if (study->state[number]) /* it stood twice in the caller's list */
        return TRK_OK;
    if (status != TRK_OK)
        trk_note(study->context, "case %lld failed: %s", (long long)number, why);
    trk_study_store(study, number, status, values);
    return trk_journal_append(study, number);
}

/* Compile the models of the chunk; *out_variants of them are valid, the others are kept as
 * failed. */
static trk_status compile(work *w, int32_t *out_variants)
{
    trk_study *study = w->study;
    *out_variants = 0;
    for (int32_t k = 0; k < w->count; k++) {
        int32_t road, n = *out_variants;
        trk_status status = trk_study_compile(study, w->number[k], w->parameters, &w->models[n]);
        if (status != TRK_OK) {
            if (!trk_study_is_outcome(status))
                return status;
            status = keep(w, w->number[k], status, NULL, trk_context_message(study->context));
            if (status != TRK_OK)
                return status;
            continue;
        }
        (void)!trk_study_get_case(study, w->number[k], NULL, &road);
        trk_reduction_reset(study, w->reductions + (int64_t)k * study->channel_count);
        w->excitations[n] = study->excitations[road - 1];
        w->place[n] = k;
        w->status[n] = TRK_STATUS_END_;
        ++*out_variants;
    }
    return TRK_OK;
}

/* Outputs of the variants that came to an end. */
static trk_status collect(work *w, int32_t variants)
{
    trk_study *study = w->study;
    trk_status status = TRK_OK;
    bool told = false; /* the message tells of the first variant that failed in the batch */
    for (int32_t n = 0; status == TRK_OK && n < variants; n++) {
        trk_status outcome = w->status[n];
        if (!trk_study_is_outcome(outcome))
            continue;
        const int64_t number = w->number[w->place[n]];
        const char *why = told ? trk_status_text(outcome) : trk_context_message(study->context);
        if (outcome == TRK_OK) {
            trk_reduction *reductions = w->reductions + (int64_t)w->place[n] * study->channel_count;
            outcome = trk_reduction_finish(study, reductions, w->density, w->values);
            why = trk_context_message(study->context);
        }
        told |= outcome != TRK_OK;
        status = trk_study_is_outcome(outcome) ? keep(w, number, outcome, w->values, why) : outcome;
    }
    return status;
}

/* What stopped the batch as a whole; TRK_OK if nothing but single variants failed. */
static trk_status stopped(const work *w, int32_t variants, trk_status returned)
{
    for (int32_t n = 0; n < variants; n++) {
        if (w->status[n] == TRK_STATUS_END_)
            return returned;
        if (!trk_study_is_outcome(w->status[n]))
            return w->status[n];
    }
    return returned == TRK_E_CANCELLED ? returned : TRK_OK;
}

static trk_status run_chunk(work *w)
{
    trk_study *study = w->study;
    int32_t variants;
    trk_status status = compile(w, &variants);
    if (status == TRK_OK && variants > 0) {
        w->batch.threads = w->options.threads;
        const trk_status returned = trk_batch_run(
            study->context, variants, (const trk_model *const *)w->models, w->excitations,
            &study->newmark, &w->batch, take_samples, w, report, w, w->status);
        status = stopped(w, variants, returned);
        const trk_status collected = collect(w, variants);
        status = collected != TRK_OK ? collected : status;
    }
    for (int32_t n = 0; n < variants; n++) {
        trk_model_destroy(w->models[n]);
        w->models[n] = NULL;
    }
    const trk_status flushed = trk_journal_flush(study);
    w->done += w->count;
    w->count = 0;
    return status == TRK_OK ? flushed : status;
}

/* Put a case into the chunk; run the chunk when it is full. */
static trk_status add_case(work *w, int64_t number)
{
    w->number[w->count++] = number;
    return w->count == w->chunk ? run_chunk(w) : TRK_OK;
}

/* The last chunk; and the end. */
static trk_status finish(work *w, trk_status status)
{
    if (status == TRK_OK && w->count > 0)
        status = run_chunk(w);
    if (status == TRK_OK && w->progress && w->total == 0)
        (void)w->progress(w->user, 1);
    free_work(w);
    return status;
}

trk_status trk_study_run(trk_study *study, const trk_study_run_options *options,
                         trk_progress progress, void *user)
{
    TRK_REQUIRE(NULL, study, "trk_study_run");
    work w = {.study = study, .progress = progress, .user = user};
    trk_status status = start(&w, "trk_study_run", options);
    if (status != TRK_OK)
        return status;
    const int64_t cases = trk_study_cases(study);
    for (int64_t k = w.options.shard - 1; k < cases; k += w.options.shards)
        w.total += study->state[k] == 0;
    status = allocate(&w);
    for (int64_t k = w.options.shard - 1; status == TRK_OK && k < cases; k += w.options.shards)
        if (study->state[k] == 0)
            status = add_case(&w, k);
    return finish(&w, status);
}

trk_status trk_study_run_cases(trk_study *study, int64_t count, const int64_t *numbers,
                               const trk_study_run_options *options, trk_progress progress,
                               void *user)
{
    static const char what[] = "trk_study_run_cases";
    TRK_REQUIRE(NULL, study, "trk_study_run_cases");
    if (count < 0 || (count > 0 && !numbers))
        return trk_fail(study->context, TRK_E_ARGUMENT,
                        "%s: count is %lld, expected >= 0 and numbers", what, (long long)count);
    work w = {.study = study, .progress = progress, .user = user};
    trk_status status = start(&w, what, options);
    for (int64_t k = 0; status == TRK_OK && k < count; k++)
        status = trk_study_check_case(study, what, numbers[k]);
    if (status != TRK_OK)
        return status;
    for (int64_t k = 0; k < count; k++)
        w.total += study->state[numbers[k]] == 0;
    status = allocate(&w);
    for (int64_t k = 0; status == TRK_OK && k < count; k++)
        if (study->state[numbers[k]] == 0)
            status = add_case(&w, numbers[k]);
    return finish(&w, status);
}
