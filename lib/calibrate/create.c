/* SPDX-License-Identifier: MIT */
/* Calibrations, their parameters and what those act on. */
#include "calibrate/calibrate.h"
#include "spec/vary.h"

#include <math.h>

static const trk_parameter_options defaults = {
    .struct_size = sizeof defaults, .start = 1, .lower = 0.01, .upper = 100};

void trk_parameter_options_init(trk_parameter_options *options, size_t struct_size)
{
    trk_write_defaults(options, struct_size, &defaults, sizeof defaults);
}

static trk_status fill(trk_calibration *calibration, const trk_spec *spec,
                       const trk_model_options *options)
{
    trk_context *context = calibration->context;
    trk_model_options_init(&calibration->model_options, sizeof calibration->model_options);
    trk_status status =
        trk_read_options(context, "trk_model_options", options, &calibration->model_options,
                         sizeof calibration->model_options);
    if (status == TRK_OK)
        status = trk_spec_copy(context, spec, &calibration->base);
    if (status == TRK_OK)
        status = trk_spec_copy(context, spec, &calibration->work);
    if (status == TRK_OK)
        status = trk_model_compile(context, spec, &calibration->model_options, &calibration->model);
    return status;
}

trk_status trk_calibration_create(trk_context *context, const trk_spec *spec,
                                  const trk_model_options *options,
                                  trk_calibration **out_calibration)
{
    TRK_REQUIRE(context, out_calibration, "trk_calibration_create");
    *out_calibration = NULL;
    TRK_REQUIRE(context, context, "trk_calibration_create");
    TRK_REQUIRE(context, spec, "trk_calibration_create");
    if (!trk_has_feature(TRK_FEATURE_NLOPT) || !trk_has_feature(TRK_FEATURE_LAPACK))
        return trk_fail(
            context, TRK_E_UNSUPPORTED,
            "calibration needs NLopt and LAPACK; this build was made without one of them");
    trk_calibration *calibration = trk_new(context, 1, sizeof *calibration);
    if (!calibration)
        return TRK_E_MEMORY;
    calibration->context = context;
    trk_status status = fill(calibration, spec, options);
    if (status != TRK_OK) {
        trk_calibration_destroy(calibration);
        return status;
    }
    *out_calibration = calibration;
    return TRK_OK;
}

void trk_calibration_destroy(trk_calibration *calibration)
{
    if (!calibration)
        return;
    trk_context *context = calibration->context;
    for (int32_t k = 0; k < trk_fit_target_count(calibration); k++) {
        trk_free(context, calibration->targets[k].shape);
        trk_free(context, (double *)calibration->targets[k].options.frequency);
        trk_free(context, (double *)calibration->targets[k].options.magnitude);
        trk_free(context, (double *)calibration->targets[k].options.road_gain);
    }
    trk_spec_destroy(calibration->base);
    trk_spec_destroy(calibration->work);
    trk_model_destroy(calibration->model);
    trk_names_clear(context, &calibration->parameter_names);
    trk_names_clear(context, &calibration->target_names);
    trk_free(context, calibration->parameters);
    trk_free(context, calibration->actions);
    trk_free(context, calibration->targets);
    trk_free(context, calibration->jacobian);
    trk_free(context, calibration->singular);
    trk_free(context, calibration->report);
    trk_free(context, calibration);
}

