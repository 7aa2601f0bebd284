/* SPDX-License-Identifier: MIT */
/* The low-pass of the resampler, one set of taps for each phase (SERIES.1). */
#ifndef TRK_SERIES_FILTER_H
#define TRK_SERIES_FILTER_H

#include "base/base.h"

/*
 * Resampling by up/down (in lowest terms). Output m lies at m * down / up input
 * samples; with i the whole part and f the remaining phase in 0 .. up - 1,
 *     y[m] = sum over j of taps[f * length + j] * x[i - before + j],  0 <= j < length
 */
typedef struct trk_filter {
    int64_t up, down, before, length;
    double *taps; /* length up * length; each phase sums to 1 */
} trk_filter;

trk_status trk_filter_create(trk_context *context, int64_t up, int64_t down,
                             trk_filter *out_filter);

/* One output; beyond its ends x (length count) is continued by its end values. */
double trk_filter_apply(const trk_filter *filter, int64_t count, const double *x, int64_t m);

#endif
