/* SPDX-License-Identifier: MIT */
/* Options of spectra: defaults, checks, derived lengths. */
#include "spectrum/settings.h"

#include <math.h>

enum { DEFAULT_SEGMENT = 4096 };

static const trk_spectrum_options defaults = {
    .struct_size = sizeof(trk_spectrum_options),
    .segment_length = 0,
    .overlap = 0.5,
    .window = TRK_WINDOW_HANN,
    .detrend = TRK_DETREND_CONSTANT,
    .scaling = TRK_SCALING_DENSITY,
    .kaiser_beta = 8.6,
};

void trk_spectrum_options_init(trk_spectrum_options *options, size_t struct_size)
{
    trk_write_defaults(options, struct_size, &defaults, sizeof defaults);
}

static trk_status check_choice(trk_context *context, const char *what, const char *field,
                               int32_t value, int32_t last)
{
    if (value >= 0 && value <= last)
        return TRK_OK;
    return trk_fail(context, TRK_E_ARGUMENT, "%s: %s is %d, expected 0 to %d", what, field,
                    (int)value, (int)last);
}

static trk_status check_options(trk_context *context, const char *what,
                                const trk_spectrum_options *o)
{
    trk_status status = check_choice(context, what, "window", o->window, TRK_WINDOW_KAISER);
    if (status == TRK_OK)
        status = check_choice(context, what, "detrend", o->detrend, TRK_DETREND_LINEAR);
    if (status == TRK_OK)
        status = check_choice(context, what, "scaling", o->scaling, TRK_SCALING_SPECTRUM);
    if (status == TRK_OK)
        status = check_choice(context, what, "reserved", o->reserved, 0);
    if (status != TRK_OK)
        return status;
    if (o->segment_length < 0)
        return trk_fail(context, TRK_E_RANGE, "%s: segment_length is %lld, expected >= 0", what,
                        (long long)o->segment_length);
    if (!(o->overlap >= 0 && o->overlap < 1))
        return trk_fail(context, TRK_E_RANGE, "%s: overlap is %g, expected 0 <= overlap < 1", what,
                        o->overlap);
    if (!(o->kaiser_beta >= 0 && o->kaiser_beta <= 700))
        return trk_fail(context, TRK_E_RANGE, "%s: kaiser_beta is %g, expected 0 to 700", what,
                        o->kaiser_beta);
    return TRK_OK;
}

trk_status trk_spectrum_resolve(trk_context *context, const char *what,
                                const trk_spectrum_options *options, int64_t count,
                                trk_spectrum_settings *out_settings)
{
    trk_spectrum_options o = defaults;
    trk_status status = trk_read_options(context, what, options, &o, sizeof o);
    if (status == TRK_OK)
        status = check_options(context, what, &o);
    if (status != TRK_OK)
        return status;
    if (count < 1)
        return trk_fail(context, TRK_E_RANGE, "%s: count is %lld samples, expected >= 1", what,
                        (long long)count);
    if (o.segment_length == 0)
        o.segment_length = count < DEFAULT_SEGMENT ? count : DEFAULT_SEGMENT;
    if (count < o.segment_length)
        return trk_fail(context, TRK_E_RANGE,
                        "%s: count is %lld samples, expected at least one segment of %lld", what,
                        (long long)count, (long long)o.segment_length);
    int64_t shared = (int64_t)floor(o.overlap * (double)o.segment_length);
    if (shared > o.segment_length - 1) /* overlap next to 1 may round up */
        shared = o.segment_length - 1;
    const int64_t step = o.segment_length - shared;
    *out_settings = (trk_spectrum_settings){
        .options = o,
        .step = step,
        .segments = (count - o.segment_length) / step + 1,
        .length = o.segment_length / 2 + 1,
    };
    return TRK_OK;
}

trk_status trk_check_rate(trk_context *context, const char *what, const char *name, double rate)
{
    if (rate > 0 && isfinite(rate))
        return TRK_OK;
    return trk_fail(context, TRK_E_RANGE, "%s: %s is %g Hz, expected > 0 and finite", what, name,
                    rate);
}

trk_status trk_check_samples(trk_context *context, const char *what, const char *name,
                             int64_t count, const double *x)
{
    for (int64_t i = 0; i < count; i++)
        if (!isfinite(x[i]))
            return trk_fail(context, TRK_E_RANGE, "%s: %s[%lld] is %g, expected finite samples",
                            what, name, (long long)i, x[i]);
    return TRK_OK;
}

trk_status trk_check_density(trk_context *context, const char *what, int64_t length,
                             const double *density)
{
    if (length < 1)
        return trk_fail(context, TRK_E_RANGE, "%s: length is %lld, expected >= 1", what,
                        (long long)length);
    for (int64_t k = 0; k < length; k++)
        if (!(density[k] >= 0 && isfinite(density[k])))
            return trk_fail(context, TRK_E_RANGE,
                            "%s: density[%lld] is %g, expected finite values >= 0", what,
                            (long long)k, density[k]);
    return TRK_OK;
}
