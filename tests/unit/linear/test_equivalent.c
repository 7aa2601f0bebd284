/* SPDX-License-Identifier: MIT */
/* Equivalents of curves and laws: closed forms. */
#include "support.h"

#include "linear/cycle.h"
#include "linear/equivalent.h"
#include "linear/gaussian.h"
#include "linear/kronrod.h"

#include <truckride/linear.h>

static const double pi = 3.14159265358979323846;

static double normal(double x)
{
    return 0.5 * erfc(-x * sqrt(0.5));
}

static double bell(double x)
{
    return exp(-0.5 * x * x) / sqrt(2 * pi);
}

/* Integral of a smooth function over a Gaussian: the trapezoidal rule is exact to rounding. */
static double expect(double (*f)(const void *data, double x), const void *data, double deviation,
                     double step)
{
    double sum = 0;
    for (double x = -9; x <= 9; x += step)
        sum += step * bell(x) * f(data, deviation * x);
    return sum;
}

static void test_rule(void **state)
{
    (void)state;
    for (int power = 0; power <= 22; power++) {
        double kronrod = 0, gauss = 0, exact = power % 2 ? 0 : 2.0 / (power + 1);
        for (int k = 0; k < TRK_KRONROD; k++) {
            kronrod += trk_kronrod[k].weight * pow(trk_kronrod[k].place, power);
            gauss += trk_kronrod[k].gauss * pow(trk_kronrod[k].place, power);
        }
        assert_near(kronrod, exact, 1e-15);
        if (power <= 13)
            assert_near(gauss, exact, 1e-15);
    }
}

static trk_curve *curve_of(trk_context *context, int count, const double *x, const double *y,
                           trk_interpolation interpolation, trk_extrapolation extrapolation)
{
    trk_curve *curve;
    trk_curve_options options;
    trk_curve_options_init(&options, sizeof options);
    options.interpolation = interpolation;
    options.extrapolation = extrapolation;
    assert_ok(context, trk_curve_create(context, "curve", count, x, y, &options, &curve));
    return curve;
}

/* A cubic y = 2 + 3 x - 5 x^2 + 7 x^3: E[y'] = 3 - 10 m + 21 (m^2 + s^2). */
static void test_cubic_curve(void **state)
{
    double x[41], y[41], value, slope;
    for (int k = 0; k <= 40; k++) {
        x[k] = k - 20 + 0.3 * (k % 3);
        y[k] = 2 + x[k] * (3 + x[k] * (-5 + x[k] * 7));
    }
    trk_curve *curve = curve_of(*state, 41, x, y, TRK_INTERPOLATION_NOT_A_KNOT, 0);
    for (double mean = -2; mean <= 2; mean += 0.4)
        for (double s = 1e-9; s < 1.6; s *= 4) {
            trk_gaussian_curve(curve, mean, s, &value, &slope);
            const double v = s * s, m = mean;
            assert_near(value, 2 + m * (3 + m * (-5 + m * 7)) + v * (-5 + 21 * m), 1e-10);
            assert_near(slope, 3 - 10 * m + 21 * (m * m + v), 1e-10);
        }
    trk_gaussian_curve(curve, 0.25, 0, &value, &slope);
    assert_true(value == trk_curve_value(curve, 0.25) && slope == trk_curve_slope(curve, 0.25));
    trk_curve_destroy(curve);
}

