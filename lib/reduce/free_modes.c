/* SPDX-License-Identifier: MIT */
/* Free modes of a component in its Craig-Bampton basis (REDUCE.4). */
#include "reduce/free_modes.h"

#include "linalg/eigen.h"

#include <string.h>

/* a := a + sum of factor w^T w over rows; those that leave the component only if asked for. */
static void add_rows(const trk_basis *basis, const trk_component *c, const trk_rows *rows,
                     const double *factor, bool leaving, double *w, double *a)
{
    int32_t n = basis->count;
    for (int32_t r = 0; r < rows->count; r++) {
        if (!trk_component_touches(c, rows, r) || (!leaving && trk_component_leaves(c, rows, r)))
            continue;
        trk_basis_project(basis, c, rows, r, w);
        for (int32_t i = 0; i < n; i++)
            for (int32_t j = 0; j < n; j++)
                a[(int64_t)i * n + j] += factor[r] * w[i] * w[j];
    }
}

/* T := T Y for the first `count` columns of y. */
static void multiply(trk_basis *basis, int32_t rows, int32_t count, const double *y, double *out)
{
    for (int32_t i = 0; i < rows; i++)
        for (int32_t k = 0; k < count; k++)
            for (int32_t j = 0; j < basis->count; j++)
                out[(int64_t)i * count + k] +=
                    basis->t[(int64_t)i * basis->count + j] * y[(int64_t)k * basis->count + j];
}

/* Stiffness of the component alone: tangents of its links, without those to ground and roads. */
static void free_stiffness(const trk_component *c, double *factor)
{
    const trk_model *model = c->model;
    for (int32_t k = 0; k < model->links.count; k++)
        factor[k] = trk_link_law_is_linear(&model->laws[k]) &&
                            model->roads.start[k] == model->roads.start[k + 1]
                        ? c->stiffness[k]
                        : 0;
}

static trk_status solve(trk_basis *basis, const trk_component *c, int32_t count, double *block)
{
    int64_t square = (int64_t)basis->count * basis->count;
    double *k = block, *m = k + square, *lambda = m + square, *w = lambda + basis->count,
           *factor = w + basis->count;
    free_stiffness(c, factor);
    add_rows(basis, c, &c->model->links, factor, false, w, k);
    add_rows(basis, c, &c->model->inertia, c->model->mass, true, w, m);
    trk_status status = trk_eigen_symmetric(c->context, basis->count, k, m, lambda);
    if (status != TRK_OK)
        return status;
    double *t = trk_new(c->context, (int64_t)c->count * count, sizeof *t);
    if (!t)
        return TRK_E_MEMORY;
    multiply(basis, c->count, count, k, t);
    trk_free(c->context, basis->t);
    basis->t = t;
    basis->count = count;
    basis->kept = 0;
    return TRK_OK;
}

trk_status trk_basis_use_free_modes(trk_basis *basis, const trk_component *component, int32_t count)
{
    if (count >= basis->count)
        return TRK_OK;
    int64_t n = basis->count;
    double *block = trk_new(component->context, 2 * n * n + 2 * n + component->model->links.count,
                            sizeof *block);
    if (!block)
        return TRK_E_MEMORY;
    trk_status status = solve(basis, component, count, block);
    trk_free(component->context, block);
    return status;
}
