/* SPDX-License-Identifier: MIT */
/* PSD, cross spectrum, coherence and H1 of signals whose spectra are known. */
#include "support.h"

#include <truckride/spectrum.h>

enum { N = 20000, BINS = 513 };
static const double pi = 3.14159265358979323846;
static const double rate = 500.0;

static trk_spectrum_options options(int64_t segment_length, trk_window window)
{
    trk_spectrum_options o;
    trk_spectrum_options_init(&o, sizeof o);
    o.segment_length = segment_length;
    o.window = window;
    return o;
}

/* White noise, uniform with variance 1. */
static void make_noise(int64_t n, uint64_t seed, double *x)
{
    for (int64_t i = 0; i < n; i++) {
        seed = seed * 6364136223846793005u + 1442695040888963407u;
        x[i] = sqrt(12.0) * ((double)(seed >> 11) / 9007199254740992.0 - 0.5);
    }
}

/* A sine on a bin: height A^2 / 2 in every window, side lobes limited to the main lobe. */
static void sine_has_its_power(void **state)
{
    static const int main_lobe[] = {2, 1, 2, 3, 4, 5}; /* bins to the first zero */
    static double x[N], p[BINS];
    for (int64_t i = 0; i < N; i++)
        x[i] = 3.0 * sin(2 * pi * 100.0 / 1024.0 * (double)i + 0.4);
    for (trk_window window = TRK_WINDOW_HANN; window <= TRK_WINDOW_KAISER; window++) {
        trk_spectrum_options o = options(1024, window);
        o.scaling = TRK_SCALING_SPECTRUM;
        assert_ok(*state, trk_psd(*state, N, x, rate, &o, p));
        assert_near(p[100], 4.5, window == TRK_WINDOW_KAISER ? 1e-4 : 1e-9);
        for (int k = 0; k < BINS && window != TRK_WINDOW_KAISER; k++)
            if (abs(k - 100) >= main_lobe[window])
                assert_near(p[k], 0, 1e-12);
        o.scaling = TRK_SCALING_DENSITY;
        double rms = 0;
        assert_ok(*state, trk_psd(*state, N, x, rate, &o, p));
        assert_ok(*state, trk_band_rms(*state, BINS, p, rate / 1024, 0, rate, &rms));
        assert_near(rms * rms, 4.5, 1e-4);
    }
}

/* Half-way between two bins: scalloping by the closed form of each window's spectrum. */
static void leakage_is_that_of_the_window(void **state)
{
    static double x[N], p[BINS];
    for (int64_t i = 0; i < N; i++)
        x[i] = sqrt(2.0) * sin(2 * pi * 100.5 / 1024.0 * (double)i);
    const struct {
        trk_window window;
        double loss, far;
    } expected[] = {
        {TRK_WINDOW_RECTANGULAR, 3.92, 50},     {TRK_WINDOW_HANN, 1.42, 120},
        {TRK_WINDOW_HAMMING, 1.75, 55},         {TRK_WINDOW_BLACKMAN, 1.10, 120},
        {TRK_WINDOW_BLACKMAN_HARRIS, 0.83, 92}, {TRK_WINDOW_FLAT_TOP, 0.01, 88},
    };
    for (size_t i = 0; i < sizeof expected / sizeof *expected; i++) {
        trk_spectrum_options o = options(1024, expected[i].window);
        o.scaling = TRK_SCALING_SPECTRUM;
        assert_ok(*state, trk_psd(*state, N, x, rate, &o, p));
        assert_near(-10 * log10(p[100]), expected[i].loss, 0.011);
        assert_true(-10 * log10(p[300]) > expected[i].far);
    }
}

/* Variance 1 spread from 0 to rate / 2: density 2 / rate; 78 averages, 512 bins. */
static void white_noise_has_its_level(void **state)
{
    static double x[4 * N], p[BINS];
    make_noise(4 * N, 5, x);
    for (trk_window window = TRK_WINDOW_HANN; window <= TRK_WINDOW_KAISER; window++) {
        trk_spectrum_options o = options(1024, window);
        assert_ok(*state, trk_psd(*state, 4 * N, x, rate, &o, p));
        double mean = 0;
        for (int k = 5; k < BINS - 5; k++)
            mean += p[k] / (BINS - 10);
        assert_near(mean * rate / 2, 1, 0.02);
    }
}

/* Parseval: without a window and overlap the area is the mean square, odd and even. */
static void area_is_the_mean_square(void **state)
{
    static double x[N], p[BINS];
    make_noise(N, 9, x);
    for (int64_t segment = 1; segment <= 1024; segment = segment * 3 / 2 + 1) {
        trk_spectrum_options o = options(segment, TRK_WINDOW_RECTANGULAR);
        o.overlap = 0;
        o.detrend = TRK_DETREND_NONE;
        assert_ok(*state, trk_psd(*state, N, x, rate, &o, p));
        double rms = 0, square = 0;
        const int64_t used = trk_psd_segments(&o, N) * segment;
        assert_ok(*state, trk_band_rms(*state, trk_psd_length(&o, N), p, rate / (double)segment, 0,
                                       rate, &rms));
        for (int64_t i = 0; i < used; i++)
            square += x[i] * x[i] / (double)used;
        assert_near(rms * rms, square, 1e-12);
    }
}

