/* SPDX-License-Identifier: MIT */
/* Lookup: hints, ends, infinities, NaN; slope against differences of the value. */
#include "tables.h"

#include "curve/curve.h"

static void test_slope_is_the_derivative(void **state)
{
    for (trk_interpolation kind = 0; kind < KINDS; kind++) {
        trk_curve *curve = new_damper(*state, kind);
        const double h = 1e-6;
        for (int k = 0; k < 130; k++) { /* never within h of a point of the table */
            double x = -0.648 + k / 100.0;
            double difference =
                (trk_curve_value(curve, x + h) - trk_curve_value(curve, x - h)) / (2 * h);
            assert_near(trk_curve_slope(curve, x), difference, 1e-4);
        }
        trk_curve_destroy(curve);
    }
}

static void test_result_does_not_depend_on_the_hint(void **state)
{
    trk_curve *curve = new_damper(*state, TRK_INTERPOLATION_PCHIP);
    for (int k = -60; k <= 60; k++) {
        double x = k / 100.0, wanted = trk_curve_value(curve, x), value, slope;
        int32_t piece = trk_curve_locate(curve, x, 0);
        for (int32_t start = 0; start <= DAMPER_POINTS; start++) {
            int32_t hint = start;
            trk_curve_point(curve, x, &hint, &value, &slope);
            assert_int_equal(hint, piece);
            assert_true(value == wanted && slope == trk_curve_slope(curve, x));
        }
        assert_true(x >= curve->pieces[piece].lower && x < curve->pieces[piece].upper);
    }
    trk_curve_destroy(curve);
}

static void test_extrapolation(void **state)
{
    for (trk_interpolation kind = 0; kind < KINDS; kind++) {
        trk_curve *straight = new_damper(*state, kind);
        double first = trk_curve_slope(straight, -0.5),
               last = trk_curve_slope(straight, nextafter(0.5, 0.0));
        assert_near(trk_curve_value(straight, -2.5), -3500.0 - 2.0 * first, 1e-9);
        assert_near(trk_curve_value(straight, 2.5), 500.0 + 2.0 * last, 1e-9);
        assert_near(trk_curve_slope(straight, 2.5), last, 1e-9);
        assert_true(trk_curve_value(straight, INFINITY) == INFINITY);
        assert_true(trk_curve_value(straight, -INFINITY) == -INFINITY);
        trk_curve_destroy(straight);

        trk_curve *level =
            new_curve(*state, DAMPER_POINTS, damper_x, damper_y, kind, TRK_EXTRAPOLATION_CLAMP);
        const double beyond[] = {0.5, 2.5, 1e300, INFINITY};
        for (int k = 0; k < 4; k++) {
            assert_true(trk_curve_value(level, beyond[k]) == 500.0);
            assert_true(trk_curve_slope(level, beyond[k]) == 0.0);
            assert_true(trk_curve_value(level, -beyond[k]) == -3500.0);
            if (k > 0)
                assert_true(trk_curve_slope(level, -beyond[k]) == 0.0);
        }
        trk_curve_destroy(level);
    }
}

static void test_nan_gives_nan(void **state)
{
    for (trk_interpolation kind = 0; kind < KINDS; kind++)
        for (int clamp = 0; clamp < 2; clamp++) {
            trk_curve *curve = new_curve(*state, DAMPER_POINTS, damper_x, damper_y, kind, clamp);
            assert_true(isnan(trk_curve_value(curve, NAN)));
            assert_true(isnan(trk_curve_slope(curve, NAN)));
            trk_curve_destroy(curve);
        }
}

static void test_many_places(void **state)
{
    trk_curve *curve = new_damper(*state, TRK_INTERPOLATION_AKIMA);
    const double x[] = {0.1, NAN, -9.0, 0.47, INFINITY, 0.0, -0.5};
    double value[7], slope[7], only[7];
    trk_curve_evaluate(curve, 7, x, value, slope);
    for (int k = 0; k < 7; k++) {
        double v = trk_curve_value(curve, x[k]), s = trk_curve_slope(curve, x[k]);
        assert_memory_equal(&value[k], &v, sizeof v);
        assert_memory_equal(&slope[k], &s, sizeof s);
    }
    trk_curve_evaluate(curve, 7, x, only, NULL);
    assert_memory_equal(only, value, sizeof only);
    trk_curve_evaluate(curve, 7, x, NULL, only);
    assert_memory_equal(only, slope, sizeof only);
    trk_curve_evaluate(curve, 7, x, NULL, NULL);
    trk_curve_evaluate(curve, 0, NULL, NULL, NULL);
    trk_curve_destroy(curve);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_slope_is_the_derivative),
        cmocka_unit_test(test_result_does_not_depend_on_the_hint),
        cmocka_unit_test(test_extrapolation),
        cmocka_unit_test(test_nan_gives_nan),
        cmocka_unit_test(test_many_places),
    };
    return cmocka_run_group_tests(tests, support_setup, support_teardown);
}
