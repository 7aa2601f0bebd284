/* SPDX-License-Identifier: MIT */
/* Eigenvalues of a general real matrix: damped modes in state space. */
#include "linalg/eigen.h"

#ifdef TRUCKRIDE_WITH_LAPACK

#include "linalg/dense_input.h"
#include "linalg/lapack.h"

/*
 * dgeev balances the matrix and gives vectors of unit 2-norm. It packs a conjugate pair
 * into two real columns, the real and the imaginary part of the vector whose eigenvalue
 * has the positive imaginary part and comes first.
 */
static void unpack(int32_t n, const double *im, const double *packed, double *out)
{
    for (int32_t j = 0; j < n; j++) {
        const double *real = packed + (int64_t)j * n;
        bool pair = im[j] > 0.0;
        for (int32_t i = 0; i < n; i++) {
            double *entry = out + 2 * ((int64_t)j * n + i);
            entry[0] = real[i];
            entry[1] = pair ? real[n + i] : 0.0;
            if (pair) {
                double *conjugate = entry + 2 * (int64_t)n;
                conjugate[0] = entry[0];
                conjugate[1] = -entry[1];
            }
        }
        if (pair)
            j++;
    }
}

static trk_status call_dgeev(trk_context *context, int32_t n, double *a, double *re, double *im,
                             double *vectors)
{
    const int32_t one = 1, query = -1;
    const char *job = vectors ? "V" : "N";
    double unused = 0.0, wanted = 0.0;
    double *right = vectors ? vectors : &unused;
    int32_t leading = vectors ? n : 1, info = 0;
    dgeev_("N", job, &n, a, &n, re, im, &unused, &one, right, &leading, &wanted, &query, &info, 1,
           1);
    int32_t size = (int32_t)wanted;
    double *work = trk_new(context, size, sizeof *work);
    if (!work)
        return TRK_E_MEMORY;
    dgeev_("N", job, &n, a, &n, re, im, &unused, &one, right, &leading, work, &size, &info, 1, 1);
    trk_free(context, work);
    if (info > 0)
        return trk_fail(context, TRK_E_CONVERGENCE,
                        "eigenproblem: dgeev of %d unknowns did not converge (info %d)", (int)n,
                        (int)info);
    if (info < 0)
        return trk_fail(context, TRK_E_INTERNAL, "eigenproblem: dgeev rejected argument %d",
                        (int)-info);
    return TRK_OK;
}

trk_status trk_eigen_general(trk_context *context, int32_t n, double *a, double *out_re,
                             double *out_im, double *out_vectors)
{
    TRK_REQUIRE(context, a, "trk_eigen_general");
    TRK_REQUIRE(context, out_re, "trk_eigen_general");
    TRK_REQUIRE(context, out_im, "trk_eigen_general");
    if (n < 1)
        return trk_fail(context, TRK_E_RANGE, "eigenproblem: %d unknowns, expected at least 1",
                        (int)n);
    trk_status status = trk_require_finite(context, "matrix", n, n, 1, a);
    if (status != TRK_OK)
        return status;
    double *packed = NULL;
    if (out_vectors) {
        packed = trk_new(context, (int64_t)n * n, sizeof *packed);
        if (!packed)
            return TRK_E_MEMORY;
    }
    status = call_dgeev(context, n, a, out_re, out_im, packed);
    if (status == TRK_OK && out_vectors)
        unpack(n, out_im, packed, out_vectors);
    trk_free(context, packed);
    return status;
}

#endif
