/* SPDX-License-Identifier: MIT */
/* The motions that a reduced component keeps (REDUCE.1, REDUCE.3). */
#ifndef TRK_REDUCE_BASIS_H
#define TRK_REDUCE_BASIS_H

#include "reduce/component.h"
#include <truckride/reduce.h>

/* q of the component = T z. */
typedef struct trk_basis {
    trk_context *context;
    int32_t count;            /* columns of T                                                    */
    int32_t kept;             /* of these the first are interface coordinates themselves         */
    double *t;                /* T, row-major, component coordinates x count                     */
    double *stiffness, *mass; /* of the columns behind `kept`, by column; 0 before          */
} trk_basis;

/* Clear it even on failure. TRK_E_SINGULAR: the interior moves freely. */
trk_status trk_basis_create(const trk_component *component, const trk_reduce_options *options,
                            trk_basis *out);
void trk_basis_clear(trk_basis *basis);

/* w := row T, the part of a row of the model that lies in the component; w has basis.count. */
void trk_basis_project(const trk_basis *basis, const trk_component *component, const trk_rows *rows,
                       int32_t row, double *w);

#endif
