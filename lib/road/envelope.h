/* SPDX-License-Identifier: MIT */
/* Profiles as the functions of enveloping share them. */
#ifndef TRK_ROAD_ENVELOPE_H
#define TRK_ROAD_ENVELOPE_H

#include "base/base.h"
#include <truckride/road.h>

/* TRK_E_RANGE with a sentence unless count, spacing, heights and `size`, a length called `name`,
 * are those of a profile. */
trk_status trk_envelope_check(trk_context *context, int64_t count, double spacing,
                              const double *height, const char *name, double size);
/* TRK_E_ARGUMENT if two of the arrays are the same; out_slope may be NULL. */
trk_status trk_envelope_check_arrays(trk_context *context, const double *height,
                                     const double *out_height, const double *out_slope);

#endif
