/* SPDX-License-Identifier: MIT */
/* Exact range of the slope, from which monotonicity follows. */
#ifndef TRK_CURVE_RANGE_H
#define TRK_CURVE_RANGE_H

/*
 * Widen *minimum .. *maximum by the slopes of the cubic between two points that has
 * slopes d0 and d1 at them and whose secant is m (CURVE.6).
 */
void trk_widen_slope_range(double d0, double d1, double m, double *minimum, double *maximum);

#endif
