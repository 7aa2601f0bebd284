/* SPDX-License-Identifier: MIT */
/* Weighting filters: magnitude at every rate, phase, blocks, levels, agreement with the PSD. */
#include "comfort/design.h"
#include "support.h"

#include <truckride/comfort.h>
#include <truckride/spectrum.h>

static const double pi = 3.14159265358979323846;
static const double rates[] = {200, 201.3, 256, 333, 500, 1000, 2048, 10000, 48000, 1e6};
enum { RATES = sizeof rates / sizeof *rates, WEIGHTINGS = TRK_WEIGHTING_BAND_LOW };

static double *zeros(int64_t count)
{
    double *x = calloc((size_t)count, sizeof *x);
    assert_non_null(x);
    return x;
}

/* Stricter than the 1 % that is asked for; a bilinear transform misses it by two orders. */
static void magnitude_of_the_design(void **state)
{
    trk_context *c = *state;
    for (int r = 0; r < RATES; r++)
        for (trk_weighting w = 1; w <= WEIGHTINGS; w++) {
            trk_design design;
            assert_ok(c, trk_design_weighting(c, trk_weighting_find(w), rates[r], &design));
            double worst = 0, top = 0.4 * rates[r];
            for (int k = 0; k <= 500; k++) {
                double f = 0.01 * pow(top / 0.01, k / 500.0);
                double h = cabs(trk_design_response(&design, 2 * pi * f / rates[r]));
                worst = fmax(worst, fabs(h / trk_weighting_factor(w, f) - 1));
            }
            assert_near(worst, 0, 5e-4);
        }
}

static void output_is_early_by_one_time_for_all_frequencies(void **state)
{
    trk_context *c = *state;
    for (int r = 0; r < RATES; r++)
        for (trk_weighting w = 1; w <= WEIGHTINGS; w++) {
            const trk_weighting_parameters *p = trk_weighting_find(w);
            trk_design design;
            assert_ok(c, trk_design_weighting(c, p, rates[r], &design));
            double early = 0, late = 10;
            for (int k = 1; k <= 100; k++) {
                double f = 0.2 * rates[r] * k / 100, angle = 2 * pi * f / rates[r];
                double lead =
                    carg(trk_design_response(&design, angle) / trk_weighting_analogue(p, f));
                early = fmax(early, lead / angle);
                late = fmin(late, lead / angle);
            }
            assert_true(late > 0.39 && early < (w == TRK_WEIGHTING_WF ? 1.57 : 1.2));
            assert_true(early - late < 0.05);
        }
}

/* Response of the running filter: DTFT of its impulse response by a turning phasor. */
static void magnitude_of_the_running_filter(void **state)
{
    trk_context *c = *state;
    const double tried[] = {200, 256, 333, 500, 1000, 2048, 10000};
    for (int r = 0; r < 7; r++)
        for (trk_weighting w = 1; w <= WEIGHTINGS; w++) {
            bool slow = w == TRK_WEIGHTING_WF || w == TRK_WEIGHTING_BAND_LOW;
            int64_t n = (int64_t)((slow ? 130 : 30) * tried[r]);
            double *h = zeros(n), worst = 0;
            h[0] = 1;
            assert_ok(c, trk_weighting_apply(c, w, n, h, tried[r], h));
            for (int k = 0; k < 8; k++) {
                double f = 0.1 * pow(800, k / 7.0), re = 0, im = 0, cosine = 1, sine = 0;
                double dc = cos(2 * pi * f / tried[r]), ds = sin(2 * pi * f / tried[r]);
                for (int64_t i = 0; i < n; i++) {
                    re += h[i] * cosine;
                    im += h[i] * sine;
                    double next = cosine * dc - sine * ds;
                    sine = cosine * ds + sine * dc;
                    cosine = next;
                }
                worst = fmax(worst, fabs(hypot(re, im) / trk_weighting_factor(w, f) - 1));
            }
            assert_near(worst, 0, 5e-4);
            free(h);
        }
}

/* A steady sine after the transient: RMS over whole periods. */
static void steady_sine(void **state)
{
    trk_context *c = *state;
    const double rate = 256, f[] = {0.5, 2, 8, 32, 80};
    for (int k = 0; k < 5; k++) {
        int64_t n = 256 * 30;
        double *x = zeros(n), sum = 0;
        for (int64_t i = 0; i < n; i++)
            x[i] = sqrt(2) * sin(2 * pi * f[k] * (double)i / rate);
        assert_ok(c, trk_weighting_apply(c, TRK_WEIGHTING_WK, n, x, rate, x));
        for (int64_t i = n - 256 * 4; i < n; i++)
            sum += x[i] * x[i];
        double factor = trk_weighting_factor(TRK_WEIGHTING_WK, f[k]);
        assert_near(sqrt(sum / (256 * 4)), factor, 5e-4 * factor);
        free(x);
    }
}

static double noise(uint64_t *seed)
{
    *seed = *seed * 6364136223846793005u + 1442695040888963407u;
    return (double)(int64_t)*seed / 9.3e18;
}

