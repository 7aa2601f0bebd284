/* SPDX-License-Identifier: MIT */
/* Which of the kernels that are compiled for several instruction sets this processor can run. */
#ifndef TRK_BASE_PROCESSOR_H
#define TRK_BASE_PROCESSOR_H

#include <stdint.h>

#if defined(__x86_64__) && defined(__GNUC__)
#define TRK_X86_KERNELS 1
#endif

enum {
    TRK_PROCESSOR_ANY = 0,
    TRK_PROCESSOR_AVX2 = 1,  /* with FMA            */
    TRK_PROCESSOR_AVX512 = 2 /* F and DQ, with AVX2 */
};

static inline int32_t trk_processor(void)
{
#ifdef TRK_X86_KERNELS
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
        return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq")
                   ? TRK_PROCESSOR_AVX512
                   : TRK_PROCESSOR_AVX2;
#endif
    return TRK_PROCESSOR_ANY;
}

#endif
