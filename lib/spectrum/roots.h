/* SPDX-License-Identifier: MIT */
/* Accurate roots of one. */
#ifndef TRK_SPECTRUM_ROOTS_H
#define TRK_SPECTRUM_ROOTS_H

#include <stdint.h>

/* root[2k] + i root[2k+1] = exp(-2 pi i k / n), k = 0 .. n - 1, each part rounded from an
 * argument below pi/4, hence good to one unit in the last place also for large n. */
void trk_roots_fill(int64_t n, double *root);

#endif
