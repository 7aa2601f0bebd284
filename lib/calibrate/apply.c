/* SPDX-License-Identifier: MIT */
/* Parameters into a spec, and its model. */
#include "calibrate/calibrate.h"
#include "spec/vary.h"

#include <math.h>

trk_status trk_fit_apply(const trk_calibration *calibration, const double *u, trk_spec *spec,
                         const int32_t *part_of)
{
    trk_status status = TRK_OK;
    for (int32_t k = 0; status == TRK_OK && k < calibration->action_count; k++) {
        const trk_fit_action *a = &calibration->actions[k];
        double scale = exp(a->power * u[a->parameter]) / a->reference;
        status = trk_spec_set_field(spec, part_of ? part_of[k] : a->part, a->field,
                                    TRK_MEANING_FACTOR, scale, calibration->base, a->part);
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
