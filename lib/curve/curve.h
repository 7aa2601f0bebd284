/* SPDX-License-Identifier: MIT */
/* Inside of a curve: one cubic a piece, evaluated in line by laws and signals. */
#ifndef TRK_CURVE_CURVE_H
#define TRK_CURVE_CURVE_H

#include <math.h>

#include "base/base.h"
#include <truckride/curve.h>

/*
 * y = c0 + t (c1 + t (c2 + t c3)), t = x - origin, for lower <= x < upper (CURVE.1).
 * Padded to a cache line, so that a lookup touches one.
 */
typedef struct trk_piece {
    _Alignas(64) double lower;
    double upper, origin, c0, c1, c2, c3;
} trk_piece;

struct trk_curve {
    trk_context *context;
    char *name;
    trk_interpolation interpolation;
    trk_extrapolation extrapolation;
    int32_t count;                       /* points of the table */
    double *x, *y;                       /* the table, length count */
    double slope_minimum, slope_maximum; /* over the whole real line */
    /* Length count + 1: piece 0 lies before the first point, piece k between the points
     * k - 1 and k (0-based), piece count after the last; the outer two are straight. */
    trk_piece *pieces;
};

/* Number of the piece that holds x, looking at the neighbours of `hint` (0 .. count) first.
 * A NaN is given to piece 1, whose polynomial hands it on. */
int32_t trk_curve_locate(const trk_curve *curve, double x, int32_t hint);

/*
 * Value and slope at x. *hint is the piece used last, 0 at first; it changes the
 * time needed, never the result. At a corner the slope is the one to the right.
 */
static inline void trk_curve_point(const trk_curve *curve, double x, int32_t *hint, double *value,
                                   double *slope)
{
    const trk_piece *p = &curve->pieces[*hint];
    if (!(x >= p->lower && x < p->upper)) {
        *hint = trk_curve_locate(curve, x, *hint);
        p = &curve->pieces[*hint];
    }
    double t = x - p->origin;
    if (*hint == 0 || *hint == curve->count) {
        *value = p->c1 != 0.0 ? p->c0 + t * p->c1 : p->c0; /* t may be infinite */
        *slope = p->c1;
    } else {
        *value = p->c0 + t * (p->c1 + t * (p->c2 + t * p->c3));
        *slope = p->c1 + t * (2.0 * p->c2 + t * (3.0 * p->c3));
    }
}

#endif
