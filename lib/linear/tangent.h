/* SPDX-License-Identifier: MIT */
/* Dense matrices about a working point, and the check of the working point. */
#ifndef TRK_LINEAR_TANGENT_H
#define TRK_LINEAR_TANGENT_H

#include "base/base.h"
#include <truckride/model.h>

/* M, C, K, each n x n in one block; free with trk_free(context, tangent.mass). */
typedef struct trk_tangent {
    int32_t n;
    double *mass, *damping, *stiffness;
} trk_tangent;

/* TRK_E_RANGE: q or v (NULL allowed) is not finite, the message names the coordinate. */
trk_status trk_check_working_point(trk_context *context, const trk_model *model, const double *q,
                                   const double *v);

/* Errors as trk_check_working_point(). */
trk_status trk_tangent_create(trk_context *context, const trk_model *model, const double *q,
                              const double *v, trk_tangent *out);

#endif
