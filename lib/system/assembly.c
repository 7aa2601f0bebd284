/* SPDX-License-Identifier: MIT */
/* Row squares into solver slots. */
#include "system/assembly.h"

#include <string.h>

/* Entries of the lower triangle of all row squares. */
static int64_t count_pairs(const trk_rows *rows)
{
    int64_t pairs = 0;
    for (int32_t r = 0; r < rows->count; r++) {
        int64_t length = rows->start[r + 1] - rows->start[r];
        pairs += length * (length + 1) / 2;
    }
    return pairs;
}

/* Row and column of each of those entries, in the order in which add_squares() visits them. */
static int64_t list_pairs(const trk_rows *rows, int32_t *row, int32_t *column)
{
    int64_t pair = 0;
    for (int32_t r = 0; r < rows->count; r++)
        for (int64_t i = rows->start[r]; i < rows->start[r + 1]; i++)
            for (int64_t j = rows->start[r]; j <= i; j++, pair++) {
                row[pair] = rows->column[i];
                column[pair] = rows->column[j];
            }
    return pair;
}

static const int64_t *add_squares(const trk_rows *rows, double factor, const double *d,
                                  const int64_t *slot, double *values)
{
    for (int32_t r = 0; r < rows->count; r++) {
        double weight = factor * d[r];
        for (int64_t i = rows->start[r]; i < rows->start[r + 1]; i++)
            for (int64_t j = rows->start[r]; j <= i; j++)
                values[*slot++] += weight * rows->value[i] * rows->value[j];
    }
    return slot;
}

trk_status trk_assembly_create(trk_context *context, trk_backend backend, int32_t n,
                               const trk_rows *inertia, const double *mass, const trk_rows *links,
                               trk_assembly *assembly)
{
    int64_t pairs = count_pairs(inertia) + count_pairs(links);
    *assembly =
        (trk_assembly){.context = context, .inertia = inertia, .links = links, .mass = mass};
    assembly->slots = trk_new(context, pairs, sizeof *assembly->slots);
    int32_t *row = trk_new(context, pairs, sizeof *row);
    int32_t *column = trk_new(context, pairs, sizeof *column);
    trk_status status = TRK_E_MEMORY;
    if (assembly->slots && row && column) {
        int64_t first = list_pairs(inertia, row, column);
        list_pairs(links, row + first, column + first);
        status = trk_solver_create(context, backend, n, pairs, row, column, assembly->slots,
                                   &assembly->solver);
    }
    trk_free(context, row);
    trk_free(context, column);
    if (status != TRK_OK)
        trk_assembly_clear(assembly);
    return status;
}

void trk_assembly_clear(trk_assembly *assembly)
{
    trk_solver_destroy(assembly->solver);
    trk_free(assembly->context, assembly->slots);
    memset(assembly, 0, sizeof *assembly);
}

void trk_assembly_fill(trk_assembly *assembly, double a, const double *s)
{
    trk_solver_clear(assembly->solver);
    double *values = trk_solver_values(assembly->solver);
    const int64_t *slot =
        add_squares(assembly->inertia, a, assembly->mass, assembly->slots, values);
    if (s)
        add_squares(assembly->links, 1, s, slot, values);
}

trk_status trk_assembly_factorize(trk_assembly *assembly, double a, const double *s,
                                  int32_t *out_bad)
{
    trk_assembly_fill(assembly, a, s);
    return trk_solver_factorize(assembly->solver, out_bad);
}
