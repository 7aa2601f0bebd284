/* SPDX-License-Identifier: MIT */
/* Monotonicity and slope range are exact; PCHIP keeps monotone tables monotone. */
#include "tables.h"

#include "curve/range.h"
#include "curve/slopes.h"

/* Smallest and largest slope by brute force, beyond the ends as well. */
static void scan(const trk_curve *curve, double *low, double *high)
{
    const double *x = trk_curve_x(curve);
    int64_t n = trk_curve_count(curve);
    double width = x[n - 1] - x[0];
    *low = INFINITY;
    *high = -INFINITY;
    for (int k = -1000; k <= 21000; k++) {
        double slope = trk_curve_slope(curve, x[0] + width * k / 20000.0);
        *low = fmin(*low, slope);
        *high = fmax(*high, slope);
    }
}

static void test_damper_is_monotone_under_pchip_only(void **state)
{
    const int32_t wanted[KINDS] = {1, 0, 0, 0, 1};
    for (trk_interpolation kind = 0; kind < KINDS; kind++) {
        trk_curve *curve = new_damper(*state, kind);
        double low, high;
        scan(curve, &low, &high);
        if (trk_curve_monotone(curve) != wanted[kind])
            fail_msg("%s: monotone is %d, scanned slopes %g to %g", kind_names[kind],
                     (int)trk_curve_monotone(curve), low, high);
        assert_int_equal(low >= 0.0, wanted[kind]);
        trk_curve_destroy(curve);
    }
}

static void test_range_holds_every_slope_and_is_attained(void **state)
{
    for (int clamp = 0; clamp < 2; clamp++)
        for (trk_interpolation kind = 0; kind < KINDS; kind++) {
            trk_curve *curve = new_curve(*state, DAMPER_POINTS, damper_x, damper_y, kind, clamp);
            double low, high, seen_low, seen_high;
            trk_curve_slope_range(curve, &low, &high);
            scan(curve, &seen_low, &seen_high);
            double rounding = 1e-11 * (high - low), resolution = 1e-5 * (high - low);
            assert_true(seen_low >= low - rounding && seen_high <= high + rounding);
            assert_near(seen_low, low, resolution);
            assert_near(seen_high, high, resolution);
            trk_curve_destroy(curve);
        }
}

/* Not-a-knot through x^3 - a x has the slopes -a (at the vertex) to 3 - a. */
static void test_vertex_inside_a_piece(void **state)
{
    double x[] = {-1.0, -0.5, 0.25, 1.0}, y[4];
    for (int k = 0; k < 4; k++)
        y[k] = x[k] * x[k] * x[k] - 0.01 * x[k];
    trk_curve *curve = new_curve(*state, 4, x, y, TRK_INTERPOLATION_NOT_A_KNOT, 0);
    double low, high;
    trk_curve_slope_range(curve, &low, &high);
    assert_near(low, -0.01, 1e-14);
    assert_near(high, 2.99, 1e-14);
    assert_int_equal(trk_curve_monotone(curve), 0);
    trk_curve_destroy(curve);
}

/* Slopes 3 m and 0 give a derivative that touches zero: rounding must not make it negative. */
static void test_touching_zero_counts_as_monotone(void **state)
{
    (void)state;
    for (int k = 1; k < 1000; k++) {
        double m = k / 7.0, low = INFINITY, high = -INFINITY;
        trk_widen_slope_range(3.0 * m, 0.0, m, &low, &high);
        assert_true(low == 0.0);
        assert_near(high, 3.0 * m, 0.0);
        for (int ulps = 1; ulps < 40; ulps++) /* nearly touching: the vertex is rounding alone */
            trk_widen_slope_range(3.0 * m * (1.0 - ulps * 0x1p-53), ulps * 0x1p-60 * m, m, &low,
                                  &high);
        assert_true(low == 0.0);
        trk_widen_slope_range(3.01 * m, 0.0, m, &low, &high);
        assert_true(low < 0.0);
    }
}

