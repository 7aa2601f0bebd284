/* SPDX-License-Identifier: MIT */
/* Sensor sums compiled for AVX512 registers. */
#define KERNEL trk_sensor_kernel_avx512
#include "simulate/sensors_kernel.h"
