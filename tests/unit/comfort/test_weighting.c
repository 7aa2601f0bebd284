/* SPDX-License-Identifier: MIT */
/* Analogue weightings against the table of the standards, and their shape. */
#include "support.h"

#include <truckride/comfort.h>

/* Factors x 1000 at nominal third octaves; Wk, Wc, Wd agree with ISO 2631-1 table 3 to 0.4 %
 * (but Wd at 10 Hz, printed 212). Columns in the order of trk_weighting with Wb before Wf. */
static const struct {
    double f, wk, wd, wc, we, wj, wb, wf;
} row[] = {
    {0.1, 31.21, 62.42, 62.38, 62.52, 30.99, 24.94, 695.1},
    {0.125, 48.62, 97.28, 97.2, 97.54, 48.28, 38.86, 895.1},
    {0.16, 79.01, 158.2, 158, 158.9, 78.47, 63.14, 1006},
    {0.2, 121.2, 243.1, 242.6, 244.6, 120.4, 96.88, 992},
    {0.25, 181.7, 365.2, 363.9, 368.4, 180.6, 145.2, 854.3},
    {0.315, 262.9, 530, 527.2, 536.3, 261.5, 210.1, 619.1},
    {0.4, 352.1, 713.2, 707.5, 723.3, 350.6, 281.4, 384.3},
    {0.5, 418.2, 852.8, 843.1, 862.4, 417.1, 334.2, 223.9},
    {0.63, 458.7, 943.9, 928.8, 938.7, 458.3, 366.5, 116.3},
    {0.8, 477, 992.3, 972.4, 941.3, 477.9, 381.1, 53.01},
    {1, 482.5, 1011, 991, 879.8, 484.4, 385.3, 23.52},
    {1.25, 484.5, 1008, 1000, 772.2, 485.2, 386.3, 9.978},
    {1.6, 494.2, 968.4, 1007, 631.8, 483.1, 392.1, 3.771},
    {2, 531.4, 890.2, 1012, 511.5, 481.9, 417.3, 1.551},
    {2.5, 630.5, 775.9, 1017, 409, 488.6, 493.5, 0.6359},
    {3.15, 804, 642, 1022, 323.1, 523.6, 661.7, 0.2523},
    {4, 967.2, 511.9, 1024, 253.1, 628.1, 889.1, 0.097},
    {5, 1039, 409.1, 1013, 201.7, 793, 1025, 0.03972},
    {6.3, 1054, 323.1, 974.3, 159.6, 946.3, 1055, 0.01575},
    {8, 1036, 253.1, 890.9, 125.4, 1017, 1025, 0.006058},
    {10, 988.4, 201.7, 776.2, 100.2, 1030, 974.5, 0.002481},
    {12.5, 902.3, 160.9, 646.6, 80.11, 1026, 906.6, 0.001016},
    {16, 768.7, 125.4, 511.8, 62.54, 1018, 810.3, 0.0003785},
    {20, 635.9, 100.2, 408.8, 49.99, 1012, 707.6, 0.000155},
    {25, 512.7, 79.96, 325.1, 39.94, 1007, 599.6, 6.351e-05},
    {31.5, 404.8, 63.24, 256, 31.6, 1001, 492.3, 2.52e-05},
    {40, 314.4, 49.4, 199.2, 24.69, 990.8, 393.2, 9.69e-06},
    {50, 245.8, 38.82, 156.1, 19.4, 972.3, 312.6, 3.969e-06},
    {63, 186.1, 29.51, 118.5, 14.75, 930.8, 239.3, 1.575e-06},
    {80, 132.4, 21.06, 84.42, 10.53, 843, 171.5, 6.056e-07},
    {100, 88.73, 14.14, 56.65, 7.071, 707.5, 115.4, 2.481e-07},
    {125, 54.04, 8.625, 34.53, 4.312, 539.2, 70.49, 1.016e-07},
    {160, 28.47, 4.548, 18.2, 2.274, 363.9, 37.21, 3.785e-08},
    {200, 15.17, 2.425, 9.705, 1.213, 242.6, 19.85, 1.55e-08},
    {250, 7.905, 1.264, 5.057, 0.632, 158, 10.35, 6.35e-09},
    {315, 3.981, 0.6367, 2.547, 0.3183, 100.3, 5.214, 2.52e-09},
    {400, 1.95, 0.3119, 1.248, 0.1559, 62.38, 2.554, 9.69e-10},
};

static void compare(trk_weighting weighting, double f, double thousandfold)
{
    assert_near(trk_weighting_factor(weighting, f) * 1000, thousandfold, 1e-3 * thousandfold);
}

static void factors_are_those_of_the_standards(void **state)
{
    (void)state;
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        compare(TRK_WEIGHTING_WK, row[k].f, row[k].wk);
        compare(TRK_WEIGHTING_WD, row[k].f, row[k].wd);
        compare(TRK_WEIGHTING_WC, row[k].f, row[k].wc);
        compare(TRK_WEIGHTING_WE, row[k].f, row[k].we);
        compare(TRK_WEIGHTING_WJ, row[k].f, row[k].wj);
        compare(TRK_WEIGHTING_WB, row[k].f, row[k].wb);
        compare(TRK_WEIGHTING_WF, row[k].f, row[k].wf);
    }
}

