/* SPDX-License-Identifier: MIT */
/* The answer: numbers one by one, in words, and put into a spec. */
#include "calibrate/calibrate.h"
#include "spec/vary.h"

#include <math.h>
#include <string.h>

/* Text that grows line by line and stops at its end. */
typedef struct text {
    char *at;
    size_t left;
} text;

static void add(text *t, const char *format, ...) TRK_PRINTF(2, 3);

static void add(text *t, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    int length = trk_format_list(t->at, t->left, format, arguments);
    va_end(arguments);
    size_t used = length < 0 ? 0 : (size_t)length < t->left ? (size_t)length : t->left - 1;
    t->at += used;
    t->left -= used;
}

static void add_parameters(text *t, const trk_calibration *c)
{
    add(t, "%-24s %12s %12s %12s %12s\n", "parameter", "start", "fitted", "low 95 %", "high 95 %");
    for (int32_t j = 0; j < trk_fit_parameter_count(c); j++) {
        const trk_parameter_result *p = &c->parameters[j].result;
        add(t, "%-24s %12.6g %12.6g %12.6g %12.6g%s%s\n",
            trk_names_text(&c->parameter_names, j + 1), p->start, p->fitted, p->low95, p->high95,
            p->at_bound < 0   ? "  at the lower bound"
            : p->at_bound > 0 ? "  at the upper bound"
                              : "",
            p->determined ? "" : "  not determined");
    }
}

static void add_targets(text *t, const trk_calibration *c)
{
    add(t, "%-24s %12s %12s %12s %12s %12s\n", "target", "before", "after", "measured",
        "uncertainty", "off [sigma]");
    for (int32_t k = 0; k < trk_fit_target_count(c); k++) {
        const trk_target_result *r = &c->targets[k].result;
        add(t, "%-24s %12.6g %12.6g %12.6g %12.3g %12.1f%s\n",
            trk_names_text(&c->target_names, k + 1), r->before, r->after, r->measured,
            c->targets[k].options.uncertainty, r->residual, r->met ? "" : "  missed");
    }
}

trk_status trk_fit_report(trk_calibration *calibration)
{
    trk_calibration *c = calibration;
    int64_t lines = trk_fit_parameter_count(c) + trk_fit_target_count(c) + 6;
    int64_t size = lines * 256 + (int64_t)sizeof c->verdict;
    trk_free(c->context, c->report);
    c->report = trk_new(c->context, size, 1);
    if (!c->report)
        return TRK_E_MEMORY;
    text t = {c->report, (size_t)size};
    add(&t, "%s: %s.\n", trk_spec_name(c->base), c->verdict);
    add(&t, "%lld evaluations of the model, %lld of which failed.\n", (long long)c->evaluations,
        (long long)c->failures);
    add_parameters(&t, c);
    add_targets(&t, c);
    return TRK_OK;
}

const char *trk_calibration_report(const trk_calibration *calibration)
{
    return calibration && calibration->solved ? calibration->report : "";
}

/* Sentence for results asked too early or of something that is not there. */
static trk_status require_result(const trk_calibration *c, const void *out, const char *what,
                                 int32_t id, int32_t count)
{
    if (!c || !out)
        return trk_fail(c ? c->context : NULL, TRK_E_ARGUMENT, "%s: a pointer is NULL", what);
    if (!c->solved)
        return trk_fail(c->context, TRK_E_ARGUMENT, "%s: nothing was solved since the last change",
                        what);
    if (id < 1 || id > count)
        return trk_fail(c->context, TRK_E_ARGUMENT, "%s: there is no id %d (1 to %d)", what, id,
                        count);
    return TRK_OK;
}

trk_status trk_calibration_get_parameter(trk_calibration *calibration, int32_t parameter,
                                         trk_parameter_result *out_result)
{
    trk_status status =
        require_result(calibration, out_result, "trk_calibration_get_parameter", parameter,
                       calibration ? trk_fit_parameter_count(calibration) : 0);
    if (status != TRK_OK)
        return status;
    return trk_write_options(out_result, &calibration->parameters[parameter - 1].result,
                             sizeof *out_result);
}

trk_status trk_calibration_get_target(trk_calibration *calibration, int32_t target,
                                      trk_target_result *out_result)
{
    trk_status status = require_result(calibration, out_result, "trk_calibration_get_target",
                                       target, calibration ? trk_fit_target_count(calibration) : 0);
    if (status != TRK_OK)
        return status;
    return trk_write_options(out_result, &calibration->targets[target - 1].result,
                             sizeof *out_result);
}

int64_t trk_calibration_evaluations(const trk_calibration *calibration)
{
    return calibration ? calibration->evaluations : 0;
}

int64_t trk_calibration_failures(const trk_calibration *calibration)
{
    return calibration ? calibration->failures : 0;
}

trk_status trk_calibration_get_jacobian(const trk_calibration *calibration, double *out_jacobian,
                                        double *out_singular)
{
    trk_status status =
        require_result(calibration, calibration, "trk_calibration_get_jacobian", 1, 1);
    if (status != TRK_OK)
        return status;
    int32_t n = trk_fit_parameter_count(calibration), m = calibration->value_count;
    if (out_jacobian)
        memcpy(out_jacobian, calibration->jacobian, (size_t)n * (size_t)m * sizeof *out_jacobian);
    if (out_singular)
        memcpy(out_singular, calibration->singular, (size_t)(n < m ? n : m) * sizeof *out_singular);
    return TRK_OK;
}

/* Ids in another spec of the parts acted on, by action. */
static trk_status find_parts(const trk_calibration *c, const trk_spec *spec, int32_t *part_of)
{
    for (int32_t k = 0; k < c->action_count; k++) {
        const trk_fit_action *a = &c->actions[k];
        trk_part kind = trk_field_part(a->field);
        const char *name = trk_spec_part_name(c->base, kind, a->part);
        part_of[k] = trk_spec_find(spec, kind, name);
        if (!part_of[k])
            return trk_fail(c->context, TRK_E_NAME, "'%s' has no %s '%s'", trk_spec_name(spec),
                            trk_part_word(kind), name);
    }
    return TRK_OK;
}

trk_status trk_calibration_apply(trk_calibration *calibration, trk_spec *spec)
{
    trk_status status = require_result(calibration, spec, "trk_calibration_apply", 1, 1);
    if (status != TRK_OK)
        return status;
    double u[TRK_MAX_PARAMETERS];
    for (int32_t j = 0; j < trk_fit_parameter_count(calibration); j++)
        u[j] = log(calibration->parameters[j].result.fitted);
    int32_t *part_of = trk_new(calibration->context, calibration->action_count, sizeof *part_of);
    if (!part_of)
        return TRK_E_MEMORY;
    status = find_parts(calibration, spec, part_of);
    if (status == TRK_OK)
        status = trk_fit_apply(calibration, u, spec, part_of);
    trk_free(calibration->context, part_of);
    return status;
}
