/* SPDX-License-Identifier: MIT */
/* The inverse of a monotone curve. */
#include "tables.h"

static void test_inverse_of_the_damper(void **state)
{
    const double sign[] = {1.0, -1.0};
    for (int mirrored = 0; mirrored < 2; mirrored++) {
        double y[DAMPER_POINTS];
        for (int k = 0; k < DAMPER_POINTS; k++)
            y[k] = sign[mirrored] * damper_y[k];
        trk_curve *curve =
            new_curve(*state, DAMPER_POINTS, damper_x, y, TRK_INTERPOLATION_PCHIP, 0);
        for (int k = -700; k <= 700; k++) {
            double x = k / 1000.0, found = NAN;
            assert_ok(*state, trk_curve_solve(*state, curve, trk_curve_value(curve, x), &found));
            assert_near(found, x, 1e-15);
        }
        trk_curve_destroy(curve);
    }
}

/* y = x^3 is level at 0, where Newton alone crawls and the inverse amplifies rounding. */
static void test_level_inflection(void **state)
{
    double x[] = {-1.0, 0.0, 1.0}, y[] = {-1.0, 0.0, 1.0}, found;
    trk_curve *line = new_curve(*state, 3, x, y, TRK_INTERPOLATION_PCHIP, 0);
    for (int k = -20; k <= 20; k++) {
        assert_ok(*state, trk_curve_solve(*state, line, k / 10.0, &found));
        assert_near(found, k / 10.0, 2e-16);
    }
    trk_curve_destroy(line);
    double s[] = {0.0, 1.0, 2.0, 3.0}, step[] = {0.0, 0.0, 1.0, 1.0};
    trk_curve *curve = new_curve(*state, 4, s, step, TRK_INTERPOLATION_PCHIP, 0);
    for (double v = 1e-12; v < 1.0; v *= 1.7) {
        assert_ok(*state, trk_curve_solve(*state, curve, v, &found));
        assert_near(trk_curve_value(curve, found), v, 4e-16);
    }
    trk_curve_destroy(curve);
}

static void test_smallest_of_many(void **state)
{
    double x[] = {0.0, 1.0, 2.0, 3.0, 4.0}, rising[] = {0.0, 0.0, 5.0, 5.0, 6.0}, found;
    double falling[] = {6.0, 5.0, 5.0, 5.0, 0.0};
    trk_curve *curve = new_curve(*state, 5, x, rising, 0, TRK_EXTRAPOLATION_CLAMP);
    assert_ok(*state, trk_curve_solve(*state, curve, 0.0, &found));
    assert_near(found, 0.0, 0.0);
    assert_ok(*state, trk_curve_solve(*state, curve, 5.0, &found));
    assert_near(found, 2.0, 0.0);
    trk_curve_destroy(curve);
    curve = new_curve(*state, 5, x, falling, 0, 0);
    assert_ok(*state, trk_curve_solve(*state, curve, 5.0, &found));
    assert_near(found, 1.0, 0.0);
    trk_curve_destroy(curve);
}

static void test_beyond_the_ends(void **state)
{
    double x[] = {0.0, 1.0}, y[] = {0.0, 2.0}, found;
    trk_curve *curve = new_curve(*state, 2, x, y, 0, TRK_EXTRAPOLATION_SLOPE);
    assert_ok(*state, trk_curve_solve(*state, curve, -8.0, &found));
    assert_near(found, -4.0, 0.0);
    assert_ok(*state, trk_curve_solve(*state, curve, 8.0, &found));
    assert_near(found, 4.0, 0.0);
    trk_curve_destroy(curve);
    curve = new_curve(*state, 2, x, y, 0, TRK_EXTRAPOLATION_CLAMP);
    assert_status(*state, trk_curve_solve(*state, curve, -8.0, &found), TRK_E_RANGE);
    assert_true(isnan(found));
    assert_status(*state, trk_curve_solve(*state, curve, 2.1, &found), TRK_E_RANGE);
    assert_message(*state, "curve 'table': never takes the value 2.1");
    assert_status(*state, trk_curve_solve(*state, curve, NAN, &found), TRK_E_RANGE);
    assert_status(*state, trk_curve_solve(*state, curve, INFINITY, &found), TRK_E_RANGE);
    trk_curve_destroy(curve);
}

static void test_errors(void **state)
{
    trk_curve *curve = new_damper(*state, TRK_INTERPOLATION_NOT_A_KNOT);
    double found;
    assert_status(*state, trk_curve_solve(*state, curve, 0.0, &found), TRK_E_RANGE);
    assert_message(*state, "not monotone");
    assert_status(*state, trk_curve_solve(*state, NULL, 0.0, &found), TRK_E_ARGUMENT);
    assert_status(*state, trk_curve_solve(*state, curve, 0.0, NULL), TRK_E_ARGUMENT);
    assert_message(*state, "out_x");
    trk_curve_destroy(curve);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_inverse_of_the_damper),
        cmocka_unit_test(test_level_inflection),
        cmocka_unit_test(test_smallest_of_many),
        cmocka_unit_test(test_beyond_the_ends),
        cmocka_unit_test(test_errors),
    };
    return cmocka_run_group_tests(tests, support_setup, support_teardown);
}
