/* SPDX-License-Identifier: MIT */
/* Symmetric eigenproblem of a few dozen unknowns, without LAPACK. */
#ifndef TRK_RUNGEKUTTA_JACOBI_H
#define TRK_RUNGEKUTTA_JACOBI_H

#include <stdint.h>

/*
 * K phi = lambda M phi, M symmetric positive definite, n x n row-major, both destroyed: columns
 * phi of out_phi with phi^T M phi = 1, lambda unordered (RUNGEKUTTA.8). work: n x n.
 */
void trk_jacobi_modes(int32_t n, double *k, double *m, double *out_lambda, double *out_phi,
                      double *work);

#endif
