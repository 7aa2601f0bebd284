/* SPDX-License-Identifier: MIT */
/*
 * Assembly of S = a A^T diag(m) A + B^T diag(s) B over inertia rows A and link
 * rows B, whatever the solver: one loop writing into slots.
 */
#ifndef TRK_SYSTEM_ASSEMBLY_H
#define TRK_SYSTEM_ASSEMBLY_H

#include "linalg/solver.h"
#include "system/rows.h"

typedef struct trk_assembly {
    trk_context *context;
    const trk_rows *inertia, *links; /* borrowed            */
    const double *mass;              /* m, borrowed         */
    int64_t *slots;                  /* of all row squares, inertia first */
    trk_solver *solver;
} trk_assembly;

/* n coordinates; the rows and masses are borrowed. On failure *assembly is cleared. */
trk_status trk_assembly_create(trk_context *context, trk_backend backend, int32_t n,
                               const trk_rows *inertia, const double *mass, const trk_rows *links,
                               trk_assembly *assembly);
void trk_assembly_clear(trk_assembly *assembly);

/* Values of the solver: mass factor a and link factors s (length links; NULL: none). */
void trk_assembly_fill(trk_assembly *assembly, double a, const double *s);

/*
 * Assemble with mass factor a and link factors s (length links; NULL: none) and
 * factorize. TRK_E_SINGULAR: *out_bad is the 0-based coordinate where it stopped;
 * no message is recorded.
 */
trk_status trk_assembly_factorize(trk_assembly *assembly, double a, const double *s,
                                  int32_t *out_bad);

#endif
