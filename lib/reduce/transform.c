/* SPDX-License-Identifier: MIT */
#include "reduce/transform.h"

#include <string.h>

void trk_transform_clear(trk_transform *t)
{
    trk_context *context = t->component->context;
    trk_free(context, t->kept);
    trk_free(context, t->of_basis);
    trk_free(context, t->w);
    trk_free(context, t->column);
    trk_free(context, t->value);
}

trk_status trk_transform_create(const trk_component *component, const trk_basis *basis,
                                trk_transform *out)
{
    int32_t old = component->model->n;
    trk_context *context = component->context;
    *out = (trk_transform){.component = component, .basis = basis};
    out->kept = trk_new(context, old, sizeof *out->kept);
    out->of_basis = trk_new(context, basis->count, sizeof *out->of_basis);
    out->w = trk_new(context, basis->count, sizeof *out->w);
    int64_t most = (int64_t)old + basis->count;
    out->column = trk_new(context, most, sizeof *out->column);
    out->value = trk_new(context, most, sizeof *out->value);
    if (!out->kept || !out->of_basis || !out->w || !out->column || !out->value)
        return TRK_E_MEMORY;
    for (int32_t i = 0; i < old; i++) {
        int32_t place = component->place[i];
        out->kept[i] = place < basis->kept ? out->n++ : -1;
        if (place >= 0 && place < basis->kept)
            out->of_basis[place] = out->kept[i];
    }
    for (int32_t j = basis->kept; j < basis->count; j++)
        out->of_basis[j] = out->n++;
    return TRK_OK;
}

/* Entries of w behind those that `column` and `value` hold already. */
static int32_t take(trk_transform *t, const double *w, int32_t count)
{
    for (int32_t j = 0; j < t->basis->count; j++)
        if (w[j] != 0) {
            t->column[count] = t->of_basis[j];
            t->value[count++] = w[j];
        }
    return count;
}

trk_status trk_transform_append(trk_transform *t, const double *w, trk_rows *out)
{
    int32_t count = take(t, w, 0);
    return trk_rows_append(t->component->context, out, count, t->column, t->value);
}

trk_status trk_transform_row(trk_transform *t, const trk_rows *rows, int32_t row, trk_rows *out)
{
    int32_t count = 0;
    for (int64_t k = rows->start[row]; k < rows->start[row + 1]; k++)
        if (t->component->place[rows->column[k]] < 0) {
            t->column[count] = t->kept[rows->column[k]];
            t->value[count++] = rows->value[k];
        }
    if (trk_component_touches(t->component, rows, row)) {
        trk_basis_project(t->basis, t->component, rows, row, t->w);
        count = take(t, t->w, count);
    }
    return trk_rows_append(t->component->context, out, count, t->column, t->value);
}
