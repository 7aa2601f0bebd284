/* SPDX-License-Identifier: MIT */
/* Every refusal has its status and a sentence that names the thing. Needs NLOPT, Needs LAPACK */
#include "fit.h"

static void parameters(void **state)
{
    trk_context *x = *state;
    trk_calibration *c = fit_create(x, TRK_VEHICLE_REFERENCE_FRONT);
    static const double bounds[][3] = {/* lower, start, upper */
                                       {0, 1, 2}, {1, 0.5, 2},      {0.5, 3, 2},
                                       {1, 1, 1}, {1, 1, INFINITY}, {NAN, 1, 2}};
    trk_parameter_options o;
    for (size_t k = 0; k < sizeof bounds / sizeof *bounds; k++) {
        trk_parameter_options_init(&o, sizeof o);
        o.lower = bounds[k][0];
        o.start = bounds[k][1];
        o.upper = bounds[k][2];
        assert_status(x, trk_calibration_add_parameter(c, "p", &o, NULL), TRK_E_RANGE);
        assert_message(x, "parameter 'p'");
    }
    trk_parameter_options_init(&o, sizeof o);
    o.meaning = 2;
    assert_status(x, trk_calibration_add_parameter(c, "p", &o, NULL), TRK_E_ARGUMENT);
    assert_message(x, "no meaning 2");
    assert_status(x, trk_calibration_add_parameter(c, NULL, NULL, NULL), TRK_E_ARGUMENT);
    assert_int_equal(trk_calibration_add_parameter(NULL, "p", NULL, NULL), TRK_E_ARGUMENT);
    assert_status(x, trk_calibration_add_parameter(c, "", NULL, NULL), TRK_E_NAME);
    assert_ok(x, trk_calibration_add_parameter(c, "p", NULL, NULL));
    assert_status(x, trk_calibration_add_parameter(c, "p", NULL, NULL), TRK_E_NAME);
    assert_message(x, "'p'");
    trk_calibration_destroy(c);
}

static void actions(void **state)
{
    trk_context *x = *state;
    trk_calibration *c = fit_create(x, TRK_VEHICLE_REFERENCE_FRONT);
    trk_parameter_options value;
    trk_parameter_options_init(&value, sizeof value);
    value.meaning = TRK_MEANING_VALUE;
    int32_t count;
    assert_ok(x, trk_calibration_add_parameter(c, "p", NULL, NULL));
    assert_ok(x, trk_calibration_add_parameter(c, "v", &value, NULL));
    assert_status(x, trk_calibration_act_on(c, 3, TRK_FIELD_MASS, "sprung", 1, NULL),
                  TRK_E_ARGUMENT);
    assert_message(x, "no parameter 3");
    assert_status(x, trk_calibration_act_on(c, 1, TRK_FIELD_BENDING + 1, "sprung", 1, NULL),
                  TRK_E_ARGUMENT);
    assert_status(x, trk_calibration_act_on(c, 1, TRK_FIELD_MASS, NULL, 1, NULL), TRK_E_ARGUMENT);
    assert_status(x, trk_calibration_act_on(c, 1, TRK_FIELD_MASS, "sprung", 0, NULL), TRK_E_RANGE);
    assert_status(x, trk_calibration_act_on(c, 1, TRK_FIELD_MASS, "sprung", NAN, NULL),
                  TRK_E_RANGE);
    assert_status(x, trk_calibration_act_on(c, 1, TRK_FIELD_MASS, "tire", 1, NULL), TRK_E_NAME);
    assert_message(x, "no body");
    assert_status(x, trk_calibration_act_on(c, 1, TRK_FIELD_STIFFNESS, "damper", 1, NULL),
                  TRK_E_MODEL);
    assert_message(x, "'damper' has nothing to scale");
    assert_ok(x, trk_calibration_act_on(c, 1, TRK_FIELD_MASS, "*sprung", 1, &count));
    assert_int_equal(count, 2);
    assert_status(x, trk_calibration_act_on(c, 2, TRK_FIELD_MASS_INERTIA, "sprung", 1, NULL),
                  TRK_E_MODEL);
    assert_message(x, "already acted on by parameter 'p'");
    trk_calibration_destroy(c);
    c = fit_create(x, TRK_VEHICLE_REFERENCE_HALF);
    assert_ok(x, trk_calibration_add_parameter(c, "v", &value, NULL));
    assert_status(x, trk_calibration_act_on(c, 1, TRK_FIELD_MASS_INERTIA, "cab", 1, NULL),
                  TRK_E_MODEL);
    assert_message(x, "has not one positive number");
    trk_calibration_destroy(c);
}

static void refused(trk_context *x, trk_calibration *c, const trk_target_options *o,
                    trk_status status, const char *text)
{
    assert_status(x, trk_calibration_add_target(c, "t", o, NULL), status);
    assert_message(x, text);
}

