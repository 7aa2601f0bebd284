/* SPDX-License-Identifier: MIT */
/* Complex linear system: the dynamic stiffness of frequency response (LINALG.4). */
#include "linalg/eigen.h"

#ifdef TRUCKRIDE_WITH_LAPACK

#include "linalg/dense_input.h"
#include "linalg/lapack.h"
#include "linalg/pattern.h"

#include <math.h>

static double magnitude(const double *z)
{
    return fmax(fabs(z[0]), fabs(z[1]));
}

static trk_status singular(trk_context *context, int32_t unknown)
{
    return trk_fail(context, TRK_E_SINGULAR, "complex system: the matrix is singular at unknown %d",
                    (int)unknown);
}

static void scale_row(int32_t n, int32_t columns, int32_t i, double scale, double *a)
{
    for (int32_t j = 0; j < columns; j++) {
        double *z = a + 2 * ((int64_t)j * n + i);
        z[0] *= scale;
        z[1] *= scale;
    }
}

/*
 * Powers of two that bring the largest entry of each row to about 1: forces and moments
 * then compete fairly for the pivot, and X does not change.
 */
static trk_status equilibrate(trk_context *context, int32_t n, int32_t count, double *a, double *b)
{
    for (int32_t i = 0; i < n; i++) {
        double largest = 0.0;
        for (int32_t j = 0; j < n; j++)
            largest = fmax(largest, magnitude(a + 2 * ((int64_t)j * n + i)));
        if (largest == 0.0)
            return singular(context, i);
        double scale = ldexp(1.0, -ilogb(largest));
        scale_row(n, n, i, scale, a);
        scale_row(n, count, i, scale, b);
    }
    return TRK_OK;
}

static void measure_columns(int32_t n, const double *a, double *largest)
{
    for (int32_t j = 0; j < n; j++)
        for (int32_t i = 0; i < n; i++)
            largest[j] = fmax(largest[j], magnitude(a + 2 * ((int64_t)j * n + i)));
}

static trk_status call_zgesv(trk_context *context, int32_t n, int32_t count, double *a, double *b,
                             const double *largest, int32_t *pivots)
{
    int32_t info = 0;
    zgesv_(&n, &count, a, &n, pivots, b, &n, &info);
    if (info < 0)
        return trk_fail(context, TRK_E_INTERNAL, "complex system: zgesv rejected argument %d",
                        (int)-info);
    if (info > 0)
        return singular(context, info - 1);
    /* zgesv stops at exact zeros only; apply the rule of the other solvers (LINALG.2). */
    double tolerance = trk_pivot_tolerance(n);
    for (int32_t j = 0; j < n; j++)
        if (!(magnitude(a + 2 * ((int64_t)j * n + j)) > tolerance * largest[j]))
            return singular(context, j);
    return TRK_OK;
}

trk_status trk_complex_solve(trk_context *context, int32_t n, int32_t count, double *a, double *b)
{
    TRK_REQUIRE(context, a, "trk_complex_solve");
    TRK_REQUIRE(context, b, "trk_complex_solve");
    if (n < 1 || count < 1)
        return trk_fail(context, TRK_E_RANGE,
                        "complex system: %d unknowns, %d right-hand sides, expected at least 1",
                        (int)n, (int)count);
    trk_status status = trk_require_finite(context, "matrix of the complex system", n, n, 2, a);
    if (status == TRK_OK)
        status =
            trk_require_finite(context, "right-hand side of the complex system", n, count, 2, b);
    if (status == TRK_OK)
        status = equilibrate(context, n, count, a, b);
    if (status != TRK_OK)
        return status;
    double *largest = trk_new(context, n, sizeof *largest);
    int32_t *pivots = largest ? trk_new(context, n, sizeof *pivots) : NULL;
    if (pivots) {
        measure_columns(n, a, largest);
        status = call_zgesv(context, n, count, a, b, largest, pivots);
    } else {
        status = TRK_E_MEMORY;
    }
    trk_free(context, largest);
    trk_free(context, pivots);
    return status;
}

#endif