/* Limited force: E[y'] = (R / w) P(|x| < w); with w to 0 dry friction, R sqrt(2 / pi) / s. */
static void test_clamped_curve(void **state)
{
    for (double w = 1; w > 1e-7; w /= 10) {
        const double x[] = {-w, w}, y[] = {-300, 300};
        double value, slope;
        trk_curve *curve =
            curve_of(*state, 2, x, y, TRK_INTERPOLATION_LINEAR, TRK_EXTRAPOLATION_CLAMP);
        trk_gaussian_curve(curve, 0, 0.2, &value, &slope);
        assert_near(value, 0, 1e-12);
        assert_near(slope, 300 / w * erf(w / 0.2 * sqrt(0.5)), 1e-9 * slope);
        if (w < 1e-4)
            assert_near(slope, 300 * sqrt(2 / pi) / 0.2, 1e-6 * slope);
        /* off its middle: mean value of a limited ramp, by parts */
        trk_gaussian_curve(curve, 0.1, 0.2, &value, &slope);
        const double a = (-w - 0.1) / 0.2, b = (w - 0.1) / 0.2;
        assert_near(slope, 300 / w * (normal(b) - normal(a)), 1e-9 * slope);
        assert_near(value,
                    300 * (1 - normal(b) - normal(a)) +
                        300 / w * (0.1 * (normal(b) - normal(a)) + 0.2 * (bell(a) - bell(b))),
                    1e-7); /* rounding of 3e8 - 3e8 */
        trk_curve_destroy(curve);
    }
}

/* A damper table against the trapezoidal rule on 20000 points. */
static double table_slope(const void *curve, double x)
{
    return trk_curve_slope(curve, x);
}

static double table_value(const void *curve, double x)
{
    return trk_curve_value(curve, x);
}

/* A stop far away: what little it does is right to the last digits. */
static void test_tail(void **state)
{
    const double x[] = {0, 1, 2}, y[] = {0, 0, 1};
    trk_curve *curve = curve_of(*state, 3, x, y, TRK_INTERPOLATION_LINEAR, TRK_EXTRAPOLATION_SLOPE);
    double value, slope;
    for (double s = 0.1; s < 1; s *= 1.5) {
        trk_gaussian_curve(curve, 0, s, &value, &slope);
        assert_near(slope, normal(-1 / s), 1e-12 * normal(-1 / s));
    }
    trk_curve_destroy(curve);
}

static void test_table(void **state)
{
    const double x[] = {-1, -0.5, -0.2, -0.05, 0, 0.05, 0.2, 0.5, 1};
    const double y[] = {-4200, -2600, -1800, -900, 0, 2500, 6000, 9000, 14000};
    for (trk_interpolation i = TRK_INTERPOLATION_PCHIP; i <= TRK_INTERPOLATION_LINEAR; i++) {
        trk_curve *curve = curve_of(*state, 9, x, y, i, TRK_EXTRAPOLATION_SLOPE);
        for (double s = 0.01; s < 2; s *= 2.3) {
            double value, slope;
            trk_gaussian_curve(curve, 0, s, &value, &slope);
            assert_near(slope, expect(table_slope, curve, s, 1e-4), 2e-4 * slope);
            assert_near(value, expect(table_value, curve, s, 1e-4), 1e-7 * slope * s);
        }
        trk_curve_destroy(curve);
    }
}

static trk_equivalent equivalent_of(const trk_law *law, double mean, double e, double v)
{
    trk_equivalent out;
    const trk_link_law link = {.law = (trk_law *)law};
    assert_true(trk_link_equivalent(&link, mean, e, v, &out));
    return out;
}

/* A tire lifts off: E[max(0, k (d - e))] and its slope. */
static void test_tire(void **state)
{
    trk_tire_options o;
    trk_law *law;
    trk_tire_options_init(&o, sizeof o);
    o.stiffness = 1e6;
    o.preload = 30e3;
    assert_ok(*state, trk_law_create_tire(*state, "tire", &o, &law));
    for (double s = 0.003; s < 0.1; s *= 2) {
        const trk_equivalent t = equivalent_of(law, 0.004, s, 0.5);
        const double d = (0.03 - 0.004) / s;
        assert_near(t.stiffness, 1e6 * normal(d), 1e-8 * 1e6);
        assert_near(t.force, -1e6 * s * (d * normal(d) + bell(d)), 1e-8 * 30e3);
        assert_near(t.damping, 0, 1e-8 * 1e6 * s / 0.5);
        assert_true(t.slope == t.stiffness);
    }
    trk_law_destroy(law);
}

