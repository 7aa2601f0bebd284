/* SPDX-License-Identifier: MIT */
/* Trend of a segment: mean and least-squares slope. */
#include "spectrum/detrend.h"

enum { PARTS = 8 }; /* independent sums: less rounding, and additions need not wait */

static double total(const double *part)
{
    return ((part[0] + part[1]) + (part[2] + part[3])) +
           ((part[4] + part[5]) + (part[6] + part[7]));
}

static double mean_of(int64_t n, const double *x)
{
    double part[PARTS] = {0};
    int64_t i = 0;
    for (; i + PARTS <= n; i += PARTS)
        for (int j = 0; j < PARTS; j++)
            part[j] += x[i + j];
    for (; i < n; i++)
        part[i % PARTS] += x[i];
    return total(part) / (double)n;
}

/* About the middle of the segment mean and slope are independent, and
 * sum (i - (n - 1) / 2)^2 = n (n^2 - 1) / 12. */
static double slope_of(int64_t n, const double *x, double mean)
{
    const double count = (double)n, middle = 0.5 * (count - 1);
    double part[PARTS] = {0};
    for (int64_t i = 0; i < n; i++)
        part[i % PARTS] += ((double)i - middle) * (x[i] - mean);
    return n > 1 ? total(part) * 12.0 / (count * (count * count - 1)) : 0;
}

trk_fft_segment trk_detrend_fit(trk_detrend detrend, int64_t n, const double *x)
{
    trk_fft_segment segment = {.x = x, .mean = 0, .slope = 0, .gain = 1};
    if (detrend != TRK_DETREND_NONE)
        segment.mean = mean_of(n, x);
    if (detrend == TRK_DETREND_LINEAR)
        segment.slope = slope_of(n, x, segment.mean);
    return segment;
}