static void blocks_do_not_matter(void **state)
{
    trk_context *c = *state;
    enum { N = 5000 };
    static double x[N], whole[N], parts[N];
    uint64_t seed = 1;
    for (int i = 0; i < N; i++)
        x[i] = noise(&seed);
    for (trk_weighting w = 1; w <= WEIGHTINGS; w++) {
        assert_ok(c, trk_weighting_apply(c, w, N, x, 300, whole));
        trk_weighting_filter *filter;
        assert_ok(c, trk_weighting_filter_create(c, w, 300, &filter));
        for (int64_t i = 0, size = 0; i < N; i += size, size = (7 * size + 1) % 1100) {
            size = size < N - i ? size : N - i;
            assert_ok(c, trk_weighting_filter_process(filter, size, x + i, parts + i));
        }
        assert_memory_equal(whole, parts, sizeof whole);
        memcpy(parts, x, sizeof parts);
        trk_weighting_filter_reset(filter, 0);
        assert_ok(c, trk_weighting_filter_process(filter, N, parts, parts));
        assert_memory_equal(whole, parts, sizeof whole);
        trk_weighting_filter_destroy(filter);
    }
}

static void a_level_makes_no_transient(void **state)
{
    trk_context *c = *state;
    double x[400];
    for (int r = 0; r < RATES; r++)
        for (trk_weighting w = 1; w <= WEIGHTINGS; w++) {
            trk_weighting_filter *filter;
            assert_ok(c, trk_weighting_filter_create(c, w, rates[r], &filter));
            trk_weighting_filter_reset(filter, 9.81);
            double worst = 0;
            for (int block = 0; block < 20; block++) {
                for (int i = 0; i < 400; i++)
                    x[i] = 9.81;
                assert_ok(c, trk_weighting_filter_process(filter, 400, x, x));
                for (int i = 0; i < 400; i++)
                    worst = fmax(worst, fabs(x[i]));
            }
            assert_near(worst, 0, 1e-9);
            trk_weighting_filter_destroy(filter);
        }
}

/* 0.08 Hz at 10 kHz for an hour: neither growth nor loss of the small signal on the offset. */
static void low_frequency_at_a_high_rate(void **state)
{
    trk_context *c = *state;
    const double rate = 10000, f = 0.2;
    enum { BLOCK = 10000 };
    static double x[BLOCK];
    trk_weighting_filter *filter;
    assert_ok(c, trk_weighting_filter_create(c, TRK_WEIGHTING_WF, rate, &filter));
    trk_weighting_filter_reset(filter, 9.81);
    double sum = 0;
    const int seconds = 400, last = 100;
    for (int s = 0; s < seconds; s++) {
        for (int i = 0; i < BLOCK; i++)
            x[i] = 9.81 + 0.01 * sqrt(2) * sin(2 * pi * f * (s + i / rate));
        assert_ok(c, trk_weighting_filter_process(filter, BLOCK, x, x));
        for (int i = 0; s >= seconds - last && i < BLOCK; i++)
            sum += x[i] * x[i];
    }
    double factor = 0.01 * trk_weighting_factor(TRK_WEIGHTING_WF, f);
    assert_near(sqrt(sum / (last * rate)), factor, 5e-4 * factor);
    trk_weighting_filter_destroy(filter);
}

/* Periodic noise in steady state: the RMS of the filter is that of the weighted periodogram. */
static void time_and_frequency_agree(void **state)
{
    trk_context *c = *state;
    enum { N = 8192, HALF = N / 2 + 1 };
    static double x[2 * N], y[2 * N], density[HALF];
    const double rate = 250;
    for (int k = 1; k < (int)(0.4 * N); k++) { /* phases of Schroeder: low crest factor */
        double phase = -pi * k * k / (0.4 * N), dc = cos(2 * pi * k / N), ds = sin(2 * pi * k / N);
        double cosine = cos(phase), sine = sin(phase);
        for (int i = 0; i < N; i++) {
            x[i] += cosine / sqrt(N);
            double next = cosine * dc - sine * ds;
            sine = cosine * ds + sine * dc;
            cosine = next;
        }
    }
    memcpy(x + N, x, N * sizeof *x);
    trk_spectrum_options o;
    trk_spectrum_options_init(&o, sizeof o);
    o.segment_length = N;
    o.window = TRK_WINDOW_RECTANGULAR;
    o.detrend = TRK_DETREND_NONE;
    for (trk_weighting w = 1; w <= WEIGHTINGS; w++) {
        double rms, sum = 0;
        assert_ok(c, trk_psd(c, N, x, rate, &o, density));
        assert_ok(c, trk_psd_weight(c, w, HALF, density, rate / N, density));
        assert_ok(c, trk_band_rms(c, HALF, density, rate / N, 0, rate, &rms));
        assert_ok(c, trk_weighting_apply(c, w, 2 * N, x, rate, y));
        for (int i = N; i < 2 * N; i++)
            sum += y[i] * y[i];
        assert_near(sqrt(sum / N), rms, 4e-4 * rms);
    }
}

