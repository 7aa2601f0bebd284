/* SPDX-License-Identifier: MIT */
/* Inter-leaf friction (LAW.12) against closed forms, and whatever the steps. */
#include "support.h"

#include "law/law.h"

static trk_leaf_options typical(void)
{
    trk_leaf_options o;
    trk_leaf_options_init(&o, sizeof o);
    o.friction = 2500;
    o.approach_bump = 0.002;
    return o;
}

static trk_law *make(trk_context *context, const trk_leaf_options *o)
{
    trk_law *law;
    assert_ok(context, trk_law_create_leaf(context, "leaf", o, &law));
    return law;
}

/* Force after a move from z, committed. */
static double move(const trk_law *law, double *z, double e)
{
    trk_law_point point;
    double next[2];
    law->ops->evaluate(law, z, e, 0, 0.001, &point, next);
    memcpy(z, next, sizeof next);
    return point.force;
}

static void approaches_exponentially(void **state)
{
    trk_leaf_options o = typical();
    trk_law *law = make(*state, &o);
    double z[2], length = 3 * 0.002;
    law->ops->relax(law, 0.01, z);
    assert_near(move(law, z, 0.01 + length), 2500 * (1 - exp(-3)), 1e-9);
    double r = z[0];
    assert_near(move(law, z, 0.01), -2500 + (r + 2500) * exp(-3), 1e-9);
    assert_near(move(law, z, 1), 2500, 1e-9);
    trk_law_destroy(law);
}

/* A large cycle settles to +-R tanh(amplitude / beta) at its ends. */
static void cycle_has_its_known_ends(void **state)
{
    trk_leaf_options o = typical();
    trk_law *law = make(*state, &o);
    double z[2], amplitude = 0.0015, top = 0, bottom = 0;
    law->ops->relax(law, 0, z);
    for (int turn = 0; turn < 40; turn++) {
        top = move(law, z, amplitude);
        bottom = move(law, z, -amplitude);
    }
    assert_near(top, 2500 * tanh(amplitude / 0.002), 1e-9);
    assert_near(bottom, -top, 1e-9);
    trk_law_destroy(law);
}

/* With R growing in compression: r = T + s beta + (r_0 - T_0 - s beta) exp(-x / beta), and the same
 * by many small steps of a plain integration. */
static void growing_friction_follows_its_equation(void **state)
{
    trk_leaf_options o = typical();
    o.friction_slope = 40e3;
    o.approach_rebound = 0.003;
    trk_law *law = make(*state, &o);
    double z[2] = {700, 0.02}, e = 0.02, r = 700;
    const int steps = 200000;
    for (int k = 0; k < steps; k++) { /* midpoint rule, compressing to -0.03 */
        double de = -0.05 / steps;
        double half = r + de / 2 * (2500 - 40e3 * e + r) / 0.002;
        r += de * (2500 - 40e3 * (e + de / 2) + half) / 0.002;
        e += de;
    }
    assert_near(move(law, z, -0.03), r, 1e-5);
    double target = -(2500 + 40e3 * 0.03), start = -(2500 - 40e3 * 0.02), lag = 40e3 * 0.002;
    assert_near(z[0], target + lag + (700 - start - lag) * exp(-0.05 / 0.002), 1e-9);
    trk_law_destroy(law);
}

static void steps_do_not_matter(void **state)
{
    trk_leaf_options o = typical();
    o.friction_slope = 40e3;
    o.approach_rebound = 0.005;
    trk_law *law = make(*state, &o);
    const double ends[] = {-0.02, 0.08, 0.03, 0.0301, -0.01, 0.07, 0.065, 0.2, -0.1};
    double once[2], cut[2], e = 0.01;
    law->ops->relax(law, e, once);
    law->ops->relax(law, e, cut);
    for (int k = 0; k < 9; k++) {
        move(law, once, ends[k]);
        for (int part = 1; part <= 1000; part++)
            move(law, cut, part == 1000 ? ends[k] : e + (ends[k] - e) * part / 1000);
        e = ends[k];
        assert_near(cut[0], once[0], 1e-12 * 2500);
    }
    trk_law_destroy(law);
}

