/* SPDX-License-Identifier: MIT */
/* Lane kernel compiled for AVX-512 registers. */
#define KERNEL trk_lanes_avx512
#include "batch/lanes_kernel.h"
