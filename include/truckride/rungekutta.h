/* SPDX-License-Identifier: MIT */
/**
 * @file  truckride/rungekutta.h
 * @brief Drive a compiled model: explicit time integration of fourth order, one step a call.
 *
 * The classical Runge-Kutta method on (MODEL.2), with a(q, v, t) = M^-1 (P p + w - B^T f):
 *
 *     V2 = v + h/2 a1    Q2 = q + h/2 v                               (RUNGEKUTTA.1)
 *     V3 = v + h/2 a2    Q3 = q + h/2 V2
 *     V4 = v + h a3      Q4 = q + h V3
 *     q1 = q + h/6 (v + 2 V2 + 2 V3 + V4)
 *     v1 = v + h/6 (a1 + 2 a2 + 2 a3 + a4)
 *
 * a1 at t, a2 and a3 at t + h/2, a4 at t + h: road and loads are needed at mid-step too.
 * Nothing is iterated, so a step always costs the same. At 1 ms the error is some hundred
 * times less than that of trk_newmark_step(), but the step must stay below the limit of
 * stability (RUNGEKUTTA.3), which creating a stepper checks: stiff links on small masses
 * are a case for trk_newmark. docs/theory/rungekutta.md says which to use when.
 *
 * Needs TRK_FEATURE_LAPACK, for that check. Links with a law of their own (trk_link_options.law)
 * are refused: take trk_newmark.
 *
 * Threads: one stepper per thread; steppers may share a model.
 */
#ifndef TRUCKRIDE_RUNGEKUTTA_H
#define TRUCKRIDE_RUNGEKUTTA_H

#include <truckride/model.h>

/** The state of one model on its way through time, by explicit steps. */
/** Explicit stepper: a model and its motion. */
typedef struct trk_rungekutta trk_rungekutta;

/** Options of trk_rungekutta_create(). */
typedef struct trk_rungekutta_options {
    size_t struct_size; /**< [byte] set by trk_rungekutta_options_init()                      */
    double step;        /**< [s] h > 0, at most trk_rungekutta_find_limit(); default 0.001     */
} trk_rungekutta_options;

/** Set every field to its default. Call as trk_rungekutta_options_init(&o, sizeof o). */
TRK_API void trk_rungekutta_options_init(trk_rungekutta_options *options, size_t struct_size);

/**
 * Longest stable step of a model (RUNGEKUTTA.3): no eigenvalue of the equations of motion
 * leaves the region of stability of the method, neither with the largest slopes of all
 * curves nor with the smallest of one kind and the largest of the other.
 *
 * Exact for a linear model with at most 50 coordinates; above, the eigenvalues of largest
 * size come from an Arnoldi iteration.
 *
 * @param out_step [s] infinite if nothing holds or damps the bodies
 * @param out_link the link that is stiffest on the masses it acts on (RUNGEKUTTA.4), 0: none, or a
 *                 beam is stiffer; NULL to skip
 * @retval TRK_E_ARGUMENT    a pointer is NULL
 * @retval TRK_E_CONVERGENCE the eigenvalues were not found
 * @retval TRK_E_UNSUPPORTED a build without LAPACK
 * @retval TRK_E_MEMORY      no memory
 */
TRK_API trk_status trk_rungekutta_find_limit(trk_context *context, const trk_model *model,
                                             double *out_step, int32_t *out_link) TRK_MUST_CHECK;

/**
 * Create a stepper at static equilibrium, at rest on a level road, unloaded, t = 0.
 *
 * @param model       borrowed
 * @param options     NULL for the defaults
 * @param out_stepper owned by caller; NULL on failure
 * @retval TRK_E_ARGUMENT    a pointer is NULL
 * @retval TRK_E_OPTIONS     options come from a newer header and set an unknown field
 * @retval TRK_E_RANGE       step is not a finite number > 0, or beyond the limit of stability;
 *                           the message gives the limit and names the stiffest link
 * @retval TRK_E_UNSUPPORTED a link has a law of its own; the message names it
 * Further errors as trk_rungekutta_find_limit().
 */
TRK_API trk_status trk_rungekutta_create(trk_context *context, const trk_model *model,
                                         const trk_rungekutta_options *options,
                                         trk_rungekutta **out_stepper) TRK_MUST_CHECK;

/** Free a stepper. NULL is allowed. */
TRK_API void trk_rungekutta_destroy(trk_rungekutta *stepper);

/**
 * Set time and state; the acceleration follows from equilibrium.
 *
 * @param time     [s]
 * @param q        [m, rad] length coordinates; NULL for static equilibrium
 * @param v        [m/s, rad/s] length coordinates; NULL for rest
 * @param height   [m] road heights, length roads; NULL for level
 * @param velocity [m/s] their rates, length roads; NULL for zero
 * @param load     [N, N m] on the force ports, length ports; NULL for none
 * @retval TRK_E_ARGUMENT stepper is NULL
 * @retval TRK_E_RANGE    a value is not finite, or the acceleration is not; the state stays as it was
 */
TRK_API trk_status trk_rungekutta_set_state(trk_rungekutta *stepper, double time, const double *q,
                                            const double *v, const double *height,
                                            const double *velocity,
                                            const double *load) TRK_MUST_CHECK;

/**
 * Advance by one step h (RUNGEKUTTA.1). Allocates nothing.
 *
 * @param middle_height   [m] road heights at t + h/2, length roads; NULL for level
 * @param middle_velocity [m/s] their rates, length roads; NULL for zero
 * @param middle_load     [N, N m] on the force ports at t + h/2; NULL for none
 * @param height          [m] road heights at t + h, length roads; NULL for level
 * @param velocity        [m/s] their rates, length roads; NULL for zero
 * @param load            [N, N m] on the force ports at t + h; NULL for none
 * @retval TRK_E_ARGUMENT stepper is NULL
 * @retval TRK_E_RANGE    an input is not finite, or the motion left the range of doubles
 * On failure the state is that of the last good step.
 * Source: W. Kutta, Z. Math. Phys. 46 (1901) 435-453.
 */
TRK_API trk_status trk_rungekutta_step(trk_rungekutta *stepper, const double *middle_height,
                                       const double *middle_velocity, const double *middle_load,
                                       const double *height, const double *velocity,
                                       const double *load) TRK_MUST_CHECK;

/** Step h [s]. */
TRK_API double trk_rungekutta_step_size(const trk_rungekutta *stepper);

/** Current time [s]. */
TRK_API double trk_rungekutta_time(const trk_rungekutta *stepper);

/**
 * Copy the state; NULL skips one.
 * @param out_q [m, rad] length coordinates
 * @param out_v [m/s, rad/s] length coordinates
 * @param out_a [m/s^2, rad/s^2] length coordinates
 */
TRK_API void trk_rungekutta_get_state(const trk_rungekutta *stepper, double *out_q, double *out_v,
                                      double *out_a);

/**
 * Copy elongation [m, rad], rate [m/s, rad/s] and force [N, N m] of every link, each
 * of length links; NULL skips one.
 */
TRK_API void trk_rungekutta_get_links(const trk_rungekutta *stepper, double *out_elongation,
                                      double *out_rate, double *out_force);

/** Values of all sensors at trk_rungekutta_time(), each in its unit [trk_model_unit()], length
 *  sensors. */
TRK_API void trk_rungekutta_read_sensors(const trk_rungekutta *stepper, double *out_values);

#endif
