/* SPDX-License-Identifier: MIT */
/* Eigenvalues of a small Hessenberg matrix, without LAPACK. */
#ifndef TRK_RUNGEKUTTA_HESSENBERG_H
#define TRK_RUNGEKUTTA_HESSENBERG_H

#include <complex.h>
#include <stdbool.h>
#include <stdint.h>

/*
 * Eigenvalues of h (n x n, row-major, zero below the subdiagonal, destroyed) by QR steps
 * with Wilkinson's shift (RUNGEKUTTA.6). false: did not converge, or an entry is not finite.
 */
bool trk_hessenberg_eigenvalues(int32_t n, double complex *h, double complex *out_lambda);

#endif
