/* SPDX-License-Identifier: MIT */
/* Linear spring and damper, spring curve, damper curve, and a law with memory. */
#include "law/link_law.h"

#include "curve/curve.h"

void trk_link_law_relax(const trk_link_law *law, double e, double *z)
{
    if (trk_link_law_states(law) > 0)
        law->law->ops->relax(law->law, e, z);
}

void trk_link_law_advance(const trk_link_law *law, const double *z, double e, double v, double h,
                          trk_law_hint *hint, trk_law_point *out, double *z_next)
{
    double value, slope;
    *out = (trk_law_point){-law->rest, 0, 0};
    if (law->law) {
        law->law->ops->evaluate(law->law, z, e, v, h, out, z_next);
        out->force -= law->rest;
    }
    if (law->spring) {
        trk_curve_point(law->spring, e + law->spring_offset, &hint->spring, &value, &slope);
        out->force += law->spring_scale * value;
        out->stiffness += law->spring_scale * slope;
    }
    if (law->damper) {
        trk_curve_point(law->damper, v, &hint->damper, &value, &slope);
        out->force += law->damper_scale * value;
        out->damping += law->damper_scale * slope;
    }
}

void trk_link_law_evaluate(const trk_link_law *law, double e, double v, trk_law_hint *hint,
                           trk_law_point *out)
{
    double z[TRK_LAW_STATES], z_next[TRK_LAW_STATES];
    trk_link_law_relax(law, e, z);
    trk_link_law_advance(law, z, e, v, 0, hint, out, z_next);
}

double trk_link_law_force(const trk_link_law *law, double e, double v)
{
    trk_law_hint hint = {0, 0};
    trk_law_point point;
    trk_link_law_evaluate(law, e, v, &hint, &point);
    return law->stiffness * e + law->damping * v + point.force;
}

double trk_link_law_static_stiffness(const trk_link_law *law, double e)
{
    trk_law_point at_rest = {0, 0, 0};
    double value, slope = 0;
    if (law->law)
        law->law->ops->rest(law->law, e, &at_rest);
    if (law->spring)
        trk_curve_point(law->spring, e + law->spring_offset, &(int32_t){0}, &value, &slope);
    return law->stiffness + law->spring_scale * slope + at_rest.stiffness;
}