/* A Butterworth pair has 1/sqrt(2) at its own limits, less what the other limit takes. */
static void band_limits_are_butterworth(void **state)
{
    (void)state;
    for (double f = 0.01; f < 500; f *= 1.3) {
        double high = 1 / sqrt(1 + pow(0.4 / f, 4)), low = 1 / sqrt(1 + pow(f / 100, 4));
        assert_near(trk_weighting_factor(TRK_WEIGHTING_BAND, f), high * low, 1e-14);
        high = 1 / sqrt(1 + pow(0.08 / f, 4));
        low = 1 / sqrt(1 + pow(f / 0.63, 4));
        assert_near(trk_weighting_factor(TRK_WEIGHTING_BAND_LOW, f), high * low, 1e-14);
    }
}

/* Straight from the polynomials in s, with real and imaginary parts by hand. */
static void wk_written_out(double f, double *re, double *im)
{
    const double w = 2 * acos(-1) * f, q = sqrt(0.5);
    const double corner[4] = {0.4, 100, 12.5, 3.35}, quality[4] = {q, q, 0.63, 0.91};
    double nr = -w * w, ni = 0; /* s^2 of the high-pass */
    double zr = 1, zi = f / 12.5, tr = nr * zr - ni * zi;
    ni = nr * zi + ni * zr;
    nr = tr;
    const double w5 = 2 * acos(-1) * 2.37;
    zr = w5 * w5 - w * w, zi = w5 * w / 0.91;
    tr = nr * zr - ni * zi;
    ni = nr * zi + ni * zr;
    nr = tr;
    for (int k = 0; k < 4; k++) {
        double wk = 2 * acos(-1) * corner[k], unit = k == 1 || k == 2 ? wk * wk : 1;
        double dr = (wk * wk - w * w) / unit, di = wk * w / quality[k] / unit,
               d = dr * dr + di * di;
        tr = (nr * dr + ni * di) / d;
        ni = (ni * dr - nr * di) / d;
        nr = tr;
    }
    *re = nr;
    *im = ni;
}

static void response_has_the_phase_of_the_polynomials(void **state)
{
    trk_context *c = *state;
    double f[40], h[80];
    for (int k = 0; k < 40; k++)
        f[k] = 0.05 * pow(1.3, k);
    assert_ok(c, trk_weighting_response(c, TRK_WEIGHTING_WK, 40, f, h));
    for (int k = 0; k < 40; k++) {
        double re, im, size = trk_weighting_factor(TRK_WEIGHTING_WK, f[k]);
        wk_written_out(f[k], &re, &im);
        assert_near(h[2 * k], re, 1e-13 * size);
        assert_near(h[2 * k + 1], im, 1e-13 * size);
    }
}

static void extremes_are_quiet(void **state)
{
    (void)state;
    for (trk_weighting w = TRK_WEIGHTING_WK; w <= TRK_WEIGHTING_BAND_LOW; w++) {
        assert_non_null(trk_weighting_name(w));
        assert_true(trk_weighting_factor(w, 0) == 0);
        for (double f = 1e-300; f < 1e300; f *= 1e3) {
            double factor = trk_weighting_factor(w, f);
            assert_true(factor >= 0 && factor < 1.1);
        }
        assert_true(isnan(trk_weighting_factor(w, -1)));
        assert_true(isnan(trk_weighting_factor(w, NAN)));
        assert_true(isnan(trk_weighting_factor(w, INFINITY)));
    }
    assert_true(isnan(trk_weighting_factor(0, 1)));
    assert_true(isnan(trk_weighting_factor(10, 1)));
    assert_null(trk_weighting_name(0));
    assert_null(trk_weighting_name(10));
    assert_string_equal(trk_weighting_name(TRK_WEIGHTING_WK), "Wk");
}

static void wrong_arguments(void **state)
{
    trk_context *c = *state;
    double f[2] = {1, -1}, h[4];
    assert_status(c, trk_weighting_response(NULL, TRK_WEIGHTING_WK, 1, f, h), TRK_E_ARGUMENT);
    assert_status(c, trk_weighting_response(c, TRK_WEIGHTING_WK, 1, NULL, h), TRK_E_ARGUMENT);
    assert_status(c, trk_weighting_response(c, TRK_WEIGHTING_WK, 1, f, NULL), TRK_E_ARGUMENT);
    assert_status(c, trk_weighting_response(c, 10, 1, f, h), TRK_E_ARGUMENT);
    assert_message(c, "weighting is 10, expected 1 to 9");
    assert_status(c, trk_weighting_response(c, TRK_WEIGHTING_WK, -1, f, h), TRK_E_RANGE);
    assert_status(c, trk_weighting_response(c, TRK_WEIGHTING_WK, 2, f, h), TRK_E_RANGE);
    assert_message(c, "frequency[1] is -1 Hz");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(factors_are_those_of_the_standards, support_setup,
                                        support_teardown),
        cmocka_unit_test_setup_teardown(band_limits_are_butterworth, support_setup,
                                        support_teardown),
        cmocka_unit_test_setup_teardown(response_has_the_phase_of_the_polynomials, support_setup,
                                        support_teardown),
        cmocka_unit_test_setup_teardown(extremes_are_quiet, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(wrong_arguments, support_setup, support_teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
