/* SPDX-License-Identifier: MIT */
#include "vehicles.h"

#include "support.h"

static const double pi = 3.14159265358979323846;

const char *support_vehicle_name(trk_vehicle vehicle)
{
    static const char *const names[] = {
        "",           "thesis quarter", "reference front", "reference rear",
        "half truck", "3D truck",       "half car"};
    return names[vehicle];
}

const char *support_variant_name(trk_variant variant)
{
    static const char *const names[] = {"linear", "thesis dampers", "non-linear"};
    return names[variant];
}

static trk_spec *half_car(trk_context *context, trk_variant variant)
{
    trk_half_car_parameters p;
    trk_half_car_parameters_init(&p, sizeof p);
    trk_curve *damper[2] = {NULL, NULL};
    for (int end = 0; variant != TRK_VARIANT_LINEAR && end < 2; end++) {
        trk_table thesis =
            end == 0 ? TRK_TABLE_THESIS_FRONT_AXLE_DAMPER : TRK_TABLE_THESIS_REAR_AXLE_DAMPER;
        trk_table table =
            variant == TRK_VARIANT_NONLINEAR ? TRK_TABLE_REFERENCE_AXLE_DAMPER : thesis;
        assert_ok(context, trk_vehicle_create_curve(context, table, NULL, &damper[end]));
        p.damping[end] = 0;
        p.damper_curve[end] = damper[end];
    }
    trk_spec *spec;
    assert_ok(context, trk_vehicle_create_half_car(context, &p, &spec));
    trk_curve_destroy(damper[0]);
    trk_curve_destroy(damper[1]);
    return spec;
}

trk_spec *support_spec(trk_context *context, trk_vehicle vehicle, trk_variant variant)
{
    if (vehicle == SUPPORT_HALF_CAR)
        return half_car(context, variant);
    trk_spec *spec;
    assert_ok(context, trk_vehicle_create_builtin(context, vehicle, variant, &spec));
    return spec;
}

trk_model *support_model(trk_context *context, trk_vehicle vehicle, trk_variant variant,
                         double gravity)
{
    trk_spec *spec = support_spec(context, vehicle, variant);
    trk_model_options options;
    trk_model_options_init(&options, sizeof options);
    options.gravity = gravity;
    trk_model *model;
    assert_ok(context, trk_model_compile(context, spec, &options, &model));
    trk_spec_destroy(spec);
    return model;
}

trk_model *support_oscillator(trk_context *context, double mass, double stiffness, double damping)
{
    trk_spec *spec;
    assert_ok(context, trk_spec_create(context, "oscillator", &spec));
    trk_body_options body;
    trk_body_options_init(&body, sizeof body);
    body.mass = mass;
    assert_ok(context, trk_spec_add_body(spec, "mass", &body, NULL));
    trk_link_options link;
    trk_link_options_init(&link, sizeof link);
    link.to_body = 1;
    link.stiffness = stiffness;
    link.damping = damping;
    assert_ok(context, trk_spec_add_link(spec, "spring", &link, NULL));
    trk_model *model;
    assert_ok(context, trk_model_compile(context, spec, NULL, &model));
    trk_spec_destroy(spec);
    return model;
}

/* A (1 - cos) (sin w1 t + sin(w2 t) / 4), analytic and of third order at t = 0. */
static void wheel_road(double t, int32_t k, double *height, double *velocity)
{
    double w0 = 0.9 * pi, w1 = 2 * pi * (1 + 0.3 * k), w2 = 2 * pi * (5 + 0.6 * k);
    double swell = 1 - cos(w0 * t), swell_rate = w0 * sin(w0 * t);
    double wave = sin(w1 * t) + sin(w2 * t) / 4,
           wave_rate = w1 * cos(w1 * t) + w2 / 4 * cos(w2 * t);
    double amplitude = 0.01 * (k % 2 ? -0.8 : 1);
    *height = amplitude * swell * wave;
    *velocity = amplitude * (swell_rate * wave + swell * wave_rate);
}