/* The same with damping, against a fine grid over both. */
static void test_damped_tire(void **state)
{
    trk_tire_options o;
    trk_law *law;
    trk_law_point point;
    trk_tire_options_init(&o, sizeof o);
    o.stiffness = 1e6;
    o.stiffening = 5e6;
    o.damping = 3e4;
    o.preload = 30e3;
    assert_ok(*state, trk_law_create_tire(*state, "tire", &o, &law));
    const double e = 0.02, v = 1.2, step = 5e-3;
    double force = 0, stiffness = 0, damping = 0;
    for (double x = -8; x < 8; x += step)
        for (double y = -8; y < 8; y += step) {
            const double share = step * step * bell(x) * bell(y);
            law->ops->evaluate(law, NULL, e * x, v * y, 0, &point, NULL);
            force += share * point.force;
            stiffness += share * point.force * x / e;
            damping += share * point.force * y / v;
        }
    const trk_equivalent t = equivalent_of(law, 0, e, v);
    assert_near(t.force, force, 1e-5 * 30e3);
    assert_near(t.stiffness, stiffness, 1e-5 * stiffness);
    assert_near(t.damping, damping, 1e-5 * damping);
    trk_law_destroy(law);
}

static void test_stops(void **state)
{
    trk_stops_options o;
    trk_law *law;
    trk_stops_options_init(&o, sizeof o);
    o.bump_clearance = 0.03;
    o.bump_stiffness = 2e6;
    o.rebound_clearance = 0.05;
    o.rebound_stiffness = 1e6;
    assert_ok(*state, trk_law_create_stops(*state, "stops", &o, &law));
    for (double s = 0.005; s < 0.1; s *= 2) {
        const trk_equivalent t = equivalent_of(law, 0, s, 0.4);
        assert_near(t.stiffness, 2e6 * normal(-0.03 / s) + 1e6 * normal(-0.05 / s), 1e-8 * 2e6);
    }
    trk_law_destroy(law);
}

static double seal_slope(const void *data, double v)
{
    const trk_law *law = data;
    trk_law_point point;
    law->ops->evaluate(law, NULL, 0, v, 0, &point, NULL);
    return point.damping;
}

static void test_seal(void **state)
{
    trk_seal_options o;
    trk_law *law;
    trk_seal_options_init(&o, sizeof o);
    o.sliding = 200;
    o.breakaway = 350;
    o.creep = 0.01;
    assert_ok(*state, trk_law_create_seal(*state, "seal", &o, &law));
    for (double s = 0.01; s < 2; s *= 3) {
        const double c = expect(seal_slope, law, s, fmin(1e-3, 1e-3 / s));
        assert_near(equivalent_of(law, 0.1, 0.02, s).damping, c, 1e-8 * c);
    }
    trk_law_destroy(law);
}

static trk_law *friction_of(trk_context *context, double friction, double stiffness)
{
    trk_friction_options o;
    trk_law *law;
    trk_friction_options_init(&o, sizeof o);
    o.friction = friction;
    o.stiffness = stiffness;
    assert_ok(context, trk_law_create_friction(context, "friction", &o, &law));
    return law;
}

/* Cycles of bilinear hysteresis (T. K. Caughey, J. Appl. Mech. 27 (1960) 640-643). */
static void test_friction_in_a_cycle(void **state)
{
    trk_law *law = friction_of(*state, 1000, 1e6);
    const double yield = 1e-3, f = 2;
    for (double a = 0.3e-3; a < 0.1; a *= 1.7) {
        double k, c;
        assert_ok(*state, trk_law_describe(*state, law, 0.01, a, f, &k, &c));
        const double angle = a > yield ? acos(1 - 2 * yield / a) : pi;
        const double stiffness = 1e6 / pi * (angle - 0.5 * sin(2 * angle));
        const double damping = a > yield ? 4 * 1000 * (a - yield) / (pi * a * a * 2 * pi * f) : 0;
        assert_near(k, stiffness, 1e-6 * 1e6);
        assert_near(c * 2 * pi * f, damping * 2 * pi * f, 1e-6 * 1e6);
    }
    trk_law_destroy(law);
}

