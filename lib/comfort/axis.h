/* SPDX-License-Identifier: MIT */
/* Multiplying factors of the axes (COMFORT.8). */
#ifndef TRK_COMFORT_AXIS_H
#define TRK_COMFORT_AXIS_H

#include "base/base.h"
#include <truckride/comfort.h>

/* trk_axis_get() with the failure recorded. */
trk_status trk_axis_check(trk_context *context, const char *what, trk_axis axis,
                          trk_purpose purpose, double *out_multiplier);

#endif
