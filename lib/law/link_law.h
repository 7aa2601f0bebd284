/* SPDX-License-Identifier: MIT */
/*
 * Force law of one link: elongation e, rate v and what a law of its own remembers, z (SPEC.3):
 *
 *     f(e, v, z) = k e + c v + g(e, v, z)                               (LAW.1)
 *     g(e, v, z) = a_s s(e + e_0) + a_d d(v) + l(e, v, z) - g_rest      (LAW.2)
 *
 * The linear part stays apart: the stepper factors it once, and only g is
 * evaluated inside an iteration. g_rest = a_s s(e_0) + a_d d(0) + l(0, 0, z at rest) when motion
 * is measured from static equilibrium, else 0.
 */
#ifndef TRK_LAW_LINK_LAW_H
#define TRK_LAW_LINK_LAW_H

#include "law/law.h"

typedef struct trk_link_law {
    double stiffness, damping;         /* k [N/m, N m/rad], c [N s/m, N m s/rad] */
    trk_curve *spring, *damper;        /* owned; NULL: none                      */
    double spring_scale, damper_scale; /* a_s, a_d [-]                           */
    double spring_offset;              /* e_0 [m, rad]                           */
    double rest;                       /* g_rest [N, N m]                        */
    trk_law *law;                      /* l; owned; NULL: none                   */
} trk_link_law;

/* Where the last evaluation stood on the curves; any value is valid. */
typedef struct trk_law_hint {
    int32_t spring, damper;
} trk_law_hint;

static inline bool trk_link_law_is_linear(const trk_link_law *law)
{
    return !law->spring && !law->damper && !law->law;
}

/* Doubles of memory of a link. */
static inline int32_t trk_link_law_states(const trk_link_law *law)
{
    return law->law ? law->law->ops->states : 0;
}

/* Memory of a link at rest at e for long. */
void trk_link_law_relax(const trk_link_law *law, double e, double *z);

/*
 * g at (e, v), reached in the time h from the memory z, its tangents (LAW.3), and the memory then.
 * z and z_next may be NULL if the link has no memory, and may not be the same.
 */
void trk_link_law_advance(const trk_link_law *law, const double *z, double e, double v, double h,
                          trk_law_hint *hint, trk_law_point *out, double *z_next);

/* g(e, v) with memory relaxed at e, and the tangents of the first motion: friction sticks, and
 * no air flows. */
void trk_link_law_evaluate(const trk_link_law *law, double e, double v, trk_law_hint *hint,
                           trk_law_point *out);

/* Whole force f(e, v) (LAW.1) with memory relaxed at e, without hints or tangents. */
double trk_link_law_force(const trk_link_law *law, double e, double v);

/* Slope [N/m, N m/rad] of the force from rest to rest (LAW.5): friction relaxed, pressures equal. */
double trk_link_law_static_stiffness(const trk_link_law *law, double e);

#endif
