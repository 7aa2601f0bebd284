/* SPDX-License-Identifier: MIT */
/**
 * @file  truckride/signal.h
 * @brief Scalar functions with their derivative: what moves a wheel or loads the frame.
 *
 * A signal is a function s(x) with an exact derivative s'(x). The argument x is
 * time [s] for a motion or a force, distance [m] for a road profile; the unit of
 * s is whatever it is used for: m, N, N m. Where the derivative jumps it is the one
 * to the right. A NaN x gives NaN.
 *
 * A signal is immutable and may be shared by threads and excitations.
 */
#ifndef TRUCKRIDE_SIGNAL_H
#define TRUCKRIDE_SIGNAL_H

#include <truckride/base.h>

/** A scalar function with its derivative; immutable. */
typedef struct trk_signal trk_signal;

/**
 * Smooth step: 0 until start, then height * s^2 (3 - 2 s) with
 * s = (x - start) / length, then height (SIGNAL.1, the Adams STEP function).
 *
 * @param start      [s or m] where the step begins
 * @param length     [s or m] > 0, how long it takes
 * @param height     [any]    value after the step
 * @param out_signal owned by caller; NULL on failure
 * @retval TRK_E_ARGUMENT a pointer is NULL
 * @retval TRK_E_RANGE    a value is not finite, length is not > 0, or the derivative overflows
 * @retval TRK_E_MEMORY   no memory
 */
TRK_API trk_status trk_signal_create_step(trk_context *context, double start, double length,
                                          double height, trk_signal **out_signal) TRK_MUST_CHECK;

/**
 * Sine: 0 before start, then amplitude * sin(2 pi frequency (x - start) + phase)
 * (SIGNAL.2). With phase 0 it starts without a jump, but with full velocity.
 *
 * @param amplitude  [any]
 * @param frequency  [Hz or 1/m] > 0
 * @param phase      [rad]
 * @param start      [s or m]
 * @param out_signal owned by caller; NULL on failure
 * Errors as trk_signal_create_step().
 */
TRK_API trk_status trk_signal_create_sine(trk_context *context, double amplitude, double frequency,
                                          double phase, double start,
                                          trk_signal **out_signal) TRK_MUST_CHECK;

/** Options of trk_signal_create_sweep(). The defaults are the thesis's road-simulator run. */
typedef struct trk_sweep_options {
    size_t struct_size;        /**< [byte] set by trk_sweep_options_init()                     */
    double start_frequency;    /**< [Hz] > 0; default 0.8                                     */
    double end_frequency;      /**< [Hz] > 0, other than start_frequency; default 20          */
    double duration;           /**< [s] > 0; default 480                                      */
    double amplitude;          /**< [m] amplitude at 1 Hz; default 0.001: 1.25 mm at 0.8 Hz   */
    double amplitude_exponent; /**< [-] amplitude falls as frequency^-exponent, -10 to 10;
                                        default 1                                             */
    double phase;              /**< [rad] phase at the start; default 0                       */
    double start;              /**< [s] signal is 0 before; default 0                         */
} trk_sweep_options;

/** Set every field to its default. Call as trk_sweep_options_init(&o, sizeof o). */
TRK_API void trk_sweep_options_init(trk_sweep_options *options, size_t struct_size);

/**
 * Logarithmic sine sweep (SIGNAL.3): instantaneous frequency
 * f(x) = f0 (f1/f0)^(x/T), value A f^-exponent sin(2 pi integral of f + phase).
 * The derivative is analytic, the change of amplitude included. After the sweep
 * the last value is held. The phase is right to about 1e-15 of the turns swept.
 *
 * @param options    NULL for the thesis's sweep
 * @param out_signal owned by caller; NULL on failure
 * @retval TRK_E_OPTIONS options come from a newer header and set an unknown field
 * Further errors as trk_signal_create_step().
 */
TRK_API trk_status trk_signal_create_sweep(trk_context *context, const trk_sweep_options *options,
                                           trk_signal **out_signal) TRK_MUST_CHECK;

/**
 * Signal through equally spaced samples (SIGNAL.4).
 *
 * With rates, each interval is the cubic Hermite polynomial of its end values
 * and rates. Without, a C2 cubic spline with not-a-knot ends passes through the
 * samples and its own derivative is the rate (fourth order for a smooth signal).
 * Before the first and after the last sample the end value is held.
 *
 * @param count      number of samples, >= 4 (>= 2 with rates)
 * @param start      [s or m] place of the first sample
 * @param spacing    [s or m] > 0
 * @param values     [any] length count; copied
 * @param rates      [any per s or m] rate at the samples, length count, copied; NULL if unknown
 * @param out_signal owned by caller; NULL on failure
 * @retval TRK_E_RANGE a sample or rate is not finite (the message names it), or count
 *                     or spacing is out of range
 * Further errors as trk_signal_create_step().
 */
TRK_API trk_status trk_signal_create_samples(trk_context *context, int64_t count, double start,
                                             double spacing, const double *values,
                                             const double *rates,
                                             trk_signal **out_signal) TRK_MUST_CHECK;

/**
 * Signal through unequally spaced points, PCHIP (no overshoot, CURVE.3), end values held:
 * a road profile given as distance and height.
 *
 * @param count      number of points, >= 2
 * @param x          [s or m] strictly increasing, length count; copied
 * @param values     [any] length count; copied
 * @param out_signal owned by caller; NULL on failure
 * Errors as trk_signal_create_samples().
 */
TRK_API trk_status trk_signal_create_points(trk_context *context, int64_t count, const double *x,
                                            const double *values,
                                            trk_signal **out_signal) TRK_MUST_CHECK;

/** Free a signal. NULL is allowed. */
TRK_API void trk_signal_destroy(trk_signal *signal);

/** Value s(x) [any]. */
TRK_API double trk_signal_value(const trk_signal *signal, double x);

/** Derivative s'(x) [any per s or m]. */
TRK_API double trk_signal_rate(const trk_signal *signal, double x);

/**
 * Values and derivatives at start + k * spacing, k = 0 .. count - 1.
 *
 * @param start     [s or m]
 * @param spacing   [s or m] may be negative or zero; results equal those of
 *                  trk_signal_value() and trk_signal_rate() at the same places
 * @param out_value [any] length count; NULL to skip
 * @param out_rate  [any per s or m] length count; NULL to skip
 */
TRK_API void trk_signal_evaluate(const trk_signal *signal, int64_t count, double start,
                                 double spacing, double *out_value, double *out_rate);

#endif
