/* SPDX-License-Identifier: MIT */
/* What one core of this machine can do: double-precision FMA peak, read bandwidth, triad. */
#include "bench.h"

#include <math.h>
#include <stdlib.h>

enum { ROUNDS_OF_PEAK = 200000, ACCUMULATORS = 12, L1_DOUBLES = 2048 };

/* Enough independent chains to hide the latency, in registers of so many bytes. */
#define DEFINE_KERNELS(isa, target, bytes)                                                         \
    typedef double isa##_register __attribute__((vector_size(bytes)));                             \
    target static double isa##_peak(void)                                                          \
    {                                                                                              \
        isa##_register zero = {0}, x = zero + 0.999999, y = zero + 1e-6, a0 = zero, a1 = zero + 1, \
                       a2 = zero + 2, a3 = zero + 3, a4 = zero + 4, a5 = zero + 5, a6 = zero + 6,  \
                       a7 = zero + 7, a8 = zero + 8, a9 = zero + 9, b0 = zero + 10,                \
                       b1 = zero + 11;                                                             \
        for (int k = 0; k < ROUNDS_OF_PEAK; k++) {                                                 \
            a0 = a0 * x + y, a1 = a1 * x + y, a2 = a2 * x + y, a3 = a3 * x + y;                    \
            a4 = a4 * x + y, a5 = a5 * x + y, a6 = a6 * x + y, a7 = a7 * x + y;                    \
            a8 = a8 * x + y, a9 = a9 * x + y, b0 = b0 * x + y, b1 = b1 * x + y;                    \
        }                                                                                          \
        return (a0 + a1 + a2 + a3 + a4 + a5 + a6 + a7 + a8 + a9 + b0 + b1)[0];                     \
    }                                                                                              \
    target static double isa##_read(int64_t count, const double *x)                                \
    {                                                                                              \
        enum { LANES = (bytes) / 8 };                                                              \
        const isa##_register *v = (const isa##_register *)x;                                       \
        isa##_register a0 = {0}, a1 = a0, a2 = a0, a3 = a0, a4 = a0, a5 = a0, a6 = a0, a7 = a0;    \
        for (int64_t k = 0; k < count / LANES; k += 8) {                                           \
            a0 += v[k], a1 += v[k + 1], a2 += v[k + 2], a3 += v[k + 3];                            \
            a4 += v[k + 4], a5 += v[k + 5], a6 += v[k + 6], a7 += v[k + 7];                        \
        }                                                                                          \
        return (a0 + a1 + a2 + a3 + a4 + a5 + a6 + a7)[0];                                         \
    }

DEFINE_KERNELS(base, , 16)
#if defined(__x86_64__) && defined(__GNUC__)
DEFINE_KERNELS(avx2, __attribute__((target("avx2,fma"))), 32)
DEFINE_KERNELS(avx512, __attribute__((target("avx512f"))), 64)
#endif

typedef struct isa {
    const char *name;
    int lanes;
    double (*peak)(void);
    double (*read)(int64_t count, const double *x);
} isa;

/* Those this processor has, the widest last; returns how many. */
static int list_isas(isa *out)
{
    int count = 0;
#if defined(__x86_64__) && defined(__GNUC__)
    out[count++] = (isa){"SSE2, multiply and add", 2, base_peak, base_read};
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
        out[count++] = (isa){"AVX2, FMA", 4, avx2_peak, avx2_read};
    if (__builtin_cpu_supports("avx512f"))
        out[count++] = (isa){"AVX-512, FMA", 8, avx512_peak, avx512_read};
#else
    out[count++] = (isa){"base, multiply and add", 2, base_peak, base_read};
#endif
    return count;
}

typedef struct load {
    const isa *isa;
    int64_t count;
    double *x, *y, *z;
    volatile double sink;
} load;

static void run_peak(void *argument)
{
    load *l = argument;
    l->sink = l->isa->peak();
}

static void run_read(void *argument)
{
    load *l = argument;
    l->sink = l->isa->read(l->count, l->x);
}

static void run_triad(void *argument)
{
    load *l = argument;
    for (int64_t k = 0; k < l->count; k++)
        l->x[k] = l->y[k] + 3.0 * l->z[k];
}

static double best(const bench *b, void (*run)(void *), load *l)
{
    double seconds = INFINITY;
    for (int round = 0; round < b->rounds + 1; round++) /* the first warms up */
        seconds = fmin(seconds, bench_repeat(run, l));
    return seconds;
}

static void report_memory(bench *b, const isa *widest)
{
    /* Several times the last-level cache of a server core, three arrays. */
    int64_t large = b->tiny ? 1 << 16 : 1 << 24;
    load l = {.isa = widest, .count = L1_DOUBLES};
    l.x = bench_zeros(large);
    l.y = bench_zeros(large);
    l.z = bench_zeros(large);
    double l1 = 8.0 * (double)l.count / best(b, run_read, &l);
    l.count = large;
    b->dram = 8.0 * (double)large / best(b, run_read, &l);
    double triad = 24.0 * (double)large / best(b, run_triad, &l);
    bench_report(b, (bench_row){"L1 read, 16 KiB", 1e-9 * l1, "GB/s", 8 * b->peak / l1,
                                "flop per number at peak"});
    bench_report(
        b, (bench_row){"DRAM read, one core", 1e-9 * b->dram, "GB/s", b->dram / l1, "L1 read"});
    bench_report(b, (bench_row){"DRAM triad, one core, 24 B a number", 1e-9 * triad, "GB/s",
                                triad / b->dram, "DRAM read"});
    free(l.x);
    free(l.y);
    free(l.z);
}

void bench_machine(bench *b)
{
    isa isas[3];
    int count = list_isas(isas);
    double rate[3];
    for (int k = 0; k < count; k++) {
        load l = {.isa = &isas[k]};
        rate[k] = 2.0 * ACCUMULATORS * isas[k].lanes * ROUNDS_OF_PEAK / best(b, run_peak, &l);
        b->peak = fmax(b->peak, rate[k]);
    }
    for (int k = 0; k < count; k++)
        bench_report(
            b, (bench_row){isas[k].name, 1e-9 * rate[k], "Gflop/s", rate[k] / b->peak, "FMA peak"});
    report_memory(b, &isas[count - 1]);
}
