/* SPDX-License-Identifier: MIT */
/* FFT kernel for four sequences at once in AVX2 registers, and the choice between kernels. */
#if defined(__GNUC__) && defined(__x86_64__)
typedef double lanes __attribute__((vector_size(32), may_alias));
#define REAL lanes
#define LANES 4
#define TARGET __attribute__((target("avx2")))
#include "spectrum/kernel_body.h"

static const trk_fft_kernel avx2 = KERNEL;

const trk_fft_kernel *trk_fft_kernel_widest(void)
{
    return __builtin_cpu_supports("avx2") ? &avx2 : &trk_fft_kernel_lanes;
}
#else
#include "spectrum/kernel.h"

const trk_fft_kernel *trk_fft_kernel_widest(void)
{
    return &trk_fft_kernel_lanes;
}
#endif
