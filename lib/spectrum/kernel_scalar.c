/* SPDX-License-Identifier: MIT */
/* FFT kernel for one sequence at a time. */
#define REAL double
#define LANES 1
#define TARGET
#include "spectrum/kernel_body.h"

const trk_fft_kernel trk_fft_kernel_scalar = KERNEL;
