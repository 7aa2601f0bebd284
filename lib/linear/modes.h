/* SPDX-License-Identifier: MIT */
/* Inside of a set of modes. */
#ifndef TRK_LINEAR_MODES_H
#define TRK_LINEAR_MODES_H

#include "base/base.h"
#include <truckride/linear.h>

struct trk_modes {
    trk_context *context;
    int32_t n, count;
    double *lambda_re, *lambda_im; /* eigenvalues [1/s], by mode; an undamped mode: 0 + i omega */
    double *re, *im;               /* shapes, count x n                                         */
    double *share;                 /* of the kinetic energy, count x n                          */
    int32_t *dominant;             /* 0-based coordinate with most of it                        */
    char **label;                  /* its name                                                  */
};

/* Memory for up to `capacity` modes of n coordinates, count still 0. */
trk_status trk_modes_allocate(trk_context *context, int32_t n, int32_t capacity, trk_modes **out);

/* Eigenvalues omega^2 are known to rounding of the largest: make those of a free body zero. */
void trk_modes_clear_rounding(int32_t n, double *omega_squared);

/* omega^2 in lambda_im becomes omega, with the sign of omega^2. */
void trk_modes_take_roots(trk_modes *modes);

/* Energy, phase, label and norm of all modes, once lambda and raw shapes are there. */
trk_status trk_modes_finish(trk_modes *modes, const trk_model *model);

#endif
