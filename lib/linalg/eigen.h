/* SPDX-License-Identifier: MIT */
/* Eigenproblems and complex systems: the only users of LAPACK and ARPACK. */
#ifndef TRK_LINALG_EIGEN_H
#define TRK_LINALG_EIGEN_H

#include "linalg/solver.h"

/*
 * All but trk_eigen_lowest(): TRK_E_UNSUPPORTED in a build without LAPACK, TRK_E_RANGE when n < 1 or an
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

/* K phi = lambda M phi of a large pencil, through the factorization of S = K + sigma M. */
typedef struct trk_pencil {
    trk_solver *solver; /* S, factorized                                             */
    const double *mass; /* M, in the pattern of the solver                           */
    double sigma;       /* > 0: also free bodies, whose K is singular, have an S      */
} trk_pencil;

/*
 * `count` pairs of lowest lambda by shift-invert Lanczos with restarts (LINALG.7), ascending;
 * eigenvectors, mass-normalised, are the rows of out_phi, count x n. `known` pairs found before,
 * the rows of known_phi, are left out: so copies of a multiple eigenvalue are found that one
 * starting vector cannot see. known + 2 count + 1 <= n must hold.
 * TRK_E_UNSUPPORTED: the build has no ARPACK. TRK_E_CONVERGENCE: ARPACK gave up.
 *
 * ARPACK keeps its place in static variables. A lock of the process lets one call at a time run;
 * it cannot keep out a program that calls the same copy of ARPACK by itself.
 */
trk_status trk_eigen_lowest(trk_context *context, const trk_pencil *pencil, int32_t known,
                            const double *known_phi, int32_t count, double *out_lambda,
                            double *out_phi);

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