trk_status trk_calibration_add_parameter(trk_calibration *calibration, const char *name,
                                         const trk_parameter_options *options,
                                         int32_t *out_parameter)
{
    TRK_REQUIRE(NULL, calibration, "trk_calibration_add_parameter");
    trk_context *context = calibration->context;
    TRK_REQUIRE(context, name, "trk_calibration_add_parameter");
    trk_parameter_options p = defaults;
    trk_status status = trk_read_options(context, "trk_parameter_options", options, &p, sizeof p);
    if (status != TRK_OK)
        return status;
    if (p.meaning != TRK_MEANING_FACTOR && p.meaning != TRK_MEANING_VALUE)
        return trk_fail(context, TRK_E_ARGUMENT, "parameter '%s': there is no meaning %d", name,
                        p.meaning);
    if (!(p.lower > 0 && p.lower <= p.start && p.start <= p.upper && p.lower < p.upper &&
          isfinite(p.upper)))
        return trk_fail(context, TRK_E_RANGE,
                        "parameter '%s': start %g within %g to %g; 0 < lower <= start <= upper, "
                        "finite, is needed",
                        name, p.start, p.lower, p.upper);
    if (trk_fit_parameter_count(calibration) == TRK_MAX_PARAMETERS)
        return trk_fail(context, TRK_E_RANGE, "parameter '%s': more than %d parameters", name,
                        TRK_MAX_PARAMETERS);
    status = trk_grow(context, (void **)&calibration->parameters, &calibration->parameter_capacity,
                      (int64_t)trk_fit_parameter_count(calibration) + 1,
                      sizeof *calibration->parameters);
    if (status == TRK_OK)
        status = trk_names_add(context, &calibration->parameter_names, "parameter", name);
    if (status != TRK_OK)
        return status;
    int32_t id = trk_fit_parameter_count(calibration);
    calibration->parameters[id - 1] = (trk_fit_parameter){.options = p};
    calibration->solved = false;
    if (out_parameter)
        *out_parameter = id;
    return TRK_OK;
}

static trk_status check_action(const trk_calibration *calibration, int32_t parameter,
                               trk_field field, int32_t part, const char *name,
                               double *out_reference)
{
    trk_context *context = calibration->context;
    const char *parameter_name = trk_names_text(&calibration->parameter_names, parameter);
    for (int32_t k = 0; k < calibration->action_count; k++) {
        const trk_fit_action *a = &calibration->actions[k];
        if (trk_field_part(a->field) == trk_field_part(field) && a->part == part &&
            trk_fields_overlap(a->field, field))
            return trk_fail(context, TRK_E_MODEL,
                            "parameter '%s': '%s' is already acted on by parameter '%s'",
                            parameter_name, name,
                            trk_names_text(&calibration->parameter_names, a->parameter + 1));
    }
    char who[160];
    trk_format(who, sizeof who, "parameter '%s'", parameter_name);
    trk_meaning meaning = calibration->parameters[parameter - 1].options.meaning;
    double value;
    trk_status status = trk_spec_check_field(calibration->base, who, field, part, meaning, &value);
    *out_reference = meaning == TRK_MEANING_VALUE ? value : 1;
    return status;
}

trk_status trk_calibration_act_on(trk_calibration *calibration, int32_t parameter, trk_field field,
                                  const char *pattern, double power, int32_t *out_count)
{
    TRK_REQUIRE(NULL, calibration, "trk_calibration_act_on");
    trk_context *context = calibration->context;
    TRK_REQUIRE(context, pattern, "trk_calibration_act_on");
    if (parameter < 1 || parameter > trk_fit_parameter_count(calibration))
        return trk_fail(context, TRK_E_ARGUMENT, "trk_calibration_act_on: there is no parameter %d",
                        parameter);
    trk_status status = trk_check_field(context, "trk_calibration_act_on", field);
    if (status != TRK_OK)
        return status;
    if (!isfinite(power) || power == 0)
        return trk_fail(context, TRK_E_RANGE,
                        "trk_calibration_act_on: power is %g; a finite number but 0 is needed",
                        power);
    trk_part kind = trk_field_part(field);
    int32_t parts = trk_spec_count(calibration->base, kind), before = calibration->action_count;
    status = trk_grow(context, (void **)&calibration->actions, &calibration->action_capacity,
                      (int64_t)before + parts, sizeof *calibration->actions);
    for (int32_t part = 1; status == TRK_OK && part <= parts; part++) {
        const char *name = trk_spec_part_name(calibration->base, kind, part);
        trk_fit_action action = {parameter - 1, field, part, power, 1};
        if (!trk_spec_matches(pattern, name))
            continue;
        status = check_action(calibration, parameter, field, part, name, &action.reference);
        if (status == TRK_OK)
            calibration->actions[calibration->action_count++] = action;
    }
    if (status == TRK_OK && calibration->action_count == before)
        status = trk_fail(context, TRK_E_NAME, "parameter '%s': no %s of '%s' is called '%s'",
                          trk_names_text(&calibration->parameter_names, parameter),
                          trk_part_word(kind), trk_spec_name(calibration->base), pattern);
    if (status != TRK_OK) {
        calibration->action_count = before;
        return status;
    }
    calibration->solved = false;
    if (out_count)
        *out_count = calibration->action_count - before;
    return TRK_OK;
}
