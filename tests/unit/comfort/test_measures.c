/* SPDX-License-Identifier: MIT */
/* RMS, dose values, ratios and running RMS against closed forms and plain sums. */
#include "support.h"

#include <truckride/comfort.h>

static const double pi = 3.14159265358979323846;

static trk_vibration measure(trk_context *c, int64_t n, const double *x, double rate)
{
    trk_vibration v = {.struct_size = sizeof v};
    assert_ok(c, trk_vibration_measure(c, n, x, rate, &v));
    return v;
}

/* Sine of amplitude A: rms A/sqrt 2, fourth-power mean 3/8 A^4, so VDV / (rms T^1/4) = 1.5^1/4. */
static void sine(void **state)
{
    trk_context *c = *state;
    enum { N = 20000 };
    static double x[N];
    const double a = 3, rate = 500, t = N / rate;
    for (int i = 0; i < N; i++)
        x[i] = a * sin(2 * pi * 5 * i / rate);
    trk_vibration v = measure(c, N, x, rate);
    assert_near(v.duration, t, 0);
    assert_near(v.rms, a / sqrt(2), 1e-14 * a);
    assert_near(v.peak, a, 1e-12);
    assert_near(v.crest_factor, sqrt(2), 1e-12);
    assert_near(v.vdv, a * pow(0.375 * t, 0.25), 1e-13 * v.vdv);
    assert_near(v.evdv, 1.4 * a / sqrt(2) * pow(t, 0.25), 1e-13 * v.evdv);
    assert_near(v.msdv, a / sqrt(2) * sqrt(t), 1e-13 * v.msdv);
    assert_near(v.vdv_ratio, pow(1.5, 0.25), 1e-13);
    assert_near(v.mtvv, a / sqrt(2), 1e-12); /* 1 s is five whole periods */
    assert_near(v.mtvv_ratio, 1, 1e-12);
    /* The square is A^2/2 (1 - cos 2wt); a first-order low-pass lets 1/(2 w tau) of it through. */
    double ripple = 1 / (4 * pi * 5);
    assert_near(v.mtvv_exponential, a / sqrt(2) * sqrt(1 + ripple), 2e-5 * a);
    assert_int_equal(v.additional, 0);
    assert_int_equal(v.reserved, 0);
}

/* One sample of height h in n: everything follows by hand, and all three criteria speak up. */
static void pulse(void **state)
{
    trk_context *c = *state;
    enum { N = 100000 };
    static double x[N];
    const double h = 7, rate = 1000;
    x[N / 2] = -h;
    trk_vibration v = measure(c, N, x, rate);
    assert_near(v.rms, h / sqrt(N), 1e-15);
    assert_near(v.peak, h, 0);
    assert_near(v.crest_factor, sqrt(N), 1e-10);
    assert_near(v.vdv, h * pow(1 / rate, 0.25), 1e-14);
    assert_near(v.mtvv, h / sqrt(rate), 1e-14);
    assert_near(v.mtvv_exponential, h * sqrt(-expm1(-1 / rate)), 1e-14);
    assert_int_equal(v.additional, TRK_ADDITIONAL_CREST | TRK_ADDITIONAL_MTVV | TRK_ADDITIONAL_VDV);
}

/* Square wave: every mean is the height; then a beginning louder by a known factor. */
static void criteria_at_their_limits(void **state)
{
    trk_context *c = *state;
    enum { N = 10000 };
    static double x[N];
    for (int loud = 1; loud <= 2; loud++) { /* one second of 100 by +-1.4, +-1.7 among +-1 */
        double height = loud == 1 ? 1.4 : 1.7;
        for (int i = 0; i < N; i++)
            x[i] = (i % 2 ? -1 : 1) * (i < 100 ? height : 1);
        trk_vibration v = measure(c, N, x, 100);
        assert_near(v.rms, sqrt((99 + height * height) / 100), 1e-13);
        assert_near(v.mtvv, height, 1e-13);
        assert_int_equal(v.additional, loud == 1 ? 0 : TRK_ADDITIONAL_MTVV);
    }
}

static void silence(void **state)
{
    trk_context *c = *state;
    double x[10] = {0};
    trk_vibration v = measure(c, 10, x, 10);
    assert_true(v.rms == 0 && v.vdv == 0 && v.mtvv == 0);
    assert_true(isnan(v.crest_factor) && isnan(v.mtvv_ratio) && isnan(v.vdv_ratio));
    assert_int_equal(v.additional, 0);
}

