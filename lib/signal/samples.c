/* SPDX-License-Identifier: MIT */
/* Equally spaced samples (SIGNAL.4). */
#include "curve/slopes.h"
#include "signal/signal.h"

static void evaluate(const trk_signal *signal, int64_t count, const double *x, double *value,
                     double *rate)
{
    const trk_samples *p = &signal->samples;
    const double last = (double)(p->count - 1);
    for (int64_t k = 0; k < count; k++) {
        double s = (x[k] - p->start) / p->spacing;
        if (s >= 0.0 && s < last) {
            int64_t i = (int64_t)s;
            const trk_sample a = p->at[i], b = p->at[i + 1];
            double t = s - (double)i, m = b.value - a.value;
            double c2 = (m - a.slope) + (m - a.slope) + (m - b.slope);
            double c3 = (a.slope - m) + (b.slope - m);
            value[k] = a.value + t * (a.slope + t * (c2 + t * c3));
            rate[k] = (a.slope + t * (2.0 * c2 + t * (3.0 * c3))) / p->spacing;
        } else {
            value[k] = s < 0.0 ? p->at[0].value : s >= last ? p->at[p->count - 1].value : s;
            rate[k] = isnan(s) ? s : 0.0;
        }
    }
}

static void destroy(trk_signal *signal)
{
    trk_free(signal->context, signal->samples.at);
}

static trk_status check(trk_context *context, int64_t count, double start, double spacing,
                        const double *values, const double *rates)
{
    int64_t least = rates ? 2 : 4, most = PTRDIFF_MAX / (int64_t)sizeof *values;
    if (count > most) /* no such array exists: do not begin to read it */
        return trk_fail(context, TRK_E_RANGE, "samples: %lld samples, expected at most %lld",
                        (long long)count, (long long)most);
    if (count < least)
        return trk_fail(context, TRK_E_RANGE,
                        "samples: %lld samples %s rates, expected at least %lld", (long long)count,
                        rates ? "with" : "without", (long long)least);
    trk_status status = trk_signal_check_finite(context, "samples", "start", start);
    if (status == TRK_OK)
        status = trk_signal_check_positive(context, "samples", "spacing", spacing);
    if (status)
        return status;
    for (int64_t k = 0; k < count; k++) {
        if (!isfinite(values[k]))
            return trk_fail(context, TRK_E_RANGE,
                            "samples: sample %lld is %g, expected a finite value", (long long)k + 1,
                            values[k]);
        if (rates && !isfinite(rates[k]))
            return trk_fail(context, TRK_E_RANGE,
                            "samples: rate %lld is %g, expected a finite value", (long long)k + 1,
                            rates[k]);
    }
    return TRK_OK;
}

/* Values and slopes per spacing, checked against overflow anywhere between the samples. */
static trk_status fill(trk_context *context, const double *values, const double *rates,
                       const double *slopes, trk_samples *p)
{
    for (int64_t k = 0; k < p->count; k++) {
        p->at[k] = (trk_sample){values[k], rates ? rates[k] * p->spacing : slopes[k]};
        double bound = fabs(p->at[k].value) + fabs(p->at[k].slope);
        if (!isfinite(32.0 * bound) || !isfinite(32.0 * bound / p->spacing))
            return trk_fail(context, TRK_E_RANGE,
                            "samples: sample %lld (%g) or its slope overflows", (long long)k + 1,
                            values[k]);
    }
    return TRK_OK;
}

static trk_status build(trk_context *context, const double *values, const double *rates,
                        trk_samples *p)
{
    p->at = trk_new(context, p->count, sizeof *p->at);
    if (!p->at)
        return TRK_E_MEMORY;
    if (rates)
        return fill(context, values, rates, NULL, p);
    double *slopes = trk_new(context, p->count, sizeof *slopes);
    if (!slopes)
        return TRK_E_MEMORY;
    trk_status status =
        trk_spline_slopes(context, TRK_INTERPOLATION_NOT_A_KNOT, p->count, NULL, values, slopes);
    if (status == TRK_OK)
        status = fill(context, values, NULL, slopes, p);
    trk_free(context, slopes);
    return status;
}

trk_status trk_signal_create_samples(trk_context *context, int64_t count, double start,
                                     double spacing, const double *values, const double *rates,
                                     trk_signal **out_signal)
{
    static const trk_signal_kind kind = {evaluate, destroy};
    TRK_REQUIRE(context, out_signal, "trk_signal_create_samples");
    *out_signal = NULL;
    if (!context)
        return TRK_E_ARGUMENT;
    TRK_REQUIRE(context, values, "trk_signal_create_samples");
    trk_status status = check(context, count, start, spacing, values, rates);
    if (status)
        return status;
    trk_signal *signal = trk_signal_new(context, &kind);
    if (!signal)
        return TRK_E_MEMORY;
    signal->samples = (trk_samples){.count = count, .start = start, .spacing = spacing};
    status = build(context, values, rates, &signal->samples);
    if (status) {
        trk_signal_destroy(signal);
        return status;
    }
    *out_signal = signal;
    return TRK_OK;
}
