/* SPDX-License-Identifier: MIT */
/* From parameters to the values of the targets. */
#include "calibrate/calibrate.h"

#include <truckride/linear.h>

#include <math.h>
#include <string.h>

/* Step of u for differences of matrices, which are affine in the parameters, and of responses. */
static const double difference_step = 1e-5;

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

static trk_status fail_at(const trk_calibration *c, int32_t target, trk_status status)
{
    return status == TRK_E_MEMORY ? status
                                  : trk_fail_within(c->context, status, "target '%s'",
                                                    trk_names_text(&c->target_names, target + 1));
}

/* ln(model / measured) at the points of a curve. */
static void compare(const trk_fit_target *target, const double *model, double *out_y)
{
    for (int32_t k = 0; k < target->count; k++)
        out_y[k] = log(model[k] / target->options.magnitude[k]);
}

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
        compare(target, out_y, out_y);
    trk_free(c->context, all);
    trk_free(c->context, gain);
    return status == TRK_OK ? status : fail_at(c, index, status);
}

/* Highest peak of a PSD between two frequencies. */
static trk_status find_peak(trk_context *context, const trk_target_options *o, int64_t length,
                            const double *density, double step, double *out_frequency)
{
    int64_t first = (int64_t)ceil(o->low / step);
    int64_t last = o->high > 0 ? (int64_t)floor(o->high / step) : length - 1;
    if (last > length - 1)
        last = length - 1;
    /* One bin more on both sides, so that a peak at the edge of the band counts. */
    first = first > 0 ? first - 1 : 0;
    last = last < length - 1 ? last + 1 : last;
    int64_t found = 0;
    trk_status status = last - first < 2
                            ? TRK_OK
                            : trk_psd_peaks(context, last - first + 1, density + first, step, NULL,
                                            1, out_frequency, NULL, NULL, &found);
    if (status != TRK_OK)
        return status;
    if (found == 0)
        return trk_fail(context, TRK_E_TARGET, "the PSD has no peak between %g and %g Hz", o->low,
                        o->high > 0 ? o->high : (double)last * step);
    *out_frequency += (double)first * step;
    return TRK_OK;
}

/* PSD at the frequencies of a curve, straight in the logarithms between bins. */
static trk_status psd_curve(trk_context *context, const trk_fit_target *target, int64_t length,
                            const double *density, double step, double *out_y)
{
    for (int32_t k = 0; k < target->count; k++) {
        double place = target->options.frequency[k] / step;
        int64_t bin = (int64_t)floor(place);
        if (bin + 1 >= length)
            return trk_fail(context, TRK_E_TARGET, "the PSD of the run ends at %g Hz, below %g Hz",
                            (double)(length - 1) * step, target->options.frequency[k]);
        double part = place - (double)bin;
        out_y[k] = exp((1 - part) * log(density[bin]) + part * log(density[bin + 1]));
    }
    compare(target, out_y, out_y);
    return TRK_OK;
}

/* All targets that are taken from the run. */
static trk_status run_targets(trk_calibration *c, const trk_series *series, double *density,
                              const trk_spectrum_options *settings, double *out_y)
{
    int64_t samples = trk_series_samples(series), length = trk_psd_length(settings, samples);
    double rate = trk_series_rate(series), step = rate / (double)settings->segment_length;
    for (int32_t k = 0; k < trk_fit_target_count(c); k++) {
        const trk_fit_target *target = &c->targets[k];
        trk_target kind = target->options.kind;
        if (kind != TRK_TARGET_PSD_PEAK && kind != TRK_TARGET_PSD_CURVE)
            continue;
        trk_status status = trk_psd(c->context, samples, trk_series_data(series, target->sensor),
                                    rate, settings, density);
        if (status == TRK_OK && kind == TRK_TARGET_PSD_PEAK)
            status = find_peak(c->context, &target->options, length, density, step,
                               out_y + target->first);
        else if (status == TRK_OK)
            status = psd_curve(c->context, target, length, density, step, out_y + target->first);
        if (status != TRK_OK)
            return fail_at(c, k, status);
    }
    return TRK_OK;
}

static trk_status simulate(trk_calibration *c, const trk_model *model, double *out_y)
{
    if (!c->excitation)
        return trk_fail(c->context, TRK_E_ARGUMENT,
                        "a target is taken from a run: call trk_calibration_set_run() first");
    trk_newmark_options newmark;
    trk_simulate_options run;
    trk_spectrum_options settings;
    trk_newmark_options_init(&newmark, sizeof newmark);
    trk_simulate_options_init(&run, sizeof run);
    trk_spectrum_options_init(&settings, sizeof settings);
    newmark.step = c->run.step;
    run.duration = c->run.duration;
    settings.segment_length = c->run.segment_length;
    settings.overlap = c->run.overlap;
    trk_series *series;
    trk_status status =
        trk_simulate(c->context, model, c->excitation, &newmark, &run, NULL, NULL, &series);
    if (status != TRK_OK)
        return status;
    double *density = trk_new(c->context, c->run.segment_length / 2 + 1, sizeof *density);
    status = density ? run_targets(c, series, density, &settings, out_y) : TRK_E_MEMORY;
    trk_free(c->context, density);
    trk_series_destroy(series);
    return status;
}

static trk_status response_targets(trk_calibration *c, const trk_model *model, double *out_y)
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
        status = response_targets(c, model, side[k]);
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

static trk_status response_gradients(trk_calibration *c, const double *u, double *jacobian)
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
        status = simulate(c, model, out_y);
    if (status == TRK_OK && count_kinds(c, TRK_TARGET_RESPONSE_CURVE, TRK_TARGET_RESPONSE_CURVE)) {
        status = response_targets(c, model, out_y);
        if (status == TRK_OK && out_jacobian)
            status = response_gradients(c, u, out_jacobian);
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
