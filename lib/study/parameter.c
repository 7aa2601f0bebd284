/* SPDX-License-Identifier: MIT */
/* Parameters of a study, what they act on, and the model of a case. */
#include "spec/vary.h"
#include "study/quantile.h"
#include "study/study.h"

#include <math.h>

static const trk_study_parameter_options defaults = {.struct_size = sizeof defaults,
                                                     .distribution = TRK_DISTRIBUTION_UNIFORM,
                                                     .meaning = TRK_MEANING_FACTOR,
                                                     .lower = 0.8,
                                                     .upper = 1.2,
                                                     .mean = 1,
                                                     .deviation = 0.1,
                                                     .levels = 3};

enum { MOST_LEVELS = 1000000 };

void trk_study_parameter_options_init(trk_study_parameter_options *options, size_t struct_size)
{
    trk_write_defaults(options, struct_size, &defaults, sizeof defaults);
}

static bool is_logarithmic(trk_distribution d)
{
    return d == TRK_DISTRIBUTION_LOG_UNIFORM || d == TRK_DISTRIBUTION_LOG_NORMAL;
}

static bool is_normal(trk_distribution d)
{
    return d == TRK_DISTRIBUTION_NORMAL || d == TRK_DISTRIBUTION_LOG_NORMAL;
}

static trk_status check(trk_context *context, const char *name,
                        const trk_study_parameter_options *o)
{
    if (o->distribution < TRK_DISTRIBUTION_UNIFORM || o->distribution > TRK_DISTRIBUTION_LOG_NORMAL)
        return trk_fail(context, TRK_E_ARGUMENT, "parameter '%s': there is no distribution %d",
                        name, o->distribution);
    if (o->meaning != TRK_MEANING_FACTOR && o->meaning != TRK_MEANING_VALUE)
        return trk_fail(context, TRK_E_ARGUMENT, "parameter '%s': there is no meaning %d", name,
                        o->meaning);
    if (o->reserved)
        return trk_fail(context, TRK_E_ARGUMENT, "parameter '%s': reserved is %d, expected 0", name,
                        o->reserved);
    if (!(o->lower >= 0 && o->upper > o->lower && isfinite(o->upper)))
        return trk_fail(context, TRK_E_RANGE,
                        "parameter '%s': bounds are %g and %g, expected 0 <= lower < upper", name,
                        o->lower, o->upper);
    if (is_logarithmic(o->distribution) && o->lower == 0)
        return trk_fail(context, TRK_E_RANGE,
                        "parameter '%s': lower is 0, expected > 0 in a logarithmic distribution",
                        name);
    if (is_normal(o->distribution) &&
        !(isfinite(o->mean) && o->deviation > 0 && isfinite(o->deviation)))
        return trk_fail(context, TRK_E_RANGE,
                        "parameter '%s': mean %g and deviation %g, expected finite numbers, the "
                        "deviation > 0",
                        name, o->mean, o->deviation);
    if (o->levels < 1 || o->levels > MOST_LEVELS)
        return trk_fail(context, TRK_E_RANGE, "parameter '%s': levels is %d, expected 1 to %d",
                        name, o->levels, (int)MOST_LEVELS);
    return TRK_OK;
}

/* Probabilities that the bounds cut off, seen from the tail in which both are small. */
static trk_status cut_off(trk_context *context, const char *name, trk_design_parameter *p)
{
    const trk_study_parameter_options *o = &p->options;
    const bool logarithmic = is_logarithmic(o->distribution);
    const double low = logarithmic ? trk_plain_log(o->lower) : o->lower;
    const double high = logarithmic ? trk_plain_log(o->upper) : o->upper;
    p->sign = low > o->mean ? -1 : 1;
    p->first = trk_normal_probability(p->sign * ((low - o->mean) / o->deviation));
    p->last = trk_normal_probability(p->sign * ((high - o->mean) / o->deviation));
    if (fabs(p->last - p->first) > 1e-300)
        return TRK_OK;
    return trk_fail(context, TRK_E_RANGE,
                    "parameter '%s': nothing of the distribution lies between %g and %g", name,
                    o->lower, o->upper);
}

