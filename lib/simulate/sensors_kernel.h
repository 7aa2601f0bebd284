/* SPDX-License-Identifier: MIT */
/*
 * Body of the sensor sum, included once for each instruction set with KERNEL set to the name of
 * the function. Four registers of sums hide the latency of an addition.
 */
#include "simulate/sensors.h"

#include <string.h>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

/* Store past the caches. */
#if defined(__AVX512F__)
enum { WIDTH = 8 };
#define STREAM(out, x) _mm512_stream_pd(out, (__m512d)(x))
#elif defined(__AVX__)
enum { WIDTH = 4 };
#define STREAM(out, x) _mm256_stream_pd(out, (__m256d)(x))
#elif defined(__SSE2__)
enum { WIDTH = 2 };
#define STREAM(out, x) _mm_stream_pd(out, (__m128d)(x))
#else
enum { WIDTH = 2 };
#define STREAM(out, x) memcpy(out, &(x), sizeof(x))
#endif
enum { REGISTERS = 4, STRIDE = REGISTERS * WIDTH };

typedef double lanes __attribute__((vector_size(8 * WIDTH), may_alias));

void KERNEL(const trk_sensor_sum *sum, const double *block, int64_t count, bool stream, double *out)
{
    stream &= (uintptr_t)out % (WIDTH * sizeof *out) == 0;
    for (int64_t first = 0; first < count; first += STRIDE) {
        lanes total[REGISTERS] = {{0}};
        for (int32_t k = 0; k < sum->count; k++) {
            const double *column = block + (int64_t)sum->column[k] * TRK_SENSORS_STRIDE + first;
            for (int r = 0; r < REGISTERS; r++)
                total[r] += sum->coefficient[k] * ((const lanes *)column)[r];
        }
        int64_t rest = count - first < STRIDE ? count - first : STRIDE;
        if (stream && rest == STRIDE)
            for (int r = 0; r < REGISTERS; r++)
                STREAM(out + first + r * WIDTH, total[r]);
        else
            memcpy(out + first, total, (size_t)rest * sizeof *out);
    }
#if defined(__SSE2__)
    if (stream)
        _mm_sfence(); /* the samples are there for any thread */
#endif
}
