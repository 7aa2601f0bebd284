/* SPDX-License-Identifier: MIT */
/* Slopes at the points of a table, from which the cubic between two points follows. */
#ifndef TRK_CURVE_SLOPES_H
#define TRK_CURVE_SLOPES_H

#include "base/base.h"
#include <truckride/curve.h>

/* All: count >= 2, x strictly increasing; two points give the straight line. */

/* Monotone slopes (CURVE.3): Fritsch and Butland inside, limited three-point ends. */
void trk_pchip_slopes(int64_t count, const double *x, const double *y, double *out_slopes);

/* Akima's slopes (CURVE.4). */
void trk_akima_slopes(int64_t count, const double *x, const double *y, double *out_slopes);

/*
 * Slopes of the C2 cubic spline (CURVE.5) in O(count); kind is NOT_A_KNOT (three
 * points: the parabola) or NATURAL. x NULL: unit spacing. TRK_E_MEMORY: no memory.
 */
trk_status trk_spline_slopes(trk_context *context, trk_interpolation kind, int64_t count,
                             const double *x, const double *y, double *out_slopes);

#endif
