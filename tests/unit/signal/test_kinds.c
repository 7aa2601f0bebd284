/* SPDX-License-Identifier: MIT */
/* What holds for every kind: rate is the derivative, evaluate() equals value() and rate(), ends. */
#include "support.h"

#include <truckride/signal.h>

enum { KINDS = 6, SAMPLES = 41 };

/* Each kind over about 0 to 10 s, with no corner but at its ends. */
static trk_signal *new_kind(trk_context *context, int kind)
{
    static const double x[] = {0.0, 1.0, 2.5, 4.0, 7.0, 10.0},
                        y[] = {0.0, 0.5, 0.2, 0.2, 1.0, -1.0};
    double value[SAMPLES], rate[SAMPLES];
    for (int k = 0; k < SAMPLES; k++) {
        value[k] = sin(0.25 * k);
        rate[k] = 1.1 * cos(0.25 * k); /* not the derivative: Hermite must take any */
    }
    trk_sweep_options sweep;
    trk_sweep_options_init(&sweep, sizeof sweep);
    sweep.duration = 10.0;
    sweep.amplitude_exponent = 1.5;
    sweep.phase = 0.3;
    trk_signal *signal = NULL;
    switch (kind) {
    case 0: assert_ok(context, trk_signal_create_step(context, 0.0, 10.0, 2.0, &signal)); break;
    case 1: assert_ok(context, trk_signal_create_sine(context, 2.0, 0.7, 0.4, 0.0, &signal)); break;
    case 2: assert_ok(context, trk_signal_create_sweep(context, &sweep, &signal)); break;
    case 3:
        assert_ok(context,
                  trk_signal_create_samples(context, SAMPLES, 0.0, 0.25, value, NULL, &signal));
        break;
    case 4:
        assert_ok(context,
                  trk_signal_create_samples(context, SAMPLES, 0.0, 0.25, value, rate, &signal));
        break;
    default: assert_ok(context, trk_signal_create_points(context, 6, x, y, &signal)); break;
    }
    return signal;
}

static void test_rate_is_the_derivative(void **state)
{
    for (int kind = 0; kind < KINDS; kind++) {
        trk_signal *signal = new_kind(*state, kind);
        const double h = 1e-5;
        for (double x = 0.013; x < 10.0; x += 0.0371) {
            double difference =
                (trk_signal_value(signal, x + h) - trk_signal_value(signal, x - h)) / (2 * h);
            assert_near(trk_signal_rate(signal, x), difference, 2e-7 * (1.0 + fabs(difference)));
        }
        trk_signal_destroy(signal);
    }
}

static void test_evaluate_equals_single_calls(void **state)
{
    enum { COUNT = 1000 };
    const double starts[] = {-1.0, 11.0, 5.0}, spacings[] = {0.013, -0.013, 0.0};
    double value[COUNT], rate[COUNT], only[COUNT];
    for (int kind = 0; kind < KINDS; kind++) {
        trk_signal *signal = new_kind(*state, kind);
        for (int j = 0; j < 3; j++) {
            trk_signal_evaluate(signal, COUNT, starts[j], spacings[j], value, rate);
            for (int k = 0; k < COUNT; k++) {
                double x = starts[j] + k * spacings[j];
                assert_true(value[k] == trk_signal_value(signal, x));
                assert_true(rate[k] == trk_signal_rate(signal, x));
            }
            trk_signal_evaluate(signal, COUNT, starts[j], spacings[j], only, NULL);
            assert_memory_equal(only, value, sizeof only);
            trk_signal_evaluate(signal, COUNT, starts[j], spacings[j], NULL, only);
            assert_memory_equal(only, rate, sizeof only);
        }
        trk_signal_evaluate(signal, 0, 0.0, 0.0, NULL, NULL);
        trk_signal_destroy(signal);
    }
}

