/* SPDX-License-Identifier: MIT */
/* A run is the same bit by bit: again, step by step, after a refused step; it may come to rest. */
#include "support.h"
#include "vehicles.h"

#include <truckride/simulate.h>

enum { STEPS = 700, MAX = 128 };

static void test_again(void **state)
{
    for (trk_variant variant = 0; variant < SUPPORT_VARIANTS; variant++) {
        trk_model *model = support_model(*state, TRK_VEHICLE_REFERENCE_TRUCK, variant, 0);
        trk_newmark_options options;
        support_method(3, 1e-3, &options);
        support_run a = support_record(*state, model, &options, support_road, STEPS);
        support_run b = support_record(*state, model, &options, support_road, STEPS);
        assert_memory_equal(a.q, b.q, (size_t)((STEPS + 1) * a.n) * sizeof *a.q);
        assert_memory_equal(a.force, b.force, (size_t)((STEPS + 1) * a.links) * sizeof *a.q);
        support_run_free(&a);
        support_run_free(&b);
        trk_model_destroy(model);
    }
}

static double peak(const trk_series *series, int32_t channel)
{
    const double *x = trk_series_data(series, channel);
    double largest = 0;
    for (int64_t k = 0; k < trk_series_samples(series); k++)
        largest = fmax(largest, fabs(x[k]));
    return largest;
}

/* trk_simulate() is trk_newmark_step() in a loop; its sensors are summed in another order. */
static void test_step_by_step(void **state)
{
    trk_model *model = support_model(*state, TRK_VEHICLE_REFERENCE_TRUCK, TRK_VARIANT_NONLINEAR,
                                     TRK_STANDARD_GRAVITY);
    trk_excitation *road;
    trk_signal *sweep, *load;
    trk_series *series;
    assert_ok(*state, trk_excitation_create(*state, model, &road));
    assert_ok(*state, trk_signal_create_sweep(*state, NULL, &sweep));
    assert_ok(*state, trk_signal_create_step(*state, 2, 0.2, 3000, &load));
    assert_ok(*state, trk_excitation_add_motion(road, TRK_ROAD_LEFT, sweep, 3, 0));
    assert_ok(*state, trk_excitation_add_load(road, 1, load, 1, 0));
    trk_simulate_options options;
    trk_simulate_options_init(&options, sizeof options);
    trk_newmark_options newmark;
    support_method(0, 0x1p-10, &newmark); /* so that every time is exact however it is added up */
    options.duration = STEPS * newmark.step;
    options.start = 1.75;
    assert_ok(*state, trk_simulate(*state, model, road, &newmark, &options, NULL, NULL, &series));
    assert_int_equal(trk_series_samples(series), STEPS + 1);

    double height[MAX], velocity[MAX], loads[MAX], values[MAX];
    trk_newmark *stepper;
    assert_ok(*state, trk_newmark_create(*state, model, &newmark, &stepper));
    for (int64_t k = 0; k <= STEPS; k++) {
        trk_excitation_evaluate(road, 1, options.start + (double)k * newmark.step, 1, height,
                                velocity, loads);
        if (k == 0)
            assert_ok(*state, trk_newmark_set_state(stepper, options.start, NULL, NULL, height,
                                                    velocity, loads));
        else
            assert_ok(*state, trk_newmark_step(stepper, height, velocity, loads));
        trk_newmark_read_sensors(stepper, values);
        for (int32_t c = 1; c <= trk_series_channels(series); c++)
            assert_near(values[c - 1], trk_series_data(series, c)[k], 1e-12 * peak(series, c));
    }
    trk_newmark_destroy(stepper);
    trk_series_destroy(series);
    trk_excitation_destroy(road);
    trk_signal_destroy(sweep);
    trk_signal_destroy(load);
    trk_model_destroy(model);
}

/* Calls that must fail and must leave no trace. */
static void disturb(trk_context *context, trk_newmark *stepper, int64_t k, const double *height,
                    const double *velocity, const double *load)
{
    double bad[MAX], q[MAX] = {0};
    double time = trk_newmark_time(stepper);
    memcpy(bad, height, MAX * sizeof *bad);
    bad[2] = k % 2 ? NAN : INFINITY;
    assert_status(context, trk_newmark_step(stepper, bad, velocity, load), TRK_E_RANGE);
    assert_message(context, "rear_left");
    assert_status(context, trk_newmark_step(stepper, height, bad, load), TRK_E_RANGE);
    bad[1] = NAN;
    assert_status(context, trk_newmark_step(stepper, height, velocity, bad), TRK_E_RANGE);
    assert_message(context, "fifth_wheel");
    bad[1] = bad[2] = 1e308;
    assert_int_not_equal(trk_newmark_step(stepper, bad, bad, load), TRK_OK);
    q[3] = NAN;
    assert_status(context, trk_newmark_set_state(stepper, 0, q, NULL, NULL, NULL, NULL),
                  TRK_E_RANGE);
    q[3] = 1e308;
    assert_status(context, trk_newmark_set_state(stepper, 0, q, NULL, NULL, NULL, NULL),
                  TRK_E_RANGE);
    assert_status(context, trk_newmark_set_state(stepper, NAN, NULL, NULL, NULL, NULL, NULL),
                  TRK_E_RANGE);
    assert_true(trk_newmark_time(stepper) == time);
}

