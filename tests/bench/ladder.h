/* SPDX-License-Identifier: MIT */
/* A ladder frame of beams in space on four tires, whose dampers are curves. */
#ifndef TRK_TESTS_BENCH_LADDER_H
#define TRK_TESTS_BENCH_LADDER_H

#include "bench.h"

/* n coordinates, a multiple of 12, at least 24. Ends the program on failure. */
trk_model *ladder_build(const bench *b, int32_t n);

#endif