/* Beyond e = friction / slope nothing is left, or R_0 if approaches differ. */
static void width_has_a_floor(void **state)
{
    trk_leaf_options o = typical();
    o.friction_slope = 40e3;
    trk_law *law = make(*state, &o);
    double z[2] = {1000, 0.0625};
    assert_near(move(law, z, 0.0645), 1000 * exp(-1), 1e-9);
    trk_law_destroy(law);
    o.approach_rebound = 0.006;
    law = make(*state, &o);
    law->ops->relax(law, 0.07, z);
    assert_near(move(law, z, 0.3), 40e3 * 0.004 / 2, 1e-9);
    trk_law_destroy(law);
}

/* Tangents: the mean of both directions while still, R / beta of a relaxed leaf. */
static void sticks_at_a_standstill(void **state)
{
    trk_leaf_options o = typical();
    trk_law *law = make(*state, &o);
    double z[2], next[2], most, none;
    trk_law_point p;
    law->ops->relax(law, 0.01, z);
    law->ops->evaluate(law, z, 0.01, 0.3, 0.001, &p, next);
    assert_near(p.stiffness, 2500 / 0.002, 1e-6);
    assert_near(p.damping, 0, 0);
    z[0] = 2400; /* nearly sliding: the tangent of letting go is twice that */
    law->ops->evaluate(law, z, 0.01, 0, 0.001, &p, next);
    assert_near(p.stiffness, 2500 / 0.002, 1e-6);
    law->ops->evaluate(law, z, 0.01 - 1e-12, 0, 0.001, &p, next);
    assert_near(p.stiffness, 4900 / 0.002, 1);
    law->ops->evaluate(law, z, 0.01 + 1e-12, 0, 0.001, &p, next);
    assert_near(p.stiffness, 100 / 0.002, 1);
    law->ops->steepest(law, &most, &none);
    assert_near(most, 5000 / 0.002, 1e-6);
    trk_law_destroy(law);
}

/* Energy of r > 0: beta (r - R ln(1 + r / R)), given back in full by letting go; then what a loop of
 * the settled cycle takes, 4 R (A - beta tanh(A / beta)). */
static void energy_comes_back(void **state)
{
    trk_leaf_options o = typical();
    trk_law *law = make(*state, &o);
    double z[2] = {1500, 0.01};
    double back = 0.002 * (1500 - 2500 * log(1 + 1500 / 2500.0));
    assert_near(law->ops->stored(law, z, 0.01), back, 1e-12);
    assert_near(law->ops->lost(law, z, 0.01, -0.2), 0, 0);
    assert_near(law->ops->lost(law, z, 0.01, 0.2), 0.2 * 2 * 1500 * 1500 / 4000.0, 1e-9);
    enum { COUNT = 4 * 40 * 20 + 1 };
    static double e[COUNT], force[COUNT], lost[COUNT];
    double amplitude = 0.0015;
    for (int k = 0; k < COUNT; k++) {
        double phase = fmod(k / 40.0, 4);
        e[k] = amplitude * (phase < 1 ? phase : phase < 3 ? 2 - phase : phase - 4);
    }
    assert_ok(*state, trk_law_trace(*state, law, COUNT, 0.01, e, force, lost));
    double loop = 4 * 2500 * (amplitude - 0.002 * tanh(amplitude / 0.002));
    assert_near(lost[COUNT - 1] - lost[COUNT - 161], loop, 1e-9 * loop);
    trk_law_destroy(law);
}

#define TEST(f) cmocka_unit_test_setup_teardown(f, support_setup, support_teardown)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(approaches_exponentially),
        TEST(cycle_has_its_known_ends),
        TEST(growing_friction_follows_its_equation),
        TEST(steps_do_not_matter),
        TEST(width_has_a_floor),
        TEST(sticks_at_a_standstill),
        TEST(energy_comes_back),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
