/* SPDX-License-Identifier: MIT */
/* Step, sine and sweep against their formulas. */
#include "support.h"

#include <truckride/signal.h>

#include "signal/turn.h"

static const double pi = 3.14159265358979323846;

static void test_step(void **state)
{
    trk_signal *signal;
    assert_ok(*state, trk_signal_create_step(*state, 1.0, 0.5, 0.01, &signal));
    const double x[] = {0.0, 1.0, 1.125, 1.25, 1.375, 1.5, 9.0};
    const double s[] = {0.0, 0.0, 0.15625, 0.5, 0.84375, 1.0, 1.0};
    const double r[] = {0.0, 0.0, 1.125, 1.5, 1.125, 0.0, 0.0};
    for (int k = 0; k < 7; k++) {
        assert_near(trk_signal_value(signal, x[k]), 0.01 * s[k], 1e-18);
        assert_near(trk_signal_rate(signal, x[k]), 0.02 * r[k], 1e-17);
    }
    trk_signal_destroy(signal);
}

static void test_turn_against_the_math_library(void **state)
{
    (void)state;
    for (int k = -50000; k <= 50000; k++) {
        double r = k / 100000.0, sine, cosine;
        trk_turn_sincos(r, &sine, &cosine);
        assert_near(sine, sin(2.0 * pi * r), 5e-16);
        assert_near(cosine, cos(2.0 * pi * r), 5e-16);
    }
    assert_true(trk_turn_fraction(-7.25) == -0.25);
    assert_true(fabs(trk_turn_fraction(0x1p50 + 0.5)) == 0.5);
    assert_true(trk_turn_fraction(1e300) == 0.0);
    assert_true(isnan(trk_turn_fraction(NAN)) && isnan(trk_turn_fraction(INFINITY)));
}

static void test_sine(void **state)
{
    trk_signal *signal;
    for (double phase = -20.0; phase <= 20.0; phase += 0.7) {
        assert_ok(*state, trk_signal_create_sine(*state, 0.01, 1.7, phase, 2.0, &signal));
        assert_true(trk_signal_value(signal, 1.999) == 0.0 &&
                    trk_signal_rate(signal, 1.999) == 0.0);
        for (double x = 2.0; x < 30.0; x += 0.37) {
            double angle = 2.0 * pi * 1.7 * (x - 2.0) + phase;
            assert_near(trk_signal_value(signal, x), 0.01 * sin(angle), 1e-15);
            assert_near(trk_signal_rate(signal, x), 0.01 * 2.0 * pi * 1.7 * cos(angle), 1e-14);
        }
        trk_signal_destroy(signal);
    }
    assert_ok(*state, trk_signal_create_sine(*state, 1.0, 2.0, 0.0, 0.0, &signal));
    assert_near(trk_signal_value(signal, 1e6 + 0.125), 1.0, 1e-15); /* 2 million turns later */
    assert_near(trk_signal_rate(signal, 1e6), 4.0 * pi, 1e-14);
    trk_signal_destroy(signal);
}

/* Largest error of a sweep's value and rate over the amplitude and the largest rate, against
 * the formula SIGNAL.3a in long double. */
static double sweep_error(trk_context *context, const trk_sweep_options *o)
{
    trk_signal *signal;
    assert_ok(context, trk_signal_create_sweep(context, o, &signal));
    long double growth = logl((long double)o->end_frequency / o->start_frequency) / o->duration;
    double worst = 0.0;
    for (int k = 0; k < 20000; k++) {
        double t = o->duration * (k / 20000.0), x = o->start + t;
        t = x - o->start;
        long double f = o->start_frequency * expl(growth * t),
                    a = o->amplitude * powl(f, -o->amplitude_exponent);
        long double turns = o->start_frequency / growth * expm1l(growth * t);
        long double angle =
            2.0L * 3.14159265358979323846264338L * (turns - rintl(turns)) + o->phase;
        long double w = 2.0L * 3.14159265358979323846264338L * f;
        long double rate = a * (w * cosl(angle) - o->amplitude_exponent * growth * sinl(angle));
        worst =
            fmax(worst, fabs(trk_signal_value(signal, x) - (double)(a * sinl(angle))) / (double)a);
        worst = fmax(worst, fabs(trk_signal_rate(signal, x) - (double)rate) / (double)(a * w));
    }
    trk_signal_destroy(signal);
    return worst;
}

static void test_sweep_against_its_formula(void **state)
{
    trk_sweep_options o;
    trk_sweep_options_init(&o, sizeof o);
    assert_near(sweep_error(*state, &o), 0.0, 1e-11); /* 2,863 turns */
    o.phase = 1.0;
    o.start = 3.0;
    o.amplitude_exponent = -10.0;
    assert_near(sweep_error(*state, &o), 0.0, 1e-11);
    o.amplitude_exponent = 0.0;
    o.start_frequency = 50.0; /* downwards */
    o.end_frequency = 0.1;
    o.duration = 10.0;
    assert_near(sweep_error(*state, &o), 0.0, 1e-12);
    o.end_frequency = 50.000001; /* nearly a sine */
    assert_near(sweep_error(*state, &o), 0.0, 1e-11);
}

/* Frequency from the times of upward zero crossings next to a given time. */
static double crossing_frequency(const trk_signal *signal, double time)
{
    double crossing[2];
    for (int n = 0; n < 2; time = crossing[n] + 1e-3, n++) {
        while (
            !(trk_signal_value(signal, time) < 0.0 && trk_signal_value(signal, time + 1e-3) >= 0.0))
            time += 1e-3;
        double low = time, high = time + 1e-3;
        while (high - low > 1e-12) {
            double middle = 0.5 * (low + high);
            *(trk_signal_value(signal, middle) < 0.0 ? &low : &high) = middle;
        }
        crossing[n] = low;
    }
    return 1.0 / (crossing[1] - crossing[0]);
}

