/* SPDX-License-Identifier: MIT */
/* The method of a run: both give the same motion, refusals come through. */
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

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_simulate, support_setup, support_teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