trk_status trk_study_add_parameter(trk_study *study, const char *name,
                                   const trk_study_parameter_options *options,
                                   int32_t *out_parameter)
{
    TRK_REQUIRE(NULL, study, "trk_study_add_parameter");
    trk_context *context = study->context;
    const char *shown = name ? name : "";
    trk_design_parameter p = {.options = defaults};
    trk_status status = trk_read_options(context, "trk_study_parameter_options", options,
                                         &p.options, sizeof p.options);
    if (status == TRK_OK)
        status = check(context, shown, &p.options);
    if (status == TRK_OK && is_normal(p.options.distribution))
        status = cut_off(context, shown, &p);
    if (status != TRK_OK)
        return status;
    const bool factorial = study->options.design == TRK_DESIGN_FACTORIAL;
    const int64_t factor = factorial ? p.options.levels : 1;
    if (trk_study_cases(study) > TRK_MOST_CASES / factor)
        return trk_fail(context, TRK_E_RANGE,
                        "parameter '%s': with %d levels the study has more than 1e12 cases", shown,
                        p.options.levels);
    status = trk_study_change(study, "trk_study_add_parameter");
    if (status == TRK_OK)
        status = trk_study_append(study, TRK_STUDY_PARAMETER, name, (void **)&study->parameters,
                                  sizeof p);
    if (status != TRK_OK)
        return status;
    study->parameters[trk_study_parameters(study) - 1] = p;
    study->points *= factor;
    if (out_parameter)
        *out_parameter = trk_study_parameters(study);
    return TRK_OK;
}

static trk_status check_action(const trk_study *study, int32_t parameter, trk_field field,
                               int32_t part)
{
    const trk_part kind = trk_field_part(field);
    const char *parameter_name = trk_study_part_name(study, TRK_STUDY_PARAMETER, parameter);
    for (int32_t k = 0; k < study->action_count; k++) {
        const trk_action *a = &study->actions[k];
        if (trk_field_part(a->field) == kind && a->part == part &&
            trk_fields_overlap(a->field, field))
            return trk_fail(study->context, TRK_E_MODEL,
                            "parameter '%s': '%s' is already acted on by parameter '%s'",
                            parameter_name, trk_spec_part_name(study->base, kind, part),
                            trk_study_part_name(study, TRK_STUDY_PARAMETER, a->parameter + 1));
    }
    char who[160];
    trk_format(who, sizeof who, "parameter '%s'", parameter_name);
    double value;
    return trk_spec_check_field(study->base, who, field, part,
                                study->parameters[parameter - 1].options.meaning, &value);
}

/* Add the actions on all parts that match; *out_count is their number. */
static trk_status match(trk_study *study, int32_t parameter, trk_field field, const char *pattern,
                        double power, int32_t *out_count)
{
    const trk_part kind = trk_field_part(field);
    const int32_t parts = trk_spec_count(study->base, kind), before = study->action_count;
    trk_status status = trk_grow(study->context, (void **)&study->actions, &study->action_capacity,
                                 (int64_t)before + parts, sizeof *study->actions);
    for (int32_t part = 1; status == TRK_OK && part <= parts; part++) {
        if (!trk_spec_matches(pattern, trk_spec_part_name(study->base, kind, part)))
            continue;
        status = check_action(study, parameter, field, part);
        if (status == TRK_OK)
            study->actions[study->action_count++] = (trk_action){parameter - 1, field, part, power};
    }
    if (status == TRK_OK && study->action_count == before)
        status =
            trk_fail(study->context, TRK_E_NAME, "parameter '%s': no %s of '%s' is called '%s'",
                     trk_study_part_name(study, TRK_STUDY_PARAMETER, parameter),
                     trk_part_word(kind), trk_spec_name(study->base), pattern);
    *out_count = study->action_count - before;
    if (status != TRK_OK)
        study->action_count = before;
    return status;
}

trk_status trk_study_act_on(trk_study *study, int32_t parameter, trk_field field,
                            const char *pattern, double power, int32_t *out_count)
{
    static const char what[] = "trk_study_act_on";
    TRK_REQUIRE(NULL, study, "trk_study_act_on");
    trk_context *context = study->context;
    TRK_REQUIRE(context, pattern, "trk_study_act_on");
    if (parameter < 1 || parameter > trk_study_parameters(study))
        return trk_fail(context, TRK_E_ARGUMENT, "%s: there is no parameter %d", what, parameter);
    trk_status status = trk_check_field(context, what, field);
    if (status == TRK_OK && (!isfinite(power) || power == 0))
        status = trk_fail(context, TRK_E_RANGE, "%s: power is %g; a finite number but 0 is needed",
                          what, power);
    if (status == TRK_OK)
        status = trk_study_change(study, what);
    int32_t count = 0;
    if (status == TRK_OK)
        status = match(study, parameter, field, pattern, power, &count);
    if (status != TRK_OK)
        return status;
    study->parameters[parameter - 1].actions += count;
    if (out_count)
        *out_count = count;
    return TRK_OK;
}

trk_status trk_study_compile(trk_study *study, int64_t number, double *parameters,
                             trk_model **out_model)
{
    trk_status status = trk_study_get_case(study, number, parameters, NULL);
    for (int32_t k = 0; status == TRK_OK && k < study->action_count; k++) {
        const trk_action *a = &study->actions[k];
        status = trk_spec_set_field(
            study->work, a->part, a->field, study->parameters[a->parameter].options.meaning,
            trk_plain_power(parameters[a->parameter], a->power), study->base, a->part);
    }
    return status == TRK_OK
               ? trk_model_compile(study->context, study->work, &study->model_options, out_model)
               : status;
}