static void targets(void **state)
{
    trk_context *x = *state;
    trk_calibration *c = fit_create(x, TRK_VEHICLE_REFERENCE_FRONT);
    static const double shape[] = {0, 0}, falling[] = {2, 1}, ones[] = {1, 1}, bad[] = {1, NAN};
    trk_target_options good, o;
    trk_target_options_init(&good, sizeof good);
    good.coordinate = "sprung.z";
    good.value = 1;
    o = good, o.kind = 7, refused(x, c, &o, TRK_E_ARGUMENT, "no kind 7");
    o = good, o.value = -1, refused(x, c, &o, TRK_E_RANGE, "value is -1");
    o = good, o.uncertainty = -1, refused(x, c, &o, TRK_E_RANGE, "uncertainty -1");
    o = good, o.weight = 0, refused(x, c, &o, TRK_E_RANGE, "weight 0");
    o = good, o.coordinate = "roof.z", refused(x, c, &o, TRK_E_NAME, "no coordinate 'roof.z'");
    o = good, o.coordinate = NULL, refused(x, c, &o, TRK_E_ARGUMENT, "coordinate or by shape");
    o = good, o.shape = ones, refused(x, c, &o, TRK_E_ARGUMENT, "coordinate or by shape");
    o = good, o.coordinate = NULL, o.shape = shape, refused(x, c, &o, TRK_E_RANGE, "shape is zero");
    o.shape = bad, refused(x, c, &o, TRK_E_RANGE, "shape[1]");
    good.kind = TRK_TARGET_RESPONSE_CURVE;
    good.sensor = "sprung_z";
    good.count = 2;
    good.frequency = good.magnitude = ones;
    o = good, o.sensor = NULL, refused(x, c, &o, TRK_E_ARGUMENT, "sensor is NULL");
    o = good, o.sensor = "horn", refused(x, c, &o, TRK_E_NAME, "no sensor 'horn'");
    o = good, o.frequency = falling, refused(x, c, &o, TRK_E_RANGE, "frequency must rise");
    o = good, o.frequency = NULL, refused(x, c, &o, TRK_E_ARGUMENT, "frequency is NULL");
    o = good, o.frequency = (const double[]){1, 2}, o.magnitude = bad,
    refused(x, c, &o, TRK_E_RANGE, "magnitude[1]");
    o = good, o.count = 0, refused(x, c, &o, TRK_E_RANGE, "0 points");
    o = good, o.kind = TRK_TARGET_PSD_PEAK, o.low = 5, o.high = 4,
    refused(x, c, &o, TRK_E_RANGE, "band 5 to 4");
    assert_status(x, trk_calibration_add_target(c, "t", NULL, NULL), TRK_E_ARGUMENT);
    trk_calibration_destroy(c);
}

static void results_and_solve(void **state)
{
    trk_context *x = *state;
    trk_calibration *c = fit_create(x, TRK_VEHICLE_REFERENCE_FRONT);
    trk_parameter_result p = {.struct_size = sizeof p};
    trk_target_result t = {.struct_size = sizeof t};
    double y, j, one = 1, zero = 0;
    assert_status(x, trk_calibration_solve(c, NULL, NULL, NULL), TRK_E_ARGUMENT);
    assert_message(x, "no parameter");
    assert_ok(x, trk_calibration_add_parameter(c, "tire", NULL, NULL));
    assert_status(x, trk_calibration_solve(c, NULL, NULL, NULL), TRK_E_ARGUMENT);
    assert_message(x, "no target");
    fit_mode(x, c, "unsprung.z", 8);
    assert_status(x, trk_calibration_solve(c, NULL, NULL, NULL), TRK_E_ARGUMENT);
    assert_message(x, "'tire' acts on nothing");
    assert_ok(x, trk_calibration_act_on(c, 1, TRK_FIELD_STIFFNESS, "tire", 1, NULL));
    assert_status(x, trk_calibration_get_parameter(c, 1, &p), TRK_E_ARGUMENT);
    assert_message(x, "nothing was solved");
    trk_solve_options o;
    trk_solve_options_init(&o, sizeof o);
    o.met = 0;
    assert_status(x, trk_calibration_solve(c, &o, NULL, NULL), TRK_E_RANGE);
    assert_status(x, trk_calibration_evaluate(c, &zero, &y, NULL), TRK_E_RANGE);
    assert_message(x, "parameter 'tire' is 0");
    assert_status(x, trk_calibration_evaluate(c, NULL, &y, NULL), TRK_E_ARGUMENT);
    assert_ok(x, trk_calibration_evaluate(c, &one, &y, &j));
    assert_ok(x, trk_calibration_solve(c, NULL, NULL, NULL));
    assert_status(x, trk_calibration_get_parameter(c, 2, &p), TRK_E_ARGUMENT);
    assert_status(x, trk_calibration_get_target(c, 0, &t), TRK_E_ARGUMENT);
    assert_message(x, "no id 0");
    assert_status(x, trk_calibration_get_target(c, 1, NULL), TRK_E_ARGUMENT);
    t.struct_size = 0;
    assert_int_equal(trk_calibration_get_target(c, 1, &t), TRK_E_OPTIONS);
    assert_int_equal(trk_calibration_apply(NULL, NULL), TRK_E_ARGUMENT);
    trk_calibration_destroy(c);
    trk_calibration_destroy(NULL);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(parameters), cmocka_unit_test(actions),
                                       cmocka_unit_test(targets),
                                       cmocka_unit_test(results_and_solve)};
    return cmocka_run_group_tests(tests, support_setup, support_teardown);
}
