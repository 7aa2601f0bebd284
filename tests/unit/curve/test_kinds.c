/* SPDX-License-Identifier: MIT */
/* What each interpolation promises: SciPy's values, polynomials reproduced, smoothness, order. */
#include "tables.h"

enum { PLACES = 6 };
static const double places[PLACES] = {-0.47, -0.12, -0.02, 0.03, 0.17, 0.44};

/* SciPy 1.10.1 on the damper table: PchipInterpolator, CubicSpline with bc_type
 * "not-a-knot" and "natural", Akima1DInterpolator. */
static const double scipy_value[4][PLACES] = {
    {-3327.425, -2152.5714285714284, -282.1818181818182, 67.85454545454546, 237.25, 440.0},
    {-3318.811631389776, -2233.369986844578, -314.5597115203909, 117.5399854350686,
     254.71420961755308, 442.1462413080248},
    {-3336.3735229688236, -2233.2584897766383, -314.5533001552061, 117.5390566165058,
     254.74688444733113, 440.65732370605303},
    {-3326.9, -2300.9999999999995, -335.2, 103.2, 239.72500000000002, 440.0}};
static const double scipy_slope[4][PLACES] = {
    {5482.500000000001, 6742.857142857143, 21963.63636363636, 1476.3636363636365, 382.1428571428571,
     1000.0000000000002},
    {5534.1325839441215, 9133.793538182044, 19928.581407003694, -491.2664834304287,
     -145.64259929211244, 1033.21563929086},
    {5364.370997536946, 9126.981678925706, 19928.29649436534, -491.18695593494886,
     -145.90466208920998, 1001.3694243876107},
    {5510.000000000001, 10587.500000000007, 21079.999999999996, -880.0, 252.50000000000023,
     1000.0000000000001}};

static void test_values_of_scipy(void **state)
{
    for (trk_interpolation kind = 0; kind < 4; kind++) {
        trk_curve *curve = new_damper(*state, kind);
        for (int k = 0; k < PLACES; k++) {
            assert_near(trk_curve_value(curve, places[k]), scipy_value[kind][k], 3.5e-9);
            assert_near(trk_curve_slope(curve, places[k]), scipy_slope[kind][k], 2e-8);
        }
        trk_curve_destroy(curve);
    }
}

static void test_points_are_met_exactly(void **state)
{
    for (trk_interpolation kind = 0; kind < KINDS; kind++) {
        trk_curve *curve = new_damper(*state, kind);
        for (int k = 0; k < DAMPER_POINTS; k++)
            assert_true(trk_curve_value(curve, damper_x[k]) == damper_y[k]);
        trk_curve_destroy(curve);
    }
}

/* Largest relative error of value and slope against a polynomial of four coefficients. */
static double polynomial_error(trk_context *context, trk_interpolation kind, int64_t n,
                               const double c[4])
{
    const double x[] = {-2.0, -1.7, -0.3, 0.4, 0.5, 2.0, 3.5};
    double y[7], worst = 0.0;
    for (int k = 0; k < 7; k++)
        y[k] = c[0] + x[k] * (c[1] + x[k] * (c[2] + x[k] * c[3]));
    trk_curve *curve = new_curve(context, n, x, y, kind, TRK_EXTRAPOLATION_SLOPE);
    for (int k = 0; k <= 100; k++) {
        double s = x[0] + (x[n - 1] - x[0]) * k / 100.0;
        double value = c[0] + s * (c[1] + s * (c[2] + s * c[3]));
        double slope = c[1] + s * (2.0 * c[2] + s * 3.0 * c[3]);
        worst = fmax(worst, fabs(trk_curve_value(curve, s) - value));
        worst = fmax(worst, fabs(trk_curve_slope(curve, s) - slope));
    }
    trk_curve_destroy(curve);
    return worst;
}

static void test_polynomials_reproduced(void **state)
{
    const double line[] = {1.0, -2.0, 0.0, 0.0}, parabola[] = {1.0, -2.0, 0.5, 0.0};
    const double cubic[] = {1.0, -2.0, 0.5, 0.7};
    for (trk_interpolation kind = 0; kind < KINDS; kind++)
        for (int64_t n = 2; n <= 7; n++)
            assert_near(polynomial_error(*state, kind, n, line), 0.0, 1e-13);
    assert_near(polynomial_error(*state, TRK_INTERPOLATION_NOT_A_KNOT, 3, parabola), 0.0, 1e-13);
    for (int64_t n = 4; n <= 7; n++)
        assert_near(polynomial_error(*state, TRK_INTERPOLATION_NOT_A_KNOT, n, cubic), 0.0, 1e-12);
    assert_true(polynomial_error(*state, TRK_INTERPOLATION_NATURAL, 7, cubic) > 0.1);
}