static void detrending_removes_a_line(void **state)
{
    static double x[N], p[BINS];
    for (int64_t i = 0; i < N; i++)
        x[i] = 1000.0 - 0.25 * (double)i;
    trk_spectrum_options o = options(1024, TRK_WINDOW_HANN);
    o.detrend = TRK_DETREND_LINEAR;
    assert_ok(*state, trk_psd(*state, N, x, rate, &o, p));
    for (int k = 0; k < BINS; k++)
        assert_near(p[k], 0, 1e-20);
}

/* y is 2.5 x one sample later: the response is 2.5 exp(-2 pi i k / L). */
static void delay_has_its_response(void **state)
{
    static double x[N + 8], H[2 * BINS], C[2 * BINS], p[BINS], coherence[BINS];
    static double y[N];
    make_noise(N + 8, 3, x);
    for (int64_t i = 0; i < N; i++)
        y[i] = 2.5 * x[i + 7]; /* the input starts at x + 8 */
    trk_spectrum_options o = options(1024, TRK_WINDOW_HANN);
    assert_ok(*state, trk_frf_h1(*state, N, x + 8, y, &o, H));
    assert_ok(*state, trk_csd(*state, N, x + 8, y, rate, &o, C));
    assert_ok(*state, trk_psd(*state, N, x + 8, rate, &o, p));
    assert_ok(*state, trk_coherence(*state, N, x + 8, y, &o, coherence));
    for (int k = 4; k < BINS - 4; k++) {
        const double phase = -2 * pi * (double)k / 1024.0;
        assert_near(H[2 * k], 2.5 * cos(phase), 0.05);
        assert_near(H[2 * k + 1], 2.5 * sin(phase), 0.05);
        assert_near(C[2 * k + 1], H[2 * k + 1] * p[k], 1e-12);
        assert_true(coherence[k] > 0.999 && coherence[k] <= 1 + 1e-12);
    }
    make_noise(N, 77, y); /* unrelated: expected value is about 1 / averages */
    assert_ok(*state, trk_coherence(*state, N, x, y, &o, coherence));
    double mean = 0;
    for (int k = 4; k < BINS - 4; k++)
        mean += coherence[k] / (BINS - 8);
    assert_in_range((int)(1000 * mean), 20, 45);
}

static void lengths_and_frequencies(void **state)
{
    trk_spectrum_options o = options(7, TRK_WINDOW_HANN);
    double f[5] = {0};
    assert_int_equal(trk_psd_length(NULL, 100), 51);
    assert_int_equal(trk_psd_length(NULL, 4097), 2049);
    assert_int_equal(trk_psd_segments(NULL, 4095 + 2048), 1);
    assert_int_equal(trk_psd_segments(NULL, 4096 + 2048), 2);
    assert_int_equal(trk_psd_length(&o, 6), 0);
    assert_int_equal(trk_psd_segments(&o, 7 + 4), 2); /* floor(7 / 2) = 3 shared */
    o.overlap = nextafter(1, 0);
    assert_int_equal(trk_psd_segments(&o, 8), 2);
    assert_ok(*state, trk_psd_frequencies(*state, 20, 14.0, &o, f));
    for (int k = 0; k < 4; k++)
        assert_near(f[k], 2.0 * k, 1e-15);
    assert_near(f[4], 0, 0);
}

/* Few segments and one segment (lanes left empty, one-lane kernel) are the same estimate. */
static void lanes_do_not_show(void **state)
{
    static double x[N], one[33], sum[33], all[33];
    make_noise(N, 4, x);
    trk_spectrum_options o = options(64, TRK_WINDOW_HANN);
    o.overlap = 0;
    for (int64_t segments = 1; segments <= 9; segments++) {
        memset(sum, 0, sizeof sum);
        for (int64_t i = 0; i < segments; i++) {
            assert_ok(*state, trk_psd(*state, 64, x + 64 * i, rate, &o, one));
            for (int k = 0; k < 33; k++)
                sum[k] += one[k] / (double)segments;
        }
        assert_ok(*state, trk_psd(*state, 64 * segments + 63, x, rate, &o, all));
        for (int k = 0; k < 33; k++)
            assert_near(all[k], sum[k], 1e-15);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(sine_has_its_power, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(leakage_is_that_of_the_window, support_setup,
                                        support_teardown),
        cmocka_unit_test_setup_teardown(white_noise_has_its_level, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(area_is_the_mean_square, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(detrending_removes_a_line, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(delay_has_its_response, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(lengths_and_frequencies, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(lanes_do_not_show, support_setup, support_teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
