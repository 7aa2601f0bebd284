/* SPDX-License-Identifier: MIT */
/* Masses of 10 kg in columns on a road, neighbours tied by springs and dampers, four of the
 * dampers curves: one column is a chain, more fill in the factor like a frame of beams. */
#ifndef TRK_TESTS_BENCH_CHAIN_H
#define TRK_TESTS_BENCH_CHAIN_H

#include "bench.h"

enum { CHAIN_CURVES = 4 };

/* n masses in so many columns. Ends the program on failure. */
trk_model *chain_build(const bench *b, int32_t n, int32_t columns);

#endif
