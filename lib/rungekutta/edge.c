/* SPDX-License-Identifier: MIT */
/*
 * The edge of the spectrum by Arnoldi's method (RUNGEKUTTA.5) on z = (s D q, D v), with
 * D^2 = diag M and s about the largest frequency, so that all entries are of one size:
 *
 *     z' = A z,    A = [      0               s I       ]
 *                      [ -D M^-1 K D^-1 / s  -D M^-1 C D^-1 ]
 */
#include "rungekutta/limit.h"

#include "linalg/eigen.h"
#include "model/model.h"
#include "system/assembly.h"

#include <float.h>
#include <math.h>
#include <string.h>

enum { MOST_VECTORS = 100 }; /* for larger systems the largest eigenvalues converge long before */

struct trk_spectrum_edge {
    trk_context *context;
    const trk_model *model;
    trk_assembly assembly; /* factors of M                               */
    trk_rows no_links;
    int32_t vectors;        /* most of the basis, at most 2 n            */
    double *root_mass;      /* diagonal of D                             */
    double *basis;          /* (vectors + 1) x 2 n                       */
    double *q, *v, *force;  /* n each                                    */
    double *hessenberg, *h; /* vectors x vectors column-major; a dense copy of its start */
    double *re, *im;        /* eigenvalues, vectors each                 */
};

void trk_spectrum_edge_destroy(trk_spectrum_edge *edge)
{
    if (!edge)
        return;
    trk_context *context = edge->context;
    if (edge->assembly.context)
        trk_assembly_clear(&edge->assembly);
    void *blocks[] = {edge->root_mass,  edge->basis, edge->q,  edge->v, edge->force,
                      edge->hessenberg, edge->h,     edge->re, edge->im};
    for (size_t k = 0; k < sizeof blocks / sizeof *blocks; k++)
        trk_free(context, blocks[k]);
    trk_free(context, edge);
}

static trk_status prepare(trk_spectrum_edge *edge)
{
    trk_context *context = edge->context;
    const trk_model *model = edge->model;
    int64_t n = model->n, m = 2 * n < MOST_VECTORS ? 2 * n : MOST_VECTORS;
    edge->vectors = (int32_t)m;
    edge->root_mass = trk_new(context, n, sizeof(double));
    edge->basis = trk_new(context, (m + 1) * 2 * n, sizeof(double));
    edge->q = trk_new(context, n, sizeof(double));
    edge->v = trk_new(context, n, sizeof(double));
    edge->force = trk_new(context, n, sizeof(double));
    edge->hessenberg = trk_new(context, m * m, sizeof(double));
    edge->h = trk_new(context, m * m, sizeof(double));
    edge->re = trk_new(context, m, sizeof(double));
    edge->im = trk_new(context, m, sizeof(double));
    if (!edge->root_mass || !edge->basis || !edge->q || !edge->v || !edge->force ||
        !edge->hessenberg || !edge->h || !edge->re || !edge->im)
        return TRK_E_MEMORY;
    trk_status status = trk_assembly_create(context, TRK_BACKEND_AUTO, model->n, &model->inertia,
                                            model->mass, &edge->no_links, &edge->assembly);
    if (status != TRK_OK)
        return status;
    for (int32_t r = 0; r < model->inertia.count; r++)
        for (int64_t k = model->inertia.start[r]; k < model->inertia.start[r + 1]; k++)
            edge->root_mass[model->inertia.column[k]] +=
                model->mass[r] * model->inertia.value[k] * model->inertia.value[k];
    for (int32_t i = 0; i < model->n; i++)
        edge->root_mass[i] = sqrt(edge->root_mass[i]);
    int32_t bad = 0;
    return trk_assembly_factorize(&edge->assembly, 1, NULL, &bad);
}

trk_status trk_spectrum_edge_create(trk_context *context, const trk_model *model,
                                    trk_spectrum_edge **out)
{
    *out = NULL;
    trk_spectrum_edge *edge = trk_new(context, 1, sizeof *edge);
    if (!edge)
        return TRK_E_MEMORY;
    edge->context = context;
    edge->model = model;
    trk_status status = prepare(edge);
    if (status == TRK_OK)
        *out = edge;
    else
        trk_spectrum_edge_destroy(edge);
    return status;
}

trk_status trk_spectrum_edge_mobility(trk_spectrum_edge *edge, int32_t link, double *out)
{
    const trk_rows *links = &edge->model->links;
    trk_rows_expand(links, link, edge->model->n, edge->force);
    trk_status status = trk_solver_solve(edge->assembly.solver, edge->force);
    *out = trk_rows_dot(links, link, edge->force);
    return status;
}

