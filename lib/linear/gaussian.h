/* SPDX-License-Identifier: MIT */
/* Expectations over Gaussian motion. */
#ifndef TRK_LINEAR_GAUSSIAN_H
#define TRK_LINEAR_GAUSSIAN_H

#include "base/base.h"
#include <truckride/curve.h>

/* Expected value and slope of a curve at a place of given mean and standard deviation >= 0
 * (LINEAR.32), exact piece by piece. */
void trk_gaussian_curve(const trk_curve *curve, double mean, double deviation, double *out_value,
                        double *out_slope);

#endif
