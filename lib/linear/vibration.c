/* SPDX-License-Identifier: MIT */
/* Lowest modes of few and of many coordinates. */
#include "linear/vibration.h"

#include "linear/modes.h"
#include "linear/search.h"
#include "linalg/eigen.h"

#include <float.h>
#include <math.h>
#include <string.h>

/* Up to here all modes by LAPACK take about as long: the table in docs/theory/linear.md. */
enum { DENSE_COORDINATES = 100 };

static trk_status solve_dense(trk_context *context, const trk_vibration *v, int32_t count,
                              double *lambda, double *phi)
{
    int64_t square = (int64_t)v->n * v->n;
    double *k = trk_new(context, 2 * square + v->n, sizeof *k);
    if (!k)
        return TRK_E_MEMORY;
    double *m = k + square, *all = m + square;
    for (int32_t r = 0; r < v->links->count; r++)
        trk_rows_add_square(v->links, r, v->tangent[r], v->n, k);
    for (int32_t r = 0; r < v->inertia->count; r++)
        trk_rows_add_square(v->inertia, r, v->mass[r], v->n, m);
    trk_status status = trk_eigen_symmetric(context, v->n, k, m, all);
    if (status == TRK_OK) {
        trk_modes_clear_rounding(v->n, all);
        memcpy(lambda, all, (size_t)count * sizeof *lambda);
        memcpy(phi, k, (size_t)count * (size_t)v->n * sizeof *phi);
    }
    trk_free(context, k);
    return status;
}

static trk_status allocate(trk_search *s)
{
    const trk_pattern *pattern = trk_solver_pattern(s->assembly.solver);
    s->mass = trk_new(s->context, pattern->start[s->rows->n], sizeof(double));
    s->scale = trk_new(s->context, s->rows->n, sizeof(double));
    s->lambda = trk_new(s->context, 2 * (int64_t)s->wanted + TRK_SEARCH_SPARE, sizeof(double));
    s->phi = trk_new(s->context, (2 * (int64_t)s->wanted + TRK_SEARCH_SPARE) * s->rows->n,
                     sizeof(double));
    s->next =
        trk_new(s->context, ((int64_t)s->wanted + TRK_SEARCH_SPARE) * s->rows->n, sizeof(double));
    s->work = trk_new(s->context, 2 * (int64_t)s->rows->n, sizeof(double));
    return s->mass && s->scale && s->lambda && s->phi && s->next && s->work ? TRK_OK : TRK_E_MEMORY;
}

/* Rounding of K in the vectors, squared in lambda, and that of the Ritz problem are zero. */
static void clear_rounding(trk_search *s)
{
    double top = s->lambda[s->count - 1], noise = DBL_EPSILON * s->stiffest;
    double limit = 64 * s->count * DBL_EPSILON * top + 1e-4 * noise * noise / top;
    for (int32_t k = 0; k < s->wanted; k++)
        if (fabs(s->lambda[k]) <= limit)
            s->lambda[k] = 0;
}

static trk_status search(trk_search *s)
{
    const trk_vibration *v = s->rows;
    trk_status status = trk_assembly_create(s->context, TRK_BACKEND_SPARSE, v->n, v->inertia,
                                            v->mass, v->links, &s->assembly);
    if (status != TRK_OK)
        return status;
    status = allocate(s);
    if (status == TRK_OK)
        status = trk_search_complete(s);
    if (status == TRK_OK)
        status = trk_search_polish(s);
    if (status == TRK_OK)
        clear_rounding(s);
    trk_assembly_clear(&s->assembly);
    return status;
}

trk_status trk_vibration_lowest(trk_context *context, const trk_vibration *vibration, int32_t count,
                                double *lambda, double *phi)
{
    if (vibration->n <= DENSE_COORDINATES || count > vibration->n / 5)
        return solve_dense(context, vibration, count, lambda, phi);
    trk_search s = {.context = context, .rows = vibration, .wanted = count};
    trk_status status = search(&s);
    if (status == TRK_OK) {
        memcpy(lambda, s.lambda, (size_t)count * sizeof *lambda);
        memcpy(phi, s.phi, (size_t)count * (size_t)vibration->n * sizeof *phi);
    }
    double *blocks[] = {s.mass, s.scale, s.lambda, s.phi, s.next, s.work};
    for (size_t k = 0; k < sizeof blocks / sizeof *blocks; k++)
        trk_free(context, blocks[k]);
    return status;
}
