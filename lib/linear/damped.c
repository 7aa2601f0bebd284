/* SPDX-License-Identifier: MIT */
/*
 * Damped modes (LINEAR.2) in modal coordinates: with the undamped modes Phi and
 * c = Phi^T C Phi, lambda and y are eigenvalue and upper half of an eigenvector of
 *
 *     [  0   I ]
 *     [ -w^2 -c ]          phi = Phi y                                (LINEAR.5)
 *
 * which is far better scaled than M^-1 K and M^-1 C.
 */
#include "linear/modes.h"
#include "linear/tangent.h"

#include "linalg/eigen.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* |lambda| and the column it stands in. */
typedef struct rank {
    double size;
    int32_t column;
} rank;

/* Arrays of the general eigenproblem of order 2 n. */
typedef struct workspace {
    double *matrix, *re, *im, *vectors, *half;
    rank *order;
} workspace;

/* Phi^T C Phi into c, column-major; half is n x n. */
static void project(int32_t n, const double *phi, const double *damping, double *half, double *c)
{
    for (int32_t k = 0; k < n; k++)
        for (int32_t i = 0; i < n; i++) {
            double sum = 0;
            for (int32_t j = 0; j < n; j++)
                sum += damping[(int64_t)i * n + j] * phi[(int64_t)k * n + j];
            half[(int64_t)k * n + i] = sum;
        }
    for (int32_t k = 0; k < n; k++)
        for (int32_t l = 0; l < n; l++) {
            double sum = 0;
            for (int32_t i = 0; i < n; i++)
                sum += phi[(int64_t)l * n + i] * half[(int64_t)k * n + i];
            c[(int64_t)k * n + l] = sum;
        }
}

static void fill_matrix(int32_t n, const double *omega_squared, const double *c, double *matrix)
{
    int64_t order = 2 * (int64_t)n;
    memset(matrix, 0, (size_t)(order * order) * sizeof *matrix);
    for (int32_t k = 0; k < n; k++) {
        matrix[(n + k) * order + k] = 1;
        matrix[k * order + n + k] = -omega_squared[k];
        for (int32_t i = 0; i < n; i++)
            matrix[(n + k) * order + n + i] = -c[(int64_t)k * n + i];
    }
}

static int by_size(const void *a, const void *b)
{
    const rank *x = a, *y = b;
    if (x->size != y->size)
        return x->size < y->size ? -1 : 1;
    return x->column - y->column;
}

/* What is rounding of the largest eigenvalue is zero: place and speed of a free body. */
static void clear_rounding(int32_t order, double *re, double *im)
{
    double largest = 0;
    for (int32_t k = 0; k < order; k++)
        largest = fmax(largest, hypot(re[k], im[k]));
    for (int32_t k = 0; k < order; k++)
        if (hypot(re[k], im[k]) <= order * DBL_EPSILON * largest)
            re[k] = im[k] = 0;
}

/* One mode for each eigenvalue with im >= 0, by rising |lambda|. */
static int32_t select_modes(int32_t n, const workspace *w)
{
    int32_t count = 0;
    for (int32_t k = 0; k < 2 * n; k++)
        if (w->im[k] >= 0)
            w->order[count++] = (rank){hypot(w->re[k], w->im[k]), k};
    qsort(w->order, (size_t)count, sizeof *w->order, by_size);
    return count;
}

/* Shapes Phi y of the selected modes. */
static void take_modes(trk_modes *modes, const double *phi, const workspace *w)
{
    int32_t n = modes->n;
    for (int32_t k = 0; k < modes->count; k++) {
        int32_t column = w->order[k].column;
        const double *y = w->vectors + (int64_t)column * 4 * n;
        modes->lambda_re[k] = w->re[column];
        modes->lambda_im[k] = w->im[column];
        for (int32_t j = 0; j < n; j++)
            for (int32_t i = 0; i < n; i++) {
                modes->re[(int64_t)k * n + i] += phi[(int64_t)j * n + i] * y[2 * j];
                modes->im[(int64_t)k * n + i] += phi[(int64_t)j * n + i] * y[2 * j + 1];
            }
    }
}

static trk_status solve(trk_context *context, const trk_model *model, trk_tangent *tangent,
                        workspace *w, trk_modes **out_modes)
{
    int32_t n = tangent->n;
    trk_status status = trk_eigen_symmetric(context, n, tangent->stiffness, tangent->mass, w->re);
    if (status != TRK_OK)
        return status;
    trk_modes_clear_rounding(n, w->re);
    const double *phi = tangent->stiffness;
    project(n, phi, tangent->damping, w->half, tangent->mass);
    fill_matrix(n, w->re, tangent->mass, w->matrix);
    status = trk_eigen_general(context, 2 * n, w->matrix, w->re, w->im, w->vectors);
    if (status != TRK_OK)
        return status;
    clear_rounding(2 * n, w->re, w->im);
    int32_t count = select_modes(n, w);
    status = trk_modes_allocate(context, n, count, out_modes);
    if (status != TRK_OK)
        return status;
    (*out_modes)->count = count;
    take_modes(*out_modes, phi, w);
    return trk_modes_finish(*out_modes, model);
}

trk_status trk_modes_create_damped(trk_context *context, const trk_model *model, const double *q,
                                   const double *v, trk_modes **out_modes)
{
    TRK_REQUIRE(context, out_modes, "trk_modes_create_damped");
    *out_modes = NULL;
    TRK_REQUIRE(context, context, "trk_modes_create_damped");
    TRK_REQUIRE(context, model, "trk_modes_create_damped");
    trk_tangent tangent;
    trk_status status = trk_tangent_create(context, model, q, v, &tangent);
    if (status != TRK_OK)
        return status;
    int64_t n = tangent.n;
    workspace w = {.matrix = trk_new(context, 4 * n * n, sizeof(double)),
                   .re = trk_new(context, 2 * n, sizeof(double)),
                   .im = trk_new(context, 2 * n, sizeof(double)),
                   .vectors = trk_new(context, 8 * n * n, sizeof(double)),
                   .half = trk_new(context, n * n, sizeof(double)),
                   .order = trk_new(context, 2 * n, sizeof *w.order)};
    trk_modes *modes = NULL;
    status = w.matrix && w.re && w.im && w.vectors && w.half && w.order
                 ? solve(context, model, &tangent, &w, &modes)
                 : TRK_E_MEMORY;
    void *blocks[] = {w.matrix, w.re, w.im, w.vectors, w.half, w.order, tangent.mass};
    for (size_t k = 0; k < sizeof blocks / sizeof *blocks; k++)
        trk_free(context, blocks[k]);
    if (status != TRK_OK) {
        trk_modes_destroy(modes);
        return status;
    }
    *out_modes = modes;
    return TRK_OK;
}