static void test_sweep_frequency_and_amplitude(void **state)
{
    trk_signal *signal;
    assert_ok(*state, trk_signal_create_sweep(*state, NULL, &signal));
    /* The period found spans one turn after the time asked for: right to growth / f. */
    const double times[] = {0.0, 120.0, 240.0, 360.0, 478.0};
    for (int k = 0; k < 5; k++) {
        double f = 0.8 * pow(25.0, times[k] / 480.0);
        assert_near(crossing_frequency(signal, times[k]) / f, 1.0, 0.015);
        double peak = 0.0;
        for (double x = times[k]; x < times[k] + 1.0 / f; x += 1e-3 / f)
            peak = fmax(peak, fabs(trk_signal_value(signal, x)));
        assert_near(peak * f, 0.001, 0.001 * 0.015);
    }
    assert_true(trk_signal_value(signal, -1e-9) == 0.0);
    assert_true(trk_signal_value(signal, 0.0) == 0.0);
    assert_near(trk_signal_rate(signal, 0.0), 0.001 * 2.0 * pi, 1e-15);
    trk_signal_destroy(signal);
}

static void refuse(trk_context *context, trk_status status, trk_status wanted,
                   trk_signal *const *signal, const char *message)
{
    assert_int_equal(status, wanted);
    assert_null(*signal);
    assert_message(context, message);
    assert_int_equal(trk_context_blocks(context), 0);
}

static void test_errors(void **state)
{
    trk_context *c = *state;
    trk_signal *s;
    refuse(c, trk_signal_create_step(c, NAN, 1, 1, &s), TRK_E_RANGE, &s, "step: start is nan");
    refuse(c, trk_signal_create_step(c, 0, 0, 1, &s), TRK_E_RANGE, &s,
           "step: length is 0, expected");
    refuse(c, trk_signal_create_step(c, 0, 1, INFINITY, &s), TRK_E_RANGE, &s,
           "step: height is inf");
    refuse(c, trk_signal_create_step(c, 0, 1e-200, 1e200, &s), TRK_E_RANGE, &s, "overflows");
    refuse(c, trk_signal_create_sine(c, NAN, 1, 0, 0, &s), TRK_E_RANGE, &s,
           "sine: amplitude is nan");
    refuse(c, trk_signal_create_sine(c, 1, -1, 0, 0, &s), TRK_E_RANGE, &s, "sine: frequency is -1");
    refuse(c, trk_signal_create_sine(c, 1, 1, NAN, 0, &s), TRK_E_RANGE, &s, "sine: phase is nan");
    refuse(c, trk_signal_create_sine(c, 1, 1, 0, NAN, &s), TRK_E_RANGE, &s, "sine: start is nan");
    refuse(c, trk_signal_create_sine(c, 1e200, 1e200, 0, 0, &s), TRK_E_RANGE, &s, "overflows");
}

static void refuse_sweep(trk_context *context, size_t field, double value, const char *message)
{
    trk_sweep_options o;
    trk_signal *signal;
    trk_sweep_options_init(&o, sizeof o);
    memcpy((char *)&o + field, &value, sizeof value);
    refuse(context, trk_signal_create_sweep(context, &o, &signal), TRK_E_RANGE, &signal, message);
}

static void test_sweep_errors(void **state)
{
    refuse_sweep(*state, offsetof(trk_sweep_options, start_frequency), 0.0, "start_frequency is 0");
    refuse_sweep(*state, offsetof(trk_sweep_options, end_frequency), NAN, "end_frequency is nan");
    refuse_sweep(*state, offsetof(trk_sweep_options, end_frequency), 0.8, "are both 0.8");
    refuse_sweep(*state, offsetof(trk_sweep_options, duration), -1.0, "duration is -1");
    refuse_sweep(*state, offsetof(trk_sweep_options, amplitude), INFINITY, "amplitude is inf");
    refuse_sweep(*state, offsetof(trk_sweep_options, amplitude_exponent), 11.0,
                 "amplitude_exponent is 11");
    refuse_sweep(*state, offsetof(trk_sweep_options, phase), NAN, "phase is nan");
    refuse_sweep(*state, offsetof(trk_sweep_options, start), NAN, "start is nan");
    refuse_sweep(*state, offsetof(trk_sweep_options, duration), 1e-310, "overflows");
    refuse_sweep(*state, offsetof(trk_sweep_options, duration), 1e308, "overflows");
    refuse_sweep(*state, offsetof(trk_sweep_options, amplitude), 1e308, "overflows");
    struct {
        trk_sweep_options known;
        double later;
    } newer;
    trk_signal *signal;
    trk_sweep_options_init(&newer.known, sizeof newer);
    newer.later = 1.0;
    refuse(*state, trk_signal_create_sweep(*state, &newer.known, &signal), TRK_E_OPTIONS, &signal,
           "trk_sweep_options");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_step),
        cmocka_unit_test(test_turn_against_the_math_library),
        cmocka_unit_test(test_sine),
        cmocka_unit_test(test_sweep_against_its_formula),
        cmocka_unit_test(test_sweep_frequency_and_amplitude),
        cmocka_unit_test(test_errors),
        cmocka_unit_test(test_sweep_errors),
    };
    return cmocka_run_group_tests(tests, support_setup, support_teardown);
}
