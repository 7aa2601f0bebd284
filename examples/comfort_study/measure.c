/* SPDX-License-Identifier: MIT */
/* A run in numbers, each with its error by chance. */
#include "comfort_study.h"

#include <math.h>
#include <stdlib.h>

/* Segments of 16 s tell resonances 0.1 Hz wide apart. */
static void welch(trk_spectrum_options *out)
{
    trk_spectrum_options_init(out, sizeof *out);
    out->segment_length = 4096;
}

double *run_psd(trk_context *context, int64_t count, const double *x, int64_t *out_length,
                double *out_step)
{
    trk_spectrum_options settings;
    welch(&settings);
    *out_length = trk_psd_length(&settings, count);
    *out_step = RATE / (double)settings.segment_length;
    double *density = allocate((size_t)*out_length * sizeof *density);
    check(context, trk_psd(context, count, x, RATE, &settings, density));
    return density;
}

/*
 * The mean square of a Gaussian signal of density G over T has the variance of (int G^2 df) / T:
 * as if it were the mean of 2 B T independent squares, B = (int G df)^2 / int G^2 df
 * (Bendat and Piersol, Random Data, section 8.5). The RMS has half of the relative error.
 * The square of an estimated density is too large by its own variance: 1.056 / K over K Hann
 * segments that overlap by half (Welch).
 */
double rms_error(int64_t length, const double *density, double step, double segments,
                 double *out_freedoms)
{
    double power = 0, square = 0;
    for (int64_t k = 0; k < length; k++) {
        power += density[k] * step;
        square += density[k] * density[k] * step;
    }
    if (segments > 0)
        square /= 1 + 1.056 / segments;
    double freedoms = 2 * duration * power * power / square;
    if (out_freedoms)
        *out_freedoms = freedoms;
    return 1 / sqrt(2 * freedoms);
}

static double run_error(trk_context *context, int64_t count, const double *x, double *out_freedoms)
{
    trk_spectrum_options settings;
    int64_t length;
    double step;
    welch(&settings);
    double *density = run_psd(context, count, x, &length, &step);
    double error =
        rms_error(length, density, step, (double)trk_psd_segments(&settings, count), out_freedoms);
    free(density);
    return error;
}

const estimate *pick(const judgement *j, int which)
{
    return which < TOTAL       ? &j->weighted[which]
           : which == TOTAL    ? &j->total
           : which < FRONT_RMS ? &j->load[which - FRONT_DLC]
                               : &j->travel[which - FRONT_RMS];
}

void add_axes(trk_context *context, judgement *j)
{
    trk_axis axes[3];
    double rms[3], sum = 0;
    for (int k = 0; k < 3; k++) {
        axes[k] = axis_of(CAB_X + k);
        rms[k] = j->weighted[k].value;
        sum += j->weighted[k].value * j->weighted[k].error;
    }
    check(context,
          trk_vibration_total(context, TRK_PURPOSE_COMFORT, 3, axes, rms, &j->total.value));
    j->total.error = sum / j->total.value;
}

static void judge_cab(trk_context *context, int64_t samples, int64_t settled, const double *x,
                      judgement *out)
{
    double *weighted = allocate((size_t)samples * sizeof *weighted);
    trk_vibration felt = {.struct_size = sizeof felt};
    for (int k = 0; k < 3; k++) {
        trk_weighting weighting;
        check(context, trk_axis_get(axis_of(CAB_X + k), TRK_PURPOSE_COMFORT, &weighting, NULL));
        check(context, trk_weighting_apply(context, weighting, samples, x + (CAB_X + k) * samples,
                                           RATE, weighted));
        check(context,
              trk_vibration_measure(context, samples - settled, weighted + settled, RATE, &felt));
        out->weighted[k].value = felt.rms;
        out->weighted[k].error =
            felt.rms * run_error(context, samples - settled, weighted + settled, &out->freedoms);
    }
    out->vdv = felt.vdv;
    free(weighted);
    add_axes(context, out);
}

static void judge_axle(trk_context *context, int axle, int64_t count, const double *force,
                       const double *elongation, judgement *out)
{
    trk_load_numbers tire = {.struct_size = sizeof tire};
    trk_travel_numbers spring = {.struct_size = sizeof spring};
    double *load = allocate((size_t)count * sizeof *load);
    check(context, trk_axle_load(context, 1, count, &force, 0, load));
    check(context, trk_load_measure(context, count, load, &tire));
    out->load[axle].value = tire.dynamic_load_coefficient;
    out->load[axle].error = tire.dynamic_load_coefficient * run_error(context, count, load, NULL);
    check(context, trk_travel_measure(context, count, elongation, &spring, 0, NULL, NULL));
    out->travel[axle].value = spring.rms;
    out->travel[axle].error = spring.rms * run_error(context, count, elongation, NULL);
    out->peak[axle] = fmax(spring.maximum - spring.mean, spring.mean - spring.minimum);
    out->lift_off[axle] = tire.lift_off;
    free(load);
}

void judge_run(trk_context *context, int64_t samples, const double *x, judgement *out)
{
    const int64_t settled = (int64_t)(settling * RATE);
    judge_cab(context, samples, settled, x, out);
    for (int axle = 0; axle < AXLES; axle++)
        judge_axle(context, axle, samples - settled, x + (FRONT_TIRE + axle) * samples + settled,
                   x + (FRONT_TRAVEL + axle) * samples + settled, out);
}
