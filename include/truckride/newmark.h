/* SPDX-License-Identifier: MIT */
/**
 * @file  truckride/newmark.h
 * @brief Drive a compiled model: implicit time integration, one step a call.
 *
 * Equation of motion (MODEL.2) with r(t) = B^T f - P p - w, all forces that are
 * not inertia. A step of size h finds the acceleration a1 for which
 *
 *     (1 - alpha_m) M a1 + alpha_m M a0
 *       + (1 - alpha_f) r(q1, v1, t1) + alpha_f r(q0, v0, t0) = 0     (NEWMARK.1)
 *     q1 = q0 + h v0 + h^2 [(1/2 - beta) a0 + beta a1]                (NEWMARK.2)
 *     v1 = v0 + h [(1 - gamma) a0 + gamma a1]                         (NEWMARK.3)
 *
 * alpha_m = alpha_f = 0 is Newmark's method (1959), alpha_m = 0 that of Hilber,
 * Hughes and Taylor (1977), both non-zero that of Chung and Hulbert (1993).
 * beta = 1/4, gamma = 1/2 (average acceleration, the default) is second order,
 * stable for every step and adds no damping. With alpha_m or alpha_f the acceleration a1
 * is second order at the time t1 - (alpha_f - alpha_m) h, at t1 first order (NEWMARK.11).
 *
 * The matrix of all linear parts is factored once. The few non-linear links see
 * the rest of the vehicle only through a small matrix, so that Newton's method
 * runs on their forces alone (NEWMARK.6); this is exact, not an approximation.
 *
 * Threads: one stepper per thread; steppers may share a model.
 */
#ifndef TRUCKRIDE_NEWMARK_H
#define TRUCKRIDE_NEWMARK_H

#include <truckride/model.h>

/** The state of one model on its way through time. */
typedef struct trk_newmark trk_newmark;

/** Options of trk_newmark_create(). */
typedef struct trk_newmark_options {
    size_t      struct_size;    /**< [byte] set by trk_newmark_options_init()              */
    double      step;           /**< [s] h > 0; default 0.001                              */
    double      beta;           /**< [-] 0 to 1; default 1/4                               */
    double      gamma;          /**< [-] 1/2 to 3/2; default 1/2                            */
    double      alpha_f;        /**< [-] 0 to 1/2; default 0                               */
    double      alpha_m;        /**< [-] -1 to alpha_f; default 0                          */
    double      tolerance;      /**< [-] residual of the link forces over the largest link force (NEWMARK.12), above 0, at most 0.01; default 1e-10 */
    int32_t     max_iterations; /**< [-] Newton iterations in a step, >= 1; default 100    */
    trk_backend backend;        /**< [-] default TRK_BACKEND_AUTO                          */
} trk_newmark_options;

/** Set every field to its default. Call as trk_newmark_options_init(&o, sizeof o). */
TRK_API void trk_newmark_options_init(trk_newmark_options *options, size_t struct_size);

/** Set beta = 0.36 and gamma = 0.7, the Newmark constants of Adams and of the thesis. */
TRK_API void trk_newmark_options_adams(trk_newmark_options *options);

/**
 * Set HHT: beta = (1 - alpha)^2 / 4, gamma = 1/2 - alpha, alpha_f = -alpha. As with the
 * other named methods, trk_newmark_create() refuses what a value out of range leads to.
 * @param alpha [-] -1/3 to 0; 0 is average acceleration
 */
TRK_API void trk_newmark_options_hht(trk_newmark_options *options, double alpha);

/**
 * Set generalized alpha by its spectral radius at infinite frequency.
 * @param rho_infinity [-] 0 (asymptotic annihilation) to 1 (no damping)
 */
TRK_API void trk_newmark_options_generalized_alpha(trk_newmark_options *options,
                                                   double rho_infinity);

/** What the stepper did since it was created. */
typedef struct trk_newmark_statistics {
    size_t  struct_size;          /**< [byte] set by the caller to sizeof the struct              */
    int64_t steps;                /**< [-] converged steps                                        */
    int64_t iterations;           /**< [-] Newton iterations in all steps                         */
    int32_t max_iterations;       /**< [-] most Newton iterations in one step                     */
    int32_t worst_link;           /**< [-] link with the largest residual in that step, 0: none   */
    int32_t nonlinear_links;      /**< [-] links with a curve or a law of their own               */
    int32_t coordinates;          /**< [-] size of the system                                     */
    int64_t factor_entries;       /**< [-] entries of the factor of the linear part               */
    trk_backend backend;          /**< [-] solver in use                                          */
} trk_newmark_statistics;

