/* SPDX-License-Identifier: MIT */
/* Parameters of the frequency weightings and their analogue response (COMFORT.1). */
#ifndef TRK_COMFORT_WEIGHTING_H
#define TRK_COMFORT_WEIGHTING_H

#include "base/base.h"
#include <complex.h>
#include <truckride/comfort.h>

/* Corner frequencies [Hz] and quality factors as ISO 8041-1 numbers them; 0 stands for infinity. */
typedef struct trk_weighting_parameters {
    const char *name;
    double f1, f2;         /* band limits, Q = 1 / sqrt(2)           */
    double f3, f4, q4;     /* transition from acceleration to velocity */
    double f5, q5, f6, q6; /* upward step, 1 at high frequencies     */
    double gain;           /* K                                      */
} trk_weighting_parameters;

/* NULL for an unknown weighting. */
const trk_weighting_parameters *trk_weighting_find(trk_weighting weighting);

/* The same with the failure recorded. */
trk_status trk_weighting_check(trk_context *context, const char *what, trk_weighting weighting,
                               const trk_weighting_parameters **out);

/* Analogue response at a frequency >= 0. */
double complex trk_weighting_analogue(const trk_weighting_parameters *p, double frequency);

#endif
