/* SPDX-License-Identifier: MIT */
/* From parameters to the values of the targets and their residuals. */
#include "calibrate/calibrate.h"

#include <math.h>

trk_status trk_fit_fail_at(const trk_calibration *c, int32_t target, trk_status status)
{
    return status == TRK_E_MEMORY ? status
                                  : trk_fail_within(c->context, status, "target '%s'",
                                                    trk_names_text(&c->target_names, target + 1));
}

/* ln(model / measured) at the points of a curve. */
void trk_fit_compare(const trk_fit_target *target, const double *model, double *out_y)
{
    for (int32_t k = 0; k < target->count; k++)
        out_y[k] = log(model[k] / target->options.magnitude[k]);
}

/* Number of targets of the given kinds. */
static int32_t count_kinds(const trk_calibration *c, trk_target low, trk_target high)
{
    int32_t count = 0;
    for (int32_t k = 0; k < trk_fit_target_count(c); k++)
        count += c->targets[k].options.kind >= low && c->targets[k].options.kind <= high;
    return count;
}

static trk_status check_values(const trk_calibration *c, const double *y)
{
    for (int32_t t = 0; t < trk_fit_target_count(c); t++)
        for (int32_t i = c->targets[t].first; i < c->targets[t].first + c->targets[t].count; i++)
            if (!isfinite(y[i]))
                return trk_fail(
                    c->context, TRK_E_TARGET, "target '%s': value %d of the model is %g",
                    trk_names_text(&c->target_names, t + 1), i - c->targets[t].first + 1, y[i]);
    return TRK_OK;
}

trk_status trk_fit_evaluate(trk_calibration *calibration, const double *u, double *out_y,
                            double *out_jacobian)
{
    trk_calibration *c = calibration;
    trk_model *model;
    if (out_jacobian && !trk_fit_has_gradient(c))
        return trk_fail(c->context, TRK_E_UNSUPPORTED,
                        "targets taken from a run have no gradient, so there is no Jacobian");
    trk_status status = trk_fit_compile(c, u, &model);
    if (status != TRK_OK)
        return status;
    if (count_kinds(c, TRK_TARGET_UNDAMPED_FREQUENCY, TRK_TARGET_DAMPING_RATIO))
        status = trk_fit_modal(c, u, model, out_y, out_jacobian);
    if (status == TRK_OK && count_kinds(c, TRK_TARGET_PSD_PEAK, TRK_TARGET_PSD_CURVE))
        status = trk_fit_run(c, model, out_y);
    if (status == TRK_OK && count_kinds(c, TRK_TARGET_RESPONSE_CURVE, TRK_TARGET_RESPONSE_CURVE)) {
        status = trk_fit_response(c, model, out_y);
        if (status == TRK_OK && out_jacobian)
            status = trk_fit_response_gradient(c, u, out_jacobian);
    }
    trk_model_destroy(model);
    return status == TRK_OK ? check_values(c, out_y) : status;
}

void trk_fit_residuals(const trk_calibration *calibration, const double *y, double *out_r,
                       double *jacobian)
{
    int32_t parameters = trk_fit_parameter_count(calibration);
    for (int32_t t = 0; t < trk_fit_target_count(calibration); t++) {
        const trk_fit_target *target = &calibration->targets[t];
        double scale = target->options.weight / target->options.uncertainty;
        double wanted = target->options.frequency ? 0 : target->options.value;
        for (int32_t i = target->first; i < target->first + target->count; i++) {
            out_r[i] = scale * (y[i] - wanted);
            for (int32_t j = 0; jacobian && j < parameters; j++)
                jacobian[(int64_t)i * parameters + j] *= scale;
        }
    }
}

trk_status trk_calibration_evaluate(trk_calibration *calibration, const double *parameter,
                                    double *out_value, double *out_jacobian)
{
    TRK_REQUIRE(NULL, calibration, "trk_calibration_evaluate");
    TRK_REQUIRE(calibration->context, parameter, "trk_calibration_evaluate");
    TRK_REQUIRE(calibration->context, out_value, "trk_calibration_evaluate");
    double u[TRK_MAX_PARAMETERS];
    int32_t parameters = trk_fit_parameter_count(calibration);
    for (int32_t j = 0; j < parameters; j++) {
        if (!isfinite(parameter[j]) || parameter[j] <= 0)
            return trk_fail(calibration->context, TRK_E_RANGE,
                            "parameter '%s' is %g; a finite number > 0 is needed",
                            trk_names_text(&calibration->parameter_names, j + 1), parameter[j]);
        u[j] = log(parameter[j]);
    }
    trk_status status = trk_fit_evaluate(calibration, u, out_value, out_jacobian);
    for (int32_t i = 0; status == TRK_OK && out_jacobian && i < calibration->value_count; i++)
        for (int32_t j = 0; j < parameters; j++)
            out_jacobian[(int64_t)i * parameters + j] /= parameter[j];
    return status;
}

int32_t trk_calibration_values(const trk_calibration *calibration)
{
    return calibration ? calibration->value_count : 0;
}