/* Jump of the second derivative at a point, by one-sided differences of the slope. */
static double curvature_jump(const trk_curve *curve, double x)
{
    const double h = 1e-4;
    double d0 = trk_curve_slope(curve, x);
    double right =
        (4.0 * trk_curve_slope(curve, x + h) - trk_curve_slope(curve, x + 2.0 * h) - 3.0 * d0);
    double left =
        (3.0 * d0 - 4.0 * trk_curve_slope(curve, x - h) + trk_curve_slope(curve, x - 2.0 * h));
    return (right - left) / (2.0 * h);
}

static void test_continuity(void **state)
{
    for (trk_interpolation kind = 0; kind < KINDS; kind++) {
        trk_curve *curve = new_damper(*state, kind);
        double value_jump = 0.0, slope_jump = 0.0, bend_jump = 0.0;
        for (int k = 1; k < DAMPER_POINTS - 1; k++) {
            double x = damper_x[k], left = nextafter(x, -1.0);
            value_jump = fmax(value_jump, fabs(trk_curve_value(curve, left) - damper_y[k]));
            slope_jump =
                fmax(slope_jump, fabs(trk_curve_slope(curve, left) - trk_curve_slope(curve, x)));
            bend_jump = fmax(bend_jump, fabs(curvature_jump(curve, x)));
        }
        int32_t c1 = kind != TRK_INTERPOLATION_LINEAR;
        int32_t c2 = kind == TRK_INTERPOLATION_NOT_A_KNOT || kind == TRK_INTERPOLATION_NATURAL;
        assert_near(value_jump, 0.0, 1e-11);
        assert_int_equal(slope_jump < 1e-9, c1); /* [N s/m], slopes are up to 20000 */
        assert_int_equal(bend_jump < 1e-3, c2);
        trk_curve_destroy(curve);
    }
}

static void test_natural_ends_are_straight(void **state)
{
    trk_curve *curve = new_damper(*state, TRK_INTERPOLATION_NATURAL);
    assert_near(curvature_jump(curve, -0.5), 0.0, 1e-3);
    double h = 1e-4, end = trk_curve_slope(curve, 0.5);
    assert_near((trk_curve_slope(curve, 0.5 - h) - end) / h, 0.0, 50.0); /* O(h) */
    trk_curve_destroy(curve);
}

static double sine_error(trk_context *context, trk_interpolation kind, int n)
{
    double x[161], y[161], worst = 0.0;
    for (int k = 0; k <= n; k++) {
        x[k] = 0.3 + 6.0 * k / n;
        y[k] = sin(x[k]);
    }
    trk_curve *curve = new_curve(context, n + 1, x, y, kind, 0);
    for (int k = 0; k <= 5000; k++) {
        double s = 0.3 + 6.0 * k / 5000.0;
        worst = fmax(worst, fabs(trk_curve_value(curve, s) - sin(s)));
    }
    trk_curve_destroy(curve);
    return worst;
}

/* PCHIP and Akima lose the fourth order where the slope or the curvature changes sign. */
static void test_order_of_convergence(void **state)
{
    const double order[KINDS] = {2.0, 4.0, 2.0, 2.0, 2.0};
    for (trk_interpolation kind = 0; kind < KINDS; kind++) {
        double found = log2(sine_error(*state, kind, 20) / sine_error(*state, kind, 160)) / 3.0;
        if (found < order[kind] - 0.15)
            fail_msg("%s: order %.2f, expected %.1f", kind_names[kind], found, order[kind]);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_values_of_scipy),
        cmocka_unit_test(test_points_are_met_exactly),
        cmocka_unit_test(test_polynomials_reproduced),
        cmocka_unit_test(test_continuity),
        cmocka_unit_test(test_natural_ends_are_straight),
        cmocka_unit_test(test_order_of_convergence),
    };
    return cmocka_run_group_tests(tests, support_setup, support_teardown);
}
