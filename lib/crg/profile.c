/* SPDX-License-Identifier: MIT */
/* Heights under the wheels: signals and series over u. */
#include "crg/crg.h"
#include "signal/signal.h"

#include <math.h>

/* The surface at constant v, linear from row to row; slope: of the interval behind the sample. */
static void evaluate(const trk_signal *signal, int64_t count, const double *x, double *value,
                     double *rate)
{
    const trk_samples *s = &signal->samples;
    for (int64_t k = 0; k < count; k++) {
        const double place = (x[k] - s->start) / s->spacing;
        if (isnan(place)) {
            value[k] = rate[k] = NAN;
            continue;
        }
        const bool before = place < 0, behind = place >= (double)(s->count - 1);
        const int64_t i = before ? 0 : behind ? s->count - 1 : (int64_t)place;
        const bool inside = !before && !behind;
        value[k] = s->at[i].value + (inside ? (place - (double)i) * s->at[i].slope : 0);
        rate[k] = inside ? s->at[i].slope / s->spacing : 0;
    }
}

static void destroy(trk_signal *signal)
{
    trk_free(signal->context, signal->samples.at);
}

static trk_status create_linear(trk_context *context, const trk_crg *crg, const double *height,
                                trk_signal **out_signal)
{
    static const trk_signal_kind kind = {evaluate, destroy};
    trk_signal *signal = trk_signal_new(context, &kind);
    if (!signal)
        return TRK_E_MEMORY;
    trk_samples *s = &signal->samples;
    *s = (trk_samples){crg->rows, crg->u, crg->increment,
                       trk_new(context, crg->rows, sizeof *s->at)};
    if (!s->at) {
        trk_signal_destroy(signal);
        return TRK_E_MEMORY;
    }
    for (int64_t i = 0; i < crg->rows; i++)
        s->at[i] = (trk_sample){height[i], i + 1 < crg->rows ? height[i + 1] - height[i] : 0};
    *out_signal = signal;
    return TRK_OK;
}

trk_status trk_crg_profile(trk_context *context, const trk_crg *crg, double v, int32_t smooth,
                           trk_signal **out_signal)
{
    TRK_REQUIRE(context, out_signal, "trk_crg_profile");
    *out_signal = NULL;
    if (!context)
        return TRK_E_ARGUMENT;
    TRK_REQUIRE(context, crg, "trk_crg_profile");
    if (!isfinite(v) || smooth < 0 || smooth > 1)
        return trk_fail(
            context, TRK_E_RANGE,
            "trk_crg_profile: v is %g m, smooth %d: expected a finite place, and 0 or 1", v,
            (int)smooth);
    double *height = trk_new(context, crg->rows, sizeof *height);
    trk_status status = height ? TRK_OK : TRK_E_MEMORY;
    for (int64_t i = 0; status == TRK_OK && i < crg->rows; i++) {
        height[i] = trk_crg_row_height(crg, i, v);
        if (!isfinite(height[i]))
            status = trk_fail(context, TRK_E_RANGE,
                              "trk_crg_profile: there is no height at u = %g m, v = %g m",
                              crg->u + (double)i * crg->increment, v);
    }
    if (status == TRK_OK)
        status = smooth ? trk_signal_create_samples(context, crg->rows, crg->u, crg->increment,
                                                    height, NULL, out_signal)
                        : create_linear(context, crg, height, out_signal);
    trk_free(context, height);
    return status;
}

static trk_status fill(trk_context *context, const trk_crg *crg, int32_t paths, const double *v,
                       double spacing, trk_series *series)
{
    for (int32_t c = 1; c <= paths; c++) {
        char name[40];
        trk_format(name, sizeof name, "v=%.9g", v[c - 1]);
        if (!isfinite(v[c - 1]) || trk_series_find(series, name))
            return trk_fail(context, TRK_E_RANGE,
                            "trk_crg_sample: v[%d] is %g m, expected finite values that differ",
                            (int)c - 1, v[c - 1]);
        trk_status status = trk_series_label(series, c, name, "m");
        if (status)
            return status;
        double *z = trk_series_data_mutable(series, c);
        for (int64_t k = 0; k < trk_series_samples(series); k++) {
            const double u = trk_series_start(series) + spacing * (double)k;
            z[k] = trk_crg_height(crg, u, v[c - 1]);
            if (!isfinite(z[k]))
                return trk_fail(context, TRK_E_RANGE,
                                "trk_crg_sample: there is no height at u = %g m, v = %g m", u,
                                v[c - 1]);
        }
    }
    return TRK_OK;
}

trk_status trk_crg_sample(trk_context *context, const trk_crg *crg, int32_t paths, const double *v,
                          double start, double spacing, int64_t samples, trk_series **out_series)
{
    TRK_REQUIRE(context, out_series, "trk_crg_sample");
    *out_series = NULL;
    if (!context)
        return TRK_E_ARGUMENT;
    TRK_REQUIRE(context, crg, "trk_crg_sample");
    TRK_REQUIRE(context, v, "trk_crg_sample");
    trk_series *series;
    trk_status status = trk_series_create(context, paths, samples, 1 / spacing, start, &series);
    if (status)
        return trk_fail_within(context, status, "trk_crg_sample");
    status = fill(context, crg, paths, v, spacing, series);
    if (status) {
        trk_series_destroy(series);
        return status;
    }
    *out_series = series;
    return TRK_OK;
}
