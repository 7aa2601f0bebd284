/* SPDX-License-Identifier: MIT */
/* The eigenproblems in a build without LAPACK. */
#include "linalg/eigen.h"

#ifndef TRUCKRIDE_WITH_LAPACK

static trk_status unsupported(trk_context *context, const char *what)
{
    return trk_fail(context, TRK_E_UNSUPPORTED,
                    "%s needs LAPACK, which this build was made without", what);
}

trk_status trk_eigen_symmetric(trk_context *context, int32_t n, double *k, double *m,
                               double *out_lambda)
{
    (void)n, (void)k, (void)m, (void)out_lambda;
    return unsupported(context, "the undamped eigenproblem");
}

trk_status trk_eigen_general(trk_context *context, int32_t n, double *a, double *out_re,
                             double *out_im, double *out_vectors)
{
    (void)n, (void)a, (void)out_re, (void)out_im, (void)out_vectors;
    return unsupported(context, "the damped eigenproblem");
}

trk_status trk_complex_solve(trk_context *context, int32_t n, int32_t count, double *a, double *b)
{
    (void)n, (void)count, (void)a, (void)b;
    return unsupported(context, "the frequency response");
}

trk_status trk_singular_values(trk_context *context, int32_t rows, int32_t columns, double *a,
                               double *out_singular, double *out_vt)
{
    (void)rows, (void)columns, (void)a, (void)out_singular, (void)out_vt;
    return unsupported(context, "the singular value decomposition");
}

#endif
