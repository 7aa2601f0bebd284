/* SPDX-License-Identifier: MIT */
/* Runs of a vehicle with a law of every kind: the blocks of trk_simulate() against single steps. */
#include "laws.h"
#include "support.h"

#include <truckride/simulate.h>

#include <math.h>
#include <string.h>

enum { SENSORS = 4, FORCES = 3, COUNT = 900 };

typedef struct fixture {
    trk_context *context;
    trk_model *model;
    trk_signal *sine;
    trk_excitation *road;
    trk_newmark_options newmark;
} fixture;

static fixture create(trk_context *context, double gravity, double rho)
{
    fixture f = {.context = context};
    trk_spec *spec = support_every_law(context);
    trk_model_options options;
    trk_model_options_init(&options, sizeof options);
    options.gravity = gravity;
    assert_ok(context, trk_model_compile(context, spec, &options, &f.model));
    trk_spec_destroy(spec);
    assert_ok(context, trk_signal_create_sine(context, 0.03, 5, 0, 0, &f.sine)); /* it lifts off */
    assert_ok(context, trk_excitation_create(context, f.model, &f.road));
    assert_ok(context, trk_excitation_add_motion(f.road, TRK_ROAD_ALL, f.sine, 1, 0));
    trk_newmark_options_init(&f.newmark, sizeof f.newmark);
    if (rho < 1)
        trk_newmark_options_generalized_alpha(&f.newmark, rho);
    return f;
}

static void destroy(fixture *f)
{
    trk_excitation_destroy(f->road);
    trk_signal_destroy(f->sine);
    trk_model_destroy(f->model);
}

static trk_series *run(const fixture *f)
{
    trk_series *series;
    trk_simulate_options options;
    trk_simulate_options_init(&options, sizeof options);
    options.duration = COUNT * f->newmark.step;
    assert_ok(f->context, trk_simulate(f->context, f->model, f->road, &f->newmark, &options, NULL,
                                       NULL, &series));
    assert_int_equal(trk_series_samples(series), COUNT + 1);
    return series;
}

/* Sensors of forces read what the links carry, step by step. */
static void check(const fixture *f)
{
    double value[SENSORS], force[SUPPORT_LAWS], height[COUNT + 1], velocity[COUNT + 1];
    static const char *const name[FORCES] = {"tire", "leaf", "air"};
    trk_series *series = run(f);
    trk_newmark *stepper;
    trk_excitation_evaluate(f->road, COUNT + 1, 0, f->newmark.step, height, velocity, NULL);
    assert_ok(f->context, trk_newmark_create(f->context, f->model, &f->newmark, &stepper));
    assert_ok(f->context, trk_newmark_set_state(stepper, 0, NULL, NULL, height, velocity, NULL));
    double largest = 0;
    for (int j = 0; j <= COUNT; j++) {
        if (j > 0)
            assert_ok(f->context, trk_newmark_step(stepper, height + j, velocity + j, NULL));
        trk_newmark_read_sensors(stepper, value);
        trk_newmark_get_links(stepper, NULL, NULL, force);
        for (int k = 0; k < FORCES; k++) {
            int32_t link = trk_model_find(f->model, TRK_PART_LINK, name[k]);
            assert_near(value[k], force[link - 1], 0);
            largest = fmax(largest, fabs(value[k]));
        }
        for (int k = 0; k < SENSORS; k++)
            assert_near(trk_series_data(series, k + 1)[j], value[k], 1e-9 * (1 + largest));
    }
    trk_newmark_destroy(stepper);
    trk_series_destroy(series);
}

static void blocks_are_steps(void **state)
{
    for (int k = 0; k < 4; k++) {
        fixture f = create(*state, k % 2 ? TRK_STANDARD_GRAVITY : 0, k / 2 ? 0.7 : 1);
        check(&f);
        destroy(&f);
    }
}

/* Memory belongs to a run, not to the model: the same bits again. */
static void runs_leave_no_trace(void **state)
{
    fixture f = create(*state, TRK_STANDARD_GRAVITY, 1);
    trk_series *first = run(&f), *second = run(&f);
    for (int k = 1; k <= SENSORS; k++)
        assert_memory_equal(trk_series_data(first, k), trk_series_data(second, k),
                            (COUNT + 1) * sizeof(double));
    trk_series_destroy(first);
    trk_series_destroy(second);
    destroy(&f);
}

#define TEST(f) cmocka_unit_test_setup_teardown(f, support_setup, support_teardown)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(blocks_are_steps),
        TEST(runs_leave_no_trace),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
