/* SPDX-License-Identifier: MIT */
/* Sensor sums compiled for AVX2 registers. */
#define KERNEL trk_sensor_kernel_avx2
#include "simulate/sensors_kernel.h"
