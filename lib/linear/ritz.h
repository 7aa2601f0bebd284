/* SPDX-License-Identifier: MIT */
/* Rayleigh-Ritz in a few vectors, from the rows (LINEAR.22). */
#ifndef TRK_LINEAR_RITZ_H
#define TRK_LINEAR_RITZ_H

#include "linear/vibration.h"

/*
 * Best pairs of K phi = lambda M phi in the span of `count` vectors, the rows of x (count x n),
 * which the mass-normalised Ritz vectors replace; lambda ascending. K is taken from elongations, so that errors of the vectors enter lambda squared and a rigid
 * mode is zero to rounding squared.
 * TRK_E_SINGULAR: the vectors are dependent.
 */
trk_status trk_ritz(trk_context *context, const trk_vibration *vibration, int32_t count, double *x,
                    double *lambda);

#endif
