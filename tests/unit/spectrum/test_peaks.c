/* SPDX-License-Identifier: MIT */
/* Peaks, band RMS and normalisation of densities given by formula. */
#include "support.h"

#include <truckride/spectrum.h>

static trk_peak_options peak_options(void)
{
    trk_peak_options o;
    trk_peak_options_init(&o, sizeof o);
    return o;
}

static void definitions_of_prominence(void **state)
{
    /*                     0  1  2  3  4  5  6  7  8  9 10 11 12 */
    const double p[] = {9, 1, 5, 2, 7, 7, 7, 3, 4, 0, 6, 6, 8};
    double f[4], h[4], d[4];
    int64_t count = 0;
    assert_ok(*state, trk_psd_peaks(*state, 13, p, 0.5, NULL, 4, f, h, d, &count));
    assert_int_equal(count, 3); /* 6 6 8 only rises, the ends are no peaks */
    const double frequency[] = {2.5, 2 * 0.5, 8 * 0.5}, height[] = {7, 5, 4};
    const double prominence[] = {6, 3, 1};
    for (int i = 0; i < 3; i++) {
        assert_near(f[i], frequency[i], i == 0 ? 1e-15 : 0.25);
        assert_near(h[i], height[i], 0);
        assert_near(d[i], prominence[i], 0);
    }
    assert_near(f[2], 4.0, 0); /* a zero beside it: the bin itself */
    trk_peak_options o = peak_options();
    o.order = TRK_PEAK_ORDER_FREQUENCY;
    o.minimum_prominence = 3;
    assert_ok(*state, trk_psd_peaks(*state, 13, p, 0.5, &o, 1, NULL, h, NULL, &count));
    assert_int_equal(count, 2);
    assert_near(h[0], 5, 0);
    o.minimum_prominence = 0;
    o.minimum_height = 5;
    assert_ok(*state, trk_psd_peaks(*state, 13, p, 0.5, &o, 0, NULL, NULL, NULL, &count));
    assert_int_equal(count, 2);
}

static void distance_keeps_the_higher(void **state)
{
    const double p[] = {0, 3, 0, 4, 0, 5, 0, 5, 0};
    double f[4];
    int64_t count = 0;
    trk_peak_options o = peak_options();
    o.order = TRK_PEAK_ORDER_FREQUENCY;
    o.minimum_distance = 0.2; /* two bins: allowed */
    assert_ok(*state, trk_psd_peaks(*state, 9, p, 0.1, &o, 4, f, NULL, NULL, &count));
    assert_int_equal(count, 4);
    o.minimum_distance = 0.21; /* 5 at 0.5 drops 4 and the other 5, so 3 stays */
    assert_ok(*state, trk_psd_peaks(*state, 9, p, 0.1, &o, 4, f, NULL, NULL, &count));
    assert_int_equal(count, 2);
    assert_near(f[0], 0.1, 1e-15);
    assert_near(f[1], 0.5, 1e-15);
}

/* Exact for a Gaussian, and second order small for a lightly damped resonance. */
static void vertex_between_bins(void **state)
{
    double p[400], f[2];
    int64_t count = 0;
    for (double offset = -0.49; offset < 0.5; offset += 0.07) {
        for (int k = 0; k < 400; k++)
            p[k] = 2e-3 * exp(-0.01 * (k - 200 - offset) * (k - 200 - offset));
        assert_ok(*state, trk_psd_peaks(*state, 400, p, 0.05, NULL, 2, f, NULL, NULL, &count));
        assert_int_equal(count, 1);
        assert_near(f[0], 0.05 * (200 + offset), 1e-12);
    }
    const double f0 = 1.83, damping = 0.08, step = 0.05;
    for (int k = 0; k < 400; k++) {
        const double r = k * step / f0;
        p[k] = 1 / ((1 - r * r) * (1 - r * r) + 4 * damping * damping * r * r);
    }
    assert_ok(*state, trk_psd_peaks(*state, 400, p, step, NULL, 2, f, NULL, NULL, &count));
    assert_int_equal(count, 1);
    assert_near(f[0], f0 * sqrt(1 - 2 * damping * damping), 0.02 * step);
}

/* The stated bound: a sine in a Hann window is found within 0.02 bin. */
static void sine_between_bins(void **state)
{
    static double x[1024], p[513];
    double f[1], worst = 0;
    int64_t count = 0;
    for (double bin = 100; bin < 101; bin += 0.05) {
        for (int i = 0; i < 1024; i++)
            x[i] = sin(2 * 3.14159265358979323846 * bin / 1024 * i);
        assert_ok(*state, trk_psd(*state, 1024, x, 1024, NULL, p));
        assert_ok(*state, trk_psd_peaks(*state, 513, p, 1, NULL, 1, f, NULL, NULL, &count));
        worst = fmax(worst, fabs(f[0] - bin));
    }
    assert_true(worst < 0.02 && worst > 0.01);
}

static void bins_cut_by_the_band(void **state)
{
    const double p[] = {1, 4, 9, 2};
    const struct {
        double low, high, square;
    } band[] = {
        {0, 100, 32}, /* all: (1 + 4 + 9 + 2) 2 Hz         */
        {0, 1, 2},    /* bin 0 lies between 0 and 1 Hz     */
        {0, 0.25, 0.5}, {1, 3, 8},  {2, 4, 4 + 9}, {3.5, 3.75, 9 * 0.25},
        {6, 7, 2},      {7, 50, 0}, {2, 2, 0},
    };
    for (size_t i = 0; i < sizeof band / sizeof *band; i++) {
        double rms = -1;
        assert_ok(*state, trk_band_rms(*state, 4, p, 2, band[i].low, band[i].high, &rms));
        assert_near(rms * rms, band[i].square, 1e-13);
    }
}

static void normalised_to_its_reference(void **state)
{
    double p[] = {1, 4, 2}, q[3], reference = 0;
    assert_ok(*state, trk_psd_normalise(*state, 3, p, 0, q, &reference));
    assert_near(q[0], 0.25, 0);
    assert_near(q[1], 1, 0);
    assert_near(reference, 4, 0);
    assert_ok(*state, trk_psd_normalise(*state, 3, p, 8, p, NULL));
    assert_near(p[1], 0.5, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(definitions_of_prominence, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(distance_keeps_the_higher, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(vertex_between_bins, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(sine_between_bins, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(bins_cut_by_the_band, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(normalised_to_its_reference, support_setup,
                                        support_teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