/* Stiff enough it is Coulomb's: c = R sqrt(2 / pi) / s_v, and no stiffness. */
static void test_coulomb_friction(void **state)
{
    double before = 0;
    for (double stiffness = 1e7; stiffness < 2e9; stiffness *= 10) {
        trk_law *law = friction_of(*state, 1000, stiffness);
        const trk_equivalent t = equivalent_of(law, 0.02, 0.01, 0.3);
        const double c = 1000 * sqrt(2 / pi) / 0.3, error = fabs(t.damping / c - 1);
        print_message("stiffness %.0e: damping %+.1e, stiffness over R / s_e %.3g\n", stiffness,
                      t.damping / c - 1, t.stiffness * 0.01 / 1000);
        assert_true(error < 3 * 1000 / stiffness / 0.01);
        assert_true(t.slope == 0 && fabs(t.force) < 1e-3);
        assert_true(before == 0 || error < 0.4 * before);
        before = error;
        trk_law_destroy(law);
    }
}

/* Leaf spring: r = R - (R + r_m) exp(-(e + A) / b) upwards, r_m = R tanh(A / b) at the top. */
static void test_leaf_in_a_cycle(void **state)
{
    trk_leaf_options o;
    trk_law *law;
    trk_leaf_options_init(&o, sizeof o);
    o.friction = 2500;
    o.approach_bump = 2e-3;
    assert_ok(*state, trk_law_create_leaf(*state, "leaf", &o, &law));
    const double r = o.friction, b = o.approach_bump, omega = 2 * pi * 1.5;
    for (double a = 1e-6; a < 0.2; a *= 3) {
        double k, c, stiffness = 0;
        assert_ok(*state, trk_law_describe(*state, law, 0, a, 1.5, &k, &c));
        const double top = r * tanh(a / b);
        const double loss = 2 * (2 * a * r + (r + top) * b * expm1(-2 * a / b));
        /* rounding of 2 a r - ..., a difference of third order in a / b */
        assert_near(c * omega, loss / (pi * a * a), 3e-6 * r / b);
        const int points = 20000; /* both ways give the same: twice the one upwards */
        for (int j = 0; j < points; j++) {
            const double angle = pi * (j + 0.5) / points, e = -a * cos(angle);
            stiffness += 2 * (r - (r + top) * exp(-(e + a) / b)) * -cos(angle) / points / a;
        }
        assert_near(k, stiffness, 1e-5 * r / b);
    }
    trk_law_destroy(law);
}

/* Air spring with an auxiliary volume, small motion: a stiffness between two, and its loss. */
static void test_air_spring_in_a_cycle(void **state)
{
    trk_air_spring_options o;
    trk_law *law;
    trk_air_spring_options_init(&o, sizeof o);
    o.pressure = 6e5;
    o.volume = 0.008;
    o.area = 0.03;
    o.auxiliary_volume = 0.006;
    o.conductance = 4e-7;
    assert_ok(*state, trk_law_create_air_spring(*state, "air", &o, &law));
    const double mass = o.pressure * o.volume / (287.05 * o.temperature);
    const double extra = mass * o.auxiliary_volume / o.volume;
    for (double f = 0.05; f < 30; f *= 3) {
        const double omega = 2 * pi * f, k0 = o.exponent * o.pressure * o.area * o.area / o.volume;
        /* dm = g (dV / V) / (i w + g (1 / m + 1 / m_a)), g = conductance p n */
        const double g = o.conductance * o.pressure * o.exponent, h = g * (1 / mass + 1 / extra);
        const double share = g / mass / (omega * omega + h * h);
        double k, c;
        assert_ok(*state, trk_law_describe(*state, law, 0, 1e-5, f, &k, &c));
        assert_near(k, k0 * (1 - share * h), 1e-4 * k0);
        assert_near(c * omega, k0 * share * omega, 1e-4 * k0);
    }
    trk_law_destroy(law);
}

