/* SPDX-License-Identifier: MIT */
/* The interior of a component, its interface held: rows, stiffness, modes. */
#ifndef TRK_REDUCE_INTERIOR_H
#define TRK_REDUCE_INTERIOR_H

#include "linear/vibration.h"
#include "reduce/component.h"
#include "system/assembly.h"

typedef struct trk_interior {
    const trk_component *component;
    int32_t n;
    trk_rows links, inertia;  /* what of each row lies in the interior                       */
    int32_t *link;            /* by row of links: the link of the model                      */
    double *stiffness, *mass; /* by row                                                     */
    trk_assembly assembly;    /* K_ii, factorized                                            */
    double *rest;             /* n                                                           */
} trk_interior;

/* Clear it even on failure. TRK_E_SINGULAR: K_ii is not positive definite. */
trk_status trk_interior_create(const trk_component *component, trk_interior *out);
void trk_interior_clear(trk_interior *interior);

/* x := -K_ii^-1 K_ib e_b for one coordinate of the interface, refined once from elongations. */
trk_status trk_interior_follow(trk_interior *interior, int32_t interface, double *x);

/* The lowest modes of fixed interface; rows of phi (count x n). */
trk_status trk_interior_modes(const trk_interior *interior, int32_t count, double *lambda,
                              double *phi);

#endif
