/* SPDX-License-Identifier: MIT */
/* Lane kernel compiled for AVX2 registers. */
#define KERNEL trk_lanes_avx2
#include "batch/lanes_kernel.h"
