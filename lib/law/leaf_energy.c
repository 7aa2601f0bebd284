/* SPDX-License-Identifier: MIT */
/*
 * Energy of the leaf spring's friction (LAW.12d): what comes back when the force is let go
 * without turning round, down to the centre r_c(e) of its smallest cycles.
 */
#include "law/leaf.h"

#include <math.h>

/* The way back: p = |r - r_c| falls as p' = -(a + b x) - p / beta over the distance x. */
typedef struct way {
    double a, b, beta;
} way;

static double p_at(const way *w, double p, double x)
{
    return p - w->beta * w->b * x +
           (p + w->beta * w->a - w->beta * w->beta * w->b) * expm1(-x / w->beta);
}

/* Distance after which p is zero, below `most`: Newton's method, kept in its bracket by bisection. */
static double zero_of(const way *w, double p, double most)
{
    double low = 0, high = most, x = w->beta * log1p(p / (w->beta * w->a));
    for (int k = 0; k < 100; k++) {
        if (!(x > low && x < high))
            x = low + (high - low) / 2;
        double value = p_at(w, p, x);
        if (value > 0)
            low = x;
        else
            high = x;
        double next = x + value / (w->a + w->b * x + value / w->beta);
        if (fabs(next - x) <= 1e-15 * (w->beta + x) || high - low <= 1e-15 * high)
            return next;
        x = next;
    }
    return x;
}

/* What comes back on the way to p = 0, and how long the way is; it may never end. */
typedef struct recovery {
    double energy, distance;
} recovery;

/* The work of a leg: the integral of p, from p' = -(a + b x) - p / beta. */
static double work_on(const way *w, double p, double p_end, double x)
{
    return w->beta * (p - p_end - x * (w->a + w->b * x / 2));
}

/* Go back over a leg at most `length` long, which may be infinite; returns the p left at its end. */
static double go_back(const way *w, double p, double length, recovery *back)
{
    double left = isfinite(length) ? p_at(w, p, length) : 0;
    if (left > 0) {
        back->energy += work_on(w, p, left, length);
        back->distance += length;
        return left;
    }
    if (!isfinite(length) && w->a <= 0 && w->b <= 0) { /* p dies away and never ends */
        back->energy += w->beta * p;
        back->distance = INFINITY;
        return 0;
    }
    /* p' <= -(a + b x) bounds the distance. */
    double bound = w->b < 0 ? length : 2 * p / (w->a + sqrt(w->a * w->a + 2 * w->b * p));
    double x = zero_of(w, p, fmin(length, bound * (1 + 1e-12)));
    back->energy += work_on(w, p, 0, x);
    back->distance += x;
    return 0;
}

/* Difference of the approach lengths over their sum: r_c = ratio R. */
static double ratio_of(const trk_leaf_options *o)
{
    return (o->approach_bump - o->approach_rebound) / (o->approach_bump + o->approach_rebound);
}

/* Distance of r from the centre, and what comes back from there. */
static recovery recover(const trk_leaf *leaf, const double *z, double e, double *out_distance)
{
    const trk_leaf_options *o = &leaf->options;
    double sum = o->approach_bump + o->approach_rebound, width = trk_leaf_width(leaf, e);
    double q = z[TRK_LEAF_FORCE] - ratio_of(o) * width, p = fabs(q), end = leaf->end;
    double beta = q > 0 ? o->approach_bump : o->approach_rebound;
    double start = o->friction - o->friction_slope * fmin(e, end);
    way sloping = {.a = 2 * start / sum + ratio_of(o) * o->friction_slope,
                   .b = (q > 0 ? 2 : -2) * o->friction_slope / sum,
                   .beta = beta};
    way level = {.a = 2 * leaf->floor / sum, .beta = beta};
    recovery back = {0, 0};
    *out_distance = q;
    if (q > 0) {
        if (e > end)
            p = go_back(&level, p, e - end, &back);
        if (p > 0)
            go_back(&sloping, p, INFINITY, &back);
    } else if (q < 0) {
        if (e < end)
            p = go_back(&sloping, p, end - e, &back);
        if (p > 0)
            go_back(&level, p, INFINITY, &back);
    }
    return back;
}

/* Energy of the force at the centre, r_c = ratio R, from 0 to e. */
static double centre_energy(const trk_leaf *leaf, double e)
{
    const trk_leaf_options *o = &leaf->options;
    double x = fmin(e, leaf->end), level = e > leaf->end ? leaf->floor * (e - leaf->end) : 0;
    return ratio_of(o) * (x * (o->friction - o->friction_slope * x / 2) + level);
}

double trk_leaf_stored(const trk_law *law, const double *z, double e)
{
    const trk_leaf *leaf = (const trk_leaf *)law;
    double q;
    return centre_energy(leaf, e) + recover(leaf, z, e, &q).energy;
}

double trk_leaf_lost(const trk_law *law, const double *z, double e, double v)
{
    const trk_leaf *leaf = (const trk_leaf *)law;
    const trk_leaf_options *o = &leaf->options;
    double q, distance = recover(leaf, z, e, &q).distance;
    if (q * v <= 0) /* let go without loss */
        return 0;
    double back = q > 0 ? o->approach_bump : o->approach_rebound;
    double on = q > 0 ? o->approach_rebound : o->approach_bump;
    return q * v * -expm1(-distance / back) * (1 + back / on);
}
