/* SPDX-License-Identifier: MIT */
/* Signals on roads and ports (EXCITATION.1) against sums worked out signal by signal. */
#include "support.h"

#include <truckride/excitation.h>
#include <truckride/vehicle.h>

enum { ROADS = 4, PORTS = 2 }; /* of the truck: front left, front right, rear left, rear right */

typedef struct fixture {
    trk_model *model;
    trk_signal *step, *sine, *profile;
    trk_excitation *excitation;
} fixture;

static fixture setup(trk_context *context)
{
    const double x[] = {0, 1, 2.5, 4, 7, 9}, y[] = {0, 0.02, -0.01, 0.03, 0.01, 0};
    fixture f;
    trk_spec *spec;
    assert_ok(context, trk_vehicle_create_builtin(context, TRK_VEHICLE_REFERENCE_TRUCK,
                                                  TRK_VARIANT_LINEAR, &spec));
    assert_ok(context, trk_model_compile(context, spec, NULL, &f.model));
    trk_spec_destroy(spec);
    assert_ok(context, trk_signal_create_step(context, 0.1, 0.3, 0.05, &f.step));
    assert_ok(context, trk_signal_create_sine(context, 0.01, 3.3, 0.4, 0.05, &f.sine));
    assert_ok(context, trk_signal_create_points(context, 6, x, y, &f.profile));
    assert_ok(context, trk_excitation_create(context, f.model, &f.excitation));
    assert_int_equal(trk_excitation_roads(f.excitation), ROADS);
    assert_int_equal(trk_excitation_ports(f.excitation), PORTS);
    return f;
}

static void clear(fixture *f)
{
    trk_excitation_destroy(f->excitation);
    trk_signal_destroy(f->step);
    trk_signal_destroy(f->sine);
    trk_signal_destroy(f->profile);
    trk_model_destroy(f->model);
}

typedef struct moment {
    double height[ROADS], velocity[ROADS], load[PORTS];
} moment;

static moment at(const fixture *f, double t)
{
    moment m;
    memset(&m, 0xff, sizeof m);
    trk_excitation_evaluate(f->excitation, 1, t, 0, m.height, m.velocity, m.load);
    return m;
}

static void level_and_unloaded_at_first(void **state)
{
    fixture f = setup(*state);
    moment m = at(&f, 0.3), zero = {{0}, {0}, {0}};
    assert_memory_equal(&m, &zero, sizeof m);
    clear(&f);
    trk_excitation_destroy(NULL);
}

static void signals_add_with_gain_and_delay(void **state)
{
    fixture f = setup(*state);
    assert_ok(*state, trk_excitation_add_motion(f.excitation, 2, f.step, 1, 0));
    assert_ok(*state, trk_excitation_add_motion(f.excitation, 2, f.sine, -0.5, 0.125));
    assert_ok(*state, trk_excitation_add_motion(f.excitation, 3, f.sine, 2, -0.25));
    assert_ok(*state, trk_excitation_add_load(f.excitation, 1, f.step, 1e5, 0.0625));
    assert_ok(*state, trk_excitation_add_load(f.excitation, 1, f.step, 1e4, 0));
    for (int k = 0; k < 100; k++) {
        double t = k / 64.0;
        moment m = at(&f, t);
        assert_near(m.height[0], 0, 0);
        assert_near(m.height[1],
                    trk_signal_value(f.step, t) - 0.5 * trk_signal_value(f.sine, t - 0.125), 1e-17);
        assert_near(m.velocity[1],
                    trk_signal_rate(f.step, t) - 0.5 * trk_signal_rate(f.sine, t - 0.125), 1e-16);
        assert_near(m.height[2], 2 * trk_signal_value(f.sine, t + 0.25), 0);
        assert_near(m.height[3], 0, 0);
        assert_near(m.load[0],
                    1e5 * trk_signal_value(f.step, t - 0.0625) + 1e4 * trk_signal_value(f.step, t),
                    1e-12);
        assert_near(m.load[1], 0, 0);
    }
    clear(&f);
}

static void sides_and_all(void **state)
{
    static const int32_t selection[] = {TRK_ROAD_ALL, TRK_ROAD_LEFT, TRK_ROAD_RIGHT, 4};
    static const int expected[][ROADS] = {{1, 1, 1, 1}, {1, 0, 1, 0}, {0, 1, 0, 1}, {0, 0, 0, 1}};
    for (int k = 0; k < 4; k++) {
        fixture f = setup(*state);
        assert_ok(*state, trk_excitation_add_motion(f.excitation, selection[k], f.step, 1, 0));
        moment m = at(&f, 10);
        for (int road = 0; road < ROADS; road++)
            assert_near(m.height[road], 0.05 * expected[k][road], 1e-17);
        clear(&f);
    }
}

