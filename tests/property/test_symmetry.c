/* SPDX-License-Identifier: MIT */
/* What must not change: left for right, sums of linear motions, half truck and whole, units. */
#include "support.h"
#include "vehicles.h"

#include <stdbool.h>
#include <truckride/simulate.h>

enum { STEPS = 1000 };

static void swapped_road(double t, int32_t wheels, double *height, double *velocity)
{
    double mirrored_height[8], mirrored_velocity[8];
    support_road(t, wheels, mirrored_height, mirrored_velocity);
    for (int32_t k = 0; k < wheels; k++) { /* left and right of an axle are neighbours */
        height[k] = mirrored_height[k ^ 1];
        velocity[k] = mirrored_velocity[k ^ 1];
    }
}

/* y, roll and yaw change sign in the mirror, the others do not. */
static double mirror_sign(const char *coordinate)
{
    const char *kind = strchr(coordinate, '.') + 1;
    return strcmp(kind, "y") && strcmp(kind, "roll") && strcmp(kind, "yaw") ? 1 : -1;
}

static void test_mirror(void **state)
{
    for (trk_variant variant = 0; variant < SUPPORT_VARIANTS; variant++) {
        trk_model *model = support_model(*state, TRK_VEHICLE_REFERENCE_TRUCK, variant, 0);
        trk_newmark_options options;
        support_method(0, 1e-3, &options);
        options.tolerance = 1e-13;
        support_run a = support_record(*state, model, &options, support_road, STEPS);
        support_run b = support_record(*state, model, &options, swapped_road, STEPS);
        for (int32_t i = 0; i < a.n; i++) {
            double sign = mirror_sign(trk_model_part_name(model, TRK_PART_COORDINATE, i + 1));
            for (int64_t k = i; k < (STEPS + 1) * a.n; k += a.n)
                b.q[k] *= sign;
        }
        double off = support_difference(STEPS + 1, a.n, a.q, b.q, 0);
        print_message("mirror, %s: %.2g\n", support_variant_name(variant), off);
        assert_true(off < 1e-11);
        support_run_free(&a);
        support_run_free(&b);
        trk_model_destroy(model);
    }
}

static double weight_one, weight_two; /* of support_road() and swapped_road() */

static void summed_road(double t, int32_t wheels, double *height, double *velocity)
{
    double h[8], v[8];
    support_road(t, wheels, h, v);
    swapped_road(t, wheels, height, velocity);
    for (int32_t k = 0; k < wheels; k++) {
        height[k] = weight_one * h[k] + weight_two * height[k];
        velocity[k] = weight_one * v[k] + weight_two * velocity[k];
    }
}

/* x(a u1 + b u2) with the load on the ports once, whatever a and b with a + b = 1. */
static void test_superposition(void **state)
{
    trk_model *model = support_model(*state, TRK_VEHICLE_REFERENCE_TRUCK, TRK_VARIANT_LINEAR, 0);
    for (int method = 0; method < SUPPORT_METHODS; method++) {
        trk_newmark_options options;
        support_method(method, 1e-3, &options);
        weight_one = 1.7;
        weight_two = 1 - weight_one;
        support_run a = support_record(*state, model, &options, support_road, STEPS);
        support_run b = support_record(*state, model, &options, swapped_road, STEPS);
        support_run sum = support_record(*state, model, &options, summed_road, STEPS);
        for (int64_t k = 0; k < (STEPS + 1) * a.n; k++)
            a.q[k] = weight_one * a.q[k] + weight_two * b.q[k];
        double off = support_difference(STEPS + 1, a.n, sum.q, a.q, 0);
        print_message("superposition, %s: %.2g\n", support_method_name(method), off);
        assert_true(off < 1e-11);
        support_run_free(&a);
        support_run_free(&b);
        support_run_free(&sum);
    }
    trk_model_destroy(model);
}

