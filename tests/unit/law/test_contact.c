/* SPDX-License-Identifier: MIT */
/* Laws without memory against numbers worked out by hand: tire (LAW.10), stops (LAW.11), seal
 * (LAW.15); and dry friction (LAW.13). */
#include "support.h"

#include "law/law.h"

static trk_law_point at(const trk_law *law, double e, double v)
{
    trk_law_point point;
    law->ops->evaluate(law, NULL, e, v, 0.001, &point, NULL);
    return point;
}

static trk_law *tire(trk_context *context, double stiffening, double preload)
{
    trk_tire_options o;
    trk_law *law;
    trk_tire_options_init(&o, sizeof o);
    o.stiffness = 1e6;
    o.stiffening = stiffening;
    o.damping = 500;
    o.preload = preload;
    assert_ok(context, trk_law_create_tire(context, "tire", &o, &law));
    return law;
}

static void tire_carries_its_preload(void **state)
{
    trk_law *law = tire(*state, 0, 30e3);
    trk_law_point p = at(law, 0, 0);
    assert_near(p.force, -30e3, 1e-9);
    assert_near(p.stiffness, 1e6, 0);
    assert_near(p.damping, 500, 0);
    assert_near(at(law, -0.01, -0.4).force, -40e3 - 200, 1e-9);
    assert_near(law->ops->stored(law, NULL, 0), 30e3 * 0.03 / 2, 1e-9);
    assert_near(law->ops->lost(law, NULL, 0, 0.4), 500 * 0.16, 1e-9);
    trk_law_destroy(law);
    law = tire(*state, 5e6, 30e3); /* 1e6 d + 5e6 d^2 = 30e3 */
    double d = (-1e6 + sqrt(1e12 + 4 * 5e6 * 30e3)) / 1e7, slope, none;
    p = at(law, 0, 0);
    assert_near(p.force, -30e3, 1e-8);
    assert_near(p.stiffness, 1e6 + 1e7 * d, 1e-4);
    law->ops->steepest(law, &slope, &none);
    assert_near(slope, p.stiffness, 1e-4);
    assert_near(none, 500, 0);
    trk_law_destroy(law);
}

static void tire_lifts_off_and_never_pulls(void **state)
{
    trk_law *law = tire(*state, 0, 30e3);
    for (int k = -100; k <= 100; k++)
        for (int j = -100; j <= 100; j++) {
            double e = 0.0007 * k, v = 0.5 * j;
            trk_law_point p = at(law, e, v);
            assert_true(p.force <= 0);
            if (e >= 0.03) {
                assert_near(p.force, 0, 0);
                assert_near(p.stiffness, 0, 0);
            }
        }
    assert_near(at(law, 0.0299, 10).force, 0, 0);
    assert_near(at(law, 0.0299, -10).force, -200, 1e-6); /* twice the spring's, not 5100 */
    assert_near(at(law, 0.03 - 1e-12, -10).force, 0, 1e-5);
    assert_near(law->ops->stored(law, NULL, 0.1), 0, 0);
    trk_law_destroy(law);
}

/* Bump: 2e5 N/m after 40 mm and a rubber of x^2; rebound: 5e5 N/m after 30 mm. */
static trk_law *stops(trk_context *context)
{
    const double x[] = {-0.01, 0, 0.01, 0.02}, y[] = {-500, 0, 1000, 3000};
    trk_curve_options c;
    trk_stops_options o;
    trk_curve *curve;
    trk_law *law;
    trk_curve_options_init(&c, sizeof c);
    c.interpolation = TRK_INTERPOLATION_LINEAR;
    assert_ok(context, trk_curve_create(context, "rubber", 4, x, y, &c, &curve));
    trk_stops_options_init(&o, sizeof o);
    o.bump_clearance = 0.04;
    o.bump_stiffness = 2e5;
    o.bump_curve = curve;
    o.rebound_clearance = 0.03;
    o.rebound_stiffness = 5e5;
    assert_ok(context, trk_law_create_stops(context, "stops", &o, &law));
    trk_curve_destroy(curve);
    return law;
}

