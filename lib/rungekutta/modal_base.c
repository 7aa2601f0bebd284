/* SPDX-License-Identifier: MIT */
/* Modal step compiled for SSE2, or whatever the processor has for sure registers. */
#define KERNEL trk_explicit_kernel_base
#include "rungekutta/modal_kernel.h"
