/* SPDX-License-Identifier: MIT */
/* Needs NLOPT. Needs LAPACK. Numbers whose size means nothing, and numbers without measure. */
#include "support.h"

#include <truckride/truckride.h>

static trk_calibration *make(trk_context *context)
{
    trk_spec *spec;
    trk_calibration *calibration;
    int32_t tire;
    assert_ok(context, trk_vehicle_create_builtin(context, TRK_VEHICLE_REFERENCE_FRONT,
                                                  TRK_VARIANT_LINEAR, &spec));
    assert_ok(context, trk_calibration_create(context, spec, NULL, &calibration));
    assert_ok(context, trk_calibration_add_parameter(calibration, "tire", NULL, &tire));
    assert_ok(context,
              trk_calibration_act_on(calibration, tire, TRK_FIELD_STIFFNESS, "tire", 1, NULL));
    trk_spec_destroy(spec);
    return calibration;
}

static void size_of_a_shape_means_nothing(void **state)
{
    const double sizes[] = {1, 1e-200, 1e200}, factor = 1;
    double value[3], slope[3];
    for (int k = 0; k < 3; k++) {
        trk_calibration *calibration = make(*state);
        double shape[2] = {0, sizes[k]};
        trk_target_options target;
        trk_target_options_init(&target, sizeof target);
        target.value = 10;
        target.shape = shape;
        assert_ok(*state, trk_calibration_add_target(calibration, "hop", &target, NULL));
        assert_ok(*state, trk_calibration_evaluate(calibration, &factor, &value[k], &slope[k]));
        assert_near(value[k], value[0], 1e-12 * value[0]);
        assert_near(slope[k], slope[0], 1e-9 * slope[0]);
        trk_calibration_destroy(calibration);
    }
}

/* The peak of a band that ends far beyond the spectrum, and of one that begins there. */
static void bands_beyond_the_spectrum(void **state)
{
    trk_calibration *calibration = make(*state);
    trk_spec *spec;
    trk_model *model;
    trk_signal *sine;
    trk_excitation *excitation;
    trk_run_options run;
    assert_ok(*state, trk_vehicle_create_builtin(*state, TRK_VEHICLE_REFERENCE_FRONT,
                                                 TRK_VARIANT_LINEAR, &spec));
    assert_ok(*state, trk_model_compile(*state, spec, NULL, &model));
    assert_ok(*state, trk_signal_create_sine(*state, 0.01, 3, 0, 0, &sine));
    assert_ok(*state, trk_excitation_create(*state, model, &excitation));
    assert_ok(*state, trk_excitation_add_motion(excitation, TRK_ROAD_ALL, sine, 1, 0));
    trk_run_options_init(&run, sizeof run);
    run.duration = 10;
    run.segment_length = 2048;
    assert_ok(*state, trk_calibration_set_run(calibration, excitation, &run));
    trk_target_options target;
    trk_target_options_init(&target, sizeof target);
    target.kind = TRK_TARGET_PSD_PEAK;
    target.value = 3;
    target.sensor = "sprung_z";
    target.high = 1e30;
    assert_ok(*state, trk_calibration_add_target(calibration, "peak", &target, NULL));
    double factor = 1, value[2];
    assert_ok(*state, trk_calibration_evaluate(calibration, &factor, value, NULL));
    assert_near(value[0], 3, 0.05);
    target.low = 1e30;
    target.high = 0;
    assert_ok(*state, trk_calibration_add_target(calibration, "nowhere", &target, NULL));
    assert_status(*state, trk_calibration_evaluate(calibration, &factor, value, NULL),
                  TRK_E_TARGET);
    assert_message(*state, "'nowhere'");
    trk_calibration_destroy(calibration);
    trk_excitation_destroy(excitation);
    trk_signal_destroy(sine);
    trk_model_destroy(model);
    trk_spec_destroy(spec);
}

static void weights_without_measure(void **state)
{
    trk_calibration *calibration = make(*state);
    trk_target_options target;
    trk_target_options_init(&target, sizeof target);
    target.value = 10;
    target.coordinate = "unsprung.z";
    target.weight = 1e300;
    target.uncertainty = 1e-300;
    assert_status(*state, trk_calibration_add_target(calibration, "hop", &target, NULL),
                  TRK_E_RANGE);
    assert_message(*state, "weight over uncertainty");
    trk_calibration_destroy(calibration);
}

#define TEST(name) cmocka_unit_test_setup_teardown(name, support_setup, support_teardown)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(size_of_a_shape_means_nothing),
        TEST(bands_beyond_the_spectrum),
        TEST(weights_without_measure),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