/* Sensors of a run over 3 s of an even road and a rocking load on the fifth wheel. */
static trk_series *simulate(trk_context *context, trk_vehicle vehicle, trk_variant variant)
{
    double factor =
        vehicle == TRK_VEHICLE_REFERENCE_HALF ? 0.5 : 1; /* half the vehicle, half the load */
    trk_model *model = support_model(context, vehicle, variant, 0);
    trk_excitation *road;
    trk_signal *wave, *load;
    trk_series *series;
    assert_ok(context, trk_excitation_create(context, model, &road));
    assert_ok(context, trk_signal_create_sine(context, 0.01, 1.3, 0, 0, &wave));
    assert_ok(context, trk_signal_create_step(context, 0.3, 1, 5000, &load));
    for (int32_t k = 1; k <= trk_model_count(model, TRK_PART_ROAD); k++) {
        double x;
        assert_ok(context, trk_model_get_road_place(model, k, &x, NULL));
        assert_ok(context, trk_excitation_add_motion(road, k, wave, 1, -x / 20));
    }
    for (int32_t k = 1; k <= trk_model_count(model, TRK_PART_PORT); k++)
        assert_ok(context, trk_excitation_add_load(road, k, load, factor, 0));
    trk_newmark_options options;
    support_method(0, 1e-3, &options);
    options.tolerance = 1e-13;
    trk_simulate_options run;
    trk_simulate_options_init(&run, sizeof run);
    run.duration = 3;
    assert_ok(context, trk_simulate(context, model, road, &options, &run, NULL, NULL, &series));
    trk_excitation_destroy(road);
    trk_signal_destroy(wave);
    trk_signal_destroy(load);
    trk_model_destroy(model);
    return series;
}

/* Channel of the half truck for one of the truck: without left_ or right_; 0: none. */
static int32_t half_channel(const trk_series *half, const char *name)
{
    static const char *const sides[] = {"left_", "right_"};
    char without[128];
    for (int k = 0; k < 2; k++) {
        const char *side = strstr(name, sides[k]);
        if (!side)
            continue;
        snprintf(without, sizeof without, "%.*s%s", (int)(side - name), name,
                 side + strlen(sides[k]));
        return trk_series_find(half, without);
    }
    return 0;
}

static double peak(const trk_series *series, int32_t channel)
{
    double largest = 0;
    for (int64_t k = 0; k < trk_series_samples(series); k++)
        largest = fmax(largest, fabs(trk_series_data(series, channel)[k]));
    return largest;
}

static void test_half_truck(void **state)
{
    for (trk_variant variant = 0; variant < SUPPORT_VARIANTS; variant++) {
        trk_series *half = simulate(*state, TRK_VEHICLE_REFERENCE_HALF, variant);
        trk_series *whole = simulate(*state, TRK_VEHICLE_REFERENCE_TRUCK, variant);
        double worst = 0, sideways = 0;
        int pairs = 0;
        for (int32_t c = 1; c <= trk_series_channels(whole); c++) {
            int32_t h = half_channel(half, trk_series_name(whole, c));
            if (h == 0) { /* lateral: at rest */
                sideways = fmax(sideways, peak(whole, c));
                continue;
            }
            assert_string_equal(trk_series_unit(half, h), trk_series_unit(whole, c));
            worst = fmax(worst,
                         support_difference(trk_series_samples(half), 1, trk_series_data(half, h),
                                            trk_series_data(whole, c), 0));
            pairs++;
        }
        print_message(
            "half truck and truck, %s: %d channels, %.2g of each peak, lateral %.2g m/s^2\n",
            support_variant_name(variant), pairs, worst, sideways);
        assert_int_equal(pairs, 2 * trk_series_channels(half));
        assert_true(worst < 1e-9);
        assert_true(sideways < 1e-9);
        trk_series_destroy(half);
        trk_series_destroy(whole);
    }
}

/* Units of mass, length and time of a vehicle in other units: 1 kg = mass of them. */
typedef struct units {
    double mass, length, time;
} units;

static trk_curve *scale_curve(trk_context *context, const trk_curve *curve, double x, double y)
{
    if (!curve)
        return NULL;
    double xs[256], ys[256];
    int64_t count = trk_curve_count(curve);
    assert_true(count <= 256);
    for (int64_t k = 0; k < count; k++) {
        xs[k] = trk_curve_x(curve)[k] * x;
        ys[k] = trk_curve_y(curve)[k] * y;
    }
    trk_curve_options options;
    trk_curve_options_init(&options, sizeof options);
    options.interpolation = trk_curve_interpolation(curve);
    options.extrapolation = trk_curve_extrapolation(curve);
    trk_curve *scaled;
    assert_ok(context, trk_curve_create(context, "scaled", count, xs, ys, &options, &scaled));
    return scaled;
}

