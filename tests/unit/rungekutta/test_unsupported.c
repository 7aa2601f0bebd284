/* SPDX-License-Identifier: MIT */
/* A build without LAPACK says so wherever the limit of stability is needed. */
#include "support.h"
#include "vehicles.h"

#include <truckride/simulate.h>

static void test_without_lapack(void **state)
{
    if (trk_has_feature(TRK_FEATURE_LAPACK))
        skip();
    trk_model *model = support_model(*state, TRK_VEHICLE_REFERENCE_HALF, TRK_VARIANT_LINEAR, 0);
    trk_rungekutta *stepper;
    trk_excitation *road;
    trk_series *series;
    trk_simulate_options options;
    double limit;
    trk_simulate_options_init(&options, sizeof options);
    options.method = TRK_METHOD_RUNGE_KUTTA;
    assert_ok(*state, trk_excitation_create(*state, model, &road));
    assert_status(*state, trk_rungekutta_find_limit(*state, model, &limit, NULL),
                  TRK_E_UNSUPPORTED);
    assert_message(*state, "LAPACK");
    assert_status(*state, trk_rungekutta_create(*state, model, NULL, &stepper), TRK_E_UNSUPPORTED);
    assert_null(stepper);
    assert_status(*state, trk_simulate(*state, model, road, NULL, &options, NULL, NULL, &series),
                  TRK_E_UNSUPPORTED);
    assert_null(series);
    trk_excitation_destroy(road);
    trk_model_destroy(model);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_without_lapack, support_setup, support_teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
