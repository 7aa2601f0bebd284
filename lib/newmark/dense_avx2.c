/* SPDX-License-Identifier: MIT */
/* Dense step compiled for AVX2 registers. */
#define KERNEL trk_dense_kernel_avx2
#include "newmark/dense_kernel.h"
