/* SPDX-License-Identifier: MIT */
/* Another sample rate over the same time span (SERIES.1). */
#include "series/filter.h"
#include "series/series.h"

#include <math.h>
#include <string.h>

enum { LARGEST_FACTOR = 1000 };

/* Smallest q with ratio = p / q to rounding; false if there is none. */
static bool find_ratio(double ratio, int64_t *p, int64_t *q)
{
    for (*q = 1; *q <= LARGEST_FACTOR; ++*q) {
        double scaled = ratio * (double)*q, whole = rint(scaled);
        if (whole >= 1.0 && whole <= LARGEST_FACTOR && fabs(scaled - whole) <= 1e-12 * whole) {
            *p = (int64_t)whole;
            return true;
        }
    }
    return false;
}

static trk_status fill(trk_context *context, int64_t up, int64_t down, const trk_series *from,
                       trk_series *to)
{
    if (up == down) { /* nothing to filter: the samples themselves */
        for (int32_t c = 0; c < from->channels; c++)
            memcpy(to->channel[c].data, from->channel[c].data,
                   (size_t)from->samples * sizeof(double));
        return TRK_OK;
    }
    trk_filter filter;
    trk_status status = trk_filter_create(context, up, down, &filter);
    if (status)
        return status;
    for (int32_t c = 0; c < from->channels; c++)
        for (int64_t m = 0; m < to->samples; m++)
            to->channel[c].data[m] =
                trk_filter_apply(&filter, from->samples, from->channel[c].data, m);
    trk_free(context, filter.taps);
    return TRK_OK;
}

trk_status trk_series_resample(trk_context *context, const trk_series *series, double sample_rate,
                               trk_series **out_series)
{
    TRK_REQUIRE(context, out_series, "trk_series_resample");
    *out_series = NULL;
    if (!context)
        return TRK_E_ARGUMENT;
    TRK_REQUIRE(context, series, "trk_series_resample");
    int64_t up, down;
    if (!isfinite(sample_rate) || sample_rate <= 0.0 ||
        !find_ratio(sample_rate / series->sample_rate, &up, &down))
        return trk_fail(
            context, TRK_E_RANGE,
            "series: sample_rate %.17g Hz over the old %.17g Hz is no ratio of numbers up to %d",
            sample_rate, series->sample_rate, LARGEST_FACTOR);
    if (series->samples > INT64_MAX / (2 * LARGEST_FACTOR))
        return trk_fail(context, TRK_E_RANGE, "series: too many samples (%lld) to resample",
                        (long long)series->samples);
    trk_series *other;
    int64_t samples = (series->samples - 1) * up / down + 1;
    trk_status status = trk_series_create_like(context, series, samples, sample_rate, &other);
    if (status)
        return status;
    status = fill(context, up, down, series, other);
    if (status) {
        trk_series_destroy(other);
        return status;
    }
    *out_series = other;
    return TRK_OK;
}
