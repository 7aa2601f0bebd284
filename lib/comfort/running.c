/* SPDX-License-Identifier: MIT */
/* Running RMS (COMFORT.6). */
#include "comfort/running.h"
#include "comfort/check.h"
#include "spectrum/settings.h"

#include <math.h>

trk_status trk_running_create(trk_context *context, const char *what, double sample_rate,
                              double integration_time, trk_running *out_running)
{
    *out_running = (trk_running){.length = 0};
    trk_status status = trk_check_rate(context, what, "sample_rate", sample_rate);
    if (status == TRK_OK)
        status = trk_comfort_check_positive(context, what, "integration_time", integration_time);
    if (status != TRK_OK)
        return status;
    double samples = sample_rate * integration_time;
    if (!(samples <= 1e9))
        return trk_fail(context, TRK_E_RANGE,
                        "%s: integration_time is %g s, %g samples, expected at most 1e9", what,
                        integration_time, samples);
    int64_t length = samples < 1 ? 1 : (int64_t)rint(samples);
    double *square = trk_new(context, length, sizeof *square);
    if (!square)
        return TRK_E_MEMORY;
    *out_running = (trk_running){.length = length, .square = square, .decay = -expm1(-1 / samples)};
    return TRK_OK;
}

void trk_running_destroy(trk_context *context, trk_running *running)
{
    trk_free(context, running->square);
}

void trk_running_reset(trk_running *running)
{
    for (int64_t k = 0; k < running->length; k++)
        running->square[k] = 0;
    running->place = 0;
    running->present = running->exponential = 0;
}

double trk_running_linear(trk_running *running, double x)
{
    double *square = running->square;
    int64_t k = running->place;
    running->present += x * x;
    double sum = running->present + (k + 1 < running->length ? square[k + 1] : 0);
    square[k] = x * x;
    running->place = k + 1;
    if (running->place == running->length) {
        for (int64_t j = running->length - 1; j > 0; j--)
            square[j - 1] += square[j];
        running->place = 0;
        running->present = 0;
    }
    return sum / (double)running->length;
}

double trk_running_exponential(trk_running *running, double x)
{
    running->exponential += running->decay * (x * x - running->exponential);
    return running->exponential;
}

trk_status trk_running_rms(trk_context *context, trk_averaging averaging, int64_t count,
                           const double *x, double sample_rate, double integration_time,
                           double *out_rms)
{
    static const char what[] = "trk_running_rms";
    TRK_REQUIRE(context, context, "trk_running_rms");
    TRK_REQUIRE(context, x, "trk_running_rms");
    TRK_REQUIRE(context, out_rms, "trk_running_rms");
    if (averaging != TRK_AVERAGING_LINEAR && averaging != TRK_AVERAGING_EXPONENTIAL)
        return trk_fail(context, TRK_E_ARGUMENT, "%s: averaging is %d, expected 0 or 1", what,
                        (int)averaging);
    trk_status status = trk_comfort_check_samples(context, what, "x", 0, count, x);
    if (status != TRK_OK)
        return status;
    trk_running running;
    status = trk_running_create(context, what, sample_rate, integration_time, &running);
    if (status != TRK_OK)
        return status;
    if (averaging == TRK_AVERAGING_LINEAR)
        for (int64_t i = 0; i < count; i++)
            out_rms[i] = sqrt(trk_running_linear(&running, x[i]));
    else
        for (int64_t i = 0; i < count; i++)
            out_rms[i] = sqrt(trk_running_exponential(&running, x[i]));
    trk_running_destroy(context, &running);
    return TRK_OK;
}
