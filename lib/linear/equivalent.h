/* SPDX-License-Identifier: MIT */
/* The linear link nearest to a link in Gaussian motion (LINEAR.31). */
#ifndef TRK_LINEAR_EQUIVALENT_H
#define TRK_LINEAR_EQUIVALENT_H

#include "law/link_law.h"

typedef struct trk_equivalent {
    double stiffness, damping;
    double force, slope; /* mean force, and its slope over the mean elongation */
} trk_equivalent;

/*
 * Mean elongation, standard deviations of elongation and rate; of 0 the tangents are the answer.
 * false: the law leaves what it can do within four standard deviations.
 */
bool trk_link_equivalent(const trk_link_law *law, double mean, double e_deviation,
                         double v_deviation, trk_equivalent *out);

#endif
