/* SPDX-License-Identifier: MIT */
/* Targets and the run that some of them need. */
#include "calibrate/calibrate.h"

#include <math.h>
#include <string.h>

static const trk_target_options defaults = {
    .struct_size = sizeof defaults, .kind = TRK_TARGET_UNDAMPED_FREQUENCY, .weight = 1};

static const trk_run_options run_defaults = {.struct_size = sizeof run_defaults,
                                             .duration = 480,
                                             .step = 1e-3,
                                             .segment_length = 8192,
                                             .overlap = 0.9};

void trk_target_options_init(trk_target_options *options, size_t struct_size)
{
    trk_write_defaults(options, struct_size, &defaults, sizeof defaults);
}

void trk_run_options_init(trk_run_options *options, size_t struct_size)
{
    trk_write_defaults(options, struct_size, &run_defaults, sizeof run_defaults);
}

static bool is_modal(trk_target kind)
{
    return kind <= TRK_TARGET_DAMPING_RATIO;
}

static bool is_curve(trk_target kind)
{
    return kind >= TRK_TARGET_PSD_CURVE;
}

static trk_status copy_array(trk_context *context, const char *target, const char *what,
                             int64_t count, const double *from, double least, const double **out)
{
    *out = NULL;
    if (!from)
        return trk_fail(context, TRK_E_ARGUMENT, "target '%s': %s is NULL", target, what);
    for (int64_t k = 0; k < count; k++)
        if (!isfinite(from[k]) || from[k] < least)
            return trk_fail(context, TRK_E_RANGE,
                            "target '%s': %s[%lld] is %g; a finite number%s is needed", target,
                            what, (long long)k, from[k], least >= 0 ? " > 0" : "");
    double *copy = trk_new(context, count, sizeof *copy);
    if (!copy)
        return TRK_E_MEMORY;
    memcpy(copy, from, (size_t)count * sizeof *copy);
    *out = copy;
    return TRK_OK;
}

/* The shape to look for: a unit vector for a coordinate, or the caller's. */
static trk_status read_shape(trk_calibration *c, const char *name, const trk_target_options *given,
                             trk_fit_target *target)
{
    int32_t n = trk_model_count(c->model, TRK_PART_COORDINATE);
    if ((given->coordinate == NULL) == (given->shape == NULL))
        return trk_fail(c->context, TRK_E_ARGUMENT,
                        "target '%s': a mode is picked by coordinate or by shape, one of them",
                        name);
    if (given->shape) {
        const double *shape;
        trk_status status =
            copy_array(c->context, name, "shape", n, given->shape, -INFINITY, &shape);
        target->shape = (double *)shape;
        double largest = 0;
        for (int32_t i = 0; status == TRK_OK && i < n; i++)
            largest = fmax(largest, fabs(shape[i]));
        if (status == TRK_OK && largest == 0)
            status = trk_fail(c->context, TRK_E_RANGE, "target '%s': shape is zero", name);
        for (int32_t i = 0; status == TRK_OK && i < n; i++)
            target->shape[i] /= largest; /* its size means nothing */
        return status;
    }
    int32_t id = trk_model_find(c->model, TRK_PART_COORDINATE, given->coordinate);
    if (!id)
        return trk_fail(c->context, TRK_E_NAME, "target '%s': '%s' has no coordinate '%s'", name,
                        trk_model_name(c->model), given->coordinate);
    target->shape = trk_new(c->context, n, sizeof *target->shape);
    if (!target->shape)
        return TRK_E_MEMORY;
    target->shape[id - 1] = 1;
    return TRK_OK;
}

static trk_status read_value(trk_context *context, const char *name, trk_target_options *o)
{
    if (!isfinite(o->value) || o->value <= 0)
        return trk_fail(context, TRK_E_RANGE,
                        "target '%s': value is %g; a finite number > 0 is needed", name, o->value);
    if (o->uncertainty == 0)
        o->uncertainty = 0.01 * o->value;
    return TRK_OK;
}

