/* SPDX-License-Identifier: MIT */
/* Many weighted rows in few: the same quadratic form (REDUCE.2). */
#ifndef TRK_REDUCE_COMPRESS_H
#define TRK_REDUCE_COMPRESS_H

#include "base/base.h"

/* R of sum w^T w = R^T R, upper triangle, by Givens rotations row by row. */
typedef struct trk_compressor {
    int32_t width;
    double *r; /* width x width, row-major */
} trk_compressor;

trk_status trk_compressor_create(trk_context *context, int32_t width, trk_compressor *out);
void trk_compressor_clear(trk_context *context, trk_compressor *compressor);

/* Add factor w^T w, factor >= 0; w is destroyed. */
void trk_compressor_add(trk_compressor *compressor, double factor, double *w);

/* Clear from each row what is rounding of its column. */
void trk_compressor_finish(trk_compressor *compressor);

/* Row j of R over its largest entry, whose square is returned; 0: the row is empty. */
double trk_compressor_row(const trk_compressor *compressor, int32_t j, double *w);

#endif
