/* SPDX-License-Identifier: MIT */
/* Parameters into a spec, and its model. */
#include "calibrate/calibrate.h"

#include <math.h>

static trk_status apply_action(const trk_calibration *c, const trk_fit_action *a, double scale,
                               trk_spec *spec, int32_t part)
{
    trk_status status;
    if (a->field == TRK_FIELD_STIFFNESS || a->field == TRK_FIELD_DAMPING) {
        trk_link_options base, link;
        trk_link_options_init(&base, sizeof base);
        trk_link_options_init(&link, sizeof link);
        status = trk_spec_get_link(c->base, a->part, &base);
        if (status == TRK_OK)
            status = trk_spec_get_link(spec, part, &link);
        if (a->field == TRK_FIELD_STIFFNESS) {
            link.stiffness = scale * base.stiffness;
            link.spring_scale = scale * base.spring_scale;
        } else {
            link.damping = scale * base.damping;
            link.damper_scale = scale * base.damper_scale;
        }
        return status == TRK_OK ? trk_spec_set_link(spec, part, &link) : status;
    }
    trk_body_options base, body;
    trk_body_options_init(&base, sizeof base);
    trk_body_options_init(&body, sizeof body);
    status = trk_spec_get_body(c->base, a->part, &base);
    if (status == TRK_OK)
        status = trk_spec_get_body(spec, part, &body);
    if (a->field != TRK_FIELD_INERTIA)
        body.mass = scale * base.mass;
    for (int k = 0; k < 3 && a->field != TRK_FIELD_MASS; k++)
        body.inertia[k] = scale * base.inertia[k];
    return status == TRK_OK ? trk_spec_set_body(spec, part, &body) : status;
}

trk_status trk_fit_apply(const trk_calibration *calibration, const double *u, trk_spec *spec,
                         const int32_t *part_of)
{
    trk_status status = TRK_OK;
    for (int32_t k = 0; status == TRK_OK && k < calibration->action_count; k++) {
        const trk_fit_action *a = &calibration->actions[k];
        double scale = exp(a->power * u[a->parameter]) / a->reference;
        status = apply_action(calibration, a, scale, spec, part_of ? part_of[k] : a->part);
    }
    return status;
}

trk_status trk_fit_compile(trk_calibration *calibration, const double *u, trk_model **out_model)
{
    trk_status status = trk_fit_apply(calibration, u, calibration->work, NULL);
    return status == TRK_OK ? trk_model_compile(calibration->context, calibration->work,
                                                &calibration->model_options, out_model)
                            : status;
}