static void running_rms_is_the_plain_sum(void **state)
{
    trk_context *c = *state;
    enum { N = 700 };
    double x[N], y[N];
    for (int i = 0; i < N; i++)
        x[i] = (i * 7919 % 101 - 50) * (i > 300 && i < 330 ? 1e6 : 1e-3); /* loud, then quiet */
    const double times[] = {0.001, 0.01, 0.37, 1, 6.9, 20};
    for (int k = 0; k < 6; k++) {
        int w = (int)fmax(1, rint(times[k] * 100));
        assert_ok(c, trk_running_rms(c, TRK_AVERAGING_LINEAR, N, x, 100, times[k], y));
        for (int i = 0; i < N; i++) {
            double sum = 0;
            for (int j = i; j > i - w && j >= 0; j--)
                sum += x[j] * x[j];
            assert_near(y[i], sqrt(sum / w), 1e-14 * sqrt(sum / w)); /* no trace of the loud part */
        }
        assert_ok(c, trk_running_rms(c, TRK_AVERAGING_EXPONENTIAL, N, x, 100, times[k], y));
        double alpha = exp(-0.01 / times[k]), mean = 0;
        for (int i = 0; i < N; i++) {
            mean = alpha * mean + (1 - alpha) * x[i] * x[i];
            assert_near(y[i], sqrt(mean), 1e-9 * sqrt(mean));
        }
    }
    assert_ok(c, trk_running_rms(c, TRK_AVERAGING_LINEAR, N, x, 100, 1, x)); /* in place */
}

static void blocks_do_not_matter(void **state)
{
    trk_context *c = *state;
    enum { N = 3000 };
    double x[N];
    for (int i = 0; i < N; i++)
        x[i] = sin(i * 0.1) * cos(i * i * 0.001);
    trk_vibration whole = measure(c, N, x, 130), parts;
    trk_vibration_meter *meter;
    assert_ok(c, trk_vibration_meter_create(c, 130, 1, &meter));
    assert_ok(c, trk_vibration_meter_process(meter, 100, x));
    trk_vibration_meter_reset(meter);
    for (int64_t i = 0, size = 0; i < N; i += size, size = (5 * size + 1) % 400) {
        size = size < N - i ? size : N - i;
        assert_ok(c, trk_vibration_meter_process(meter, size, x + i));
    }
    memset(&parts, 0, sizeof parts);
    parts.struct_size = sizeof parts;
    assert_ok(c, trk_vibration_meter_read(meter, &parts));
    assert_memory_equal(&whole, &parts, sizeof whole);
    trk_vibration_meter_destroy(meter);
}

static void a_long_run_keeps_its_digits(void **state)
{
    trk_context *c = *state;
    enum { BLOCK = 10000 };
    static double x[BLOCK];
    for (int i = 0; i < BLOCK; i++)
        x[i] = 0.1;
    trk_vibration_meter *meter;
    assert_ok(c, trk_vibration_meter_create(c, 1000, 1, &meter));
    for (int k = 0; k < 200; k++)
        assert_ok(c, trk_vibration_meter_process(meter, BLOCK, x));
    trk_vibration v = {.struct_size = sizeof v};
    assert_ok(c, trk_vibration_meter_read(meter, &v));
    assert_near(v.rms, 0.1, 2e-17);
    assert_near(v.vdv, 0.1 * pow(2000, 0.25), 4e-16);
    trk_vibration_meter_destroy(meter);
}

static void largest_samples_stay_finite(void **state)
{
    trk_context *c = *state;
    enum { N = 1000 };
    double x[N];
    for (int i = 0; i < N; i++)
        x[i] = i % 2 ? 1e75 : -1e75;
    trk_vibration v = measure(c, N, x, 100);
    assert_near(v.rms / 1e75, 1, 1e-14);
    assert_near(v.vdv / 1e75, pow(10, 0.25), 1e-14);
    assert_near(v.mtvv / 1e75, 1, 1e-14);
}

