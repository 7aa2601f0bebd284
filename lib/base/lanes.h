/* SPDX-License-Identifier: MIT */
/*
 * Vectors as wide as the registers of the instruction set that the including file is compiled for:
 * 8 numbers with AVX-512, 4 with AVX2, else 2. For the files of kernels only.
 */
#ifndef TRK_BASE_LANES_H
#define TRK_BASE_LANES_H

#include <stdbool.h>
#include <stdint.h>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

#if defined(__AVX512DQ__)
enum { WIDTH = 8 };
#elif defined(__AVX2__)
enum { WIDTH = 4 };
#else
enum { WIDTH = 2 };
#endif

typedef double lanes __attribute__((vector_size(8 * WIDTH)));
typedef int64_t lane_mask __attribute__((vector_size(8 * WIDTH)));

#define INLINE static inline __attribute__((always_inline, unused))

INLINE lanes spread(double x)
{
    return (lanes){0} + x;
}

INLINE lanes absolute(lanes x)
{
    return (lanes)((lane_mask)x & INT64_MAX);
}

/* b where one of them is not a number. */
INLINE lanes larger(lanes a, lanes b)
{
#if defined(__AVX512DQ__)
    return (lanes)_mm512_max_pd((__m512d)a, (__m512d)b);
#elif defined(__AVX2__)
    return (lanes)_mm256_max_pd((__m256d)a, (__m256d)b);
#elif defined(__SSE2__)
    return (lanes)_mm_max_pd((__m128d)a, (__m128d)b);
#else
    lane_mask m = a > b;
    return (lanes)(((lane_mask)a & m) | ((lane_mask)b & ~m));
#endif
}

/* Is any lane of a comparison true? */
INLINE bool any(lane_mask m)
{
#if defined(__AVX512DQ__)
    return _mm512_movepi64_mask((__m512i)m) != 0;
#elif defined(__AVX2__)
    return _mm256_movemask_pd((__m256d)m) != 0;
#elif defined(__SSE2__)
    return _mm_movemask_pd((__m128d)m) != 0;
#else
    return m[0] | m[1];
#endif
}

/* The largest lane, in all lanes. */
INLINE lanes largest(lanes x)
{
#if defined(__AVX512DQ__)
    return spread(_mm512_reduce_max_pd((__m512d)x));
#elif defined(__AVX2__)
    __m256d a = (__m256d)x, b = _mm256_max_pd(a, _mm256_permute2f128_pd(a, a, 1));
    return (lanes)_mm256_max_pd(b, _mm256_permute_pd(b, 5));
#else
    return spread(x[0] > x[1] ? x[0] : x[1]);
#endif
}

INLINE lanes get(const double *array, int64_t block)
{
    return ((const lanes *)array)[block];
}

INLINE void put(double *array, int64_t block, lanes x)
{
    ((lanes *)array)[block] = x;
}

#endif
