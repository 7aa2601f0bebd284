/* SPDX-License-Identifier: MIT */
/* Dense step compiled for AVX512 registers. */
#define KERNEL trk_dense_kernel_avx512
#include "newmark/dense_kernel.h"