/* out := A z */
static trk_status apply(trk_spectrum_edge *edge, const trk_linearised *l, const double *z,
                        double *out)
{
    const trk_model *model = edge->model;
    int32_t n = model->n;
    for (int32_t i = 0; i < n; i++) {
        edge->q[i] = z[i] / (l->scale * edge->root_mass[i]);
        edge->v[i] = z[n + i] / edge->root_mass[i];
    }
    memset(edge->force, 0, (size_t)n * sizeof(double));
    for (int32_t k = 0; k < model->links.count; k++)
        trk_rows_add(&model->links, k,
                     -l->stiffness[k] * trk_rows_dot(&model->links, k, edge->q) -
                         l->damping[k] * trk_rows_dot(&model->links, k, edge->v),
                     edge->force);
    trk_status status = trk_solver_solve(edge->assembly.solver, edge->force);
    for (int32_t i = 0; i < n; i++) {
        out[i] = l->scale * z[n + i];
        out[n + i] = edge->root_mass[i] * edge->force[i];
    }
    return status;
}

/* A start that is orthogonal to no eigenvector but by accident; the same in every run. */
static void start(int64_t count, double *x)
{
    uint64_t state = 1;
    double sum = 0;
    for (int64_t i = 0; i < count; i++) {
        state = state * 6364136223846793005u + 1442695040888963407u;
        x[i] = (double)(state >> 11) / 9007199254740992.0 - 0.5;
        sum += x[i] * x[i];
    }
    for (int64_t i = 0; i < count; i++)
        x[i] /= sqrt(sum);
}

/*
 * Column j of the Hessenberg matrix: next := next - basis basis^T next, twice, as once leaves
 * too much rounding. Returns the length of what is left.
 */
static double orthogonalise(trk_spectrum_edge *edge, int32_t j, double *next)
{
    int64_t size = 2 * (int64_t)edge->model->n;
    double sum = 0;
    for (int pass = 0; pass < 2; pass++)
        for (int32_t i = 0; i <= j; i++) {
            const double *b = edge->basis + i * size;
            double dot = 0;
            for (int64_t k = 0; k < size; k++)
                dot += b[k] * next[k];
            for (int64_t k = 0; k < size; k++)
                next[k] -= dot * b[k];
            edge->hessenberg[(int64_t)j * edge->vectors + i] += dot;
        }
    for (int64_t k = 0; k < size; k++)
        sum += next[k] * next[k];
    return sqrt(sum);
}

/* Columns of the Hessenberg matrix until the space is exhausted; their number. */
static trk_status build(trk_spectrum_edge *edge, const trk_linearised *l, int32_t *out_count)
{
    int64_t size = 2 * (int64_t)edge->model->n, m = edge->vectors;
    memset(edge->hessenberg, 0, (size_t)(m * m) * sizeof *edge->hessenberg);
    start(size, edge->basis);
    double largest = 0;
    for (int32_t j = 0; j < m; j++) {
        double *next = edge->basis + (j + 1) * size;
        trk_status status = apply(edge, l, edge->basis + j * size, next);
        if (status != TRK_OK)
            return status;
        double rest = orthogonalise(edge, j, next);
        *out_count = j + 1;
        for (int32_t i = 0; i <= j; i++)
            largest = fmax(largest, fabs(edge->hessenberg[j * m + i]));
        if (!(rest > (double)size * DBL_EPSILON * largest) || j + 1 == m)
            break;
        edge->hessenberg[j * m + j + 1] = rest;
        for (int64_t k = 0; k < size; k++)
            next[k] /= rest;
    }
    return TRK_OK;
}

trk_status trk_spectrum_edge_find(trk_spectrum_edge *edge, const trk_linearised *linearised,
                                  const double **out_re, const double **out_im, int32_t *out_count)
{
    trk_status status = build(edge, linearised, out_count);
    if (status != TRK_OK)
        return status;
    int64_t count = *out_count;
    for (int64_t j = 0; j < count; j++)
        memcpy(edge->h + j * count, edge->hessenberg + j * edge->vectors,
               (size_t)count * sizeof *edge->h);
    *out_re = edge->re;
    *out_im = edge->im;
    return trk_eigen_general(edge->context, *out_count, edge->h, edge->re, edge->im, NULL);
}
