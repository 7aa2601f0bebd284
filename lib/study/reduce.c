/* SPDX-License-Identifier: MIT */
/* Reductions of a case, and its outputs. */
#include "study/reduce.h"

#include <math.h>

int64_t trk_reduction_size(const trk_study *study)
{
    int64_t size = 0;
    for (int32_t c = 0; c < study->channel_count; c++) {
        size += (int64_t)sizeof(trk_reduction);
        size += study->channels[c].psd ? trk_welch_stream_size(&study->plan) : 0;
    }
    return size;
}

trk_status trk_reduction_create(const trk_study *study, trk_reduction *reductions)
{
    trk_status status = TRK_OK;
    for (int32_t c = 0; status == TRK_OK && c < study->channel_count; c++)
        if (study->channels[c].psd)
            status = trk_welch_stream_create(&study->plan, &reductions[c].stream);
    return status;
}

void trk_reduction_free(const trk_study *study, trk_reduction *reductions)
{
    for (int32_t c = 0; c < study->channel_count; c++)
        if (study->channels[c].psd)
            trk_welch_stream_free(&study->plan, &reductions[c].stream);
}

void trk_reduction_reset(const trk_study *study, trk_reduction *reductions)
{
    for (int32_t c = 0; c < study->channel_count; c++) {
        trk_moments_reset(&reductions[c].moments);
        if (study->channels[c].psd)
            trk_welch_stream_reset(&study->plan, &reductions[c].stream);
    }
}

void trk_reduction_push(const trk_study *study, trk_reduction *reductions, int64_t first,
                        int64_t count, const double *values, double *const buffer[2])
{
    const int64_t wanted = study->skipped - first, skip = wanted > 0 ? wanted : 0;
    if (skip >= count)
        return;
    for (int32_t c = 0; c < study->channel_count; c++) {
        const trk_channel *channel = &study->channels[c];
        const double *x = values + c * count + skip;
        trk_moments_push(&reductions[c].moments, count - skip, x);
        if (channel->psd)
            trk_welch_stream_push(&study->plan, &reductions[c].stream, count - skip, x, buffer);
    }
}

static double moment_of(const trk_moments *m, trk_output kind)
{
    const double variance = m->squares / (double)m->count;
    switch (kind) {
    case TRK_OUTPUT_MAXIMUM: return m->maximum;
    case TRK_OUTPUT_MINIMUM: return m->minimum;
    case TRK_OUTPUT_PEAK: return fmax(fabs(m->minimum), fabs(m->maximum));
    case TRK_OUTPUT_MEAN: return m->mean;
    case TRK_OUTPUT_RMS: return sqrt(m->mean * m->mean + variance);
    default: return sqrt(variance);
    }
}

/* Highest peak of the PSD in the band; NaN if there is none (STUDY.8). */
static trk_status highest_peak(trk_context *context, const trk_study_output_options *o,
                               int64_t length, const double *density, double step, double *out)
{
    /* Compared before they become integers: a band may lie anywhere. */
    const double end = (double)(length - 1), low = ceil(o->low / step),
                 high = floor(o->high / step);
    /* One bin more on both sides, so that a peak at the edge of the band counts. */
    int64_t first = low < end ? (int64_t)low - 1 : length - 1;
    int64_t last = o->high > 0 && high < end ? (int64_t)high + 1 : length - 1;
    first = first > 0 ? first : 0;
    double frequency = 0, height = 0;
    int64_t found = 0;
    trk_status status = TRK_OK;
    if (last - first >= 2)
        status = trk_psd_peaks(context, last - first + 1, density + first, step, NULL, 1,
                               &frequency, &height, NULL, &found);
    if (status != TRK_OK)
        return status;
    *out = o->kind == TRK_OUTPUT_PSD_PEAK_HEIGHT ? height : frequency + (double)first * step;
    if (found == 0)
        *out = NAN;
    return TRK_OK;
}

/* (STUDY.9) */
static double weighted_rms(int64_t length, const double *density, const double *gain, double step)
{
    double sum = 0;
    for (int64_t k = 0; k < length; k++)
        sum += gain[k] * density[k];
    return sqrt(sum) * sqrt(step);
}

static trk_status spectral(trk_study *study, const trk_design_output *output, const double *density,
                           double *out)
{
    const trk_study_output_options *o = &output->options;
    const int64_t length = study->plan.settings.length;
    const double step = study->sample_rate / (double)study->plan.settings.options.segment_length;
    if (o->kind == TRK_OUTPUT_BAND_RMS)
        return trk_band_rms(study->context, length, density, step, o->low,
                            o->high > 0 ? o->high : fmax(study->sample_rate, o->low), out);
    if (o->kind == TRK_OUTPUT_WEIGHTED_RMS) {
        *out = weighted_rms(length, density, output->gain, step);
        return TRK_OK;
    }
    return highest_peak(study->context, o, length, density, step, out);
}

static trk_status finish_output(trk_study *study, int32_t k, const trk_moments *moments,
                                const double *density, double *out)
{
    const trk_design_output *output = &study->outputs[k];
    const bool plain = output->options.kind < TRK_OUTPUT_BAND_RMS;
    trk_status status = TRK_OK;
    if (plain)
        *out = moment_of(moments, output->options.kind);
    else
        status = spectral(study, output, density, out);
    if (status == TRK_OK && !isfinite(*out) &&
        (plain || output->options.kind == TRK_OUTPUT_WEIGHTED_RMS))
        status = trk_fail(study->context, TRK_E_RANGE, "output '%s' is %g, not a finite number",
                          trk_study_part_name(study, TRK_STUDY_OUTPUT, k + 1), *out);
    return status;
}

trk_status trk_reduction_finish(trk_study *study, trk_reduction *reductions, double *density,
                                double *out_values)
{
    trk_status status = TRK_OK;
    for (int32_t c = 0; status == TRK_OK && c < study->channel_count; c++) {
        trk_moments_finish(&reductions[c].moments);
        if (study->channels[c].psd)
            status = trk_welch_stream_density(&study->plan, "trk_study_run", study->sample_rate,
                                              &reductions[c].stream, density);
        for (int32_t k = 0; status == TRK_OK && k < trk_study_outputs(study); k++)
            if (study->outputs[k].channel == c)
                status = finish_output(study, k, &reductions[c].moments, density, &out_values[k]);
    }
    return status;
}
