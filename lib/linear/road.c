/* SPDX-License-Identifier: MIT */
/* Cross spectra of the wheels on a homogeneous road (LINEAR.9), of ISO 8608 (LINEAR.30). */
#include "model/model.h"

#include <truckride/linear.h>

#include <float.h>
#include <math.h>
#include <string.h>

static const double two_pi = 6.283185307179586476925286766559, largest = DBL_MAX;

static trk_status fail_speed(trk_context *context, double speed)
{
    return trk_fail(context, TRK_E_RANGE,
                    "road spectra: speed is %g m/s; a finite number > 0 is needed", speed);
}

static trk_status check(trk_context *context, const char *what, int64_t count, const double *values,
                        double low, double high, const char *needed)
{
    for (int64_t k = 0; values && k < count; k++)
        if (!(values[k] >= low && values[k] <= high))
            return trk_fail(context, TRK_E_RANGE, "road spectra: %s[%lld] is %g; %s is needed",
                            what, (long long)k, values[k], needed);
    return TRK_OK;
}

/* The entries of all pairs of wheels at one frequency. */
static void fill(const trk_model *model, double wave_number, double density, double coherence,
                 double *out)
{
    int32_t roads = trk_model_count(model, TRK_PART_ROAD);
    int32_t inputs = roads + trk_model_count(model, TRK_PART_PORT);
    memset(out, 0, 2 * (size_t)inputs * (size_t)inputs * sizeof *out);
    if (density == 0)
        return; /* where the wave number may overflow */
    for (int32_t i = 0; i < roads; i++)
        for (int32_t j = 0; j < roads; j++) {
            bool one_side = (model->road_y[i] >= 0) == (model->road_y[j] >= 0);
            double size = density * (one_side ? 1 : coherence);
            double phase = wave_number * (model->road_x[j] - model->road_x[i]);
            out[2 * ((int64_t)i * inputs + j)] = size * cos(phase);
            out[2 * ((int64_t)i * inputs + j) + 1] = size * sin(phase);
        }
}

trk_status trk_road_cross_spectra(trk_context *context, const trk_model *model, int64_t count,
                                  const double *frequency, const double *density, double speed,
                                  const double *coherence, double *out_input)
{
    TRK_REQUIRE(context, context, "trk_road_cross_spectra");
    TRK_REQUIRE(context, model, "trk_road_cross_spectra");
    TRK_REQUIRE(context, frequency, "trk_road_cross_spectra");
    TRK_REQUIRE(context, density, "trk_road_cross_spectra");
    TRK_REQUIRE(context, out_input, "trk_road_cross_spectra");
    trk_status status =
        check(context, "frequency", count, frequency, 0, largest, "a finite number >= 0");
    if (status == TRK_OK)
        status = check(context, "density", count, density, 0, largest, "a finite number >= 0");
    if (status == TRK_OK)
        status = check(context, "coherence", count, coherence, 0, 1, "0 to 1");
    if (status == TRK_OK && !(speed > 0 && speed <= largest))
        status = fail_speed(context, speed);
    int64_t inputs =
        (int64_t)trk_model_count(model, TRK_PART_ROAD) + trk_model_count(model, TRK_PART_PORT);
    for (int64_t k = 0; status == TRK_OK && k < count; k++)
        fill(model, two_pi * frequency[k] / speed, density[k], coherence ? coherence[k] : 1,
             out_input + 2 * k * inputs * inputs);
    return status;
}

trk_status trk_road_input_spectra(trk_context *context, const trk_model *model,
                                  const trk_road_options *road, double speed, int64_t count,
                                  const double *frequency, double *out_input)
{
    TRK_REQUIRE(context, context, "trk_road_input_spectra");
    TRK_REQUIRE(context, model, "trk_road_input_spectra");
    TRK_REQUIRE(context, frequency, "trk_road_input_spectra");
    TRK_REQUIRE(context, out_input, "trk_road_input_spectra");
    if (count < 0)
        return trk_fail(context, TRK_E_RANGE, "road spectra: count is %lld; at least 0 is needed",
                        (long long)count);
    if (!(speed > 0 && speed <= largest))
        return fail_speed(context, speed);
    trk_status status =
        check(context, "frequency", count, frequency, 0, largest, "a finite number >= 0");
    if (status != TRK_OK)
        return status;
    double *wavenumber = trk_new(context, count, sizeof *wavenumber);
    double *density = trk_new(context, count, sizeof *density);
    double *coherence = trk_new(context, count, sizeof *coherence);
    status = wavenumber && density && coherence ? TRK_OK : TRK_E_MEMORY;
    for (int64_t k = 0; status == TRK_OK && k < count; k++)
        wavenumber[k] = frequency[k] / speed;
    if (status == TRK_OK)
        status = trk_road_density(context, road, count, wavenumber, density);
    if (status == TRK_OK)
        status = trk_road_coherence(context, road, count, wavenumber, coherence);
    for (int64_t k = 0; status == TRK_OK && k < count; k++)
        density[k] /= speed;
    if (status == TRK_OK)
        status = trk_road_cross_spectra(context, model, count, frequency, density, speed, coherence,
                                        out_input);
    trk_free(context, wavenumber);
    trk_free(context, density);
    trk_free(context, coherence);
    return status;
}