static void test_failure_leaves_no_trace(void **state)
{
    for (int method = 0; method < SUPPORT_METHODS; method++) {
        trk_model *model =
            support_model(*state, TRK_VEHICLE_REFERENCE_TRUCK, TRK_VARIANT_NONLINEAR, 0);
        trk_newmark_options options;
        support_method(method, 1e-3, &options);
        support_run good = support_record(*state, model, &options, support_road, STEPS);
        double height[MAX] = {0}, velocity[MAX] = {0}, load[MAX] = {0}, q[MAX];
        trk_newmark *stepper;
        assert_ok(*state, trk_newmark_create(*state, model, &options, &stepper));
        support_road(0, 4, height, velocity);
        support_load(0, 2, load);
        assert_ok(*state, trk_newmark_set_state(stepper, 0, NULL, NULL, height, velocity, load));
        for (int64_t k = 1; k <= STEPS; k++) {
            support_road((double)k * 1e-3, 4, height, velocity);
            support_load((double)k * 1e-3, 2, load);
            if (k % 50 < 2)
                disturb(*state, stepper, k, height, velocity, load);
            assert_ok(*state, trk_newmark_step(stepper, height, velocity, load));
            trk_newmark_get_state(stepper, q, NULL, NULL);
            assert_memory_equal(q, good.q + k * good.n, (size_t)good.n * sizeof *q);
        }
        trk_newmark_destroy(stepper);
        support_run_free(&good);
        trk_model_destroy(model);
    }
}

/* A step that does not converge says where and leaves the state; the next good one goes on. */
static void test_no_convergence(void **state)
{
    trk_model *model =
        support_model(*state, TRK_VEHICLE_REFERENCE_TRUCK, TRK_VARIANT_THESIS_DAMPERS, 0);
    trk_newmark_options options;
    support_method(0, 1e-3, &options);
    options.max_iterations = 1;
    double height[4] = {0.05, -0.05, 0.05, -0.05}, q[MAX], zero[MAX] = {0};
    trk_newmark *stepper;
    assert_ok(*state, trk_newmark_create(*state, model, &options, &stepper));
    double velocity[4] = {50, -50, 50, -50};
    assert_status(*state, trk_newmark_step(stepper, height, velocity, NULL), TRK_E_CONVERGENCE);
    assert_message(*state, "_damper'");
    assert_message(*state, "after 1 iterations");
    trk_newmark_get_state(stepper, q, NULL, NULL);
    assert_memory_equal(q, zero, 13 * sizeof *q);
    assert_ok(*state, trk_newmark_step(stepper, NULL, NULL, NULL));
    trk_newmark_get_state(stepper, q, NULL, NULL);
    assert_memory_equal(q, zero, 13 * sizeof *q);
    trk_newmark_destroy(stepper);
    trk_model_destroy(model);
}

/* Motions far below the rounding of the tables' forces converge: a vehicle may stop. */
static void test_coming_to_rest(void **state)
{
    for (trk_vehicle vehicle = 1; vehicle <= SUPPORT_VEHICLES; vehicle++)
        for (trk_variant variant = TRK_VARIANT_THESIS_DAMPERS; variant < SUPPORT_VARIANTS;
             variant++)
            for (double size = 1e-3; size > 1e-18; size /= 1e3) {
                trk_model *model = support_model(*state, vehicle, variant, 0);
                trk_newmark *stepper;
                double q[MAX] = {size, -size}, largest = 0;
                assert_ok(*state, trk_newmark_create(*state, model, NULL, &stepper));
                assert_ok(*state, trk_newmark_set_state(stepper, 0, q, NULL, NULL, NULL, NULL));
                for (int64_t k = 0; k < 2000; k++)
                    assert_ok(*state, trk_newmark_step(stepper, NULL, NULL, NULL));
                trk_newmark_get_state(stepper, q, NULL, NULL);
                for (int32_t i = 0; i < trk_model_count(model, TRK_PART_COORDINATE); i++)
                    largest = fmax(largest, fabs(q[i]));
                assert_true(largest < 3 * size + 1e-15);
                trk_newmark_destroy(stepper);
                trk_model_destroy(model);
            }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_again, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(test_step_by_step, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(test_failure_leaves_no_trace, support_setup,
                                        support_teardown),
        cmocka_unit_test_setup_teardown(test_no_convergence, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(test_coming_to_rest, support_setup, support_teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
