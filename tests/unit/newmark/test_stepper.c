/* SPDX-License-Identifier: MIT */
/* Creating, setting and asking a stepper: every error path, memory, statistics. */
#include "support.h"
#include "vehicles.h"

static void test_null(void **state)
{
    trk_model *model = support_oscillator(*state, 1, 1, 0);
    trk_newmark *stepper;
    trk_newmark_statistics statistics = {0};
    double q = 7;
    assert_status(*state, trk_newmark_create(*state, model, NULL, NULL), TRK_E_ARGUMENT);
    assert_status(*state, trk_newmark_create(NULL, model, NULL, &stepper), TRK_E_ARGUMENT);
    stepper = (trk_newmark *)&q;
    assert_status(*state, trk_newmark_create(*state, NULL, NULL, &stepper), TRK_E_ARGUMENT);
    assert_null(stepper);
    assert_int_equal(trk_newmark_step(NULL, NULL, NULL, NULL), TRK_E_ARGUMENT);
    assert_int_equal(trk_newmark_set_state(NULL, 0, NULL, NULL, NULL, NULL, NULL), TRK_E_ARGUMENT);
    assert_int_equal(trk_newmark_get_statistics(NULL, &statistics), TRK_E_ARGUMENT);
    assert_true(isnan(trk_newmark_time(NULL)));
    assert_true(isnan(trk_newmark_step_size(NULL)));
    trk_newmark_get_state(NULL, &q, &q, &q);
    trk_newmark_get_links(NULL, &q, &q, &q);
    trk_newmark_read_sensors(NULL, &q);
    assert_true(q == 7);
    trk_newmark_options_adams(NULL);
    trk_newmark_options_hht(NULL, 0);
    trk_newmark_options_generalized_alpha(NULL, 1);
    trk_newmark_destroy(NULL);
    trk_model_destroy(model);
}

static void refuse(trk_context *context, const trk_model *model, const trk_newmark_options *options,
                   const char *message)
{
    trk_newmark *stepper;
    assert_status(context, trk_newmark_create(context, model, options, &stepper), TRK_E_RANGE);
    assert_message(context, message);
    assert_null(stepper);
}

/* A field, a value on the wrong side of its bound, and one on the bound. */
static void test_ranges(void **state)
{
    trk_model *model = support_oscillator(*state, 1, 1, 0);
    trk_newmark_options o;
    static const double bad_steps[] = {0, -1, NAN, INFINITY};
    for (int k = 0; k < 4; k++) {
        support_method(0, bad_steps[k], &o);
        refuse(*state, model, &o, "step is");
        support_method(0, 1e-3, &o);
        o.tolerance = bad_steps[k];
        refuse(*state, model, &o, "tolerance is");
    }
    static const struct {
        const char *message;
        double bad_low, low, high, bad_high;
    } fields[] = {{"beta is", -1e-9, 0, 1, 1.1},
                  {"gamma is", 0.49, 0.5, 1.5, 1.51},
                  {"alpha_f is", -1e-9, 0, 0.5, 0.51},
                  {"alpha_m is", -1.01, -1, 0.3, 0.31}};
    for (int k = 0; k < 4; k++) {
        const double value[] = {fields[k].bad_low, fields[k].bad_high, NAN, fields[k].low,
                                fields[k].high};
        for (int i = 0; i < 5; i++) {
            support_method(0, 1e-3, &o);
            o.alpha_f = k == 3 ? 0.3 : 0; /* the bound of alpha_m */
            double *field[] = {&o.beta, &o.gamma, &o.alpha_f, &o.alpha_m};
            *field[k] = value[i];
            trk_newmark *stepper = NULL;
            if (i < 3)
                refuse(*state, model, &o, fields[k].message);
            else
                assert_ok(*state, trk_newmark_create(*state, model, &o, &stepper));
            trk_newmark_destroy(stepper);
        }
    }
    support_method(0, 1e-3, &o);
    o.max_iterations = 0;
    refuse(*state, model, &o, "max_iterations is 0");
    trk_model_destroy(model);
}

/* Every method that has a name can be created, over the whole range of its parameter. */
static void test_named_methods_are_accepted(void **state)
{
    trk_model *model = support_oscillator(*state, 1, 1, 0);
    for (int k = 0; k <= 40; k++) {
        trk_newmark_options o;
        support_method(k == 0 ? 1 : 0, 1e-3, &o);
        if (k > 20)
            trk_newmark_options_hht(&o, -(k - 20) / 60.0);
        else if (k > 0)
            trk_newmark_options_generalized_alpha(&o, (k - 1) / 19.0);
        trk_newmark *stepper;
        assert_ok(*state, trk_newmark_create(*state, model, &o, &stepper));
        trk_newmark_destroy(stepper);
    }
    trk_model_destroy(model);
}

static void test_newer_options(void **state)
{
    struct {
        trk_newmark_options options;
        double unknown;
    } newer = {.unknown = 1};
    trk_model *model = support_oscillator(*state, 1, 1, 0);
    trk_newmark *stepper;
    trk_newmark_options_init(&newer.options, sizeof newer.options);
    newer.options.struct_size = sizeof newer;
    assert_status(*state, trk_newmark_create(*state, model, &newer.options, &stepper),
                  TRK_E_OPTIONS);
    assert_null(stepper);
    trk_model_destroy(model);
}