static trk_status read_curve(trk_calibration *c, const char *name, const trk_target_options *given,
                             trk_target_options *o)
{
    o->frequency = o->magnitude = o->road_gain = NULL;
    if (o->count < 1 || o->count > TRK_MAX_VALUES)
        return trk_fail(c->context, TRK_E_RANGE, "target '%s': %lld points; 1 to %d are needed",
                        name, (long long)o->count, TRK_MAX_VALUES);
    if (o->uncertainty == 0)
        o->uncertainty = 0.01;
    trk_status status = copy_array(c->context, name, "frequency", o->count, given->frequency,
                                   1e-300, &o->frequency);
    for (int64_t k = 1; status == TRK_OK && k < o->count; k++)
        if (!(o->frequency[k] > o->frequency[k - 1]))
            status = trk_fail(c->context, TRK_E_RANGE,
                              "target '%s': frequency must rise (%g after %g Hz)", name,
                              o->frequency[k], o->frequency[k - 1]);
    if (status == TRK_OK)
        status = copy_array(c->context, name, "magnitude", o->count, given->magnitude, 1e-300,
                            &o->magnitude);
    if (status == TRK_OK && o->kind == TRK_TARGET_RESPONSE_CURVE && given->road_gain)
        status = copy_array(c->context, name, "road_gain", trk_model_count(c->model, TRK_PART_ROAD),
                            given->road_gain, -INFINITY, &o->road_gain);
    return status;
}

static trk_status read_sensor(trk_calibration *c, const char *name, const trk_target_options *o,
                              trk_fit_target *target)
{
    if (!o->sensor)
        return trk_fail(c->context, TRK_E_ARGUMENT, "target '%s': sensor is NULL", name);
    target->sensor = trk_model_find(c->model, TRK_PART_SENSOR, o->sensor);
    if (!target->sensor)
        return trk_fail(c->context, TRK_E_NAME, "target '%s': '%s' has no sensor '%s'", name,
                        trk_model_name(c->model), o->sensor);
    if (!isfinite(o->low) || !isfinite(o->high) || o->low < 0 ||
        (o->high != 0 && o->high <= o->low))
        return trk_fail(c->context, TRK_E_RANGE,
                        "target '%s': band %g to %g Hz; 0 <= low < high is needed", name, o->low,
                        o->high);
    return TRK_OK;
}

static trk_status read_target(trk_calibration *c, const char *name, const trk_target_options *given,
                              trk_fit_target *target)
{
    trk_context *context = c->context;
    trk_target_options o = defaults;
    trk_status status = trk_read_options(context, "trk_target_options", given, &o, sizeof o);
    if (status != TRK_OK)
        return status;
    trk_target_options read = o;
    o.frequency = o.magnitude = o.road_gain = o.shape = NULL;
    target->options = o;
    if (o.kind < TRK_TARGET_UNDAMPED_FREQUENCY || o.kind > TRK_TARGET_RESPONSE_CURVE)
        return trk_fail(context, TRK_E_ARGUMENT, "target '%s': there is no kind %d", name, o.kind);
    if (!isfinite(o.uncertainty) || o.uncertainty < 0 || !isfinite(o.weight) || o.weight <= 0)
        return trk_fail(context, TRK_E_RANGE,
                        "target '%s': uncertainty %g and weight %g; finite numbers > 0 are needed",
                        name, o.uncertainty, o.weight);
    status =
        is_modal(o.kind) ? read_shape(c, name, &read, target) : read_sensor(c, name, &read, target);
    if (status == TRK_OK)
        status = is_curve(o.kind) ? read_curve(c, name, &read, &target->options)
                                  : read_value(context, name, &target->options);
    double scale = target->options.weight / target->options.uncertainty;
    if (status == TRK_OK && !(scale > 1e-100 && scale < 1e100))
        status = trk_fail(context, TRK_E_RANGE,
                          "target '%s': weight over uncertainty is %g; 1e-100 to 1e100 is needed",
                          name, scale);
    target->options.coordinate = target->options.sensor = NULL;
    target->count = is_curve(o.kind) ? (int32_t)o.count : 1;
    target->first = c->value_count;
    if (status == TRK_OK && target->first + target->count > TRK_MAX_VALUES)
        status = trk_fail(context, TRK_E_RANGE, "target '%s': more than %d values in all", name,
                          TRK_MAX_VALUES);
    return status;
}