static void wrong_arguments(void **state)
{
    trk_context *c = *state;
    double x[3] = {1, 2, 3}, y[3] = {7, 7, 7};
    trk_weighting_filter *f = (void *)&x;
    assert_status(c, trk_weighting_filter_create(c, TRK_WEIGHTING_WK, 500, NULL), TRK_E_ARGUMENT);
    assert_status(c, trk_weighting_filter_create(NULL, TRK_WEIGHTING_WK, 500, &f), TRK_E_ARGUMENT);
    assert_null(f);
    assert_status(c, trk_weighting_filter_create(c, 0, 500, &f), TRK_E_ARGUMENT);
    assert_message(c, "weighting is 0");
    const double bad[] = {199.99, 0, -1, 1.1e6, NAN, INFINITY};
    for (int k = 0; k < 6; k++) {
        assert_status(c, trk_weighting_filter_create(c, TRK_WEIGHTING_WK, bad[k], &f), TRK_E_RANGE);
        assert_message(c, "expected 200 to 1e+06; below, weight the PSD");
        assert_null(f);
    }
    assert_ok(c, trk_weighting_filter_create(c, TRK_WEIGHTING_WK, 500, &f));
    assert_status(c, trk_weighting_filter_process(NULL, 1, x, y), TRK_E_ARGUMENT);
    assert_status(c, trk_weighting_filter_process(f, 1, NULL, y), TRK_E_ARGUMENT);
    assert_status(c, trk_weighting_filter_process(f, 1, x, NULL), TRK_E_ARGUMENT);
    assert_status(c, trk_weighting_filter_process(f, -1, x, y), TRK_E_RANGE);
    x[2] = NAN;
    assert_status(c, trk_weighting_filter_process(f, 3, x, y), TRK_E_RANGE);
    assert_message(c, "x[2] is nan");
    x[2] = 1e76;
    assert_status(c, trk_weighting_filter_process(f, 3, x, y), TRK_E_RANGE);
    assert_true(y[0] == 7);
    x[2] = 0;
    x[0] = x[1] = 0;
    assert_ok(c, trk_weighting_filter_process(f, 3, x, y)); /* the refused blocks left no trace */
    assert_true(y[0] == 0 && y[1] == 0 && y[2] == 0);
    trk_weighting_filter_reset(NULL, 0);
    trk_weighting_filter_reset(f, NAN);
    assert_ok(c, trk_weighting_filter_process(f, 3, x, y));
    assert_true(y[2] == 0);
    trk_weighting_filter_destroy(f);
    trk_weighting_filter_destroy(NULL);
    assert_status(c, trk_weighting_apply(NULL, TRK_WEIGHTING_WK, 3, x, 500, y), TRK_E_ARGUMENT);
    assert_status(c, trk_weighting_apply(c, TRK_WEIGHTING_WK, 3, NULL, 500, y), TRK_E_ARGUMENT);
    assert_status(c, trk_weighting_apply(c, TRK_WEIGHTING_WK, 3, x, 500, NULL), TRK_E_ARGUMENT);
    assert_status(c, trk_weighting_apply(c, TRK_WEIGHTING_WK, 3, x, 100, y), TRK_E_RANGE);
    assert_status(c, trk_weighting_apply(c, TRK_WEIGHTING_WK, -3, x, 500, y), TRK_E_RANGE);
}

static void largest_samples_stay_finite(void **state)
{
    trk_context *c = *state;
    enum { N = 2000 };
    static double x[N];
    for (trk_weighting w = 1; w <= WEIGHTINGS; w++) {
        for (int i = 0; i < N; i++)
            x[i] = i % 100 < 50 ? 1e75 : -1e75;
        assert_ok(c, trk_weighting_apply(c, w, N, x, 1e6, x));
        for (int i = 0; i < N; i++)
            assert_true(isfinite(x[i]));
    }
}

static trk_status use_memory(trk_context *c)
{
    double x[5] = {1, 2, 3, 4, 5};
    return trk_weighting_apply(c, TRK_WEIGHTING_WK, 5, x, 500, x);
}

static void memory_runs_out(void **state)
{
    (void)state;
    support_exhaust_memory(use_memory);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(magnitude_of_the_design, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(output_is_early_by_one_time_for_all_frequencies,
                                        support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(magnitude_of_the_running_filter, support_setup,
                                        support_teardown),
        cmocka_unit_test_setup_teardown(steady_sine, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(blocks_do_not_matter, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(a_level_makes_no_transient, support_setup,
                                        support_teardown),
        cmocka_unit_test_setup_teardown(low_frequency_at_a_high_rate, support_setup,
                                        support_teardown),
        cmocka_unit_test_setup_teardown(time_and_frequency_agree, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(wrong_arguments, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(largest_samples_stay_finite, support_setup,
                                        support_teardown),
        cmocka_unit_test(memory_runs_out),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
