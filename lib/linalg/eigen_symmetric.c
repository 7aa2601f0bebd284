/* SPDX-License-Identifier: MIT */
/* Symmetric-definite eigenproblem of undamped vibration (LINALG.3). */
#include "linalg/eigen.h"

#ifdef TRUCKRIDE_WITH_LAPACK

#include "linalg/dense_input.h"
#include "linalg/lapack.h"
#include "linalg/pattern.h"

#include <math.h>

/* The workspace of dsygvd, 2 n^2 + 6 n + 1, must be countable in 32 bits. */
enum { LARGEST = 32000 };

typedef struct workspace {
    double *work;
    int32_t *iwork;
    int32_t work_size, iwork_size;
} workspace;

static void workspace_free(trk_context *context, workspace *w)
{
    trk_free(context, w->work);
    trk_free(context, w->iwork);
}

static int32_t call_dsygvd(int32_t n, double *k, double *m, double *lambda, workspace *w)
{
    const int32_t itype = 1;
    int32_t info = 0;
    dsygvd_(&itype, "V", "L", &n, k, &n, m, &n, lambda, w->work, &w->work_size, w->iwork,
            &w->iwork_size, &info, 1, 1);
    return info;
}

static trk_status workspace_allocate(trk_context *context, int32_t n, workspace *w)
{
    double size = 0.0, unused = 0.0;
    int32_t isize = 0;
    workspace query = {.work = &size, .iwork = &isize, .work_size = -1, .iwork_size = -1};
    call_dsygvd(n, &unused, &unused, &unused, &query);
    w->work_size = (int32_t)size;
    w->iwork_size = isize;
    w->work = trk_new(context, w->work_size, sizeof *w->work);
    w->iwork = w->work ? trk_new(context, w->iwork_size, sizeof *w->iwork) : NULL;
    return w->iwork ? TRK_OK : TRK_E_MEMORY;
}

static trk_status not_definite(trk_context *context, int32_t unknown)
{
    return trk_fail(context, TRK_E_SINGULAR,
                    "eigenproblem: the mass matrix is not positive definite at unknown %d",
                    (int)unknown);
}

/* Pivots of the Cholesky factor that dsygvd leaves in m, which itself stops only at <= 0. */
static trk_status check_mass_factor(trk_context *context, int32_t n, const double *l)
{
    double tolerance = trk_pivot_tolerance(n);
    for (int32_t j = 0; j < n; j++) {
        double diagonal = 0.0; /* of M: |row j of L|^2 */
        for (int32_t i = 0; i <= j; i++)
            diagonal += l[(int64_t)i * n + j] * l[(int64_t)i * n + j];
        double root = l[(int64_t)j * n + j];
        if (!(root * root > tolerance * diagonal))
            return not_definite(context, j);
    }
    return TRK_OK;
}

/*
 * Largest component positive. Components equal but for rounding (symmetric and antisymmetric
 * modes) must not decide by chance: the first wins.
 */
static void orient(int32_t n, double *phi)
{
    double largest = 0.0;
    for (int32_t i = 0; i < n; i++)
        largest = fmax(largest, fabs(phi[i]));
    int32_t first = 0;
    while (first < n - 1 && fabs(phi[first]) < (1.0 - 1e-8) * largest)
        first++;
    if (phi[first] < 0.0)
        for (int32_t i = 0; i < n; i++)
            phi[i] = -phi[i];
}

static trk_status solve(trk_context *context, int32_t n, double *k, double *m, double *lambda,
                        workspace *w)
{
    int32_t info = call_dsygvd(n, k, m, lambda, w);
    if (info > n)
        return not_definite(context, info - n - 1);
    if (info > 0)
        return trk_fail(context, TRK_E_CONVERGENCE,
                        "eigenproblem: dsygvd of %d unknowns did not converge (info %d)", (int)n,
                        (int)info);
    if (info < 0)
        return trk_fail(context, TRK_E_INTERNAL, "eigenproblem: dsygvd rejected argument %d",
                        (int)-info);
    trk_status status = check_mass_factor(context, n, m);
    for (int32_t j = 0; j < n; j++)
        orient(n, k + (int64_t)j * n);
    return status;
}

trk_status trk_eigen_symmetric(trk_context *context, int32_t n, double *k, double *m,
                               double *out_lambda)
{
    TRK_REQUIRE(context, k, "trk_eigen_symmetric");
    TRK_REQUIRE(context, m, "trk_eigen_symmetric");
    TRK_REQUIRE(context, out_lambda, "trk_eigen_symmetric");
    if (n < 1 || n > LARGEST)
        return trk_fail(context, TRK_E_RANGE, "eigenproblem: %d unknowns, expected 1 to %d", (int)n,
                        (int)LARGEST);
    trk_status status = trk_require_finite(context, "stiffness matrix", n, n, 1, k);
    if (status == TRK_OK)
        status = trk_require_finite(context, "mass matrix", n, n, 1, m);
    if (status != TRK_OK)
        return status;
    workspace w = {0};
    status = workspace_allocate(context, n, &w);
    if (status == TRK_OK)
        status = solve(context, n, k, m, out_lambda, &w);
    workspace_free(context, &w);
    return status;
}

#endif
