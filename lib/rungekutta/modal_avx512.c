/* SPDX-License-Identifier: MIT */
/* Modal step compiled for AVX-512 registers. */
#define KERNEL trk_explicit_kernel_avx512
#include "rungekutta/modal_kernel.h"
