/* SPDX-License-Identifier: MIT */
/*
 * Rows: sparse linear functionals on the coordinates. Elongations, inertia,
 * sensors, ports and road inputs are all rows, kept in compressed form.
 */
#ifndef TRK_SYSTEM_ROWS_H
#define TRK_SYSTEM_ROWS_H

#include "base/base.h"

typedef struct trk_rows {
    int32_t count;   /* rows                                       */
    int64_t entries; /* in all rows                                */
    int64_t *start;  /* row r has the entries start[r] .. start[r + 1] - 1 */
    int32_t *column; /* 0-based coordinate, rising within a row    */
    double *value;
    int64_t row_capacity, column_capacity, value_capacity;
} trk_rows;

/* Append a row of `count` entries; zeros are left out, columns are sorted, equal ones added. */
trk_status trk_rows_append(trk_context *context, trk_rows *rows, int32_t count,
                           const int32_t *column, const double *value);
void trk_rows_clear(trk_context *context, trk_rows *rows);

/* row . x */
static inline double trk_rows_dot(const trk_rows *rows, int32_t row, const double *restrict x)
{
    double sum = 0;
    for (int64_t k = rows->start[row]; k < rows->start[row + 1]; k++)
        sum += rows->value[k] * x[rows->column[k]];
    return sum;
}

/* y := y + factor row^T */
static inline void trk_rows_add(const trk_rows *rows, int32_t row, double factor,
                                double *restrict y)
{
    for (int64_t k = rows->start[row]; k < rows->start[row + 1]; k++)
        y[rows->column[k]] += factor * rows->value[k];
}

/* Row written out: out[0 .. n - 1]. */
void trk_rows_expand(const trk_rows *rows, int32_t row, int32_t n, double *out);

/* A := A + d row^T row, A row-major n x n. */
void trk_rows_add_square(const trk_rows *rows, int32_t row, double d, int32_t n, double *a);

#endif
