/* SPDX-License-Identifier: MIT */
/* The same numbers of the linear truck without a run. */
#include "comfort_study.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* PSDs of all sensors at the frequencies k step, k = 0 .. count - 1, the road being level at 0. */
static double *respond(trk_context *context, const trk_model *model, int class, int speed,
                       int64_t count, double step)
{
    size_t sensors = (size_t)trk_model_count(model, TRK_PART_SENSOR), lines = (size_t)count - 1;
    double *input = road_spectra(context, model, class, speed, count, step);
    double *frequency = allocate(lines * sizeof *frequency);
    double *density = allocate(sensors * lines * sizeof *density);
    double *padded = allocate(sensors * (lines + 1) * sizeof *padded);
    for (size_t k = 0; k < lines; k++)
        frequency[k] = (double)(k + 1) * step;
    check(context,
          trk_response_psd(context, model, NULL, NULL, count - 1, frequency, input, density, NULL));
    for (size_t s = 0; s < sensors; s++) {
        padded[s * (lines + 1)] = 0;
        memcpy(padded + s * (lines + 1) + 1, density + s * lines, lines * sizeof *density);
    }
    free(density);
    free(frequency);
    free(input);
    return padded;
}

static estimate rms_of_density(trk_context *context, int64_t count, const double *density,
                               double step, double scale, double *out_freedoms)
{
    estimate e;
    check(context, trk_band_rms(context, count, density, step, 0, RATE, &e.value));
    e.value *= scale;
    e.error = e.value * rms_error(count, density, step, 0, out_freedoms);
    return e;
}

void judge_spectra(trk_context *context, int class, int speed, int damper, double step,
                   judgement *out, double **out_density)
{
    trk_model *model = create_truck(context, LINEAR, damper);
    int64_t count = road_frequencies(speed, step);
    double *density = respond(context, model, class, speed, count, step);
    double *weighted = allocate((size_t)count * sizeof *weighted);
    const double *of[CHANNELS];
    for (int c = 0; c < CHANNELS; c++)
        of[c] = density + (sensor_of(model, c) - 1) * count;
    for (int k = 0; k < 3; k++) {
        trk_weighting weighting;
        check(context, trk_axis_get(axis_of(CAB_X + k), TRK_PURPOSE_COMFORT, &weighting, NULL));
        check(context, trk_psd_weight(context, weighting, count, of[CAB_X + k], step, weighted));
        out->weighted[k] = rms_of_density(context, count, weighted, step, 1, &out->freedoms);
    }
    add_axes(context, out);
    for (int axle = 0; axle < AXLES; axle++) {
        out->load[axle] = rms_of_density(context, count, of[FRONT_TIRE + axle], step,
                                         1 / static_load(model, axle), NULL);
        out->travel[axle] = rms_of_density(context, count, of[FRONT_TRAVEL + axle], step, 1, NULL);
        out->peak[axle] = out->lift_off[axle] = NAN;
    }
    out->vdv = NAN;
    if (out_density) {
        *out_density = weighted;
        memcpy(weighted, of[CAB_Z], (size_t)count * sizeof *weighted);
    } else {
        free(weighted);
    }
    free(density);
    trk_model_destroy(model);
}
