/* SPDX-License-Identifier: MIT */
/* Needs LAPACK. What a frequency response refuses, and an undamped resonance. */
#include "models.h"

static trk_status respond(trk_context *context, const trk_model *model, const double *q,
                          const double *v, double frequency, double gain, double delay, double load)
{
    const double gains[] = {0.1, gain, 0.1, 0.1}, delays[] = {0, 0, delay, 0}, loads[] = {load, 1};
    const double frequencies[] = {1, frequency};
    double y[2 * 2 * 64];
    return trk_frequency_response(context, model, q, v, 2, frequencies, gains, delays, loads, y);
}

static void not_finite(void **state)
{
    trk_context *context = *state;
    trk_model *model = builtin(context, TRK_VEHICLE_REFERENCE_TRUCK);
    const double bad[13] = {[4] = NAN};
    assert_ok(context, respond(context, model, NULL, NULL, 2, 1, 0.1, 1));
    assert_status(context, respond(context, model, NULL, NULL, -2, 1, 0.1, 1), TRK_E_RANGE);
    assert_message(context, "frequency[1] is -2; a finite number >= 0 is needed");
    assert_status(context, respond(context, model, NULL, NULL, NAN, 1, 0.1, 1), TRK_E_RANGE);
    assert_message(context, "frequency[1] is nan");
    assert_status(context, respond(context, model, NULL, NULL, INFINITY, 1, 0.1, 1), TRK_E_RANGE);
    assert_status(context, respond(context, model, NULL, NULL, 2, NAN, 0.1, 1), TRK_E_RANGE);
    assert_message(context, "road_gain[1] is nan; a finite number is needed");
    assert_status(context, respond(context, model, NULL, NULL, 2, -INFINITY, 0.1, 1), TRK_E_RANGE);
    assert_status(context, respond(context, model, NULL, NULL, 2, 1, INFINITY, 1), TRK_E_RANGE);
    assert_message(context, "road_delay[2] is inf");
    assert_status(context, respond(context, model, NULL, NULL, 2, 1, 0.1, NAN), TRK_E_RANGE);
    assert_message(context, "load_gain[0] is nan");
    assert_status(context, respond(context, model, bad, NULL, 2, 1, 0.1, 1), TRK_E_RANGE);
    assert_message(context, "displacement of 'cab.pitch' is nan");
    assert_status(context, respond(context, model, NULL, bad, 2, 1, 0.1, 1), TRK_E_RANGE);
    assert_message(context, "velocity of 'cab.pitch' is nan");
    trk_model_destroy(model);
}

static void null_pointers(void **state)
{
    trk_context *context = *state;
    trk_model *model = builtin(context, TRK_VEHICLE_THESIS_QUARTER);
    const double f = 1;
    double y[6];
    assert_int_equal(trk_frequency_response(NULL, model, NULL, NULL, 1, &f, NULL, NULL, NULL, y),
                     TRK_E_ARGUMENT);
    assert_status(context,
                  trk_frequency_response(context, NULL, NULL, NULL, 1, &f, NULL, NULL, NULL, y),
                  TRK_E_ARGUMENT);
    assert_status(context,
                  trk_frequency_response(context, model, NULL, NULL, 1, NULL, NULL, NULL, NULL, y),
                  TRK_E_ARGUMENT);
    assert_status(context,
                  trk_frequency_response(context, model, NULL, NULL, 1, &f, NULL, NULL, NULL, NULL),
                  TRK_E_ARGUMENT);
    assert_ok(context,
              trk_frequency_response(context, model, NULL, NULL, 0, &f, NULL, NULL, NULL, y));
    trk_model_destroy(model);
}

/* k = (2 pi f)^2 m in floating point: the dynamic stiffness at f is exactly zero. */
static void resonance(void **state)
{
    trk_context *context = *state;
    const double frequency[] = {1, 2, 3};
    double omega = two_pi * frequency[1], y[6];
    trk_spec *spec = chain(context, 1, 1, 0, 0);
    trk_link_options link;
    trk_link_options_init(&link, sizeof link);
    link.to_body = 1;
    link.stiffness = omega * omega;
    assert_ok(context, trk_spec_add_link(spec, "spring", &link, NULL));
    trk_sensor_options sensor;
    trk_sensor_options_init(&sensor, sizeof sensor);
    sensor.body = 1;
    assert_ok(context, trk_spec_add_sensor(spec, "a", &sensor, NULL));
    trk_model *model = compile(context, spec);
    assert_status(
        context,
        trk_frequency_response(context, model, NULL, NULL, 3, frequency, NULL, NULL, NULL, y),
        TRK_E_SINGULAR);
    assert_message(context, "chain: an undamped resonance lies at 2 Hz");
    assert_ok(context, trk_frequency_response(context, model, NULL, NULL, 1, &frequency[2], NULL,
                                              NULL, NULL, y));
    trk_model_destroy(model);
}

/* What nothing holds has its resonance at 0 Hz. */
static void free_body(void **state)
{
    trk_context *context = *state;
    trk_model *model = compile(context, chain(context, 3, 250, 100, 4e5));
    const double frequency[] = {0, 1};
    double y = 0;
    assert_status(
        context,
        trk_frequency_response(context, model, NULL, NULL, 1, frequency, NULL, NULL, NULL, &y),
        TRK_E_SINGULAR);
    assert_message(context, "at 0 Hz");
    assert_ok(context, trk_frequency_response(context, model, NULL, NULL, 1, frequency + 1, NULL,
                                              NULL, NULL, &y));
    trk_model_destroy(model);
}

static trk_status work(trk_context *context)
{
    trk_spec *spec;
    trk_model *model = NULL;
    const double f = 3, gain = 0.01, delay = 0.1;
    double y[6];
    trk_status status =
        trk_vehicle_create_builtin(context, TRK_VEHICLE_THESIS_QUARTER, TRK_VARIANT_LINEAR, &spec);
    if (status == TRK_OK)
        status = trk_model_compile(context, spec, NULL, &model);
    if (status == TRK_OK)
        status = trk_frequency_response(context, model, NULL, NULL, 1, &f, &gain, &delay, NULL, y);
    trk_model_destroy(model);
    trk_spec_destroy(spec);
    return status;
}

static void out_of_memory(void **state)
{
    (void)state;
    support_exhaust_memory(work);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(not_finite, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(null_pointers, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(resonance, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(free_body, support_setup, support_teardown),
        cmocka_unit_test(out_of_memory),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
