/* SPDX-License-Identifier: MIT */
/* What all kinds of signal share. */
#include "signal/signal.h"

trk_signal *trk_signal_new(trk_context *context, const trk_signal_kind *kind)
{
    trk_signal *signal = trk_new(context, 1, sizeof *signal);
    if (signal) {
        signal->kind = kind;
        signal->context = context;
    }
    return signal;
}

trk_status trk_signal_check_finite(trk_context *context, const char *what, const char *name,
                                   double value)
{
    if (isfinite(value))
        return TRK_OK;
    return trk_fail(context, TRK_E_RANGE, "%s: %s is %g, expected a finite value", what, name,
                    value);
}

trk_status trk_signal_check_positive(trk_context *context, const char *what, const char *name,
                                     double value)
{
    if (isfinite(value) && value > 0.0)
        return TRK_OK;
    return trk_fail(context, TRK_E_RANGE, "%s: %s is %g, expected a finite value > 0", what, name,
                    value);
}

void trk_signal_destroy(trk_signal *signal)
{
    if (!signal)
        return;
    if (signal->kind->destroy)
        signal->kind->destroy(signal);
    trk_free(signal->context, signal);
}

double trk_signal_value(const trk_signal *signal, double x)
{
    double value = NAN, rate;
    if (signal)
        signal->kind->evaluate(signal, 1, &x, &value, &rate);
    return value;
}

double trk_signal_rate(const trk_signal *signal, double x)
{
    double value, rate = NAN;
    if (signal)
        signal->kind->evaluate(signal, 1, &x, &value, &rate);
    return rate;
}

void trk_signal_evaluate(const trk_signal *signal, int64_t count, double start, double spacing,
                         double *out_value, double *out_rate)
{
    double x[TRK_SIGNAL_BLOCK], value[TRK_SIGNAL_BLOCK], rate[TRK_SIGNAL_BLOCK];
    for (int64_t first = 0; signal && first < count; first += TRK_SIGNAL_BLOCK) {
        int64_t n = count - first < TRK_SIGNAL_BLOCK ? count - first : TRK_SIGNAL_BLOCK;
        for (int64_t k = 0; k < n; k++)
            x[k] = start + (double)(first + k) * spacing;
        signal->kind->evaluate(signal, n, x, out_value ? out_value + first : value,
                               out_rate ? out_rate + first : rate);
    }
}
