/* SPDX-License-Identifier: MIT */
/* A build without LAPACK says so; a build with it has nothing to show here. */
#include "models.h"

static void says_so(void **state)
{
    trk_context *context = *state;
    if (trk_has_feature(TRK_FEATURE_LAPACK))
        skip();
    trk_model *model = builtin(context, TRK_VEHICLE_THESIS_QUARTER);
    trk_modes *modes = (trk_modes *)state;
    const double f = 1;
    double y[6];
    assert_status(context, trk_modes_create_undamped(context, model, NULL, &modes),
                  TRK_E_UNSUPPORTED);
    assert_null(modes);
    assert_message(context, "LAPACK");
    modes = (trk_modes *)state;
    assert_status(context, trk_modes_create_damped(context, model, NULL, NULL, &modes),
                  TRK_E_UNSUPPORTED);
    assert_null(modes);
    assert_status(context,
                  trk_frequency_response(context, model, NULL, NULL, 1, &f, NULL, NULL, NULL, y),
                  TRK_E_UNSUPPORTED);
    assert_message(context, "LAPACK");
    const double input[2] = {1, 0};
    trk_model *linear = model;
    assert_status(
        context, trk_model_linearise(context, model, 1, &f, input, NULL, NULL, NULL, NULL, &linear),
        TRK_E_UNSUPPORTED);
    assert_null(linear);
    assert_message(context, "LAPACK");
    trk_model_destroy(model);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(says_so, support_setup, support_teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
