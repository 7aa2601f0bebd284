/* SPDX-License-Identifier: MIT */
/* What a solver backend must offer; solver.c lists the backends of this build. */
#ifndef TRK_LINALG_BACKEND_H
#define TRK_LINALG_BACKEND_H

#include "linalg/pattern.h"

typedef struct trk_solver_ops {
    trk_backend backend;
    const char *name;
    /* The pattern is borrowed and outlives the state. */
    trk_status (*create)(trk_context *context, const trk_pattern *pattern, void **out_state);
    void (*destroy)(void *state); /* NULL allowed */
    /* Values in the order of the pattern, as in trk_solver_factorize(). */
    trk_status (*factorize)(void *state, double *values, int32_t *out_bad);
    trk_status (*solve)(void *state, double *x);
    int64_t (*factor_entries)(const void *state);
    /* As trk_solver_count_negative(); the factorization is lost. */
    trk_status (*count_negative)(void *state, double *values, const double *scale,
                                 int32_t *out_count, double *out_growth);
} trk_solver_ops;

extern const trk_solver_ops trk_dense_ops;
#ifdef TRUCKRIDE_WITH_CHOLMOD
extern const trk_solver_ops trk_cholmod_ops;
#endif

#endif
