/* SPDX-License-Identifier: MIT */
/* What an excitation refuses, by the words that name the culprit; memory that runs out. */
#include "support.h"

#include <truckride/excitation.h>
#include <truckride/vehicle.h>

static trk_model *make_model(trk_context *context)
{
    trk_spec *spec;
    trk_model *model;
    assert_ok(context, trk_vehicle_create_builtin(context, TRK_VEHICLE_REFERENCE_HALF,
                                                  TRK_VARIANT_LINEAR, &spec));
    assert_ok(context, trk_model_compile(context, spec, NULL, &model));
    trk_spec_destroy(spec);
    return model;
}

#define REFUSED(call, status, text)                                                                \
    do {                                                                                           \
        assert_status(*state, call, status);                                                       \
        assert_message(*state, text);                                                              \
    } while (0)

static void refusals(void **state)
{
    trk_model *model = make_model(*state);
    trk_signal *s;
    trk_excitation *x = (trk_excitation *)model;
    assert_ok(*state, trk_signal_create_step(*state, 0, 1, 1, &s));
    REFUSED(trk_excitation_create(*state, NULL, &x), TRK_E_ARGUMENT,
            "trk_excitation_create: model is NULL");
    assert_null(x);
    REFUSED(trk_excitation_create(*state, model, NULL), TRK_E_ARGUMENT, "out_excitation is NULL");
    assert_int_equal(trk_excitation_create(NULL, model, &x), TRK_E_ARGUMENT);
    assert_ok(*state, trk_excitation_create(*state, model, &x));

    REFUSED(trk_excitation_add_motion(x, 3, s, 1, 0), TRK_E_ARGUMENT,
            "excitation: there is no road 3 (1 to 2)");
    REFUSED(trk_excitation_add_motion(x, 0, s, 1, 0), TRK_E_ARGUMENT, "there is no road 0");
    REFUSED(trk_excitation_add_motion(x, TRK_ROAD_RIGHT, s, 1, 0), TRK_E_ARGUMENT,
            "no road lies on the right");
    REFUSED(trk_excitation_add_motion(x, -4, s, 1, 0), TRK_E_ARGUMENT, "there is no road -4");
    REFUSED(trk_excitation_add_motion(x, 1, NULL, 1, 0), TRK_E_ARGUMENT, "signal is NULL");
    REFUSED(trk_excitation_add_motion(x, 1, s, NAN, 0), TRK_E_RANGE, "excitation: gain is ");
    REFUSED(trk_excitation_add_motion(x, 1, s, 1, INFINITY), TRK_E_RANGE,
            "excitation: delay is inf;");
    REFUSED(trk_excitation_add_profile(x, 9, s, 1, 1, 0), TRK_E_ARGUMENT, "there is no road 9");
    REFUSED(trk_excitation_add_profile(x, 1, NULL, 1, 1, 0), TRK_E_ARGUMENT, "profile is NULL");
    REFUSED(trk_excitation_add_profile(x, 1, s, 1, 0, 0), TRK_E_RANGE,
            "excitation: speed is 0 m/s");
    REFUSED(trk_excitation_add_profile(x, 1, s, 1, -3, 0), TRK_E_RANGE,
            "excitation: speed is -3 m/s");
    REFUSED(trk_excitation_add_profile(x, 1, s, 1, NAN, 0), TRK_E_RANGE, "excitation: speed is ");
    REFUSED(trk_excitation_add_profile(x, 1, s, 1, 1, -INFINITY), TRK_E_RANGE,
            "excitation: start is -inf;");
    REFUSED(trk_excitation_add_load(x, 3, s, 1, 0), TRK_E_ARGUMENT,
            "there is no force port 3 (1 to 2)");
    REFUSED(trk_excitation_add_load(x, TRK_ROAD_ALL, s, 1, 0), TRK_E_ARGUMENT,
            "there is no force port -1");
    REFUSED(trk_excitation_add_load(x, 1, NULL, 1, 0), TRK_E_ARGUMENT, "signal is NULL");
    REFUSED(trk_excitation_add_load(x, 1, s, 1, NAN), TRK_E_RANGE, "excitation: delay is ");
    assert_int_equal(trk_excitation_add_motion(NULL, 1, s, 1, 0), TRK_E_ARGUMENT);
    assert_int_equal(trk_excitation_add_profile(NULL, 1, s, 1, 1, 0), TRK_E_ARGUMENT);
    assert_int_equal(trk_excitation_add_load(NULL, 1, s, 1, 0), TRK_E_ARGUMENT);
    assert_int_equal(trk_excitation_roads(NULL), 0);
    assert_int_equal(trk_excitation_ports(NULL), 0);
    trk_excitation_evaluate(NULL, 1, 0, 1, NULL, NULL, NULL);

    double height[2], velocity[2], load[2], zero[2] = {0, 0};
    trk_excitation_evaluate(x, 1, 5, 0, height, velocity, load); /* nothing was half done */
    assert_memory_equal(height, zero, sizeof zero);
    assert_memory_equal(velocity, zero, sizeof zero);
    assert_memory_equal(load, zero, sizeof zero);
    trk_excitation_destroy(x);
    trk_signal_destroy(s);
    trk_model_destroy(model);
}

static trk_model *shared_model;
static trk_signal *shared_signal;

static trk_status fill(trk_context *context)
{
    trk_excitation *x = NULL;
    trk_status status = trk_excitation_create(context, shared_model, &x);
    for (int k = 0; status == TRK_OK && k < 12; k++)
        status = trk_excitation_add_motion(x, TRK_ROAD_ALL, shared_signal, 1, k);
    if (status == TRK_OK)
        status = trk_excitation_add_load(x, 2, shared_signal, 1, 0);
    trk_excitation_destroy(x);
    return status;
}

static void lack_of_memory(void **state)
{
    shared_model = make_model(*state);
    assert_ok(*state, trk_signal_create_step(*state, 0, 1, 1, &shared_signal));
    support_exhaust_memory(fill);
    trk_signal_destroy(shared_signal);
    trk_model_destroy(shared_model);
}

#define TEST(f) cmocka_unit_test_setup_teardown(f, support_setup, support_teardown)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(refusals),
        TEST(lack_of_memory),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
