/* SPDX-License-Identifier: MIT */
/* The vehicle that a word names. */
#ifndef TRUCKRIDE_COMMON_VEHICLE_H
#define TRUCKRIDE_COMMON_VEHICLE_H

#include "common/text.h"

#include <truckride/truckride.h>

/* Names of the ready-made vehicles and of their variants, from the first value of each on; NULL ends. */
extern const char *const vehicle_names[];
extern const char *const vehicle_variants[];

/* Names of trk_field, from TRK_FIELD_STIFFNESS on; NULL ends. */
extern const char *const vehicle_fields[];

/*
 * Read MODEL: "builtin:NAME[:VARIANT]", the path of a model file, or "-": one on standard input.
 * TRK_E_NAME with a complaint: there is no such ready-made vehicle. For other failures the
 * context has the message.
 */
trk_status vehicle_read(trk_context *context, const char *text, complaint *wrong,
                        trk_spec **out_spec);

#endif
