/* SPDX-License-Identifier: MIT */
/* Lane kernel compiled for the registers that every processor of the kind has. */
#define KERNEL trk_lanes_portable
#include "batch/lanes_kernel.h"
