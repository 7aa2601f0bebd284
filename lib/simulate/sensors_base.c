/* SPDX-License-Identifier: MIT */
/* Sensor sums for any processor. */
#define KERNEL trk_sensor_kernel_base
#include "simulate/sensors_kernel.h"