static double air_slope(const void *data, double e)
{
    const trk_law *law = data;
    trk_law_point point;
    law->ops->rest(law, 0.01 + e, &point);
    return point.stiffness;
}

static void test_closed_air_spring(void **state)
{
    trk_air_spring_options o;
    trk_law *law;
    trk_air_spring_options_init(&o, sizeof o);
    o.pressure = 6e5;
    o.volume = 0.009;
    o.area = 0.03;
    assert_ok(*state, trk_law_create_air_spring(*state, "air", &o, &law));
    const double k = expect(air_slope, law, 0.02, 0.01);
    const trk_equivalent t = equivalent_of(law, 0.01, 0.02, 0.3);
    assert_near(t.stiffness, k, 1e-6 * k);
    /* more than the bellows has */
    trk_equivalent out;
    const trk_link_law link = {.law = law};
    assert_false(trk_link_equivalent(&link, 0, 0.2, 1, &out));
    trk_law_destroy(law);
}

/* Little motion gives the tangents, friction sticking; none at all just these. */
static void test_small_motion(void **state)
{
    trk_law *law = friction_of(*state, 1000, 1e6);
    for (double s = 0; s<1e-6; s = s> 0 ? 100 * s : 1e-16) {
        const trk_equivalent t = equivalent_of(law, 0.02, s, 30 * s);
        assert_near(t.stiffness, 1e6, 1e-6 * 1e6);
        assert_near(t.damping * 30, 0, 1e-6 * 1e6);
    }
    trk_law_destroy(law);
}

static void test_describe_errors(void **state)
{
    trk_law *law = friction_of(*state, 1000, 1e6);
    double k, c;
    assert_ok(*state, trk_law_describe(*state, law, 0, 0.01, 1, NULL, NULL));
    assert_status(NULL, trk_law_describe(NULL, law, 0, 0.01, 1, &k, &c), TRK_E_ARGUMENT);
    assert_status(*state, trk_law_describe(*state, NULL, 0, 0.01, 1, &k, &c), TRK_E_ARGUMENT);
    assert_status(*state, trk_law_describe(*state, law, NAN, 0.01, 1, &k, &c), TRK_E_RANGE);
    assert_status(*state, trk_law_describe(*state, law, 0, 0, 1, &k, &c), TRK_E_RANGE);
    assert_status(*state, trk_law_describe(*state, law, 0, INFINITY, 1, &k, &c), TRK_E_RANGE);
    assert_status(*state, trk_law_describe(*state, law, 0, 0.01, -1, &k, &c), TRK_E_RANGE);
    trk_law_destroy(law);
    trk_air_spring_options o;
    trk_air_spring_options_init(&o, sizeof o);
    o.pressure = 6e5;
    o.volume = 0.009;
    o.area = 0.03;
    assert_ok(*state, trk_law_create_air_spring(*state, "air", &o, &law));
    assert_status(*state, trk_law_describe(*state, law, 0, 0.4, 1, &k, &c), TRK_E_RANGE);
    assert_message(*state, "leaves what 'air' can do");
    trk_law_destroy(law);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_rule),
        cmocka_unit_test(test_cubic_curve),
        cmocka_unit_test(test_clamped_curve),
        cmocka_unit_test(test_tail),
        cmocka_unit_test(test_table),
        cmocka_unit_test(test_tire),
        cmocka_unit_test(test_damped_tire),
        cmocka_unit_test(test_stops),
        cmocka_unit_test(test_seal),
        cmocka_unit_test(test_friction_in_a_cycle),
        cmocka_unit_test(test_coulomb_friction),
        cmocka_unit_test(test_leaf_in_a_cycle),
        cmocka_unit_test(test_air_spring_in_a_cycle),
        cmocka_unit_test(test_closed_air_spring),
        cmocka_unit_test(test_small_motion),
        cmocka_unit_test(test_describe_errors),
    };
    return cmocka_run_group_tests(tests, support_setup, support_teardown);
}
