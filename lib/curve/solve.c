/* SPDX-License-Identifier: MIT */
/* Inverse of a monotone curve: the piece by bisection, then a bracketed Newton iteration. */
#include "curve/curve.h"

/* Smallest t in (0, end] where the rising (direction 1) or falling (-1) cubic reaches y. */
static double solve_piece(const trk_piece *p, double direction, double end, double y)
{
    double low = 0.0, high = end, t = 0.5 * end, before = INFINITY;
    while (t > low && t < high) {
        double excess = direction * ((p->c0 - y) + t * (p->c1 + t * (p->c2 + t * p->c3)));
        double slope = direction * (p->c1 + t * (2.0 * p->c2 + t * (3.0 * p->c3)));
        if (excess >= 0.0)
            high = t;
        else
            low = t;
        double newton = t - excess / slope;
        if (newton == t)
            return t;
        /* Newton must stay inside and halve the excess, else halve the bracket: a triple
         * root would make it crawl. */
        bool good = newton > low && newton < high && fabs(excess) <= 0.5 * before;
        t = good ? newton : low + 0.5 * (high - low);
        before = fabs(excess);
    }
    return high;
}

/* First point of the table at or beyond y in the direction of the curve; count if none. */
static int32_t first_beyond(const trk_curve *curve, double direction, double y)
{
    int32_t low = 0, high = curve->count;
    while (low < high) {
        int32_t middle = low + (high - low) / 2;
        if (direction * (curve->y[middle] - y) < 0.0)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

trk_status trk_curve_solve(trk_context *context, const trk_curve *curve, double y, double *out_x)
{
    TRK_REQUIRE(context, curve, "trk_curve_solve");
    TRK_REQUIRE(context, out_x, "trk_curve_solve");
    *out_x = NAN;
    int32_t direction = trk_curve_monotone(curve);
    if (direction == 0)
        return trk_fail(
            context, TRK_E_RANGE,
            "curve '%s': cannot be solved, because it is not monotone (slopes %g to %g)",
            curve->name, curve->slope_minimum, curve->slope_maximum);
    double x = NAN;
    int32_t k = isfinite(y) ? first_beyond(curve, direction, y) : curve->count;
    const trk_piece *p = &curve->pieces[k];
    if (k < curve->count && curve->y[k] == y)
        x = curve->x[k];
    else if (k == 0 || k == curve->count)
        x = p->origin + (y - p->c0) / p->c1; /* not finite where the curve ends level */
    else
        x = p->origin + solve_piece(p, direction, p->upper - p->lower, y);
    if (!isfinite(x))
        return trk_fail(context, TRK_E_RANGE, "curve '%s': never takes the value %g", curve->name,
                        y);
    *out_x = x;
    return TRK_OK;
}
