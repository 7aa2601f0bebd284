/* SPDX-License-Identifier: MIT */
/* Step in modal coordinates compiled for AVX2 registers. */
#define KERNEL trk_fast_kernel_avx2
#include "newmark/kernel_body.h"
