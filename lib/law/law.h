/* SPDX-License-Identifier: MIT */
/*
 * Force law of one link, a pure function of elongation e and rate v (SPEC.3):
 *
 *     f(e, v) = k e + c v + g(e, v)                                    (LAW.1)
 *     g(e, v) = a_s s(e + e_0) + a_d d(v) - g_rest                      (LAW.2)
 *
 * The linear part stays apart: the stepper factors it once, and only g is
 * evaluated inside an iteration. g_rest = a_s s(e_0) + a_d d(0) when motion is
 * measured from static equilibrium, else 0.
 */
#ifndef TRK_LAW_LAW_H
#define TRK_LAW_LAW_H

#include "base/base.h"
#include <truckride/curve.h>

typedef struct trk_law {
    double stiffness, damping;         /* k [N/m, N m/rad], c [N s/m, N m s/rad] */
    trk_curve *spring, *damper;        /* owned; NULL: none                      */
    double spring_scale, damper_scale; /* a_s, a_d [-]                           */
    double spring_offset;              /* e_0 [m, rad]                           */
    double rest;                       /* g_rest [N, N m]                        */
} trk_law;

/* Where the last evaluation stood on the curves; any value is valid. */
typedef struct trk_law_hint {
    int32_t spring, damper;
} trk_law_hint;

/* Non-linear force g and its tangents dg/de, dg/dv. */
typedef struct trk_law_point {
    double force, stiffness, damping;
} trk_law_point;

static inline bool trk_law_is_linear(const trk_law *law)
{
    return !law->spring && !law->damper;
}

/* g(e, v) and its tangents (LAW.2). */
void trk_law_evaluate(const trk_law *law, double e, double v, trk_law_hint *hint,
                      trk_law_point *out);

/* Whole force f(e, v) (LAW.1) without hints or tangents. */
double trk_law_force(const trk_law *law, double e, double v);

#endif
