/* SPDX-License-Identifier: MIT */
/* Public spectra: PSD, cross spectrum, coherence, H1. */
#include "spectrum/welch.h"

int64_t trk_psd_length(const trk_spectrum_options *options, int64_t count)
{
    trk_spectrum_settings settings;
    trk_status status = trk_spectrum_resolve(NULL, "trk_psd_length", options, count, &settings);
    return status == TRK_OK ? settings.length : 0;
}

int64_t trk_psd_segments(const trk_spectrum_options *options, int64_t count)
{
    trk_spectrum_settings settings;
    trk_status status = trk_spectrum_resolve(NULL, "trk_psd_segments", options, count, &settings);
    return status == TRK_OK ? settings.segments : 0;
}

trk_status trk_psd_frequencies(trk_context *context, int64_t count, double sample_rate,
                               const trk_spectrum_options *options, double *out_frequency)
{
    static const char what[] = "trk_psd_frequencies";
    TRK_REQUIRE(context, context, "trk_psd_frequencies");
    TRK_REQUIRE(context, out_frequency, "trk_psd_frequencies");
    trk_spectrum_settings settings;
    trk_status status = trk_check_rate(context, what, "sample_rate", sample_rate);
    if (status == TRK_OK)
        status = trk_spectrum_resolve(context, what, options, count, &settings);
    if (status != TRK_OK)
        return status;
    for (int64_t k = 0; k < settings.length; k++)
        out_frequency[k] = (double)k * (sample_rate / (double)settings.options.segment_length);
    return TRK_OK;
}

trk_status trk_psd(trk_context *context, int64_t count, const double *x, double sample_rate,
                   const trk_spectrum_options *options, double *out_density)
{
    TRK_REQUIRE(context, context, "trk_psd");
    TRK_REQUIRE(context, x, "trk_psd");
    TRK_REQUIRE(context, out_density, "trk_psd");
    trk_welch welch;
    trk_status status = trk_check_rate(context, "trk_psd", "sample_rate", sample_rate);
    if (status == TRK_OK)
        status =
            trk_welch_average(context, "trk_psd", count, x, NULL, options, TRK_WELCH_XX, &welch);
    if (status != TRK_OK)
        return status;
    status = trk_welch_write(&welch.plan, "trk_psd", sample_rate, 1, welch.xx, out_density);
    trk_welch_free(&welch);
    return status;
}

trk_status trk_csd(trk_context *context, int64_t count, const double *x, const double *y,
                   double sample_rate, const trk_spectrum_options *options, double *out_cross)
{
    TRK_REQUIRE(context, context, "trk_csd");
    TRK_REQUIRE(context, x, "trk_csd");
    TRK_REQUIRE(context, y, "trk_csd");
    TRK_REQUIRE(context, out_cross, "trk_csd");
    trk_welch welch;
    trk_status status = trk_check_rate(context, "trk_csd", "sample_rate", sample_rate);
    if (status == TRK_OK)
        status = trk_welch_average(context, "trk_csd", count, x, y, options, TRK_WELCH_XY, &welch);
    if (status != TRK_OK)
        return status;
    status = trk_welch_write(&welch.plan, "trk_csd", sample_rate, 2, welch.xy, out_cross);
    trk_welch_free(&welch);
    return status;
}

trk_status trk_coherence(trk_context *context, int64_t count, const double *x, const double *y,
                         const trk_spectrum_options *options, double *out_coherence)
{
    TRK_REQUIRE(context, context, "trk_coherence");
    TRK_REQUIRE(context, x, "trk_coherence");
    TRK_REQUIRE(context, y, "trk_coherence");
    TRK_REQUIRE(context, out_coherence, "trk_coherence");
    trk_welch welch;
    trk_status status = trk_welch_average(context, "trk_coherence", count, x, y, options,
                                          TRK_WELCH_XX | TRK_WELCH_YY | TRK_WELCH_XY, &welch);
    if (status != TRK_OK)
        return status;
    for (int64_t k = 0; k < welch.plan.settings.length; k++) {
        const double re = welch.xy[2 * k], im = welch.xy[2 * k + 1];
        /* Divided in turn: the product of two small powers may underflow. */
        out_coherence[k] =
            (re / welch.xx[k]) * (re / welch.yy[k]) + (im / welch.xx[k]) * (im / welch.yy[k]);
    }
    trk_welch_free(&welch);
    return TRK_OK;
}

trk_status trk_frf_h1(trk_context *context, int64_t count, const double *x, const double *y,
                      const trk_spectrum_options *options, double *out_response)
{
    TRK_REQUIRE(context, context, "trk_frf_h1");
    TRK_REQUIRE(context, x, "trk_frf_h1");
    TRK_REQUIRE(context, y, "trk_frf_h1");
    TRK_REQUIRE(context, out_response, "trk_frf_h1");
    trk_welch welch;
    trk_status status = trk_welch_average(context, "trk_frf_h1", count, x, y, options,
                                          TRK_WELCH_XX | TRK_WELCH_XY, &welch);
    if (status != TRK_OK)
        return status;
    for (int64_t k = 0; k < 2 * welch.plan.settings.length; k++)
        out_response[k] = welch.xy[k] / welch.xx[k / 2];
    trk_welch_free(&welch);
    return TRK_OK;
}
