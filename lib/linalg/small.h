/* SPDX-License-Identifier: MIT */
/* LU with partial pivoting of small dense systems, row-major, in place, no allocation. */
#ifndef TRK_LINALG_SMALL_H
#define TRK_LINALG_SMALL_H

#include <stdbool.h>
#include <stdint.h>

/*
 * Solve A x = b; a (n x n, row-major) is destroyed, b becomes x. false: not finite, or
 * singular, that is a pivot of at most n * epsilon after the largest entry of each row
 * was scaled to 1 (LINALG.5).
 */
bool trk_small_solve(int32_t n, double *a, double *b);

#endif