void support_road(double t, int32_t wheels, double *height, double *velocity)
{
    for (int32_t k = 0; k < wheels; k++)
        wheel_road(t, k, &height[k], &velocity[k]);
}

void support_even_road(double t, int32_t wheels, double *height, double *velocity)
{
    for (int32_t k = 0; k < wheels; k++)
        wheel_road(t, 0, &height[k], &velocity[k]);
}

void support_load(double t, int32_t ports, double *load)
{
    for (int32_t k = 0; k < ports; k++)
        load[k] = (k % 2 ? -4000.0 : 2500.0) * (1 - cos(2 * pi * (0.7 + 0.2 * k) * t));
}

const char *support_method_name(int method)
{
    static const char *const names[SUPPORT_METHODS] = {"average acceleration", "Adams", "HHT -0.1",
                                                       "generalized alpha 0.6"};
    return names[method];
}

void support_method(int method, double step, trk_newmark_options *options)
{
    trk_newmark_options_init(options, sizeof *options);
    options->step = step;
    if (method == 1)
        trk_newmark_options_adams(options);
    else if (method == 2)
        trk_newmark_options_hht(options, -0.1);
    else if (method == 3)
        trk_newmark_options_generalized_alpha(options, 0.6);
}

static double *zeros(int64_t count)
{
    double *block = calloc((size_t)count + 1, sizeof *block);
    assert_non_null(block);
    return block;
}

support_run support_record(trk_context *context, const trk_model *model,
                           const trk_newmark_options *options, support_drive road, int64_t steps)
{
    int32_t n = trk_model_count(model, TRK_PART_COORDINATE),
            links = trk_model_count(model, TRK_PART_LINK),
            wheels = trk_model_count(model, TRK_PART_ROAD),
            ports = trk_model_count(model, TRK_PART_PORT);
    support_run run = {n,
                       links,
                       steps,
                       zeros((steps + 1) * n),
                       zeros((steps + 1) * n),
                       zeros((steps + 1) * links)};
    double *height = zeros(wheels), *velocity = zeros(wheels), *load = zeros(ports);
    trk_newmark *stepper;
    assert_ok(context, trk_newmark_create(context, model, options, &stepper));
    for (int64_t k = 0; k <= steps; k++) {
        double t = (double)k * trk_newmark_step_size(stepper);
        road(t, wheels, height, velocity);
        support_load(t, ports, load);
        if (k == 0)
            assert_ok(context,
                      trk_newmark_set_state(stepper, 0, NULL, NULL, height, velocity, load));
        else
            assert_ok(context, trk_newmark_step(stepper, height, velocity, load));
        trk_newmark_get_state(stepper, run.q + k * n, run.v + k * n, NULL);
        trk_newmark_get_links(stepper, NULL, NULL, run.force + k * links);
    }
    trk_newmark_destroy(stepper);
    free(height);
    free(velocity);
    free(load);
    return run;
}

void support_run_free(support_run *run)
{
    free(run->q);
    free(run->v);
    free(run->force);
}

double support_difference(int64_t rows, int32_t columns, const double *a, const double *b,
                          double floor)
{
    double largest_peak = 0, worst = 0;
    for (int64_t i = 0; i < rows * columns; i++)
        largest_peak = fmax(largest_peak, fabs(a[i]));
    for (int32_t j = 0; j < columns; j++) {
        double peak = floor * largest_peak, difference = 0;
        for (int64_t i = j; i < rows * columns; i += columns) {
            peak = fmax(peak, fabs(a[i]));
            double d = fabs(a[i] - b[i]);
            difference = d <= difference ? difference : d; /* keeps a NaN */
        }
        double ratio = difference == 0 ? 0 : difference / peak;
        worst = ratio <= worst ? worst : ratio;
    }
    return worst;
}