static void test_state(void **state)
{
    trk_model *model = support_oscillator(*state, 2, 50, 3);
    trk_newmark *stepper;
    const double q0 = 0.1, v0 = -0.4;
    double q, v, a, e, rate, force;
    assert_ok(*state, trk_newmark_create(*state, model, NULL, &stepper));
    assert_true(trk_newmark_step_size(stepper) == 1e-3 && trk_newmark_time(stepper) == 0);
    assert_ok(*state, trk_newmark_set_state(stepper, 5, &q0, &v0, NULL, NULL, NULL));
    trk_newmark_get_state(stepper, &q, &v, &a);
    trk_newmark_get_links(stepper, &e, &rate, &force);
    assert_true(q == q0 && v == v0 && e == q0 && rate == v0);
    assert_near(a, -(50 * q0 + 3 * v0) / 2, 1e-14);
    assert_near(force, 50 * q0 + 3 * v0, 1e-14);
    assert_ok(*state, trk_newmark_step(stepper, NULL, NULL, NULL));
    assert_near(trk_newmark_time(stepper), 5.001, 1e-15);
    trk_newmark_get_state(stepper, &q, &v, &a);
    assert_near(2 * a + 3 * v + 50 * q, 0, 1e-13); /* (NEWMARK.1) */
    trk_newmark_destroy(stepper);
    trk_model_destroy(model);
}

/* A vehicle under gravity starts where it stands, and stays there. */
static void test_starts_in_equilibrium(void **state)
{
    trk_model *model = support_model(*state, TRK_VEHICLE_REFERENCE_TRUCK, TRK_VARIANT_NONLINEAR,
                                     TRK_STANDARD_GRAVITY);
    trk_newmark *stepper;
    double q0[13], q[13];
    trk_model_get_static(model, q0, NULL);
    assert_ok(*state, trk_newmark_create(*state, model, NULL, &stepper));
    for (int k = 0; k < 1000; k++)
        assert_ok(*state, trk_newmark_step(stepper, NULL, NULL, NULL));
    trk_newmark_get_state(stepper, q, NULL, NULL);
    for (int i = 0; i < 13; i++)
        assert_near(q[i], q0[i], 1e-12);
    trk_newmark_destroy(stepper);
    trk_model_destroy(model);
}

static void test_statistics(void **state)
{
    trk_model *model =
        support_model(*state, TRK_VEHICLE_REFERENCE_TRUCK, TRK_VARIANT_THESIS_DAMPERS, 0);
    trk_newmark *stepper;
    trk_newmark_statistics s = {0};
    double height[4], velocity[4];
    assert_ok(*state, trk_newmark_create(*state, model, NULL, &stepper));
    assert_int_equal(trk_newmark_get_statistics(stepper, &s), TRK_E_OPTIONS);
    for (int k = 1; k <= 100; k++) {
        support_road(k * 1e-3, 4, height, velocity);
        assert_ok(*state, trk_newmark_step(stepper, height, velocity, NULL));
    }
    s.struct_size = sizeof s;
    assert_ok(*state, trk_newmark_get_statistics(stepper, &s));
    assert_true(s.steps == 100 && s.nonlinear_links == 8 && s.coordinates == 13);
    assert_true(s.iterations >= s.max_iterations && s.max_iterations >= 1 && s.worst_link >= 1);
    assert_true(s.backend == TRK_BACKEND_DENSE && s.factor_entries == 13 * 14 / 2);
    trk_newmark_destroy(stepper);
    trk_model_destroy(model);
}

static trk_spec *spec_for_memory;

static trk_status create_and_set(trk_context *context)
{
    trk_model *model = NULL;
    trk_newmark *stepper = NULL;
    trk_status status = trk_model_compile(context, spec_for_memory, NULL, &model);
    if (status == TRK_OK)
        status = trk_newmark_create(context, model, NULL, &stepper);
    if (status == TRK_OK)
        status = trk_newmark_set_state(stepper, 1, NULL, NULL, NULL, NULL, NULL);
    trk_newmark_destroy(stepper);
    trk_model_destroy(model);
    return status;
}

static void test_memory(void **state)
{
    spec_for_memory = support_spec(*state, TRK_VEHICLE_REFERENCE_HALF, TRK_VARIANT_NONLINEAR);
    support_exhaust_memory(create_and_set);
    trk_spec_destroy(spec_for_memory);
}

/* set_state() needs no memory: it cannot lose the factors that the next step works with. */
static void test_set_state_without_memory(void **state)
{
    (void)state;
    support_memory memory = {0, 0, 0};
    trk_context *context;
    assert_int_equal(trk_context_create(support_allocate, &memory, &context), TRK_OK);
    trk_model *model = support_oscillator(context, 1, 100, 0);
    trk_newmark *stepper;
    const double q0 = 1;
    double q;
    assert_ok(context, trk_newmark_create(context, model, NULL, &stepper));
    memory.refuse_at = 1;
    assert_ok(context, trk_newmark_set_state(stepper, 0, &q0, NULL, NULL, NULL, NULL));
    assert_ok(context, trk_newmark_step(stepper, NULL, NULL, NULL));
    trk_newmark_get_state(stepper, &q, NULL, NULL);
    assert_near(q, cos(2 * atan(10 * 1e-3 / 2)), 1e-15);
    trk_newmark_destroy(stepper);
    trk_model_destroy(model);
    trk_context_destroy(context);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_null, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(test_ranges, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(test_named_methods_are_accepted, support_setup,
                                        support_teardown),
        cmocka_unit_test_setup_teardown(test_newer_options, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(test_state, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(test_starts_in_equilibrium, support_setup,
                                        support_teardown),
        cmocka_unit_test_setup_teardown(test_statistics, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(test_memory, support_setup, support_teardown),
        cmocka_unit_test(test_set_state_without_memory),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
