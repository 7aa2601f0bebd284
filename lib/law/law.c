/* SPDX-License-Identifier: MIT */
/* Linear spring and damper, spring curve and damper curve. */
#include "law/law.h"

#include "curve/curve.h"

void trk_law_evaluate(const trk_law *law, double e, double v, trk_law_hint *hint,
                      trk_law_point *out)
{
    double value, slope;
    *out = (trk_law_point){-law->rest, 0, 0};
    if (law->spring) {
        trk_curve_point(law->spring, e + law->spring_offset, &hint->spring, &value, &slope);
        out->force += law->spring_scale * value;
        out->stiffness = law->spring_scale * slope;
    }
    if (law->damper) {
        trk_curve_point(law->damper, v, &hint->damper, &value, &slope);
        out->force += law->damper_scale * value;
        out->damping = law->damper_scale * slope;
    }
}

double trk_law_force(const trk_law *law, double e, double v)
{
    trk_law_hint hint = {0, 0};
    trk_law_point point;
    trk_law_evaluate(law, e, v, &hint, &point);
    return law->stiffness * e + law->damping * v + point.force;
}