static void scale_link(trk_context *context, const units *u, trk_link_options *link, trk_spec *to,
                       const char *name)
{
    bool turns = link->motion == TRK_MOTION_ROTATION;
    double way = turns ? 1 : u->length, rate = u->mass / (u->time * u->time);
    double force = rate * u->length * (turns ? u->length : 1);
    link->stiffness *= force / way;
    link->damping *= force / way * u->time;
    link->spring_offset *= way;
    for (int k = 0; k < 3; k++) {
        link->from_point[k] *= u->length;
        link->to_point[k] *= u->length;
    }
    trk_curve *spring = scale_curve(context, link->spring_curve, way, force);
    trk_curve *damper = scale_curve(context, link->damper_curve, way / u->time, force);
    link->spring_curve = spring;
    link->damper_curve = damper;
    assert_ok(context, trk_spec_add_link(to, name, link, NULL));
    trk_curve_destroy(spring);
    trk_curve_destroy(damper);
}

/* The same vehicle in other units, without sensors and ports. */
static trk_model *scaled_model(trk_context *context, trk_vehicle vehicle, trk_variant variant,
                               const units *u)
{
    trk_spec *from = support_spec(context, vehicle, variant), *to;
    assert_ok(context, trk_spec_create(context, "scaled", &to));
    for (int32_t k = 1; k <= trk_spec_count(from, TRK_PART_BODY); k++) {
        trk_body_options body;
        trk_body_options_init(&body, sizeof body);
        assert_ok(context, trk_spec_get_body(from, k, &body));
        body.mass *= u->mass;
        for (int i = 0; i < 3; i++) {
            body.inertia[i] *= u->mass * u->length * u->length;
            body.cg[i] *= u->length;
        }
        assert_ok(context,
                  trk_spec_add_body(to, trk_spec_part_name(from, TRK_PART_BODY, k), &body, NULL));
    }
    for (int32_t k = 1; k <= trk_spec_count(from, TRK_PART_ROAD); k++)
        assert_ok(context,
                  trk_spec_add_road(to, trk_spec_part_name(from, TRK_PART_ROAD, k), 0, 0, NULL));
    for (int32_t k = 1; k <= trk_spec_count(from, TRK_PART_LINK); k++) {
        trk_link_options link;
        trk_link_options_init(&link, sizeof link);
        assert_ok(context, trk_spec_get_link(from, k, &link));
        scale_link(context, u, &link, to, trk_spec_part_name(from, TRK_PART_LINK, k));
    }
    trk_model *model;
    assert_ok(context, trk_model_compile(context, to, NULL, &model));
    trk_spec_destroy(from);
    trk_spec_destroy(to);
    return model;
}

static units road_units;

static void scaled_road(double t, int32_t wheels, double *height, double *velocity)
{
    support_road(t / road_units.time, wheels, height, velocity);
    for (int32_t k = 0; k < wheels; k++) {
        height[k] *= road_units.length;
        velocity[k] *= road_units.length / road_units.time;
    }
}

/* Run in other units and bring the displacements back. */
static support_run run_in(trk_context *context, trk_vehicle vehicle, trk_variant variant, units u)
{
    trk_model *model = scaled_model(context, vehicle, variant, &u);
    trk_newmark_options options;
    support_method(0, 0x1p-10 * u.time, &options);
    options.tolerance = 1e-13;
    road_units = u;
    support_run run = support_record(context, model, &options, scaled_road, STEPS);
    for (int32_t i = 0; i < run.n; i++)
        for (int64_t k = i; k < (STEPS + 1) * run.n; k += run.n)
            if (!strcmp(trk_model_unit(model, TRK_PART_COORDINATE, i + 1), "m"))
                run.q[k] /= u.length;
    trk_model_destroy(model);
    return run;
}

/* Tonnes, millimetres, milliseconds change the rounding, powers of two change not a bit. */
static void test_units(void **state)
{
    for (trk_vehicle vehicle = 1; vehicle <= SUPPORT_VEHICLES; vehicle++)
        for (trk_variant variant = 0; variant < SUPPORT_VARIANTS; variant++) {
            support_run si = run_in(*state, vehicle, variant, (units){1, 1, 1});
            support_run binary = run_in(*state, vehicle, variant, (units){0x1p-10, 1, 0x1p3});
            support_run decimal = run_in(*state, vehicle, variant, (units){1e-3, 1e3, 1e3});
            size_t size = (size_t)((STEPS + 1) * si.n) * sizeof *si.q;
            double off = support_difference(STEPS + 1, si.n, si.q, decimal.q, 0);
            print_message("units, %s %s: %.2g\n", support_vehicle_name(vehicle),
                          support_variant_name(variant), off);
            assert_memory_equal(si.q, binary.q, size);
            assert_true(off < 1e-10);
            support_run_free(&si);
            support_run_free(&binary);
            support_run_free(&decimal);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_mirror, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(test_superposition, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(test_half_truck, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(test_units, support_setup, support_teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
