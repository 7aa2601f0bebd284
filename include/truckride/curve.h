/* SPDX-License-Identifier: MIT */
/**
 * @file  truckride/curve.h
 * @brief Smooth curve through a table: damper force over velocity, spring force over elongation.
 *
 * A piecewise cubic y(x) through the points of a table, beyond the table
 * continued as asked (CURVE.1, CURVE.2). Interpolations:
 *
 *  | interpolation  | continuity | overshoot at a kink | use                                   |
 *  |----------------|-----------|---------------------|---------------------------------------|
 *  | PCHIP          | C1        | never               | default; keeps monotone tables monotone |
 *  | NOT_A_KNOT     | C2        | yes                 | what MATLAB's spline does; the thesis |
 *  | NATURAL        | C2        | yes                 | zero curvature at both ends           |
 *  | AKIMA          | C1        | little              | measured tables with outliers         |
 *  | LINEAR         | C0        | never               | exact table lookup                    |
 *
 * A curve is immutable and may be shared by threads.
 */
#ifndef TRUCKRIDE_CURVE_H
#define TRUCKRIDE_CURVE_H

#include <truckride/base.h>

/** A curve; immutable. */
typedef struct trk_curve trk_curve;

/** Interpolation between the points of the table; see the table above. */
typedef int32_t trk_interpolation;
enum {
    TRK_INTERPOLATION_PCHIP      = 0,
    TRK_INTERPOLATION_NOT_A_KNOT = 1,
    TRK_INTERPOLATION_NATURAL    = 2,
    TRK_INTERPOLATION_AKIMA      = 3,
    TRK_INTERPOLATION_LINEAR     = 4
};

/** What follows beyond the first and last point. */
typedef int32_t trk_extrapolation;
enum {
    TRK_EXTRAPOLATION_SLOPE = 0, /**< straight on with the slope at the end */
    TRK_EXTRAPOLATION_CLAMP = 1  /**< constant at the end value             */
};

/** Options of trk_curve_create(). */
typedef struct trk_curve_options {
    size_t            struct_size;   /**< [byte] set by trk_curve_options_init() */
    trk_interpolation interpolation; /**< [-] default TRK_INTERPOLATION_PCHIP   */
    trk_extrapolation extrapolation; /**< [-] default TRK_EXTRAPOLATION_SLOPE   */
} trk_curve_options;

/** Set every field to its default. Call as trk_curve_options_init(&o, sizeof o). */
TRK_API void trk_curve_options_init(trk_curve_options *options, size_t struct_size);

/**
 * Create a curve through a table (CURVE.3 to CURVE.5).
 *
 * A monotone table whose curve is not monotone is noted in the context's log.
 *
 * @param name      how messages call the curve, e.g. "front axle damper"; copied
 * @param count     number of points, 2 to 2^31 - 2
 * @param x         [any] strictly increasing, length count; copied
 * @param y         [any] length count; copied
 * @param options   NULL for PCHIP with end-slope extrapolation
 * @param out_curve owned by caller; NULL on failure
 * @retval TRK_E_ARGUMENT a pointer is NULL, or an option has an unknown value
 * @retval TRK_E_OPTIONS  options come from a newer header and set an unknown field
 * @retval TRK_E_RANGE    fewer than 2 points, a value not finite, x not increasing
 *                        (the message names the point), or slopes overflow
 * @retval TRK_E_MEMORY   no memory
 * Sources: F. N. Fritsch, J. Butland, SIAM J. Sci. Stat. Comput. 5 (1984) 300-304
 * (PCHIP slopes); C. de Boor, A Practical Guide to Splines, 1978 (not-a-knot);
 * H. Akima, J. ACM 17 (1970) 589-602.
 */
TRK_API trk_status trk_curve_create(trk_context *context, const char *name, int64_t count,
                                    const double *x, const double *y,
                                    const trk_curve_options *options,
                                    trk_curve **out_curve) TRK_MUST_CHECK;

/** Copy a curve into a context (which may be another one). Errors as trk_curve_create(). */
TRK_API trk_status trk_curve_copy(trk_context *context, const trk_curve *curve,
                                  trk_curve **out_curve) TRK_MUST_CHECK;

/** Free a curve. NULL is allowed. */
TRK_API void trk_curve_destroy(trk_curve *curve);

/** Value y(x) [unit of y]. A NaN x gives NaN. */
TRK_API double trk_curve_value(const trk_curve *curve, double x);

/** Slope y'(x) [unit of y / unit of x], the exact derivative of trk_curve_value(); at a
 *  corner (LINEAR, or the first and last point with CLAMP) the one to the right. */
TRK_API double trk_curve_slope(const trk_curve *curve, double x);

/**
 * Value and slope at many places.
 *
 * @param count     number of places
 * @param x         [any] length count
 * @param out_value [any] length count; NULL to skip
 * @param out_slope [any] length count; NULL to skip
 */
TRK_API void trk_curve_evaluate(const trk_curve *curve, int64_t count, const double *x,
                                double *out_value, double *out_slope);

/**
 * Monotonicity of the whole curve, between the points and beyond them:
 * 1 nowhere falling, -1 nowhere rising, 0 neither (or constant: 1). Decided without
 * a tolerance from the derivative of each piece, a parabola (CURVE.6).
 */
TRK_API int32_t trk_curve_monotone(const trk_curve *curve);

/** Smallest and largest slope over the whole curve [unit of y / unit of x] (CURVE.6);
 *  NULL to skip one. */
TRK_API void trk_curve_slope_range(const trk_curve *curve, double *out_minimum,
                                   double *out_maximum);

/**
 * The x at which a monotone curve takes the value y.
 *
 * @param y     [any] wanted value
 * @param out_x [any] the smallest such x up to rounding; the first point where the
 *              curve comes level from minus infinity; NaN on failure
 * @retval TRK_E_ARGUMENT a pointer is NULL
 * @retval TRK_E_RANGE    the curve is not monotone, never takes the value, or y is not finite
 */
TRK_API trk_status trk_curve_solve(trk_context *context, const trk_curve *curve, double y,
                                   double *out_x) TRK_MUST_CHECK;

/** Number of points of the table. */
TRK_API int64_t trk_curve_count(const trk_curve *curve);

/** Abscissas of the table [any], length trk_curve_count(); owned by the curve. */
TRK_API const double *trk_curve_x(const trk_curve *curve);

/** Ordinates of the table [any], length trk_curve_count(); owned by the curve. */
TRK_API const double *trk_curve_y(const trk_curve *curve);

/** Name given at creation; owned by the curve. */
TRK_API const char *trk_curve_name(const trk_curve *curve);

/** Interpolation and extrapolation of the curve. */
TRK_API trk_interpolation trk_curve_interpolation(const trk_curve *curve);
TRK_API trk_extrapolation trk_curve_extrapolation(const trk_curve *curve);

#endif
