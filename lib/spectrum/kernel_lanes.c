/* SPDX-License-Identifier: MIT */
/* FFT kernel for four sequences at once, in whatever vector registers the build allows. */
#if defined(__GNUC__)
/* Aligned as the ABI without AVX aligns; GCC notes a change of ABI otherwise. */
typedef double lanes __attribute__((vector_size(32), aligned(16), may_alias));
#define REAL lanes
#define LANES 4
#else
#define REAL double
#define LANES 1
#endif
#define TARGET
#include "spectrum/kernel_body.h"

const trk_fft_kernel trk_fft_kernel_lanes = KERNEL;
