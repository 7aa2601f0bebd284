/* SPDX-License-Identifier: MIT */
/* Before the first case: samples counted, PSD planned, room for the results. */
#include "study/study.h"

#include <math.h>

void trk_study_unready(trk_study *study)
{
    trk_context *context = study->context;
    for (int32_t k = 0; k < trk_study_outputs(study); k++) {
        trk_free(context, study->outputs[k].gain);
        study->outputs[k].gain = NULL;
    }
    if (study->psd)
        trk_welch_plan_free(&study->plan);
    trk_free(context, study->channels);
    trk_free(context, study->values);
    trk_free(context, study->state);
    study->channels = NULL;
    study->values = NULL;
    study->state = NULL;
    study->channel_count = 0;
    study->psd = study->ready = false;
    study->finished = 0;
}

static trk_status check(const trk_study *study, const char *function)
{
    trk_context *context = study->context;
    if (trk_study_count(study, TRK_STUDY_EXCITATION) == 0)
        return trk_fail(context, TRK_E_ARGUMENT, "%s: the study has no road", function);
    if (trk_study_outputs(study) == 0)
        return trk_fail(context, TRK_E_ARGUMENT, "%s: the study has no output", function);
    for (int32_t k = 0; k < trk_study_parameters(study); k++)
        if (study->parameters[k].actions == 0)
            return trk_fail(context, TRK_E_ARGUMENT,
                            "%s: parameter '%s' acts on nothing; call trk_study_act_on()", function,
                            trk_study_part_name(study, TRK_STUDY_PARAMETER, k + 1));
    return TRK_OK;
}

/* Samples that are recorded, and those of them that outputs look at. */
static trk_status count_samples(trk_study *study, const char *function)
{
    trk_batch_options batch;
    trk_batch_options_init(&batch, sizeof batch);
    batch.duration = study->options.duration;
    batch.start = study->options.start;
    batch.record_every = study->options.record_every;
    const int64_t recorded = trk_batch_samples(&study->newmark, &batch);
    const double spacing = study->newmark.step * (double)study->options.record_every;
    if (recorded < 1)
        return trk_fail(study->context, TRK_E_RANGE,
                        "%s: %g s in steps of %g s, every %lld recorded, is not possible", function,
                        study->options.duration, study->newmark.step,
                        (long long)study->options.record_every);
    study->sample_rate = 1 / spacing;
    /* A sample that comes a rounding error before the end of settling counts. */
    const double skipped = ceil(study->options.settle / spacing * (1 - 1e-12));
    if (!(skipped < (double)recorded))
        return trk_fail(study->context, TRK_E_RANGE,
                        "%s: settling takes %g s, all %lld samples of the run", function,
                        study->options.settle, (long long)recorded);
    study->skipped = (int64_t)skipped;
    study->samples = recorded - study->skipped;
    return TRK_OK;
}

static bool needs_psd(trk_output kind)
{
    return kind >= TRK_OUTPUT_BAND_RMS;
}

/* One channel for each sensor that some output looks at. */
static trk_status list_channels(trk_study *study)
{
    study->channels = trk_new(study->context, trk_study_outputs(study), sizeof *study->channels);
    if (!study->channels)
        return TRK_E_MEMORY;
    for (int32_t k = 0; k < trk_study_outputs(study); k++) {
        trk_design_output *output = &study->outputs[k];
        int32_t c = 0;
        while (c < study->channel_count && study->channels[c].sensor != output->sensor)
            c++;
        if (c == study->channel_count)
            study->channels[study->channel_count++].sensor = output->sensor;
        output->channel = c;
        study->channels[c].psd |= needs_psd(output->options.kind);
        study->psd |= needs_psd(output->options.kind);
    }
    return TRK_OK;
}

/* Weight at a frequency, straight in the logarithms (STUDY.9). */
static double weight_at(const trk_study_output_options *o, double frequency)
{
    const double *f = o->frequency, *w = o->weight;
    int64_t k = 0;
    if (!(frequency >= f[0] && frequency <= f[o->count - 1]))
        return 0;
    while (k + 1 < o->count && f[k + 1] <= frequency)
        k++;
    if (f[k] == frequency)
        return w[k];
    const double part = log(frequency / f[k]) / log(f[k + 1] / f[k]);
    return w[k] * exp(part * log(w[k + 1] / w[k]));
}

static trk_status tabulate_weights(trk_study *study)
{
    const int64_t length = study->plan.settings.length;
    const double step = study->sample_rate / (double)study->plan.settings.options.segment_length;
    for (int32_t k = 0; k < trk_study_outputs(study); k++) {
        trk_design_output *output = &study->outputs[k];
        if (output->options.kind != TRK_OUTPUT_WEIGHTED_RMS)
            continue;
        output->gain = trk_new(study->context, length, sizeof *output->gain);
        if (!output->gain)
            return TRK_E_MEMORY;
        for (int64_t i = 0; i < length; i++) {
            const double weight = weight_at(&output->options, (double)i * step);
            output->gain[i] = weight * weight;
        }
    }
    return TRK_OK;
}

static trk_status plan_psd(trk_study *study, const char *function)
{
    if (!study->psd)
        return TRK_OK;
    study->psd = false; /* there is nothing to free yet */
    trk_status status = trk_welch_plan_create(study->context, function, study->samples,
                                              &study->spectrum, &study->plan);
    if (status != TRK_OK)
        return status;
    study->psd = true;
    return tabulate_weights(study);
}

static trk_status allocate(trk_study *study)
{
    const int64_t cases = trk_study_cases(study);
    study->values =
        trk_new(study->context, cases * trk_study_outputs(study), sizeof *study->values);
    if (study->values)
        study->state = trk_new(study->context, cases, sizeof *study->state);
    return study->state ? TRK_OK : TRK_E_MEMORY;
}

trk_status trk_study_prepare(trk_study *study, const char *function)
{
    if (study->ready)
        return TRK_OK;
    trk_status status = check(study, function);
    if (status == TRK_OK)
        status = count_samples(study, function);
    if (status == TRK_OK)
        status = list_channels(study);
    if (status == TRK_OK)
        status = plan_psd(study, function);
    if (status == TRK_OK)
        status = trk_study_hash(study, &study->fingerprint);
    if (status == TRK_OK)
        status = allocate(study);
    if (status == TRK_OK)
        study->ready = true;
    else
        trk_study_unready(study);
    return status;
}

trk_status trk_study_get_fingerprint(trk_study *study, int64_t *out_fingerprint)
{
    TRK_REQUIRE(NULL, study, "trk_study_get_fingerprint");
    TRK_REQUIRE(study->context, out_fingerprint, "trk_study_get_fingerprint");
    trk_status status = trk_study_prepare(study, "trk_study_get_fingerprint");
    if (status == TRK_OK)
        *out_fingerprint = (int64_t)study->fingerprint;
    return status;
}
