/* SPDX-License-Identifier: MIT */
/* Samples and points: exactness, order, refusals. */
#include "support.h"

#include <truckride/curve.h>
#include <truckride/signal.h>

static double cubic(double x)
{
    return 1.0 + x * (-2.0 + x * (0.5 + x * 0.7));
}

static double cubic_rate(double x)
{
    return -2.0 + x * (1.0 + x * 2.1);
}

static void test_cubic_is_exact_with_and_without_rates(void **state)
{
    double value[9], rate[9];
    for (int k = 0; k < 9; k++) {
        value[k] = cubic(-1.0 + 0.3 * k);
        rate[k] = cubic_rate(-1.0 + 0.3 * k);
    }
    for (int given = 0; given < 2; given++)
        for (int64_t n = given ? 2 : 4; n <= 9; n++) {
            trk_signal *signal;
            assert_ok(*state, trk_signal_create_samples(*state, n, -1.0, 0.3, value,
                                                        given ? rate : NULL, &signal));
            double end = -1.0 + 0.3 * (double)(n - 1);
            for (double x = -1.0; x < end - 1e-9; x += 0.0173) {
                assert_near(trk_signal_value(signal, x), cubic(x), 2e-14);
                assert_near(trk_signal_rate(signal, x), cubic_rate(x), 2e-13);
            }
            trk_signal_destroy(signal);
        }
}

static void test_samples_are_met(void **state)
{
    enum { COUNT = 2000 };
    double value[COUNT], rate[COUNT];
    for (int k = 0; k < COUNT; k++) {
        value[k] = sin(0.1 * k);
        rate[k] = cos(0.3 * k);
    }
    trk_signal *signal;
    assert_ok(*state, trk_signal_create_samples(*state, COUNT, 0.0, 0.001, value, rate, &signal));
    for (int k = 0; k < COUNT - 1; k++) {
        assert_near(trk_signal_value(signal, k * 0.001), value[k], 1e-14);
        assert_near(trk_signal_rate(signal, k * 0.001), rate[k], 1e-8); /* curvature is 1e5 */
    }
    trk_signal_destroy(signal);
}

static void sine_error(trk_context *context, int n, double error[2])
{
    double value[641];
    for (int k = 0; k <= n; k++)
        value[k] = sin(0.5 + 6.0 * k / n);
    trk_signal *signal;
    assert_ok(context,
              trk_signal_create_samples(context, n + 1, 0.5, 6.0 / n, value, NULL, &signal));
    error[0] = error[1] = 0.0;
    for (int k = 0; k < 4999; k++) {
        double x = 0.5 + 6.0 * k / 5000.0;
        error[0] = fmax(error[0], fabs(trk_signal_value(signal, x) - sin(x)));
        error[1] = fmax(error[1], fabs(trk_signal_rate(signal, x) - cos(x)));
    }
    trk_signal_destroy(signal);
}

static void test_order_four_in_value_three_in_rate(void **state)
{
    double coarse[2], fine[2];
    sine_error(*state, 160, coarse);
    sine_error(*state, 640, fine);
    assert_near(log2(coarse[0] / fine[0]) / 2.0, 4.0, 0.1);
    assert_near(log2(coarse[1] / fine[1]) / 2.0, 3.0, 0.1);
}

static void test_samples_agree_with_the_curve(void **state)
{
    double x[30], y[30];
    for (int k = 0; k < 30; k++) {
        x[k] = 2.0 + 0.5 * k;
        y[k] = (k * 7919 % 31) / 10.0;
    }
    trk_curve_options options;
    trk_curve_options_init(&options, sizeof options);
    options.interpolation = TRK_INTERPOLATION_NOT_A_KNOT;
    trk_curve *curve;
    trk_signal *signal;
    assert_ok(*state, trk_curve_create(*state, "same", 30, x, y, &options, &curve));
    assert_ok(*state, trk_signal_create_samples(*state, 30, 2.0, 0.5, y, NULL, &signal));
    for (double at = 2.0; at < 16.5; at += 0.0371) {
        assert_near(trk_signal_value(signal, at), trk_curve_value(curve, at), 1e-13);
        assert_near(trk_signal_rate(signal, at), trk_curve_slope(curve, at), 1e-12);
    }
    trk_signal_destroy(signal);
    trk_curve_destroy(curve);
}

static void test_points_do_not_overshoot(void **state)
{
    double x[] = {0.0, 1.0, 1.2, 2.0, 5.0}, y[] = {0.0, 0.0, 0.1, 0.1, 0.0};
    trk_signal *signal;
    assert_ok(*state, trk_signal_create_points(*state, 5, x, y, &signal));
    for (double at = -1.0; at < 6.0; at += 0.001) {
        double value = trk_signal_value(signal, at);
        assert_true(value >= 0.0 && value <= 0.1);
        if (at < 1.0 || at >= 5.0)
            assert_true(value == 0.0 && trk_signal_rate(signal, at) == 0.0);
    }
    trk_signal_destroy(signal);
}

static void refuse(trk_context *context, trk_status status, trk_signal *const *signal,
                   const char *message)
{
    assert_int_equal(status, TRK_E_RANGE);
    assert_null(*signal);
    assert_message(context, message);
    assert_int_equal(trk_context_blocks(context), 0);
}

static void test_errors(void **state)
{
    trk_context *c = *state;
    trk_signal *s;
    double y[] = {0.0, 1.0, 2.0, 3.0}, bad[] = {0.0, 1.0, NAN, 3.0},
           big[] = {0.0, 1e308, -1e308, 0.0};
    double down[] = {0.0, 1.0, 0.5, 2.0};
    refuse(c, trk_signal_create_samples(c, 3, 0, 1, y, NULL, &s), &s,
           "3 samples without rates, expected at least 4");
    refuse(c, trk_signal_create_samples(c, 1, 0, 1, y, y, &s), &s,
           "1 samples with rates, expected at least 2");
    refuse(c, trk_signal_create_samples(c, 4, NAN, 1, y, y, &s), &s, "start is nan");
    refuse(c, trk_signal_create_samples(c, 4, 0, 0, y, y, &s), &s, "spacing is 0");
    refuse(c, trk_signal_create_samples(c, 4, 0, 1, bad, NULL, &s), &s, "sample 3 is nan");
    refuse(c, trk_signal_create_samples(c, 4, 0, 1, y, bad, &s), &s, "rate 3 is nan");
    refuse(c, trk_signal_create_samples(c, 4, 0, 1, big, NULL, &s), &s, "overflows");
    refuse(c, trk_signal_create_samples(c, 4, 0, 1e-308, y, NULL, &s), &s, "overflows");
    refuse(c, trk_signal_create_points(c, 1, y, y, &s), &s, "1 points");
    refuse(c, trk_signal_create_points(c, 4, down, y, &s), &s,
           "x must increase (point 3: 0.5 after 1)");
    refuse(c, trk_signal_create_points(c, 4, y, bad, &s), &s, "point 3 is (2, nan)");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_cubic_is_exact_with_and_without_rates),
        cmocka_unit_test(test_samples_are_met),
        cmocka_unit_test(test_order_four_in_value_three_in_rate),
        cmocka_unit_test(test_samples_agree_with_the_curve),
        cmocka_unit_test(test_points_do_not_overshoot),
        cmocka_unit_test(test_errors),
    };
    return cmocka_run_group_tests(tests, support_setup, support_teardown);
}
