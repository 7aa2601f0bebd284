/* SPDX-License-Identifier: MIT */
/* Dense eigenproblems and complex systems: the only users of LAPACK. */
#ifndef TRK_LINALG_EIGEN_H
#define TRK_LINALG_EIGEN_H

#include "base/base.h"

/*
 * All: TRK_E_UNSUPPORTED in a build without LAPACK, TRK_E_RANGE when n < 1 or an
 * entry is not finite, TRK_E_MEMORY. A failure leaves the arrays undefined.
 */

/*
 * K phi = lambda M phi, symmetric, M positive definite (LINALG.3); n x n column-major, both
 * triangles given, both destroyed. out_lambda ascending, length n; eigenvectors, mass-normalised
 * (phi^T M phi = 1, largest component positive), replace the columns of k. Errors of
 * lambda are about epsilon times the largest one: a rigid mode may come out slightly negative.
 * n up to 32000.
 * TRK_E_SINGULAR: M is not positive definite. TRK_E_CONVERGENCE: LAPACK gave up.
 */
trk_status trk_eigen_symmetric(trk_context *context, int32_t n, double *k, double *m,
                               double *out_lambda);

/*
 * General real matrix a (n x n column-major, destroyed), balanced. Eigenvalues
 * re + i im, a conjugate pair in adjacent places with im > 0 first; right eigenvectors
 * as complex columns, interleaved (re, im), 2 n n doubles, unit 2-norm; out_vectors NULL
 * to skip. TRK_E_CONVERGENCE: LAPACK gave up.
 */
trk_status trk_eigen_general(trk_context *context, int32_t n, double *a, double *out_re,
                             double *out_im, double *out_vectors);

/*
 * Complex system A X = B by LU with rows scaled (LINALG.4); a (n x n) and b (n x count)
 * column-major, interleaved (re, im), both destroyed, b becomes X.
 * TRK_E_SINGULAR: A is singular.
 */
trk_status trk_complex_solve(trk_context *context, int32_t n, int32_t count, double *a, double *b);

/*
 * Singular values of a (rows x columns, column-major, destroyed), falling, length
 * min(rows, columns), and V^T of A = U S V^T (columns x columns, column-major, whole: also
 * the directions that A does not see). TRK_E_CONVERGENCE: LAPACK gave up.
 */
trk_status trk_singular_values(trk_context *context, int32_t rows, int32_t columns, double *a,
                               double *out_singular, double *out_vt);

#endif
