/* SPDX-License-Identifier: MIT */
/* Numbers from a PSD: normalised PSD, RMS of a band. */
#include "spectrum/settings.h"

#include <math.h>

trk_status trk_psd_normalise(trk_context *context, int64_t length, const double *density,
                             double reference, double *out_normalised, double *out_reference)
{
    static const char what[] = "trk_psd_normalise";
    TRK_REQUIRE(context, context, "trk_psd_normalise");
    TRK_REQUIRE(context, density, "trk_psd_normalise");
    TRK_REQUIRE(context, out_normalised, "trk_psd_normalise");
    trk_status status = trk_check_density(context, what, length, density);
    if (status != TRK_OK)
        return status;
    if (!(reference >= 0 && isfinite(reference)))
        return trk_fail(context, TRK_E_RANGE, "%s: reference is %g, expected >= 0 and finite", what,
                        reference);
    double maximum = 0;
    for (int64_t k = 0; k < length; k++)
        maximum = fmax(maximum, density[k]);
    const double divisor = reference > 0 ? reference : maximum;
    if (divisor == 0)
        return trk_fail(context, TRK_E_RANGE, "%s: density is 0 everywhere, expected a maximum > 0",
                        what);
    if (!isfinite(maximum / divisor))
        return trk_fail(context, TRK_E_RANGE, "%s: maximum %g divided by reference %g overflows",
                        what, maximum, divisor);
    for (int64_t k = 0; k < length; k++)
        out_normalised[k] = density[k] / divisor;
    if (out_reference)
        *out_reference = divisor;
    return TRK_OK;
}

trk_status trk_band_rms(trk_context *context, int64_t length, const double *density,
                        double frequency_step, double low, double high, double *out_rms)
{
    static const char what[] = "trk_band_rms";
    TRK_REQUIRE(context, context, "trk_band_rms");
    TRK_REQUIRE(context, density, "trk_band_rms");
    TRK_REQUIRE(context, out_rms, "trk_band_rms");
    trk_status status = trk_check_density(context, what, length, density);
    if (status == TRK_OK)
        status = trk_check_rate(context, what, "frequency_step", frequency_step);
    if (status != TRK_OK)
        return status;
    if (!(low >= 0 && high >= low && isfinite(high)))
        return trk_fail(context, TRK_E_RANGE, "%s: band is %g to %g Hz, expected 0 <= low <= high",
                        what, low, high);
    /* (SPECTRUM.8) in bins: cell k reaches from max(k - 1/2, 0) to k + 1/2. */
    const double first = low / frequency_step, last = high / frequency_step;
    double sum = 0;
    for (int64_t k = 0; k < length; k++) {
        const double bottom = k ? (double)k - 0.5 : 0.0, top = (double)k + 0.5;
        const double covered = fmin(top, last) - fmax(bottom, first);
        if (covered > 0)
            sum += density[k] * (covered / (top - bottom));
    }
    const double rms = sqrt(sum) * sqrt(frequency_step);
    if (!isfinite(rms))
        return trk_fail(context, TRK_E_RANGE, "%s: the mean square of the band overflows", what);
    *out_rms = rms;
    return TRK_OK;
}
