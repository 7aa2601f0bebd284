/* SPDX-License-Identifier: MIT */
/* Sinc with a Kaiser window, in phases (SERIES.1). */
#include "series/filter.h"

#include <math.h>

static const double pi = 3.14159265358979323846;

/*
 * From 0.8 to 1.0 of the lower Nyquist frequency the response falls by 80 dB. Kaiser's
 * formulas ask for beta 7.9 and 25.1 samples of the slower rate on either side; a
 * little more of both leaves a margin for normalizing each phase.
 */
static const double kaiser_beta = 8.5, half_length = 30.0, cutoff = 0.9;

/* Modified Bessel function of order zero by its power series, which has no cancellation. */
static double bessel_i0(double x)
{
    double term = 1.0, sum = 1.0;
    for (int k = 1; term > 1e-17 * sum; k++) {
        term *= (x / (2.0 * k)) * (x / (2.0 * k));
        sum += term;
    }
    return sum;
}

/* Impulse response at a distance in input samples; reach is where the window ends. */
static double impulse(double distance, double slowness, double reach)
{
    double s = distance / reach;
    if (fabs(s) >= 1.0)
        return 0.0;
    double a = pi * cutoff * distance / slowness;
    double sinc = a == 0.0 ? 1.0 : sin(a) / a;
    return sinc * bessel_i0(kaiser_beta * sqrt((1.0 - s) * (1.0 + s)));
}

trk_status trk_filter_create(trk_context *context, int64_t up, int64_t down, trk_filter *out_filter)
{
    /* Input samples to one sample of the slower of the two rates. */
    double slowness = down > up ? (double)down / (double)up : 1.0;
    double reach = half_length * slowness;
    int64_t before = (int64_t)ceil(reach), length = 2 * before + 1;
    double *taps = trk_new(context, up * length, sizeof *taps);
    if (!taps)
        return TRK_E_MEMORY;
    for (int64_t phase = 0; phase < up; phase++) {
        double *h = taps + phase * length, sum = 0.0;
        for (int64_t j = 0; j < length; j++) {
            h[j] = impulse((double)(j - before) - (double)phase / (double)up, slowness, reach);
            sum += h[j];
        }
        for (int64_t j = 0; j < length; j++)
            h[j] /= sum; /* a constant stays what it is */
    }
    *out_filter = (trk_filter){up, down, before, length, taps};
    return TRK_OK;
}

/* Four sums, because one would wait for each addition. */
static double dot(int64_t n, const double *a, const double *b)
{
    double s0 = 0.0, s1 = 0.0, s2 = 0.0, s3 = 0.0;
    int64_t k = 0;
    for (; k + 4 <= n; k += 4) {
        s0 += a[k] * b[k];
        s1 += a[k + 1] * b[k + 1];
        s2 += a[k + 2] * b[k + 2];
        s3 += a[k + 3] * b[k + 3];
    }
    for (; k < n; k++)
        s0 += a[k] * b[k];
    return (s0 + s1) + (s2 + s3);
}

static double dot_beyond_ends(int64_t n, const double *h, int64_t count, const double *x,
                              int64_t first)
{
    double sum = 0.0;
    for (int64_t j = 0; j < n; j++) {
        int64_t i = first + j;
        sum += h[j] * x[i < 0 ? 0 : i >= count ? count - 1 : i];
    }
    return sum;
}

double trk_filter_apply(const trk_filter *filter, int64_t count, const double *x, int64_t m)
{
    int64_t place = m * filter->down, first = place / filter->up - filter->before;
    const double *h = filter->taps + place % filter->up * filter->length;
    if (first >= 0 && first + filter->length <= count)
        return dot(filter->length, h, x + first);
    return dot_beyond_ends(filter->length, h, count, x, first);
}