static void stops_act_beyond_their_clearance(void **state)
{
    trk_law *law = stops(*state);
    for (int k = -40; k <= 30; k++) {
        trk_law_point p = at(law, 0.001 * k * (1 - 1e-12), 1);
        assert_near(p.force, 0, 0);
        assert_near(p.stiffness, 0, 0);
    }
    trk_law_point bump = at(law, -0.055, 0), rebound = at(law, 0.034, 0);
    assert_near(bump.force, -(2e5 * 0.015 + 2000), 1e-8);
    assert_near(bump.stiffness, 2e5 + 2e5, 1e-6);
    assert_near(rebound.force, 5e5 * 0.004, 1e-8);
    assert_near(rebound.stiffness, 5e5, 0);
    assert_near(at(law, -0.065, 0).force, -(2e5 * 0.025 + 4000), 1e-8); /* beyond the curve */
    double energy = 2e5 * 0.015 * 0.015 / 2 + 0.01 * 500 + 0.005 * 1500;
    assert_near(law->ops->stored(law, NULL, -0.055), energy, 1e-10);
    assert_near(law->ops->stored(law, NULL, 0.034), 5e5 * 0.004 * 0.004 / 2, 1e-10);
    assert_near(law->ops->lost(law, NULL, -0.055, 1), 0, 0);
    double most, none;
    law->ops->steepest(law, &most, &none);
    assert_near(most, 5e5, 1e-6);
    trk_law_destroy(law);
}

static void seal_follows_stribeck(void **state)
{
    trk_seal_options o;
    trk_law *law;
    trk_seal_options_init(&o, sizeof o);
    o.sliding = 40;
    o.breakaway = 90;
    assert_ok(*state, trk_law_create_seal(*state, "seal", &o, &law));
    assert_near(at(law, 0, 0).force, 0, 0);
    assert_near(at(law, 0, 0).damping, 90 / 0.001, 1e-9);
    assert_near(at(law, 0, 0.001).force, (40 + 50 * exp(-1e-4)) * tanh(1), 1e-12);
    assert_near(at(law, 0, 0.02).force, 40 + 50 * exp(-0.04), 1e-12);
    assert_near(at(law, 0, -0.1).force, -(40 + 50 * exp(-1)), 1e-12);
    assert_near(at(law, 0, 1e200).force, 40, 0); /* and no NaN far away */
    assert_near(at(law, 0, 1e200).damping, 0, 0);
    assert_near(law->ops->lost(law, NULL, 0, 2), 80, 1e-12);
    trk_law_destroy(law);
}

static void friction_sticks_and_slides(void **state)
{
    trk_friction_options o;
    trk_law *law;
    trk_friction_options_init(&o, sizeof o);
    o.friction = 800;
    o.stiffness = 4e5; /* slides after 2 mm */
    assert_ok(*state, trk_law_create_friction(*state, "dry", &o, &law));
    const double e[] = {0, 0.001, 0.005, 0.003, 0.0, 0.002};
    const double expected[] = {0, 400, 800, 0, -800, 0};
    const double heat[] = {0, 0, 800 * 0.003, 800 * 0.003, 800 * 0.004, 800 * 0.004};
    double force[6], lost[6];
    assert_ok(*state, trk_law_trace(*state, law, 6, 0.1, e, force, lost));
    for (int k = 0; k < 6; k++) {
        assert_near(force[k], expected[k], 1e-9);
        assert_near(lost[k], heat[k], 2e-3); /* sliding begins within a piece of a step */
    }
    double z[2] = {800, 0.005}, next[2];
    trk_law_point p;
    law->ops->evaluate(law, z, 0.005, 1, 0.001, &p, next); /* at a standstill it sticks */
    assert_near(p.stiffness, 4e5, 0);
    law->ops->evaluate(law, z, 0.0051, 1, 0.001, &p, next);
    assert_near(p.stiffness, 0, 0);
    assert_near(law->ops->lost(law, next, 0.0051, 0.5), 400, 0);
    assert_near(law->ops->lost(law, next, 0.0051, -0.5), 0, 0);
    assert_near(law->ops->stored(law, next, 0.0051), 800 * 800 / 8e5, 1e-12);
    trk_law_destroy(law);
}

#define TEST(f) cmocka_unit_test_setup_teardown(f, support_setup, support_teardown)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(tire_carries_its_preload),         TEST(tire_lifts_off_and_never_pulls),
        TEST(stops_act_beyond_their_clearance), TEST(seal_follows_stribeck),
        TEST(friction_sticks_and_slides),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
