/* SPDX-License-Identifier: MIT */
/* Targets on a simulated run: peaks and curves of its PSDs. */
#include "calibrate/calibrate.h"

#include <math.h>

/* Highest peak of a PSD between two frequencies. */
static trk_status find_peak(trk_context *context, const trk_target_options *o, int64_t length,
                            const double *density, double step, double *out_frequency)
{
    /* Compared before they become integers: a band may lie anywhere. */
    double end = (double)(length - 1), low = ceil(o->low / step), high = floor(o->high / step);
    int64_t first = low < end ? (int64_t)low : length - 1;
    int64_t last = o->high > 0 && high < end ? (int64_t)high : length - 1;
    /* One bin more on both sides, so that a peak at the edge of the band counts. */
    first = first > 0 ? first - 1 : 0;
    last = last < length - 1 ? last + 1 : last;
    int64_t found = 0;
    trk_status status = last - first < 2
                            ? TRK_OK
                            : trk_psd_peaks(context, last - first + 1, density + first, step, NULL,
                                            1, out_frequency, NULL, NULL, &found);
    if (status != TRK_OK)
        return status;
    if (found == 0)
        return trk_fail(context, TRK_E_TARGET, "the PSD has no peak between %g and %g Hz", o->low,
                        o->high > 0 ? o->high : (double)last * step);
    *out_frequency += (double)first * step;
    return TRK_OK;
}

/* PSD at the frequencies of a curve, straight in the logarithms between bins. */
static trk_status psd_curve(trk_context *context, const trk_fit_target *target, int64_t length,
                            const double *density, double step, double *out_y)
{
    for (int32_t k = 0; k < target->count; k++) {
        double place = target->options.frequency[k] / step;
        if (!(place <= (double)(length - 1)))
            return trk_fail(context, TRK_E_TARGET, "the PSD of the run ends at %g Hz, below %g Hz",
                            (double)(length - 1) * step, target->options.frequency[k]);
        int64_t bin = place < (double)(length - 1) ? (int64_t)place : length - 2;
        double part = place - (double)bin;
        out_y[k] = exp((1 - part) * log(density[bin]) + part * log(density[bin + 1]));
    }
    trk_fit_compare(target, out_y, out_y);
    return TRK_OK;
}

/* All targets that are taken from the run. */
static trk_status run_targets(trk_calibration *c, const trk_series *series, double *density,
                              const trk_spectrum_options *settings, double *out_y)
{
    int64_t samples = trk_series_samples(series), length = trk_psd_length(settings, samples);
    double rate = trk_series_rate(series), step = rate / (double)settings->segment_length;
    for (int32_t k = 0; k < trk_fit_target_count(c); k++) {
        const trk_fit_target *target = &c->targets[k];
        trk_target kind = target->options.kind;
        if (kind != TRK_TARGET_PSD_PEAK && kind != TRK_TARGET_PSD_CURVE)
            continue;
        trk_status status = trk_psd(c->context, samples, trk_series_data(series, target->sensor),
                                    rate, settings, density);
        if (status == TRK_OK && kind == TRK_TARGET_PSD_PEAK)
            status = find_peak(c->context, &target->options, length, density, step,
                               out_y + target->first);
        else if (status == TRK_OK)
            status = psd_curve(c->context, target, length, density, step, out_y + target->first);
        if (status != TRK_OK)
            return trk_fit_fail_at(c, k, status);
    }
    return TRK_OK;
}

trk_status trk_fit_run(trk_calibration *c, const trk_model *model, double *out_y)
{
    if (!c->excitation)
        return trk_fail(c->context, TRK_E_ARGUMENT,
                        "a target is taken from a run: call trk_calibration_set_run() first");
    trk_newmark_options newmark;
    trk_simulate_options run;
    trk_spectrum_options settings;
    trk_newmark_options_init(&newmark, sizeof newmark);
    trk_simulate_options_init(&run, sizeof run);
    trk_spectrum_options_init(&settings, sizeof settings);
    newmark.step = c->run.step;
    run.duration = c->run.duration;
    settings.segment_length = c->run.segment_length;
    settings.overlap = c->run.overlap;
    trk_series *series;
    trk_status status =
        trk_simulate(c->context, model, c->excitation, &newmark, &run, NULL, NULL, &series);
    if (status != TRK_OK)
        return status;
    double *density = trk_new(c->context, c->run.segment_length / 2 + 1, sizeof *density);
    status = density ? run_targets(c, series, density, &settings, out_y) : TRK_E_MEMORY;
    trk_free(c->context, density);
    trk_series_destroy(series);
    return status;
}