static void test_ends_are_held(void **state)
{
    const double far[] = {10.0, 10.5, 1e6, 1e300, INFINITY};
    for (int kind = 0; kind < KINDS; kind++) {
        trk_signal *signal = new_kind(*state, kind);
        for (int k = 0; k < 5; k++) {
            if (kind != 1) { /* a sine does not end */
                double end = trk_signal_value(signal, nextafter(10.0, 0.0));
                assert_near(trk_signal_value(signal, far[k]), end, 1e-12);
                assert_true(trk_signal_rate(signal, far[k]) == 0.0);
            }
            double before = kind < 3 ? 0.0 : trk_signal_value(signal, 0.0);
            assert_true(trk_signal_value(signal, 9.99 - far[k]) == before || k == 0);
            assert_true(trk_signal_rate(signal, 9.99 - far[k]) == 0.0 || k == 0);
        }
        trk_signal_destroy(signal);
    }
}

static void test_nan_gives_nan(void **state)
{
    for (int kind = 0; kind < KINDS; kind++) {
        trk_signal *signal = new_kind(*state, kind);
        assert_true(isnan(trk_signal_value(signal, NAN)));
        assert_true(isnan(trk_signal_rate(signal, NAN)));
        trk_signal_destroy(signal);
    }
}

static trk_status create(trk_context *context, int kind, trk_signal **signal)
{
    double y[] = {0.0, 1.0, 0.0, 2.0, 3.0}, x[] = {0.0, 1.0, 2.0, 4.0, 8.0};
    switch (kind) {
    case 0: return trk_signal_create_step(context, 0.0, 1.0, 1.0, signal);
    case 1: return trk_signal_create_sine(context, 1.0, 1.0, 0.0, 0.0, signal);
    case 2: return trk_signal_create_sweep(context, NULL, signal);
    case 3: return trk_signal_create_samples(context, 5, 0.0, 1.0, y, NULL, signal);
    case 4: return trk_signal_create_samples(context, 5, 0.0, 1.0, y, y, signal);
    default: return trk_signal_create_points(context, 5, x, y, signal);
    }
}

static trk_status create_all(trk_context *context)
{
    for (int kind = 0; kind < KINDS; kind++) {
        trk_signal *signal = NULL;
        trk_status status = create(context, kind, &signal);
        if (status) {
            assert_null(signal);
            return status;
        }
        trk_signal_destroy(signal);
    }
    return TRK_OK;
}

static void test_out_of_memory(void **state)
{
    (void)state;
    support_exhaust_memory(create_all);
}

static void test_null_pointers(void **state)
{
    double y[] = {0.0, 1.0, 0.0, 2.0};
    trk_signal *signal;
    for (int kind = 0; kind < KINDS; kind++) {
        assert_status(*state, create(*state, kind, NULL), TRK_E_ARGUMENT);
        assert_message(*state, "out_signal is NULL");
        signal = (trk_signal *)y;
        assert_status(NULL, create(NULL, kind, &signal), TRK_E_ARGUMENT);
        assert_null(signal);
    }
    assert_status(*state, trk_signal_create_samples(*state, 4, 0.0, 1.0, NULL, y, &signal),
                  TRK_E_ARGUMENT);
    assert_status(*state, trk_signal_create_points(*state, 4, NULL, y, &signal), TRK_E_ARGUMENT);
    assert_status(*state, trk_signal_create_points(*state, 4, y, NULL, &signal), TRK_E_ARGUMENT);
    assert_message(*state, "values is NULL");
    trk_signal_destroy(NULL);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_rate_is_the_derivative),
        cmocka_unit_test(test_evaluate_equals_single_calls),
        cmocka_unit_test(test_ends_are_held),
        cmocka_unit_test(test_nan_gives_nan),
        cmocka_unit_test(test_out_of_memory),
        cmocka_unit_test(test_null_pointers),
    };
    return cmocka_run_group_tests(tests, support_setup, support_teardown);
}
