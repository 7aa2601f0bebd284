/* SPDX-License-Identifier: MIT */
/* Modal step compiled for AVX2 registers. */
#define KERNEL trk_explicit_kernel_avx2
#include "rungekutta/modal_kernel.h"
