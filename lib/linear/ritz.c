/* SPDX-License-Identifier: MIT */
/* Rayleigh-Ritz in a few vectors (LINEAR.22). */
#include "linear/ritz.h"

#include "linalg/eigen.h"

#include <string.h>

/* Elongations of all vectors in one row. */
static void elongations(const trk_rows *rows, int32_t row, int32_t n, int32_t count,
                        const double *x, double *e)
{
    for (int32_t j = 0; j < count; j++)
        e[j] = trk_rows_dot(rows, row, x + (int64_t)j * n);
}

/* a := sum over the rows of factor e e^T, count x count. */
static void project(const trk_rows *rows, const double *factor, int32_t n, int32_t count,
                    const double *x, double *e, double *a)
{
    for (int32_t r = 0; r < rows->count; r++) {
        elongations(rows, r, n, count, x, e);
        for (int32_t i = 0; i < count; i++)
            for (int32_t j = 0; j <= i; j++)
                a[(int64_t)i * count + j] += factor[r] * e[i] * e[j];
    }
    for (int32_t i = 0; i < count; i++)
        for (int32_t j = 0; j < i; j++)
            a[(int64_t)j * count + i] = a[(int64_t)i * count + j];
}

/* x := y^T x, where column k of y holds the shares of the vectors in new vector k. */
static void combine(int32_t n, int32_t count, const double *y, double *x, double *old)
{
    for (int32_t i = 0; i < n; i++) {
        for (int32_t j = 0; j < count; j++)
            old[j] = x[(int64_t)j * n + i];
        for (int32_t k = 0; k < count; k++) {
            double sum = 0;
            for (int32_t j = 0; j < count; j++)
                sum += y[(int64_t)k * count + j] * old[j];
            x[(int64_t)k * n + i] = sum;
        }
    }
}

trk_status trk_ritz(trk_context *context, const trk_vibration *vibration, int32_t count, double *x,
                    double *lambda)
{
    int32_t n = vibration->n;
    int64_t square = (int64_t)count * count;
    double *k = trk_new(context, 2 * square + count, sizeof *k);
    if (!k)
        return TRK_E_MEMORY;
    double *m = k + square, *e = m + square;
    project(vibration->links, vibration->tangent, n, count, x, e, k);
    project(vibration->inertia, vibration->mass, n, count, x, e, m);
    trk_status status = trk_eigen_symmetric(context, count, k, m, lambda);
    if (status == TRK_OK)
        combine(n, count, k, x, e);
    trk_free(context, k);
    return status;
}
