/* SPDX-License-Identifier: MIT */
/* Needs LAPACK. The method of a run: both give the same motion, refusals come through. */
#include "support.h"
#include "vehicles.h"

#include <truckride/simulate.h>

/* The run call takes the same steps; both methods tend to the same motion. */
static void test_simulate(void **state)
{
    trk_model *model =
        support_model(*state, TRK_VEHICLE_REFERENCE_HALF, TRK_VARIANT_THESIS_DAMPERS, 0);
    trk_signal *step;
    trk_excitation *road;
    trk_series *series[2];
    trk_simulate_options options;
    trk_simulate_options_init(&options, sizeof options);
    options.duration = 1;
    assert_ok(*state, trk_signal_create_step(*state, 0.05, 0.25, 0.02, &step));
    assert_ok(*state, trk_excitation_create(*state, model, &road));
    assert_ok(*state, trk_excitation_add_motion(road, TRK_ROAD_ALL, step, 1, 0));
    for (trk_method method = 0; method < 2; method++) {
        options.method = method;
        assert_ok(*state,
                  trk_simulate(*state, model, road, NULL, &options, NULL, NULL, &series[method]));
    }
    for (int32_t s = 1; s <= trk_series_channels(series[0]); s++) {
        double peak = 0, difference = 0;
        for (int64_t k = 0; k <= 1000; k++) {
            const double a = trk_series_data(series[0], s)[k], b = trk_series_data(series[1], s)[k];
            peak = fmax(peak, fabs(a));
            difference = fmax(difference, fabs(a - b));
        }
        assert_true(difference <= 2e-3 * peak && difference > 0);
    }
    trk_newmark_options newmark;
    trk_newmark_options_init(&newmark, sizeof newmark);
    newmark.step = 0.02;
    trk_series *none;
    assert_status(*state, trk_simulate(*state, model, road, &newmark, &options, NULL, NULL, &none),
                  TRK_E_RANGE);
    assert_message(*state, "limit of stability");
    options.method = 2;
    assert_status(*state, trk_simulate(*state, model, road, NULL, &options, NULL, NULL, &none),
                  TRK_E_ARGUMENT);
    assert_message(*state, "method is 2");
    trk_series_destroy(series[0]);
    trk_series_destroy(series[1]);
    trk_excitation_destroy(road);
    trk_signal_destroy(step);
    trk_model_destroy(model);
}

/* Runs over an uneven road, the sensors of every third step, read a block at a time, against the
 * same steps one by one. */
static void compare_with_steps(trk_context *context, const trk_model *model)
{
    enum { STEPS = 1000, EVERY = 3, MOST = 256, ROADS = 8 };
    trk_signal *sweep;
    trk_sweep_options sweep_options;
    trk_excitation *road;
    trk_series *series;
    trk_rungekutta *stepper;
    trk_simulate_options options;
    trk_simulate_options_init(&options, sizeof options);
    trk_sweep_options_init(&sweep_options, sizeof sweep_options);
    sweep_options.duration = options.duration = 1e-3 * STEPS;
    options.method = TRK_METHOD_RUNGE_KUTTA;
    options.record_every = EVERY;
    assert_ok(context, trk_signal_create_sweep(context, &sweep_options, &sweep));
    assert_ok(context, trk_excitation_create(context, model, &road));
    if (trk_model_count(model, TRK_PART_ROAD) > 0)
        assert_ok(context, trk_excitation_add_motion(road, TRK_ROAD_ALL, sweep, 1, 0.1));
    assert_ok(context, trk_simulate(context, model, road, NULL, &options, NULL, NULL, &series));
    assert_ok(context, trk_rungekutta_create(context, model, NULL, &stepper));
    double height[2][ROADS], velocity[2][ROADS], load[ROADS], values[MOST];
    int32_t sensors = trk_series_channels(series);
    for (int64_t k = 0; k <= STEPS; k++) {
        for (int i = 0; i < 2; i++)
            trk_excitation_evaluate(road, 1, 1e-3 * ((double)k - 0.5 + 0.5 * i), 0, height[i],
                                    velocity[i], load);
        if (k == 0)
            assert_ok(context, trk_rungekutta_set_state(stepper, 0, NULL, NULL, height[1],
                                                        velocity[1], NULL));
        else
            assert_ok(context, trk_rungekutta_step(stepper, height[0], velocity[0], NULL, height[1],
                                                   velocity[1], NULL));
        trk_rungekutta_read_sensors(stepper, values);
        for (int32_t s = 1; s <= sensors && k % EVERY == 0; s++) {
            const double *data = trk_series_data(series, s);
            double peak = 0;
            for (int64_t i = 0; i < STEPS / EVERY; i++)
                peak = fmax(peak, fabs(data[i]));
            assert_near(data[k / EVERY], values[s - 1], 1e-11 * (peak + 1e-3));
        }
    }
    trk_rungekutta_destroy(stepper);
    trk_series_destroy(series);
    trk_excitation_destroy(road);
    trk_signal_destroy(sweep);
}

/* A mass between two springs, one of which pushes: no modes, so rows, laws and factors of M. */
static trk_model *pushed_mass(trk_context *context)
{
    static const double x[] = {-0.1, -0.02, 0, 0.03, 0.1}, y[] = {-900, -100, 0, 200, 800};
    trk_curve *curve;
    trk_spec *spec;
    trk_body_options body;
    trk_link_options link;
    trk_sensor_options sensor;
    trk_model *model;
    assert_ok(context, trk_curve_create(context, "strut", 5, x, y, NULL, &curve));
    assert_ok(context, trk_spec_create(context, "pushed mass", &spec));
    trk_body_options_init(&body, sizeof body);
    trk_link_options_init(&link, sizeof link);
    trk_sensor_options_init(&sensor, sizeof sensor);
    body.mass = 40;
    assert_ok(context, trk_spec_add_body(spec, "mass", &body, &sensor.body));
    link.to_body = sensor.body;
    link.stiffness = -1e3;
    assert_ok(context, trk_spec_add_link(spec, "buckled strut", &link, NULL));
    assert_ok(context, trk_spec_add_road(spec, "road", 0, 0, &link.from_road));
    link.stiffness = 5e3;
    link.damping = 30;
    link.spring_curve = link.damper_curve = curve;
    link.spring_offset = -0.01;
    assert_ok(context, trk_spec_add_link(spec, "strut", &link, &sensor.link));
    for (sensor.quantity = 0; sensor.quantity <= TRK_QUANTITY_FORCE; sensor.quantity++) {
        trk_sensor_options one = sensor;
        *(one.quantity < TRK_QUANTITY_ELONGATION ? &one.link : &one.body) = 0;
        const char name[] = {(char)('a' + one.quantity), 0};
        assert_ok(context, trk_spec_add_sensor(spec, name, &one, NULL));
    }
    assert_ok(context, trk_model_compile(context, spec, NULL, &model));
    trk_spec_destroy(spec);
    trk_curve_destroy(curve);
    return model;
}

static void test_sensors_of_blocks(void **state)
{
    trk_model *pushed = pushed_mass(*state);
    compare_with_steps(*state, pushed);
    trk_model_destroy(pushed);
    for (trk_variant variant = 0; variant < SUPPORT_VARIANTS; variant++) {
        trk_model *model = support_model(*state, TRK_VEHICLE_REFERENCE_TRUCK, variant, 0);
        compare_with_steps(*state, model);
        trk_model_destroy(model);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_simulate, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(test_sensors_of_blocks, support_setup, support_teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
