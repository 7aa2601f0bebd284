/* SPDX-License-Identifier: MIT */
/* Counter-based random numbers: a number is a function of its place, there is no state. */
#ifndef TRK_BASE_RANDOM_H
#define TRK_BASE_RANDOM_H

#include <stdint.h>

/*
 * Philox4x32-10 (STUDY.2): 128 bits from a counter of 128 and a key of 64.
 * J. K. Salmon, M. A. Moraes, R. O. Dror, D. E. Shaw, Parallel random numbers: as easy as
 * 1, 2, 3, SC'11 (2011).
 */
void trk_philox(const uint32_t counter[4], const uint32_t key[2], uint32_t out[4]);

/* What a random number is for: the last word of its counter. A permutation takes one
 * purpose for each of its rounds. */
enum {
    TRK_PURPOSE_SAMPLE = 0,
    TRK_PURPOSE_PERMUTE = 1,
    TRK_PURPOSE_ROAD_ORIGIN = 16,
    TRK_PURPOSE_ROAD_SIGN = 17,
    TRK_PURPOSE_ROAD_FLIP = 18
};

/* Random bits number `place` of a stream (a parameter, an octave) under a seed, for a purpose. */
void trk_random_bits(int64_t seed, uint64_t place, uint32_t stream, uint32_t purpose,
                     uint32_t out[4]);

/* Uniform in (0, 1), a multiple of 2^-53: never 0, never 1. */
double trk_random_uniform(int64_t seed, uint64_t place, uint32_t stream);

/*
 * Where a keyed permutation of 0 .. n - 1 puts `place`, 1 <= n <= 2^62 (STUDY.3). Each
 * stream has a permutation of its own.
 */
uint64_t trk_random_permute(int64_t seed, uint32_t stream, uint64_t n, uint64_t place);

#endif
