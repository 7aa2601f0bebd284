/* SPDX-License-Identifier: MIT */
/* Dense step for any processor. */
#define KERNEL trk_dense_kernel_base
#include "newmark/dense_kernel.h"
