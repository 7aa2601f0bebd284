/* SPDX-License-Identifier: MIT */
/* Smooth step (SIGNAL.1). */
#include "signal/signal.h"

static void evaluate(const trk_signal *signal, int64_t count, const double *x, double *value,
                     double *rate)
{
    const trk_step p = signal->step;
    for (int64_t k = 0; k < count; k++) {
        double s = (x[k] - p.start) / p.length;
        s = s < 0.0 ? 0.0 : s > 1.0 ? 1.0 : s; /* keeps NaN */
        value[k] = p.height * (s * s * (3.0 - 2.0 * s));
        rate[k] = p.height / p.length * (6.0 * s * (1.0 - s));
    }
}

trk_status trk_signal_create_step(trk_context *context, double start, double length, double height,
                                  trk_signal **out_signal)
{
    static const trk_signal_kind kind = {evaluate, NULL};
    TRK_REQUIRE(context, out_signal, "trk_signal_create_step");
    *out_signal = NULL;
    if (!context)
        return TRK_E_ARGUMENT;
    trk_status status = trk_signal_check_finite(context, "step", "start", start);
    if (status == TRK_OK)
        status = trk_signal_check_positive(context, "step", "length", length);
    if (status == TRK_OK)
        status = trk_signal_check_finite(context, "step", "height", height);
    if (status == TRK_OK && !isfinite(2.0 * height / length))
        status = trk_fail(context, TRK_E_RANGE, "step: height %g over length %g overflows", height,
                          length);
    if (status)
        return status;
    trk_signal *signal = trk_signal_new(context, &kind);
    if (!signal)
        return TRK_E_MEMORY;
    signal->step = (trk_step){start, length, height};
    *out_signal = signal;
    return TRK_OK;
}
