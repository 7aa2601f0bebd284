/* SPDX-License-Identifier: MIT */
/* Curves by their expected slopes, laws by the cycles they go through (LINEAR.31 to LINEAR.34). */
#include "linear/equivalent.h"

#include "linear/cycle.h"
#include "linear/gaussian.h"

#include <math.h>

/* Below this share of the mean motion is lost in the rounding of what it is added to. */
static const double smallest = 1e-8;

static void add_curves(const trk_link_law *law, double mean, double e_deviation, double v_deviation,
                       trk_equivalent *out)
{
    double value, slope;
    if (law->spring) {
        trk_gaussian_curve(law->spring, mean + law->spring_offset, e_deviation, &value, &slope);
        out->force += law->spring_scale * value;
        out->stiffness += law->spring_scale * slope;
        out->slope += law->spring_scale * slope;
    }
    if (law->damper) {
        trk_gaussian_curve(law->damper, 0, v_deviation, &value, &slope);
        out->force += law->damper_scale * value;
        out->damping += law->damper_scale * slope;
    }
}

static bool add_law(const trk_law *law, double mean, double e_deviation, double v_deviation,
                    trk_equivalent *out)
{
    double z[TRK_LAW_STATES], next[TRK_LAW_STATES];
    trk_law_point rest, tangent;
    law->ops->rest(law, mean, &rest);
    law->ops->relax(law, mean, z);
    law->ops->evaluate(law, z, mean, 0, 0, &tangent, next);
    const double change =
        fabs(tangent.stiffness) * e_deviation + fabs(tangent.damping) * v_deviation;
    if (!(e_deviation > smallest * fabs(mean) && v_deviation > 0 &&
          (change == 0 || change > smallest * fabs(rest.force)))) {
        out->force += rest.force;
        out->slope += rest.stiffness;
        out->stiffness += tangent.stiffness;
        out->damping += tangent.damping;
        return isfinite(tangent.force);
    }
    trk_parts parts;
    if (!trk_cycle_expect(law, &(trk_swing){mean, e_deviation, v_deviation}, &parts))
        return false;
    out->force += parts.rest + parts.force;
    out->stiffness += parts.in_phase / e_deviation;
    out->damping += parts.quadrature / v_deviation;
    /* Friction follows its mean, so its force does not hold the vehicle up. */
    out->slope += law->ops->states > 0 ? rest.stiffness : parts.in_phase / e_deviation;
    return true;
}

bool trk_link_equivalent(const trk_link_law *law, double mean, double e_deviation,
                         double v_deviation, trk_equivalent *out)
{
    *out = (trk_equivalent){.stiffness = law->stiffness,
                            .damping = law->damping,
                            .force = law->stiffness * mean - law->rest,
                            .slope = law->stiffness};
    add_curves(law, mean, e_deviation, v_deviation, out);
    return !law->law || add_law(law->law, mean, e_deviation, v_deviation, out);
}
