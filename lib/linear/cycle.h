/* SPDX-License-Identifier: MIT */
/* What a law does in a closed cycle, and in Gaussian motion made of such (LINEAR.33). */
#ifndef TRK_LINEAR_CYCLE_H
#define TRK_LINEAR_CYCLE_H

#include "law/law.h"

/* Motion e = mean + e_size x, v = v_size y, with x = cos, y = -sin of an angle, or both Gaussian
 * of variance 1. */
typedef struct trk_swing {
    double mean, e_size, v_size;
} trk_swing;

/* Averages of f - rest, (f - rest) x and (f - rest) y, rest the force at rest at the mean. */
typedef struct trk_parts {
    double rest, force, in_phase, quadrature;
} trk_parts;

/* Over one cycle, after the law has settled in it. false: the law leaves what it can do there. */
bool trk_cycle_average(const trk_law *law, const trk_swing *swing, trk_parts *out);

/* Over Gaussian motion. The same if it does so within four standard deviations. */
bool trk_cycle_expect(const trk_law *law, const trk_swing *swing, trk_parts *out);

#endif
