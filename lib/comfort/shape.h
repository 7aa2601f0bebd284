/* SPDX-License-Identifier: MIT */
/* Short minimum-phase filter fitted to a power response (COMFORT.5). */
#ifndef TRK_COMFORT_SHAPE_H
#define TRK_COMFORT_SHAPE_H

#include "comfort/design.h"

/*
 * Taps whose squared magnitude, least squares of the relative error, is power at the given angles
 * from 0 to pi; above 0.85 pi it counts little. false: the fit is not positive everywhere.
 */
bool trk_shape_fit(int32_t nodes, const double *angle, const double *power, double *out_taps);

#endif
