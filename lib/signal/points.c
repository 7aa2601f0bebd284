/* SPDX-License-Identifier: MIT */
/* Unequally spaced points: a monotone curve (CURVE.3), its end values held. */
#include "curve/curve.h"
#include "signal/signal.h"

static void evaluate(const trk_signal *signal, int64_t count, const double *x, double *value,
                     double *rate)
{
    int32_t hint = 0;
    for (int64_t k = 0; k < count; k++)
        trk_curve_point(signal->points, x[k], &hint, &value[k], &rate[k]);
}

static void destroy(trk_signal *signal)
{
    trk_curve_destroy(signal->points);
}

trk_status trk_signal_create_points(trk_context *context, int64_t count, const double *x,
                                    const double *values, trk_signal **out_signal)
{
    static const trk_signal_kind kind = {evaluate, destroy};
    TRK_REQUIRE(context, out_signal, "trk_signal_create_points");
    *out_signal = NULL;
    if (!context)
        return TRK_E_ARGUMENT;
    TRK_REQUIRE(context, x, "trk_signal_create_points");
    TRK_REQUIRE(context, values, "trk_signal_create_points");
    trk_signal *signal = trk_signal_new(context, &kind);
    if (!signal)
        return TRK_E_MEMORY;
    trk_curve_options options;
    trk_curve_options_init(&options, sizeof options);
    options.interpolation = TRK_INTERPOLATION_PCHIP;
    options.extrapolation = TRK_EXTRAPOLATION_CLAMP;
    trk_status status = trk_curve_create(context, "points of a signal", count, x, values, &options,
                                         &signal->points);
    if (status) {
        trk_signal_destroy(signal);
        return status;
    }
    *out_signal = signal;
    return TRK_OK;
}