static void drop(trk_context *context, trk_fit_target *target)
{
    trk_free(context, target->shape);
    trk_free(context, (double *)target->options.frequency);
    trk_free(context, (double *)target->options.magnitude);
    trk_free(context, (double *)target->options.road_gain);
}

trk_status trk_calibration_add_target(trk_calibration *calibration, const char *name,
                                      const trk_target_options *options, int32_t *out_target)
{
    TRK_REQUIRE(NULL, calibration, "trk_calibration_add_target");
    trk_context *context = calibration->context;
    TRK_REQUIRE(context, name, "trk_calibration_add_target");
    TRK_REQUIRE(context, options, "trk_calibration_add_target");
    trk_fit_target target = {0};
    trk_status status = read_target(calibration, name, options, &target);
    if (status == TRK_OK)
        status =
            trk_grow(context, (void **)&calibration->targets, &calibration->target_capacity,
                     (int64_t)trk_fit_target_count(calibration) + 1, sizeof *calibration->targets);
    if (status == TRK_OK)
        status = trk_names_add(context, &calibration->target_names, "target", name);
    if (status != TRK_OK) {
        drop(context, &target);
        return status;
    }
    int32_t id = trk_fit_target_count(calibration);
    calibration->targets[id - 1] = target;
    calibration->value_count += target.count;
    calibration->solved = false;
    if (out_target)
        *out_target = id;
    return TRK_OK;
}

trk_status trk_calibration_set_run(trk_calibration *calibration, const trk_excitation *excitation,
                                   const trk_run_options *options)
{
    TRK_REQUIRE(NULL, calibration, "trk_calibration_set_run");
    trk_context *context = calibration->context;
    TRK_REQUIRE(context, excitation, "trk_calibration_set_run");
    trk_run_options run = run_defaults;
    trk_status status = trk_read_options(context, "trk_run_options", options, &run, sizeof run);
    if (status != TRK_OK)
        return status;
    if (!isfinite(run.duration) || run.duration <= 0 || !isfinite(run.step) || run.step <= 0 ||
        run.segment_length < 8 || !(run.overlap >= 0 && run.overlap < 1) ||
        (double)run.segment_length * run.step > run.duration)
        return trk_fail(
            context, TRK_E_RANGE,
            "trk_run_options: %g s at %g s a step, segments of %lld samples, overlap %g: "
            "positive numbers, at least one segment of 8 samples, 0 <= overlap < 1 are needed",
            run.duration, run.step, (long long)run.segment_length, run.overlap);
    if (trk_excitation_roads(excitation) != trk_model_count(calibration->model, TRK_PART_ROAD) ||
        trk_excitation_ports(excitation) != trk_model_count(calibration->model, TRK_PART_PORT))
        return trk_fail(context, TRK_E_ARGUMENT,
                        "the excitation was made for another vehicle than '%s'",
                        trk_model_name(calibration->model));
    calibration->excitation = excitation;
    calibration->run = run;
    calibration->solved = false;
    return TRK_OK;
}

bool trk_fit_has_gradient(const trk_calibration *calibration)
{
    for (int32_t k = 0; k < trk_fit_target_count(calibration); k++) {
        trk_target kind = calibration->targets[k].options.kind;
        if (kind == TRK_TARGET_PSD_PEAK || kind == TRK_TARGET_PSD_CURVE)
            return false;
    }
    return true;
}
