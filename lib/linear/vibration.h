/* SPDX-License-Identifier: MIT */
/* Undamped vibration of anything made of rows: a model, or a component of one. */
#ifndef TRK_LINEAR_VIBRATION_H
#define TRK_LINEAR_VIBRATION_H

#include "system/rows.h"

/* K = B^T diag(tangent) B, M = A^T diag(mass) A over n coordinates; all borrowed. */
typedef struct trk_vibration {
    const char *name; /* in messages */
    int32_t n;
    const trk_rows *inertia; /* A             */
    const double *mass;      /* by row of A   */
    const trk_rows *links;   /* B             */
    const double *tangent;   /* by row of B   */
} trk_vibration;

/*
 * The `count` lowest lambda = omega^2, ascending, and the mass-normalised vectors, the rows of
 * phi (count x n). What is rounding of a rigid motion is 0. All modes by LAPACK where
 * these are few or most are wanted, else by Lanczos, verified (LINEAR.20 to LINEAR.22).
 * Statuses of trk_modes_create_lowest(), and TRK_E_SINGULAR: M is not positive definite.
 */
trk_status trk_vibration_lowest(trk_context *context, const trk_vibration *vibration, int32_t count,
                                double *lambda, double *phi);

#endif