static double random_number(uint64_t *seed) /* [0, 1) */
{
    *seed = *seed * 6364136223846793005u + 1442695040888963407u;
    return (double)(*seed >> 11) / 9007199254740992.0;
}

static void test_random_monotone_tables_stay_monotone(void **state)
{
    uint64_t seed = 1;
    for (int round = 0; round < 2000; round++) {
        double x[12], y[12], direction = round % 2 ? 1.0 : -1.0;
        x[0] = y[0] = 0.0;
        for (int k = 1; k < 12; k++) {
            x[k] = x[k - 1] + pow(10.0, 6.0 * random_number(&seed) - 3.0);
            double rise = pow(10.0, 12.0 * random_number(&seed) - 6.0);
            y[k] = y[k - 1] + (random_number(&seed) < 0.2 ? 0.0 : direction * rise);
        }
        trk_curve *curve = new_curve(*state, 12, x, y, TRK_INTERPOLATION_PCHIP, 0);
        double low, high;
        trk_curve_slope_range(curve, &low, &high);
        assert_true(direction > 0 ? low >= 0.0 : high <= 0.0);
        assert_int_equal(trk_curve_monotone(curve), low == 0.0 && high == 0.0 ? 1 : (int)direction);
        trk_curve_destroy(curve);
    }
}

/* Where the harmonic mean approaches three times the flatter secant, rounding must not pass it. */
static void test_slopes_keep_to_three_secants(void **state)
{
    (void)state;
    uint64_t seed = 7;
    for (int round = 0; round < 2000; round++) {
        double h = 1e17 * (1.0 + random_number(&seed)), rise = 1.0 + random_number(&seed);
        double x[] = {-h, 0.0, 1.0}, y[] = {-rise, 0.0, 1e30}, slopes[3];
        trk_pchip_slopes(3, x, y, slopes);
        assert_true(slopes[1] <= 3.0 * (rise / h) && slopes[1] > 2.99 * (rise / h));
    }
    double x[] = {0.0, 1.0, 2.0, 3.0}, turning[] = {0.0, 1.0, -9.0, -8.0}, slopes[4];
    trk_pchip_slopes(4, x, turning, slopes); /* the three-point formula gives 6.5 and 6.5 */
    assert_near(slopes[0], 3.0, 0.0);
    assert_near(slopes[3], 3.0, 0.0);
}

static void test_constant_is_rising(void **state)
{
    double x[] = {0.0, 1.0, 2.5, 4.0, 5.0}, y[] = {7.0, 7.0, 7.0, 7.0, 7.0};
    for (trk_interpolation kind = 0; kind < KINDS; kind++) {
        trk_curve *curve = new_curve(*state, 5, x, y, kind, 0);
        assert_int_equal(trk_curve_monotone(curve), 1);
        trk_curve_destroy(curve);
    }
}

static void keep_note(void *user, const char *message)
{
    snprintf(user, 256, "%s", message);
}

static void test_overshoot_is_noted(void **state)
{
    char note[256] = "";
    trk_context_set_log(*state, keep_note, note);
    trk_curve_destroy(new_damper(*state, TRK_INTERPOLATION_PCHIP));
    assert_string_equal(note, "");
    trk_curve_destroy(new_damper(*state, TRK_INTERPOLATION_NOT_A_KNOT));
    assert_non_null(strstr(note, "curve 'table': the table is monotone, the curve is not"));
    trk_context_set_log(*state, NULL, NULL);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_damper_is_monotone_under_pchip_only),
        cmocka_unit_test(test_range_holds_every_slope_and_is_attained),
        cmocka_unit_test(test_vertex_inside_a_piece),
        cmocka_unit_test(test_touching_zero_counts_as_monotone),
        cmocka_unit_test(test_random_monotone_tables_stay_monotone),
        cmocka_unit_test(test_slopes_keep_to_three_secants),
        cmocka_unit_test(test_constant_is_rising),
        cmocka_unit_test(test_overshoot_is_noted),
    };
    return cmocka_run_group_tests(tests, support_setup, support_teardown);
}
