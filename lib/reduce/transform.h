/* SPDX-License-Identifier: MIT */
/* From old coordinates to new ones. */
#ifndef TRK_REDUCE_TRANSFORM_H
#define TRK_REDUCE_TRANSFORM_H

#include "reduce/basis.h"

typedef struct trk_transform {
    const trk_component *component;
    const trk_basis *basis;
    int32_t n;         /* new coordinates                                          */
    int32_t *kept;     /* by old coordinate: its new number, -1: none              */
    int32_t *of_basis; /* by column of T: its new number                          */
    double *w;         /* basis.count                                              */
    int32_t *column;   /* n, of a row being written                                */
    double *value;
} trk_transform;

/* Coordinates that stay keep their order, modes come last. Clear it even on failure. */
trk_status trk_transform_create(const trk_component *component, const trk_basis *basis,
                                trk_transform *out);
void trk_transform_clear(trk_transform *transform);

/* Append row T to `out`. */
trk_status trk_transform_row(trk_transform *transform, const trk_rows *rows, int32_t row,
                             trk_rows *out);

/* Append the entries of w, by column of T. */
trk_status trk_transform_append(trk_transform *transform, const double *w, trk_rows *out);

#endif
