/* SPDX-License-Identifier: MIT */
/* Reading the parameter structs of this room. */
#ifndef TRK_VEHICLE_PARAMETERS_H
#define TRK_VEHICLE_PARAMETERS_H

#include "base/base.h"
#include <truckride/vehicle.h>

trk_status trk_quarter_car_read(trk_context *context, const trk_quarter_car_parameters *given,
                                trk_quarter_car_parameters *out);
trk_status trk_half_car_read(trk_context *context, const trk_half_car_parameters *given,
                             trk_half_car_parameters *out);
trk_status trk_truck_read(trk_context *context, const trk_truck_parameters *given,
                          trk_truck_parameters *out);

/*
 * Static loads of a truck (VEHICLE.5), from the lever rule: of cab and frame on
 * both springs of each axle, and of the cab on both mounts of each end, as masses [kg].
 */
void trk_truck_axle_share(const trk_truck_parameters *truck, double *out_share);
void trk_truck_cab_share(const trk_truck_parameters *truck, double *out_share);

#endif
