/* SPDX-License-Identifier: MIT */
/* The resampler's promises: flat passband, 80 dB beyond Nyquist, times, ends. */
#include "support.h"

#include <truckride/series.h>

static const double pi = 3.14159265358979323846;

/* Resample one sine and compare with `expected` times the same sine, away from the ends. */
static double sine_error(trk_context *context, double old_rate, double new_rate, double frequency,
                         double expected)
{
    double slow = fmin(old_rate, new_rate), worst = 0.0;
    int64_t n = (int64_t)(150.0 / slow * old_rate);
    trk_series *series, *other;
    assert_ok(context, trk_series_create(context, 1, n, old_rate, 2.0, &series));
    double *x = trk_series_data_mutable(series, 1);
    for (int64_t k = 0; k < n; k++)
        x[k] = sin(2.0 * pi * frequency * (double)k / old_rate + 0.4);
    assert_ok(context, trk_series_resample(context, series, new_rate, &other));
    const double *y = trk_series_data(other, 1);
    for (int64_t k = 0; k < trk_series_samples(other); k++) {
        double t = (double)k / new_rate;
        if (t > 32.0 / slow && t < 115.0 / slow)
            worst = fmax(worst, fabs(y[k] - expected * sin(2.0 * pi * frequency * t + 0.4)));
    }
    trk_series_destroy(other);
    trk_series_destroy(series);
    return worst;
}

static const double rates[][2] = {{1000.0, 200.0}, {1000.0, 300.0}, {1000.0, 999.0}, {512.0, 500.0},
                                  {200.0, 1000.0}, {300.0, 1000.0}, {999.0, 1000.0}, {1000.0, 7.0}};
enum { RATES = sizeof rates / sizeof *rates };

static void test_passband_is_flat(void **state)
{
    for (int k = 0; k < RATES; k++) {
        double nyquist = 0.5 * fmin(rates[k][0], rates[k][1]);
        for (double f = 0.0; f <= 0.8001; f += 0.1)
            assert_near(sine_error(*state, rates[k][0], rates[k][1], f * nyquist, 1.0), 0.0, 1e-4);
    }
}

static void test_stopband_is_80_db_down(void **state)
{
    for (int k = 0; k < RATES; k++) {
        double nyquist = 0.5 * rates[k][1];
        if (rates[k][1] > rates[k][0])
            continue;
        for (double f = 1.0; f * nyquist < 0.5 * rates[k][0]; f *= 1.07)
            assert_near(sine_error(*state, rates[k][0], rates[k][1], f * nyquist, 0.0), 0.0, 1e-4);
    }
}

static void test_times_and_labels(void **state)
{
    trk_series *series, *other;
    assert_ok(*state, trk_series_create(*state, 2, 11, 10.0, 3.0, &series));
    assert_ok(*state, trk_series_label(series, 2, "seat", "m"));
    for (int k = 0; k < 11; k++)
        trk_series_data_mutable(series, 2)[k] = 5.0;
    const double new_rates[] = {5.0, 4.0, 20.0, 10.0, 0.01, 30.0 / 7.0};
    const int64_t samples[] = {6, 5, 21, 11, 1, 5};
    for (int k = 0; k < 6; k++) {
        assert_ok(*state, trk_series_resample(*state, series, new_rates[k], &other));
        assert_int_equal(trk_series_samples(other), samples[k]);
        assert_true(trk_series_rate(other) == new_rates[k] && trk_series_start(other) == 3.0);
        assert_string_equal(trk_series_name(other, 2), "seat");
        assert_string_equal(trk_series_unit(other, 2), "m");
        for (int64_t j = 0; j < samples[k]; j++)
            assert_near(trk_series_data(other, 2)[j], 5.0, 1e-13); /* constant, ends included */
        trk_series_destroy(other);
    }
    trk_series_destroy(series);
}

static void test_same_rate_copies(void **state)
{
    trk_series *series, *other;
    assert_ok(*state, trk_series_create(*state, 1, 100, 10.0, 0.0, &series));
    for (int k = 0; k < 100; k++)
        trk_series_data_mutable(series, 1)[k] = k % 7;
    assert_ok(*state, trk_series_resample(*state, series, 10.0, &other));
    assert_memory_equal(trk_series_data(other, 1), trk_series_data(series, 1),
                        100 * sizeof(double));
    trk_series_destroy(other);
    trk_series_destroy(series);
}

static void test_errors(void **state)
{
    trk_series *series, *other;
    assert_ok(*state, trk_series_create(*state, 1, 10, 1000.0, 0.0, &series));
    const double bad[] = {0.0, -1.0, NAN, INFINITY, 0.999, 1001000.0, 1000.0 * 3.14159265};
    for (int k = 0; k < 7; k++) {
        assert_status(*state, trk_series_resample(*state, series, bad[k], &other), TRK_E_RANGE);
        assert_null(other);
    }
    assert_message(*state, "no ratio of numbers up to 1000");
    assert_status(*state, trk_series_resample(*state, NULL, 1.0, &other), TRK_E_ARGUMENT);
    assert_status(*state, trk_series_resample(*state, series, 1.0, NULL), TRK_E_ARGUMENT);
    assert_status(NULL, trk_series_resample(NULL, series, 1.0, &other), TRK_E_ARGUMENT);
    trk_series_destroy(series);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_passband_is_flat), cmocka_unit_test(test_stopband_is_80_db_down),
        cmocka_unit_test(test_times_and_labels), cmocka_unit_test(test_same_rate_copies),
        cmocka_unit_test(test_errors),
    };
    return cmocka_run_group_tests(tests, support_setup, support_teardown);
}
