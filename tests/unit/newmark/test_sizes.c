/* SPDX-License-Identifier: MIT */
/*
 * Kernels on chains of random masses and curves of every size they are compiled for, with curves
 * on links that stand on roads: each kernel takes the steps of the general way.
 */
#include "newmark/newmark.h"
#include "support.h"
#include "vehicles.h"

enum { STEPS = 300, MAX = 128, ROADS = 4, SENSORS = 7 };

static double random_number(uint32_t *seed, double from, double to)
{
    *seed = *seed * 1664525u + 1013904223u;
    return from + (to - from) * (double)(*seed >> 8) / (1 << 24);
}

/* A degressive damper and a progressive spring, both smooth. */
static void create_curves(trk_context *context, trk_curve **damper, trk_curve **spring)
{
    static const double v[] = {-1, -0.3, -0.1, 0, 0.1, 0.3, 1},
                        f[] = {-2600, -1500, -700, 0, 500, 900, 1500},
                        e[] = {-0.1, -0.04, -0.02, 0, 0.02, 0.04, 0.1},
                        s[] = {-9000, -1600, -600, 0, 600, 1600, 9000};
    assert_ok(context, trk_curve_create(context, "damper", 7, v, f, NULL, damper));
    assert_ok(context, trk_curve_create(context, "spring", 7, e, s, NULL, spring));
}

/* Masses one after another, each on the one before; the first four on roads, some with curves. */
static void add_link(trk_context *context, trk_spec *spec, int32_t k, bool curved,
                     const trk_curve *damper, const trk_curve *spring, uint32_t *seed)
{
    char name[32];
    trk_link_options link;
    trk_link_options_init(&link, sizeof link);
    link.to_body = k;
    link.from_body = k > ROADS ? k - ROADS : 0;
    link.from_road = k > ROADS ? 0 : k;
    link.stiffness = random_number(seed, 2e4, 2e5);
    link.damping = k % 3 ? random_number(seed, 100, 900) : 0;
    if (curved) {
        link.damper_curve = damper;
        link.damper_scale = random_number(seed, 0.3, 1);
        link.spring_curve = k % 2 ? spring : NULL;
        link.spring_scale = random_number(seed, 0.3, 1);
    }
    snprintf(name, sizeof name, "link%d", (int)k);
    assert_ok(context, trk_spec_add_link(spec, name, &link, NULL));
}

static void add_sensors(trk_context *context, trk_spec *spec, int32_t n)
{
    for (int32_t k = 0; k < SENSORS; k++) {
        char name[32];
        trk_sensor_options sensor;
        trk_sensor_options_init(&sensor, sizeof sensor);
        sensor.quantity = k % 6;
        if (sensor.quantity <= TRK_QUANTITY_ACCELERATION)
            sensor.body = 1 + k % n;
        else
            sensor.link = 1 + (k - 3) % n;
        snprintf(name, sizeof name, "sensor%d", (int)k);
        assert_ok(context, trk_spec_add_sensor(spec, name, &sensor, NULL));
    }
}

static trk_model *create_model(trk_context *context, int32_t n, int32_t curved, uint32_t seed)
{
    trk_spec *spec;
    trk_model *model;
    trk_curve *damper, *spring;
    create_curves(context, &damper, &spring);
    assert_ok(context, trk_spec_create(context, "chain", &spec));
    for (int32_t k = 1; k <= ROADS; k++) {
        char name[32];
        snprintf(name, sizeof name, "road%d", (int)k);
        assert_ok(context, trk_spec_add_road(spec, name, k, 0, NULL));
    }
    for (int32_t k = 1; k <= n; k++) {
        char name[32];
        trk_body_options body;
        trk_body_options_init(&body, sizeof body);
        body.mass = random_number(&seed, 20, 400);
        snprintf(name, sizeof name, "mass%d", (int)k);
        assert_ok(context, trk_spec_add_body(spec, name, &body, NULL));
    }
    for (int32_t k = 1; k <= n; k++)
        add_link(context, spec, k, k <= curved, damper, spring, &seed);
    add_sensors(context, spec, n);
    assert_ok(context, trk_model_compile(context, spec, NULL, &model));
    trk_spec_destroy(spec);
    trk_curve_destroy(damper);
    trk_curve_destroy(spring);
    return model;
}

/* q, v, a and the sensors of every step; false: no such kernel here. */
static bool run(trk_context *context, const trk_model *model, int32_t kernel, double *out,
                trk_newmark_statistics *statistics)
{
    const int32_t n = model->n, width = 3 * n + SENSORS;
    trk_newmark_options options;
    trk_newmark *stepper;
    double height[ROADS], velocity[ROADS];
    support_method(0, 1e-3, &options);
    options.tolerance = 1e-13;
    assert_ok(context, trk_newmark_create(context, model, &options, &stepper));
    assert_true(stepper->fast != NULL);
    bool is_there = trk_newmark_set_kernel(stepper, kernel);
    for (int k = 0; is_there && k < STEPS; k++) {
        double *row = out + k * width;
        support_road((k + 1) * options.step, ROADS, height, velocity);
        assert_ok(context, trk_newmark_step(stepper, height, velocity, NULL));
        trk_newmark_read_sensors(stepper, row + 3 * n);
        trk_newmark_get_state(stepper, row, row + n, row + 2 * n);
    }
    *statistics = (trk_newmark_statistics){.struct_size = sizeof *statistics};
    assert_ok(context, trk_newmark_get_statistics(stepper, statistics));
    trk_newmark_destroy(stepper);
    return is_there;
}

static void test_sizes(void **state)
{
    static const int32_t sizes[][2] = {{4, 4},   {5, 2},   {9, 9},   {12, 8},  {16, 10}, {17, 0},
                                       {17, 17}, {20, 20}, {24, 24}, {31, 13}, {32, 24}};
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        const int32_t n = sizes[i][0], curved = sizes[i][1];
        trk_model *model = create_model(*state, n, curved, 7 + (uint32_t)i);
        int32_t width = 3 * model->n + SENSORS;
        double *general = calloc((size_t)(STEPS * width), sizeof *general),
               *other = calloc((size_t)(STEPS * width), sizeof *other);
        trk_newmark_statistics general_does, does;
        assert_true(general && other);
        assert_int_equal(model->n, n);
        assert_true(run(*state, model, TRK_KERNEL_GENERAL, general, &general_does));
        print_message("n %2d curves on %2d:", (int)n, (int)curved);
        for (int32_t kernel = TRK_KERNEL_PORTABLE; kernel <= TRK_KERNEL_AVX512; kernel++) {
            if (!run(*state, model, kernel, other, &does))
                continue;
            double off = support_difference(STEPS, width, general, other, 1e-6);
            print_message(" %8.2g", off);
            assert_true(off < 1e-9);
            assert_int_equal(does.steps, STEPS);
            /* Others count a look that needs no correction as none. */
            assert_true(does.iterations <= general_does.iterations + STEPS);
        }
        print_message("\n");
        free(general);
        free(other);
        trk_model_destroy(model);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_sizes, support_setup, support_teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