/**
 * Create a stepper at static equilibrium, at rest on a level road, unloaded, t = 0.
 *
 * @param model       borrowed
 * @param options     NULL for the defaults
 * @param out_stepper owned by caller; NULL on failure
 * @retval TRK_E_ARGUMENT    a pointer is NULL
 * @retval TRK_E_OPTIONS     options come from a newer header and set an unknown field
 * @retval TRK_E_RANGE       an option is out of its range
 * @retval TRK_E_SINGULAR    the matrix of the step is not positive definite; the message names
 *                           the coordinate and the link
 * @retval TRK_E_UNSUPPORTED the sparse backend was asked for in a build without CHOLMOD
 * @retval TRK_E_MEMORY      no memory
 */
TRK_API trk_status trk_newmark_create(trk_context *context, const trk_model *model,
                                      const trk_newmark_options *options,
                                      trk_newmark **out_stepper) TRK_MUST_CHECK;

/** Free a stepper. NULL is allowed. */
TRK_API void trk_newmark_destroy(trk_newmark *stepper);

/**
 * Set time and state; the acceleration follows from equilibrium. Laws with memory are those of
 * links that have stood at these elongations for long (LAW.5): friction carries nothing.
 *
 * @param time     [s]
 * @param q        [m, rad] length coordinates; NULL for static equilibrium
 * @param v        [m/s, rad/s] length coordinates; NULL for rest
 * @param height   [m] road heights, length roads; NULL for level
 * @param velocity [m/s] their rates, length roads; NULL for zero
 * @param load     [N, N m] on the force ports, length ports; NULL for none
 * @retval TRK_E_ARGUMENT stepper is NULL
 * @retval TRK_E_RANGE    a value is not finite, or the acceleration is not; the state stays as it was
 * @retval TRK_E_MEMORY   sparse backend only: no scratch memory for CHOLMOD
 */
TRK_API trk_status trk_newmark_set_state(trk_newmark *stepper, double time, const double *q,
                                         const double *v, const double *height,
                                         const double *velocity, const double *load) TRK_MUST_CHECK;

/**
 * Advance by one step h (NEWMARK.1). Allocates nothing.
 *
 * @param height   [m] road heights at the end of the step, length roads; NULL for level
 * @param velocity [m/s] their rates, length roads; NULL for zero
 * @param load     [N, N m] on the force ports at the end of the step; NULL for none
 * @retval TRK_E_ARGUMENT    stepper is NULL
 * @retval TRK_E_RANGE       an input is not finite, or the motion left the range of doubles
 * @retval TRK_E_CONVERGENCE Newton did not converge; the message gives time, iterations and
 *                           the worst link
 * On failure the state is that of the last good step.
 */
TRK_API trk_status trk_newmark_step(trk_newmark *stepper, const double *height,
                                    const double *velocity, const double *load) TRK_MUST_CHECK;

/** Step h [s]. */
TRK_API double trk_newmark_step_size(const trk_newmark *stepper);

/** Current time [s]. */
TRK_API double trk_newmark_time(const trk_newmark *stepper);

/**
 * Copy the state; NULL skips one.
 * @param out_q [m, rad] length coordinates
 * @param out_v [m/s, rad/s] length coordinates
 * @param out_a [m/s^2, rad/s^2] length coordinates
 */
TRK_API void trk_newmark_get_state(const trk_newmark *stepper, double *out_q, double *out_v,
                                   double *out_a);

/**
 * Copy elongation [m, rad], rate [m/s, rad/s] and force [N, N m] of every link, each
 * of length links; NULL skips one.
 */
TRK_API void trk_newmark_get_links(const trk_newmark *stepper, double *out_elongation,
                                   double *out_rate, double *out_force);

/** Values of all sensors at trk_newmark_time(), each in its unit [trk_model_unit()], length
 *  sensors. In a loop with hardware, a load computed from them acts in the next step. */
TRK_API void trk_newmark_read_sensors(const trk_newmark *stepper, double *out_values);

/** What the stepper did. @retval TRK_E_ARGUMENT a pointer is NULL @retval TRK_E_OPTIONS struct_size is not set */
TRK_API trk_status trk_newmark_get_statistics(const trk_newmark *stepper,
                                              trk_newmark_statistics *out_statistics) TRK_MUST_CHECK;

#endif
