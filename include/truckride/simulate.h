/* SPDX-License-Identifier: MIT */
/**
 * @file  truckride/simulate.h
 * @brief Run a model over an excitation into a series of all its sensors.
 */
#ifndef TRUCKRIDE_SIMULATE_H
#define TRUCKRIDE_SIMULATE_H

#include <truckride/excitation.h>
#include <truckride/newmark.h>
#include <truckride/rungekutta.h>
#include <truckride/series.h>

/** How a run is integrated over time. */
typedef int32_t trk_method;
enum {
    TRK_METHOD_NEWMARK     = 0, /**< trk_newmark: implicit, second order, for every model    */
    TRK_METHOD_RUNGE_KUTTA = 1  /**< trk_rungekutta: explicit, fourth order, within its limit */
};

/** Options of trk_simulate(). */
typedef struct trk_simulate_options {
    size_t        struct_size;      /**< [byte] set by trk_simulate_options_init()          */
    double        duration;         /**< [s] > 0, rounded to whole steps; default 10        */
    double        start;            /**< [s] time at the beginning; default 0               */
    int64_t       record_every;     /**< [-] record each such step, >= 1; default 1         */
    const double *initial_q;        /**< [m, rad] length coordinates; default NULL: static equilibrium */
    const double *initial_velocity; /**< [m/s, rad/s] length coordinates; default NULL: rest */
    trk_method    method;           /**< [-] default TRK_METHOD_NEWMARK                     */
    int32_t       reserved;         /**< [-] must be 0                                      */
} trk_simulate_options;

/** Set every field to its default. Call as trk_simulate_options_init(&o, sizeof o). */
TRK_API void trk_simulate_options_init(trk_simulate_options *options, size_t struct_size);

/**
 * Run a model over an excitation.
 *
 * The series has one channel per sensor, in their order and with their names and
 * units, sampled at 1 / (step * record_every), the initial state included.
 *
 * @param newmark    NULL for average acceleration at 1 ms; of a Runge-Kutta run only its step counts
 * @param options    NULL for 10 s, all steps recorded
 * @param progress   called about a hundred times; NULL for none
 * @param user       handed to progress; borrowed
 * @param out_series owned by caller; NULL on failure
 * @retval TRK_E_ARGUMENT  a pointer is NULL, the excitation does not fit the model, or the method is
 *                         unknown
 * @retval TRK_E_RANGE     an option is out of its range, or more samples than fit
 * @retval TRK_E_MODEL     the model has no sensor
 * @retval TRK_E_CANCELLED progress returned non-zero
 * Further errors as trk_newmark_create() and trk_newmark_step(), or trk_rungekutta_create() and
 * trk_rungekutta_step(): TRK_E_RANGE if the step is beyond the limit of stability,
 * TRK_E_UNSUPPORTED in a build without LAPACK.
 */
TRK_API trk_status trk_simulate(trk_context *context, const trk_model *model,
                                const trk_excitation *excitation,
                                const trk_newmark_options *newmark,
                                const trk_simulate_options *options, trk_progress progress,
                                void *user, trk_series **out_series) TRK_MUST_CHECK;

#endif