/* The rear axle, 4.5 m behind, sees at 16 m/s what the front saw 288/1024 s before, exactly. */
static void profile_reaches_the_rear_later(void **state)
{
    enum { COUNT = 1024, LATER = 288 };
    static double height[COUNT][ROADS], velocity[COUNT][ROADS];
    fixture f = setup(*state);
    assert_ok(*state,
              trk_excitation_add_profile(f.excitation, TRK_ROAD_ALL, f.profile, 1.5, 16, -1.25));
    trk_excitation_evaluate(f.excitation, COUNT, 0, 1.0 / 1024, height[0], velocity[0], NULL);
    for (int k = 0; k + LATER < COUNT; k++) {
        assert_near(height[k + LATER][2], height[k][0], 0);
        assert_near(velocity[k + LATER][3], velocity[k][1], 0);
    }
    for (int k = 0; k < COUNT; k++) {
        double s = -1.25 + 16 * k / 1024.0;
        assert_near(height[k][0], 1.5 * trk_signal_value(f.profile, s), 1e-18);
        assert_near(velocity[k][1], 1.5 * 16 * trk_signal_rate(f.profile, s), 1e-15);
    }
    clear(&f);
}

static void everything(trk_context *context, fixture *f)
{
    assert_ok(context, trk_excitation_add_motion(f->excitation, TRK_ROAD_LEFT, f->sine, 1, 0.0123));
    assert_ok(context,
              trk_excitation_add_profile(f->excitation, TRK_ROAD_ALL, f->profile, -1, 20.1, 0.7));
    assert_ok(context, trk_excitation_add_load(f->excitation, 2, f->sine, 3e4, 0.3));
}

static void blocks_of_any_size_agree_bitwise(void **state)
{
    enum { COUNT = 700 };
    static const int64_t sizes[] = {1, 7, 127, 128, 129, 256, 600};
    static double height[2][COUNT * ROADS], velocity[2][COUNT * ROADS], load[2][COUNT * PORTS];
    const double start = 0.25, step = 1.0 / 1024;
    fixture f = setup(*state);
    everything(*state, &f);
    trk_excitation_evaluate(f.excitation, COUNT, start, step, height[0], velocity[0], load[0]);
    for (size_t s = 0; s < sizeof sizes / sizeof *sizes; s++) {
        for (int64_t first = 0; first < COUNT; first += sizes[s]) {
            int64_t count = COUNT - first < sizes[s] ? COUNT - first : sizes[s];
            trk_excitation_evaluate(f.excitation, count, start + (double)first * step, step,
                                    height[1] + first * ROADS, velocity[1] + first * ROADS,
                                    load[1] + first * PORTS);
        }
        assert_memory_equal(height[0], height[1], sizeof height[0]);
        assert_memory_equal(velocity[0], velocity[1], sizeof velocity[0]);
        assert_memory_equal(load[0], load[1], sizeof load[0]);
    }
    /* Any step: a sample depends on its time alone. */
    trk_excitation_evaluate(f.excitation, COUNT, 0.1, 1e-3, height[0], velocity[0], load[0]);
    for (int k = 0; k < COUNT; k++) {
        moment m = at(&f, 0.1 + k * 1e-3);
        assert_memory_equal(m.height, height[0] + k * ROADS, sizeof m.height);
        assert_memory_equal(m.velocity, velocity[0] + k * ROADS, sizeof m.velocity);
        assert_memory_equal(m.load, load[0] + k * PORTS, sizeof m.load);
    }
    /* Outputs may be left out one by one. */
    memset(height[1], 0xff, sizeof height[1]);
    trk_excitation_evaluate(f.excitation, COUNT, 0.1, 1e-3, height[1], NULL, NULL);
    assert_memory_equal(height[0], height[1], sizeof height[0]);
    memset(load[1], 0xff, sizeof load[1]);
    trk_excitation_evaluate(f.excitation, COUNT, 0.1, 1e-3, NULL, NULL, load[1]);
    assert_memory_equal(load[0], load[1], sizeof load[0]);
    trk_excitation_evaluate(f.excitation, 0, 0, 1, height[1], NULL, NULL);
    trk_excitation_evaluate(f.excitation, -5, 0, 1, height[1], NULL, NULL);
    assert_memory_equal(height[0], height[1], sizeof height[0]);
    clear(&f);
}

static void velocity_is_the_derivative(void **state)
{
    fixture f = setup(*state);
    everything(*state, &f);
    const double h = 1e-5;
    for (int k = 0; k < 300; k++) {
        double t = 0.07 + k * 0.00137;
        moment m = at(&f, t), later = at(&f, t + h), before = at(&f, t - h);
        for (int road = 0; road < ROADS; road++)
            assert_near(m.velocity[road], (later.height[road] - before.height[road]) / (2 * h),
                        2e-4);
    }
    clear(&f);
}

#define TEST(f) cmocka_unit_test_setup_teardown(f, support_setup, support_teardown)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(level_and_unloaded_at_first),
        TEST(signals_add_with_gain_and_delay),
        TEST(sides_and_all),
        TEST(profile_reaches_the_rear_later),
        TEST(blocks_of_any_size_agree_bitwise),
        TEST(velocity_is_the_derivative),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
