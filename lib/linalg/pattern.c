/* SPDX-License-Identifier: MIT */
/* Sparsity pattern of the lower triangle, by two counting sorts: O(count + n). */
#include "linalg/pattern.h"

#include <float.h>
#include <string.h>

/* Entries being sorted: ids below n are the diagonal, id n + k is entry k of the caller. */
typedef struct entries {
    int32_t n, total;
    int32_t *row, *column;       /* row >= column                 */
    int32_t *by_row, *by_column; /* ids, sorted; the second by (column, row) */
    int32_t *place;              /* n + 1 counters of the sort    */
} entries;

static void entries_free(trk_context *context, entries *e)
{
    trk_free(context, e->row);
    trk_free(context, e->column);
    trk_free(context, e->by_row);
    trk_free(context, e->by_column);
    trk_free(context, e->place);
}

static trk_status entries_allocate(trk_context *context, entries *e)
{
    e->row = trk_new(context, e->total, sizeof *e->row);
    e->column = e->row ? trk_new(context, e->total, sizeof *e->column) : NULL;
    e->by_row = e->column ? trk_new(context, e->total, sizeof *e->by_row) : NULL;
    e->by_column = e->by_row ? trk_new(context, e->total, sizeof *e->by_column) : NULL;
    e->place = e->by_column ? trk_new(context, (int64_t)e->n + 1, sizeof *e->place) : NULL;
    return e->place ? TRK_OK : TRK_E_MEMORY;
}

static trk_status entries_read(trk_context *context, const int32_t *rows, const int32_t *columns,
                               entries *e)
{
    for (int32_t j = 0; j < e->n; j++)
        e->row[j] = e->column[j] = j;
    for (int32_t k = 0; k < e->total - e->n; k++) {
        if (rows[k] < 0 || rows[k] >= e->n || columns[k] < 0 || columns[k] >= e->n)
            return trk_fail(context, TRK_E_RANGE,
                            "solver: entry %d is at (%d, %d), expected 0 to %d", (int)k,
                            (int)rows[k], (int)columns[k], (int)(e->n - 1));
        e->row[e->n + k] = rows[k] > columns[k] ? rows[k] : columns[k];
        e->column[e->n + k] = rows[k] > columns[k] ? columns[k] : rows[k];
    }
    return TRK_OK;
}

/* Stable counting sort of ids (NULL: 0, 1, 2, ...) by key[id]. */
static void sort_ids(entries *e, const int32_t *key, const int32_t *ids, int32_t *sorted)
{
    memset(e->place, 0, ((size_t)e->n + 1) * sizeof *e->place);
    for (int32_t k = 0; k < e->total; k++)
        e->place[key[k] + 1]++;
    for (int32_t j = 0; j < e->n; j++)
        e->place[j + 1] += e->place[j];
    for (int32_t k = 0; k < e->total; k++) {
        int32_t id = ids ? ids[k] : k;
        sorted[e->place[key[id]]++] = id;
    }
}

static trk_status compress(trk_context *context, const entries *e, int64_t *out_slots,
                           trk_pattern *pattern)
{
    pattern->n = e->n;
    pattern->start = trk_new(context, (int64_t)e->n + 1, sizeof *pattern->start);
    pattern->row = pattern->start ? trk_new(context, e->total, sizeof *pattern->row) : NULL;
    if (!pattern->row)
        return TRK_E_MEMORY;
    int32_t used = 0, last_row = -1, last_column = -1;
    for (int32_t k = 0; k < e->total; k++) {
        int32_t id = e->by_column[k];
        if (e->row[id] != last_row || e->column[id] != last_column) {
            last_row = e->row[id];
            last_column = e->column[id];
            pattern->row[used++] = last_row;
            pattern->start[last_column + 1] = used;
        }
        if (id >= e->n)
            out_slots[id - e->n] = used - 1;
    }
    return TRK_OK;
}

trk_status trk_pattern_create(trk_context *context, int32_t n, int64_t count, const int32_t *rows,
                              const int32_t *columns, int64_t *out_slots, trk_pattern *out_pattern)
{
    memset(out_pattern, 0, sizeof *out_pattern);
    if (count > INT32_MAX - (int64_t)n)
        return trk_fail(context, TRK_E_RANGE,
                        "solver: %lld entries of %d unknowns, expected at most %d",
                        (long long)count, (int)n, (int)(INT32_MAX - n));
    entries e = {.n = n, .total = (int32_t)(count + n)};
    trk_status status = entries_allocate(context, &e);
    if (status == TRK_OK)
        status = entries_read(context, rows, columns, &e);
    if (status == TRK_OK) {
        sort_ids(&e, e.row, NULL, e.by_row);
        sort_ids(&e, e.column, e.by_row, e.by_column);
        status = compress(context, &e, out_slots, out_pattern);
    }
    entries_free(context, &e);
    if (status != TRK_OK)
        trk_pattern_destroy(context, out_pattern);
    return status;
}

void trk_pattern_destroy(trk_context *context, trk_pattern *pattern)
{
    trk_free(context, pattern->start);
    trk_free(context, pattern->row);
    memset(pattern, 0, sizeof *pattern);
}

void trk_pattern_multiply(const trk_pattern *pattern, const double *values,
                          const double *restrict x, double *restrict y)
{
    memset(y, 0, (size_t)pattern->n * sizeof *y);
    for (int32_t j = 0; j < pattern->n; j++) {
        int32_t k = pattern->start[j];
        double known = x[j], sum = values[k] * known;
        for (k++; k < pattern->start[j + 1]; k++) {
            int32_t i = pattern->row[k];
            y[i] += values[k] * known;
            sum += values[k] * x[i];
        }
        y[j] += sum;
    }
}

double trk_pivot_tolerance(int32_t n)
{
    return n * DBL_EPSILON;
}
