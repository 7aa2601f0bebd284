/* SPDX-License-Identifier: MIT */
/* Sparsity pattern of the lower triangle, the same for every solver backend. */
#ifndef TRK_LINALG_PATTERN_H
#define TRK_LINALG_PATTERN_H

#include "base/base.h"

/*
 * Compressed columns. Rows ascend within a column and the diagonal is always there, so
 * column j occupies [start[j], start[j + 1]) and its diagonal entry is start[j].
 */
typedef struct trk_pattern {
    int32_t n;
    int32_t *start; /* length n + 1    */
    int32_t *row;   /* length start[n] */
} trk_pattern;

/*
 * Merge the entries (rows[k], columns[k]) of either triangle with the diagonal;
 * out_slots[k] receives the place of entry k in the pattern.
 * TRK_E_RANGE: an index outside 0..n-1, or more entries than int32_t counts.
 */
trk_status trk_pattern_create(trk_context *context, int32_t n, int64_t count, const int32_t *rows,
                              const int32_t *columns, int64_t *out_slots, trk_pattern *out_pattern);
void trk_pattern_destroy(trk_context *context, trk_pattern *pattern);

/* y := S x with the values of the lower triangle of a symmetric S. */
void trk_pattern_multiply(const trk_pattern *pattern, const double *values,
                          const double *restrict x, double *restrict y);

/* Cholesky pivots up to this fraction of their diagonal entry count as zero (LINALG.2). */
double trk_pivot_tolerance(int32_t n);

#endif
