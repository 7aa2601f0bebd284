/* SPDX-License-Identifier: MIT */
/* Step in modal coordinates compiled for AVX512 registers. */
#define KERNEL trk_fast_kernel_avx512
#include "newmark/kernel_body.h"