static void wrong_arguments(void **state)
{
    trk_context *c = *state;
    double x[3] = {1, NAN, 1}, y[3];
    trk_vibration v = {.struct_size = sizeof v};
    trk_vibration_meter *m = (void *)x;
    assert_status(c, trk_vibration_meter_create(c, 100, 1, NULL), TRK_E_ARGUMENT);
    assert_status(c, trk_vibration_meter_create(NULL, 100, 1, &m), TRK_E_ARGUMENT);
    assert_null(m);
    assert_status(c, trk_vibration_meter_create(c, 0, 1, &m), TRK_E_RANGE);
    assert_message(c, "sample_rate is 0 Hz");
    assert_status(c, trk_vibration_meter_create(c, 100, 0, &m), TRK_E_RANGE);
    assert_message(c, "integration_time is 0");
    assert_status(c, trk_vibration_meter_create(c, 100, 1e8, &m), TRK_E_RANGE);
    assert_message(c, "at most 1e9");
    assert_null(m);
    assert_ok(c, trk_vibration_meter_create(c, 100, 1, &m));
    assert_int_equal(trk_vibration_meter_read(m, &v), TRK_E_RANGE);
    assert_status(c, trk_vibration_meter_process(m, 3, x), TRK_E_RANGE);
    assert_message(c, "x[1] is nan");
    assert_status(c, trk_vibration_meter_process(m, -1, x), TRK_E_RANGE);
    assert_status(c, trk_vibration_meter_process(m, 1, NULL), TRK_E_ARGUMENT);
    assert_status(c, trk_vibration_meter_process(NULL, 1, x), TRK_E_ARGUMENT);
    assert_int_equal(trk_vibration_meter_read(m, &v), TRK_E_RANGE); /* nothing was measured */
    assert_ok(c, trk_vibration_meter_process(m, 1, x));
    assert_int_equal(trk_vibration_meter_read(NULL, &v), TRK_E_ARGUMENT);
    assert_int_equal(trk_vibration_meter_read(m, NULL), TRK_E_ARGUMENT);
    v.struct_size = 0;
    assert_int_equal(trk_vibration_meter_read(m, &v), TRK_E_OPTIONS);
    trk_vibration_meter_destroy(m);
    trk_vibration_meter_destroy(NULL);
    trk_vibration_meter_reset(NULL);
    assert_status(c, trk_vibration_measure(c, 1, x, 100, &v), TRK_E_OPTIONS);
    assert_message(c, "struct_size is 0");
    v.struct_size = sizeof v;
    assert_status(c, trk_vibration_measure(NULL, 1, x, 100, &v), TRK_E_ARGUMENT);
    assert_status(c, trk_vibration_measure(c, 1, NULL, 100, &v), TRK_E_ARGUMENT);
    assert_status(c, trk_vibration_measure(c, 1, x, 100, NULL), TRK_E_ARGUMENT);
    assert_status(c, trk_vibration_measure(c, 0, x, 100, &v), TRK_E_RANGE);
    assert_status(c, trk_vibration_measure(c, 1, x, -1, &v), TRK_E_RANGE);
    assert_status(c, trk_running_rms(NULL, 0, 1, x, 100, 1, y), TRK_E_ARGUMENT);
    assert_status(c, trk_running_rms(c, 0, 1, NULL, 100, 1, y), TRK_E_ARGUMENT);
    assert_status(c, trk_running_rms(c, 0, 1, x, 100, 1, NULL), TRK_E_ARGUMENT);
    assert_status(c, trk_running_rms(c, 2, 1, x, 100, 1, y), TRK_E_ARGUMENT);
    assert_message(c, "averaging is 2");
    assert_status(c, trk_running_rms(c, 0, 3, x, 100, 1, y), TRK_E_RANGE);
    assert_status(c, trk_running_rms(c, 0, -1, x, 100, 1, y), TRK_E_RANGE);
    assert_status(c, trk_running_rms(c, 0, 1, x, NAN, 1, y), TRK_E_RANGE);
    assert_status(c, trk_running_rms(c, 0, 1, x, 100, INFINITY, y), TRK_E_RANGE);
}

static trk_status use_memory(trk_context *c)
{
    double x[5] = {1, 2, 3, 4, 5}, ratio;
    trk_vibration v = {.struct_size = sizeof v};
    trk_status status = trk_vibration_measure(c, 5, x, 500, &v);
    if (status == TRK_OK)
        status = trk_running_rms(c, TRK_AVERAGING_LINEAR, 5, x, 500, 1, x);
    if (status == TRK_OK)
        status = trk_seat_factor(c, TRK_WEIGHTING_WK, 5, x, x, 500, &ratio, NULL);
    return status;
}

static void memory_runs_out(void **state)
{
    (void)state;
    support_exhaust_memory(use_memory);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(sine, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(pulse, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(criteria_at_their_limits, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(silence, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(running_rms_is_the_plain_sum, support_setup,
                                        support_teardown),
        cmocka_unit_test_setup_teardown(blocks_do_not_matter, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(a_long_run_keeps_its_digits, support_setup,
                                        support_teardown),
        cmocka_unit_test_setup_teardown(largest_samples_stay_finite, support_setup,
                                        support_teardown),
        cmocka_unit_test_setup_teardown(wrong_arguments, support_setup, support_teardown),
        cmocka_unit_test(memory_runs_out),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
