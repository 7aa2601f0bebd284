/* SPDX-License-Identifier: MIT */
/**
 * @file  truckride/excitation.h
 * @brief What acts on a vehicle over time: road heights u(t), u'(t) and loads p(t).
 *
 * An excitation adds signals to the road inputs and force ports of a model:
 *
 *     u_i(t) = sum gain s(t - delay) + sum gain r(start + speed t + x_i)   (EXCITATION.1)
 *
 * so that several signals on one input are summed, a sign or a delay makes a
 * wheel run against or behind another, and a road profile r over distance reaches
 * each axle x_i when it comes along. u'(t) is the exact derivative.
 */
#ifndef TRUCKRIDE_EXCITATION_H
#define TRUCKRIDE_EXCITATION_H

#include <truckride/model.h>
#include <truckride/signal.h>

/** What moves the wheels and loads the ports of a model. */
typedef struct trk_excitation trk_excitation;

/** In place of a road id: all road inputs, those with y >= 0, those with y < 0. */
enum { TRK_ROAD_ALL = -1, TRK_ROAD_LEFT = -2, TRK_ROAD_RIGHT = -3 };

/**
 * Create an excitation that leaves the road level and the ports unloaded.
 *
 * It fits every model with as many road inputs and ports, e.g. variants of one
 * vehicle. The places of the wheels are copied from the model.
 * @param out_excitation owned by caller; NULL on failure
 * @retval TRK_E_ARGUMENT a pointer is NULL
 * @retval TRK_E_MEMORY   no memory
 */
TRK_API trk_status trk_excitation_create(trk_context *context, const trk_model *model,
                                         trk_excitation **out_excitation) TRK_MUST_CHECK;

/** Free an excitation. NULL is allowed. */
TRK_API void trk_excitation_destroy(trk_excitation *excitation);

/**
 * Move road inputs by a signal over time.
 *
 * @param road   road id or TRK_ROAD_ALL, TRK_ROAD_LEFT, TRK_ROAD_RIGHT
 * @param signal [m over s] borrowed
 * @param gain   [-]
 * @param delay  [s]
 * @retval TRK_E_ARGUMENT a pointer is NULL, there is no such road, or none lies on that side
 * @retval TRK_E_RANGE    a value is not finite
 * @retval TRK_E_MEMORY   no memory
 */
TRK_API trk_status trk_excitation_add_motion(trk_excitation *excitation, int32_t road,
                                             const trk_signal *signal, double gain,
                                             double delay) TRK_MUST_CHECK;

/**
 * Drive road inputs over a profile: at time t the input at place x sees the
 * profile at start + speed t + x.
 *
 * @param profile [m over m] borrowed
 * @param gain    [-]
 * @param speed   [m/s] > 0
 * @param start   [m] distance of the vehicle's origin along the profile at t = 0
 * Further arguments and errors as trk_excitation_add_motion().
 */
TRK_API trk_status trk_excitation_add_profile(trk_excitation *excitation, int32_t road,
                                              const trk_signal *profile, double gain, double speed,
                                              double start) TRK_MUST_CHECK;

/**
 * Load a force port, e.g. the fifth wheel.
 *
 * @param port   port id
 * @param signal [N or N m over s] borrowed
 * @param gain   [-]
 * @param delay  [s]
 * Errors as trk_excitation_add_motion().
 */
TRK_API trk_status trk_excitation_add_load(trk_excitation *excitation, int32_t port,
                                           const trk_signal *signal, double gain,
                                           double delay) TRK_MUST_CHECK;

/** Number of road inputs. */
TRK_API int32_t trk_excitation_roads(const trk_excitation *excitation);

/** Number of force ports. */
TRK_API int32_t trk_excitation_ports(const trk_excitation *excitation);

/**
 * Values at the times start + k step, k = 0 .. count - 1, time by time.
 *
 * @param start        [s]
 * @param step         [s]
 * @param out_height   [m]      count x roads, row-major; NULL to skip
 * @param out_velocity [m/s]    count x roads; NULL to skip
 * @param out_load     [N, N m] count x ports; NULL to skip
 */
TRK_API void trk_excitation_evaluate(const trk_excitation *excitation, int64_t count, double start,
                                     double step, double *out_height, double *out_velocity,
                                     double *out_load);

#endif
