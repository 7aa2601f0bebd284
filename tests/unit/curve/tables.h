/* SPDX-License-Identifier: MIT */
/* Tables used by several tests of curves. */
#ifndef TRK_TESTS_CURVE_TABLES_H
#define TRK_TESTS_CURVE_TABLES_H

#include "support.h"
#include <truckride/curve.h>

static const char *const kind_names[] = {"PCHIP", "NOT_A_KNOT", "NATURAL", "AKIMA", "LINEAR"};
enum { KINDS = 5 };

/* Front axle damper of a heavy truck: force [N] over velocity [m/s], kinked at zero. */
enum { DAMPER_POINTS = 13 };
static const double damper_x[DAMPER_POINTS] = {-0.5, -0.4, -0.3, -0.2, -0.1, -0.05, 0.0,
                                               0.05, 0.1,  0.2,  0.3,  0.4,  0.5};
static const double damper_y[DAMPER_POINTS] = {-3500, -3000, -2700, -2500, -2000, -1000, 0,
                                               100,   200,   250,   300,   400,   500};

static inline trk_curve *new_curve(trk_context *context, int64_t count, const double *x,
                                   const double *y, trk_interpolation interpolation,
                                   trk_extrapolation extrapolation)
{
    trk_curve_options options;
    trk_curve_options_init(&options, sizeof options);
    options.interpolation = interpolation;
    options.extrapolation = extrapolation;
    trk_curve *curve = NULL;
    assert_ok(context, trk_curve_create(context, "table", count, x, y, &options, &curve));
    return curve;
}

static inline trk_curve *new_damper(trk_context *context, trk_interpolation interpolation)
{
    return new_curve(context, DAMPER_POINTS, damper_x, damper_y, interpolation,
                     TRK_EXTRAPOLATION_SLOPE);
}

#endif
