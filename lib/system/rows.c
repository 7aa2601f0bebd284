/* SPDX-License-Identifier: MIT */
/* Building and expanding rows. */
#include "system/rows.h"

#include <string.h>

/* Put the entry (column, value) in its place among the entries of the open row. */
static void insert(trk_rows *rows, int64_t first, int32_t column, double value)
{
    int64_t k = rows->entries;
    while (k > first && rows->column[k - 1] > column)
        k--;
    if (k > first && rows->column[k - 1] == column) {
        rows->value[k - 1] += value;
        return;
    }
    size_t behind = (size_t)(rows->entries - k);
    memmove(rows->column + k + 1, rows->column + k, behind * sizeof *rows->column);
    memmove(rows->value + k + 1, rows->value + k, behind * sizeof *rows->value);
    rows->column[k] = column;
    rows->value[k] = value;
    rows->entries++;
}

trk_status trk_rows_append(trk_context *context, trk_rows *rows, int32_t count,
                           const int32_t *column, const double *value)
{
    trk_status status = trk_grow(context, (void **)&rows->start, &rows->row_capacity,
                                 (int64_t)rows->count + 2, sizeof *rows->start);
    if (status == TRK_OK)
        status = trk_grow(context, (void **)&rows->column, &rows->column_capacity,
                          rows->entries + count, sizeof *rows->column);
    if (status == TRK_OK)
        status = trk_grow(context, (void **)&rows->value, &rows->value_capacity,
                          rows->entries + count, sizeof *rows->value);
    if (status != TRK_OK)
        return status;
    int64_t first = rows->entries;
    for (int32_t k = 0; k < count; k++)
        if (value[k] != 0)
            insert(rows, first, column[k], value[k]);
    rows->start[++rows->count] = rows->entries;
    return TRK_OK;
}

void trk_rows_clear(trk_context *context, trk_rows *rows)
{
    trk_free(context, rows->start);
    trk_free(context, rows->column);
    trk_free(context, rows->value);
    memset(rows, 0, sizeof *rows);
}

void trk_rows_expand(const trk_rows *rows, int32_t row, int32_t n, double *out)
{
    memset(out, 0, (size_t)n * sizeof *out);
    trk_rows_add(rows, row, 1, out);
}

void trk_rows_add_square(const trk_rows *rows, int32_t row, double d, int32_t n, double *a)
{
    for (int64_t k = rows->start[row]; k < rows->start[row + 1]; k++)
        trk_rows_add(rows, row, d * rows->value[k], a + (int64_t)rows->column[k] * n);
}
