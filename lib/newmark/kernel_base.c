/* SPDX-License-Identifier: MIT */
/* Step in modal coordinates for any processor. */
#define KERNEL trk_fast_kernel_base
#include "newmark/kernel_body.h"
