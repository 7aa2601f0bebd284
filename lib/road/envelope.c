/* SPDX-License-Identifier: MIT */
/* Moving average over the contact patch (ROAD.11), and a signal of what a tire passes on. */
#include "road/envelope.h"

#include "signal/turn.h"

#include <math.h>

/* Integral of the profile from its first sample, in units of the spacing: high + low, so that the
 * difference of two is as good as a sum over what lies between. */
typedef struct area {
    double high, low;
} area;

typedef struct profile {
    int64_t count;
    const double *height;
    area *area; /* length count */
} profile;

trk_status trk_envelope_check(trk_context *context, int64_t count, double spacing,
                              const double *height, const char *name, double size)
{
    const double least = 1e-12, most = 1e12; /* far from overflow */
    if (count < 1)
        return trk_fail(context, TRK_E_RANGE, "envelope: %lld heights, expected at least 1",
                        (long long)count);
    if (!(spacing >= least && spacing <= most))
        return trk_fail(context, TRK_E_RANGE, "envelope: spacing is %g m, expected 1e-12 to 1e12",
                        spacing);
    if (!(size >= least && size <= most))
        return trk_fail(context, TRK_E_RANGE, "envelope: %s is %g m, expected 1e-12 to 1e12", name,
                        size);
    for (int64_t k = 0; k < count; k++)
        if (!(fabs(height[k]) <= most))
            return trk_fail(context, TRK_E_RANGE,
                            "envelope: height[%lld] is %g m, expected a number within 1e12",
                            (long long)k, height[k]);
    return TRK_OK;
}

static double at(const profile *p, int64_t k)
{
    return p->height[k < 0 ? 0 : k < p->count ? k : p->count - 1];
}

static void integrate(profile *p)
{
    p->area[0] = (area){0, 0};
    for (int64_t k = 1; k < p->count; k++) {
        const area before = p->area[k - 1];
        const double cell = 0.5 * (p->height[k - 1] + p->height[k]);
        const double high = before.high + cell, back = high - before.high;
        const double lost = (before.high - (high - back)) + (cell - back);
        p->area[k] = (area){high, before.low + lost};
    }
}

/* From sample a to sample b >= a, which may lie beyond the ends. */
static double area_between(const profile *p, int64_t a, int64_t b)
{
    const int64_t last = p->count - 1,
                  from = a < 0      ? 0
                         : a > last ? last
                                    : a,
                  to = b < 0      ? 0
                       : b > last ? last
                                  : b;
    double sum = (p->area[to].high - p->area[from].high) + (p->area[to].low - p->area[from].low);
    if (a < 0)
        sum += (double)((b < 0 ? b : 0) - a) * p->height[0];
    if (b > last)
        sum += (double)(b - (a > last ? a : last)) * p->height[last];
    return sum;
}

static void average(const profile *p, double spacing, double length, double *out_height,
                    double *out_slope)
{
    const double half = 0.5 * length / spacing;
    /* Longer than this the patch lies on level ground but for a share that rounding loses. */
    const double limit = 0x1p52;
    const int64_t whole = (int64_t)fmin(half, limit);
    const double rest = half < limit ? half - (double)whole : 0;
    for (int64_t k = 0; k < p->count; k++) {
        const double behind = at(p, k - whole), further_behind = at(p, k - whole - 1),
                     ahead = at(p, k + whole), further_ahead = at(p, k + whole + 1);
        const double sum = area_between(p, k - whole, k + whole) +
                           rest * (behind + 0.5 * rest * (further_behind - behind)) +
                           rest * (ahead + 0.5 * rest * (further_ahead - ahead));
        if (out_slope)
            out_slope[k] = ((ahead + rest * (further_ahead - ahead)) -
                            (behind + rest * (further_behind - behind))) /
                           length;
        out_height[k] = sum / (2 * ((double)whole + rest));
    }
}

double trk_envelope_weight(double wavenumber, double length)
{
    const double pi = 3.14159265358979323846, turns = 0.5 * wavenumber * length;
    double sine, cosine;
    trk_turn_sincos(trk_turn_fraction(turns), &sine, &cosine);
    return turns == 0 ? 1 : sine / (2 * pi * turns);
}

trk_status trk_envelope_check_arrays(trk_context *context, const double *height,
                                     const double *out_height, const double *out_slope)
{
    return height == out_height || height == out_slope || out_height == out_slope
               ? trk_fail(context, TRK_E_ARGUMENT,
                          "envelope: height, out_height and out_slope must be different arrays")
               : TRK_OK;
}

trk_status trk_envelope_average(trk_context *context, int64_t count, double spacing,
                                const double *height, double length, double *out_height,
                                double *out_slope)
{
    TRK_REQUIRE(context, context, "trk_envelope_average");
    TRK_REQUIRE(context, height, "trk_envelope_average");
    TRK_REQUIRE(context, out_height, "trk_envelope_average");
    trk_status status = trk_envelope_check_arrays(context, height, out_height, out_slope);
    if (status == TRK_OK)
        status = trk_envelope_check(context, count, spacing, height, "length", length);
    if (status != TRK_OK)
        return status;
    profile p = {count, height, trk_new(context, count, sizeof *p.area)};
    if (!p.area)
        return TRK_E_MEMORY;
    integrate(&p);
    average(&p, spacing, length, out_height, out_slope);
    trk_free(context, p.area);
    return TRK_OK;
}
