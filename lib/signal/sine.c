/* SPDX-License-Identifier: MIT */
/* Sine (SIGNAL.2). */
#include "signal/signal.h"
#include "signal/turn.h"

static const double pi = 3.14159265358979323846;

static void evaluate(const trk_signal *signal, int64_t count, const double *x, double *value,
                     double *rate)
{
    const trk_sine p = signal->sine;
    const double peak_rate = 2.0 * pi * p.frequency * p.amplitude;
    for (int64_t k = 0; k < count; k++) {
        double t = x[k] - p.start, sine, cosine;
        /* Whole turns are dropped before the phase is added, which may be small beside them. */
        double turns = trk_turn_fraction(p.frequency * t) + p.phase_turns;
        trk_turn_sincos(trk_turn_fraction(turns), &sine, &cosine);
        double v = p.amplitude * sine, r = peak_rate * cosine;
        value[k] = t < 0.0 ? 0.0 : v;
        rate[k] = t < 0.0 ? 0.0 : r;
    }
}

trk_status trk_signal_create_sine(trk_context *context, double amplitude, double frequency,
                                  double phase, double start, trk_signal **out_signal)
{
    static const trk_signal_kind kind = {evaluate, NULL};
    TRK_REQUIRE(context, out_signal, "trk_signal_create_sine");
    *out_signal = NULL;
    if (!context)
        return TRK_E_ARGUMENT;
    trk_status status = trk_signal_check_finite(context, "sine", "amplitude", amplitude);
    if (status == TRK_OK)
        status = trk_signal_check_positive(context, "sine", "frequency", frequency);
    if (status == TRK_OK)
        status = trk_signal_check_finite(context, "sine", "phase", phase);
    if (status == TRK_OK)
        status = trk_signal_check_finite(context, "sine", "start", start);
    if (status == TRK_OK && !isfinite(2.0 * pi * frequency * amplitude))
        status = trk_fail(context, TRK_E_RANGE, "sine: amplitude %g at frequency %g overflows",
                          amplitude, frequency);
    if (status)
        return status;
    trk_signal *signal = trk_signal_new(context, &kind);
    if (!signal)
        return TRK_E_MEMORY;
    signal->sine = (trk_sine){start, amplitude, frequency, trk_turn_fraction(phase / (2.0 * pi))};
    *out_signal = signal;
    return TRK_OK;
}
