/* SPDX-License-Identifier: MIT */
/* Weighting in the frequency domain: PSDs and third octaves (COMFORT.2 to COMFORT.4). */
#include "comfort/check.h"
#include "comfort/weighting.h"
#include "spectrum/settings.h"

#include <math.h>

enum { BAND_LIMIT = 60 };

trk_status trk_psd_weight(trk_context *context, trk_weighting weighting, int64_t length,
                          const double *density, double frequency_step, double *out_density)
{
    static const char what[] = "trk_psd_weight";
    TRK_REQUIRE(context, context, "trk_psd_weight");
    TRK_REQUIRE(context, density, "trk_psd_weight");
    TRK_REQUIRE(context, out_density, "trk_psd_weight");
    const trk_weighting_parameters *p;
    trk_status status = trk_weighting_check(context, what, weighting, &p);
    if (status == TRK_OK)
        status = trk_check_density(context, what, length, density);
    if (status == TRK_OK)
        status = trk_check_rate(context, what, "frequency_step", frequency_step);
    if (status != TRK_OK)
        return status;
    for (int64_t k = 0; k < length; k++) {
        double factor = cabs(trk_weighting_analogue(p, (double)k * frequency_step));
        out_density[k] = density[k] * factor * factor;
    }
    return TRK_OK;
}

double trk_third_octave_centre(int32_t band)
{
    return pow(10, band / 10.0);
}

static trk_status check_bands(trk_context *context, const char *what, int32_t first, int32_t bands)
{
    if (first < -BAND_LIMIT || first > BAND_LIMIT)
        return trk_fail(context, TRK_E_RANGE, "%s: first_band is %d, expected %d to %d", what,
                        (int)first, -BAND_LIMIT, BAND_LIMIT);
    if (bands < 1 || bands > BAND_LIMIT - first + 1)
        return trk_fail(context, TRK_E_RANGE, "%s: bands is %d, expected 1 to %d", what, (int)bands,
                        BAND_LIMIT - (int)first + 1);
    return TRK_OK;
}

trk_status trk_third_octave_rms(trk_context *context, int64_t length, const double *density,
                                double frequency_step, int32_t first_band, int32_t bands,
                                double *out_rms)
{
    static const char what[] = "trk_third_octave_rms";
    TRK_REQUIRE(context, context, "trk_third_octave_rms");
    TRK_REQUIRE(context, density, "trk_third_octave_rms");
    TRK_REQUIRE(context, out_rms, "trk_third_octave_rms");
    trk_status status = check_bands(context, what, first_band, bands);
    for (int32_t k = 0; status == TRK_OK && k < bands; k++) {
        double low = pow(10, (first_band + k - 0.5) / 10);
        double high = pow(10, (first_band + k + 0.5) / 10);
        status = trk_band_rms(context, length, density, frequency_step, low, high, &out_rms[k]);
        if (status != TRK_OK)
            return trk_fail_within(context, status, "%s", what);
    }
    return status;
}

trk_status trk_third_octave_weight(trk_context *context, trk_weighting weighting,
                                   int32_t first_band, int32_t bands, const double *rms,
                                   double *out_rms)
{
    static const char what[] = "trk_third_octave_weight";
    TRK_REQUIRE(context, context, "trk_third_octave_weight");
    TRK_REQUIRE(context, rms, "trk_third_octave_weight");
    TRK_REQUIRE(context, out_rms, "trk_third_octave_weight");
    const trk_weighting_parameters *p;
    trk_status status = trk_weighting_check(context, what, weighting, &p);
    if (status == TRK_OK)
        status = check_bands(context, what, first_band, bands);
    for (int32_t k = 0; status == TRK_OK && k < bands; k++)
        status = trk_comfort_check_value(context, what, "rms", rms[k], 0);
    if (status != TRK_OK)
        return status;
    double sum = 0;
    for (int32_t k = 0; k < bands; k++) {
        double a =
            rms[k] * cabs(trk_weighting_analogue(p, trk_third_octave_centre(first_band + k)));
        sum += a * a;
    }
    *out_rms = sqrt(sum);
    return TRK_OK;
}
