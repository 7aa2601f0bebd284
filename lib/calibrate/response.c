/* SPDX-License-Identifier: MIT */
/* Targets on frequency responses. */
#include "calibrate/calibrate.h"

#include <truckride/linear.h>

#include <math.h>
#include <string.h>

static const double difference_step = 1e-5; /* of u */

/* |response| at the frequencies of a target. */
static trk_status response_curve(trk_calibration *c, const trk_model *model, int32_t index,
                                 double *out_y)
{
    const trk_fit_target *target = &c->targets[index];
    int32_t sensors = trk_model_count(model, TRK_PART_SENSOR);
    int32_t roads = trk_model_count(model, TRK_PART_ROAD);
    double *all = trk_new(c->context, 2 * (int64_t)target->count * sensors, sizeof *all);
    double *gain = trk_new(c->context, roads, sizeof *gain);
    trk_status status = all && gain ? TRK_OK : TRK_E_MEMORY;
    for (int32_t k = 0; gain && k < roads; k++)
        gain[k] = target->options.road_gain ? target->options.road_gain[k] : 1;
    if (status == TRK_OK)
        status = trk_frequency_response(c->context, model, NULL, NULL, target->count,
                                        target->options.frequency, gain, NULL, NULL, all);
    for (int32_t k = 0; status == TRK_OK && k < target->count; k++) {
        const double *z = all + 2 * ((int64_t)k * sensors + target->sensor - 1);
        out_y[k] = hypot(z[0], z[1]);
    }
    if (status == TRK_OK)
        trk_fit_compare(target, out_y, out_y);
    trk_free(c->context, all);
    trk_free(c->context, gain);
    return status == TRK_OK ? status : trk_fit_fail_at(c, index, status);
}

trk_status trk_fit_response(trk_calibration *c, const trk_model *model, double *out_y)
{
    trk_status status = TRK_OK;
    for (int32_t k = 0; status == TRK_OK && k < trk_fit_target_count(c); k++)
        if (c->targets[k].options.kind == TRK_TARGET_RESPONSE_CURVE)
            status = response_curve(c, model, k, out_y + c->targets[k].first);
    return status;
}

/* d y / d u_j of the response curves by central differences. */
static trk_status response_gradient(trk_calibration *c, double *u, int32_t parameter, double *high,
                                    double *low, double *jacobian)
{
    double centre = u[parameter], *side[2] = {low, high};
    trk_status status = TRK_OK;
    for (int k = 0; status == TRK_OK && k < 2; k++) {
        trk_model *model;
        u[parameter] = centre + (k ? difference_step : -difference_step);
        status = trk_fit_compile(c, u, &model);
        if (status != TRK_OK)
            break;
        status = trk_fit_response(c, model, side[k]);
        trk_model_destroy(model);
    }
    u[parameter] = centre;
    int32_t parameters = trk_fit_parameter_count(c);
    for (int32_t t = 0; status == TRK_OK && t < trk_fit_target_count(c); t++) {
        const trk_fit_target *target = &c->targets[t];
        for (int32_t i = target->first;
             target->options.kind == TRK_TARGET_RESPONSE_CURVE && i < target->first + target->count;
             i++)
            jacobian[(int64_t)i * parameters + parameter] =
                (high[i] - low[i]) / (2 * difference_step);
    }
    return status;
}

trk_status trk_fit_response_gradient(trk_calibration *c, const double *u, double *jacobian)
{
    int32_t parameters = trk_fit_parameter_count(c);
    double *space = trk_new(c->context, 2 * (int64_t)c->value_count + parameters, sizeof *space);
    if (!space)
        return TRK_E_MEMORY;
    double *moved = space + 2 * (int64_t)c->value_count;
    memcpy(moved, u, (size_t)parameters * sizeof *moved);
    trk_status status = TRK_OK;
    for (int32_t j = 0; status == TRK_OK && j < parameters; j++)
        status = response_gradient(c, moved, j, space, space + c->value_count, jacobian);
    trk_free(c->context, space);
    return status;
}
