/* SPDX-License-Identifier: MIT */
/* Air spring (LAW.14) against its closed forms: shut, open, in between, and order of its steps. */
#include "support.h"

#include "law/law.h"

static const double pressure = 5.5e5, ambient = 101325, volume = 0.012, area = 0.045;

static trk_air_spring_options typical(void)
{
    trk_air_spring_options o;
    trk_air_spring_options_init(&o, sizeof o);
    o.pressure = pressure;
    o.volume = volume;
    o.area = area;
    o.area_slope = -0.08;
    return o;
}

static trk_law *make(trk_context *context, const trk_air_spring_options *o)
{
    trk_law *law;
    assert_ok(context, trk_law_create_air_spring(context, "bellows", o, &law));
    return law;
}

static trk_law_point move(const trk_law *law, double *z, double e, double h)
{
    trk_law_point point;
    double next[2];
    law->ops->evaluate(law, z, e, 0, h, &point, next);
    memcpy(z, next, sizeof next);
    return point;
}

static double volume_at(double e)
{
    return volume + area * e - 0.04 * e * e;
}

/* k = n p A^2 / V - (p - p_a) dA/de at e = 0. */
static void shut_it_is_a_polytropic_bellows(void **state)
{
    trk_air_spring_options o = typical();
    for (int auxiliary = 0; auxiliary < 2; auxiliary++) {
        o.auxiliary_volume = 0.02 * auxiliary;
        trk_law *law = make(*state, &o);
        double z[2];
        law->ops->relax(law, 0, z);
        trk_law_point p = move(law, z, 0, 0.001);
        assert_near(p.force, -(pressure - ambient) * area, 1e-9);
        double stiffness = 1.38 * pressure * area * area / volume + (pressure - ambient) * 0.08;
        assert_near(p.stiffness, stiffness, 1e-12 * stiffness);
        assert_near(p.damping, 0, 0);
        double most, none;
        law->ops->steepest(law, &most, &none);
        assert_near(most, stiffness, 1e-12 * stiffness);
        p = move(law, z, -0.05, 0.001);
        double there = pressure * pow(volume / volume_at(-0.05), 1.38);
        assert_near(p.force, -(there - ambient) * (area + 0.004), 1e-8);
        trk_law_destroy(law);
    }
}

/* A throttle that hardly resists makes both volumes one. */
static void open_it_has_both_volumes(void **state)
{
    trk_air_spring_options o = typical();
    o.auxiliary_volume = 0.02;
    o.conductance = 1;
    trk_law *law = make(*state, &o);
    double z[2], all = volume + 0.02;
    law->ops->relax(law, 0, z);
    for (int k = 1; k <= 100; k++)
        move(law, z, -0.0005 * k, 0.01);
    double there = pressure * pow(all / (volume_at(-0.05) + 0.02), 1.38);
    double force = -(there - ambient) * (area + 0.004);
    assert_near(move(law, z, -0.05, 0.01).force, force, 1e-4 * fabs(force));
    trk_law_point rest, flowing;
    law->ops->rest(law, -0.05, &rest);
    assert_near(rest.force, force, 1e-9 * fabs(force));
    double a = area + 0.004, v = volume_at(-0.05) + 0.02;
    double stiffness = 1.38 * there * a * a / v + (there - ambient) * 0.08;
    assert_near(rest.stiffness, stiffness, 1e-9 * stiffness);
    flowing = move(law, z, -0.05, 0.01);
    assert_near(flowing.stiffness, stiffness, 1e-3 * stiffness);
    trk_law_destroy(law);
}

/* A small step of e: the force falls from that of the bellows to that of both volumes as
 * exp(-t / tau), tau = 1 / (C n p (1 / m + 1 / m_a)) (LAW.14f). */
static void pressures_level_out(void **state)
{
    trk_air_spring_options o = typical();
    o.area_slope = 0;
    o.auxiliary_volume = 0.02;
    o.conductance = 1e-6;
    trk_law *law = make(*state, &o);
    double mass = pressure * volume / (287.05 * 293.15), other = mass * 0.02 / volume;
    double tau = 1 / (1e-6 * 1.38 * pressure * (1 / mass + 1 / other)), e = -1e-6, z[2];
    double quick = 1.38 * pressure * area * area / volume, slow = quick * volume / (volume + 0.02);
    law->ops->relax(law, 0, z);
    double before = move(law, z, 0, 0).force, force = move(law, z, e, 0).force;
    assert_near((force - before) / e, quick, 1e-4 * quick);
    for (int k = 0; k < 1000; k++)
        force = move(law, z, e, tau / 1000).force;
    assert_near((force - before) / e, slow + (quick - slow) * exp(-1), 1e-3 * quick);
    for (int k = 0; k < 5000; k++)
        force = move(law, z, e, tau / 100).force;
    assert_near((force - before) / e, slow, 1e-4 * quick);
    trk_law_destroy(law);
}

/* Whatever it went through, back at e = 0 it comes to rest with the mass it had. */
static void no_air_is_lost(void **state)
{
    trk_air_spring_options o = typical();
    o.auxiliary_volume = 0.02;
    o.conductance = 1e-5;
    trk_law *law = make(*state, &o);
    double z[2], start[2];
    law->ops->relax(law, 0, start);
    memcpy(z, start, sizeof z);
    for (int k = 0; k < 100000; k++)
        move(law, z, 0.1 * sin(0.03 * k) * cos(0.0071 * k), 0.001);
    assert_true(fabs(z[0] - start[0]) > 1e-3 * start[0]);
    for (int k = 0; k < 2000; k++)
        move(law, z, 0, 0.01);
    assert_near(z[0], start[0], 1e-13 * start[0]);
    assert_near(move(law, z, 0, 0.01).force, -(pressure - ambient) * area, 1e-8);
    trk_law_destroy(law);
}

/* Mass in the bellows after 0.9 s of a sine in a number of steps. */
static double mass_after(const trk_law *law, int steps)
{
    double z[2];
    law->ops->relax(law, 0, z);
    for (int k = 1; k <= steps; k++)
        move(law, z, 0.06 * sin(7 * 0.9 * k / steps), 0.9 / steps);
    return z[0];
}

static void steps_converge_with_order_two(void **state)
{
    trk_air_spring_options o = typical();
    o.auxiliary_volume = 0.02;
    o.conductance = 1e-6;
    trk_law *law = make(*state, &o);
    double exact = mass_after(law, 204800);
    double coarse = fabs(mass_after(law, 400) - exact), fine = fabs(mass_after(law, 800) - exact);
    assert_near(log2(coarse / fine), 2, 0.01);
    assert_true(coarse > 1e-10); /* a real difference, not rounding */
    trk_law_destroy(law);
}

/* Steps far longer than tau stay bounded and find the balance. */
static void long_steps_are_stable(void **state)
{
    trk_air_spring_options o = typical();
    o.auxiliary_volume = 0.02;
    o.conductance = 1e-3;
    trk_law *law = make(*state, &o);
    double z[2], rest[2];
    law->ops->relax(law, 0, z);
    for (int k = 0; k < 20; k++) {
        double force = move(law, z, k % 2 ? -0.08 : 0.08, 1).force;
        assert_true(force < 0 && z[0] > 0);
    }
    for (int k = 0; k < 20; k++)
        move(law, z, 0.02, 1e-3);
    law->ops->relax(law, 0.02, rest);
    assert_near(z[0], rest[0], 1e-3 * rest[0]);
    trk_law_destroy(law);
}

static void without_volume_or_area_there_is_no_force(void **state)
{
    trk_air_spring_options o = typical();
    trk_law *law = make(*state, &o);
    const double crushed[] = {0, -0.1, -0.3}, stretched[] = {0, 0.6};
    double force[3];
    assert_status(*state, trk_law_trace(*state, law, 3, 0.1, crushed, force, NULL), TRK_E_RANGE);
    assert_message(*state, "point 3");
    assert_status(*state, trk_law_trace(*state, law, 2, 0.1, stretched, force, NULL), TRK_E_RANGE);
    assert_message(*state, "'bellows' has no force at point 2, e = 0.6");
    assert_ok(*state, trk_law_trace(*state, law, 2, 0.1, crushed, force, NULL));
    trk_law_destroy(law);
}

#define TEST(f) cmocka_unit_test_setup_teardown(f, support_setup, support_teardown)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(shut_it_is_a_polytropic_bellows),
        TEST(open_it_has_both_volumes),
        TEST(pressures_level_out),
        TEST(no_air_is_lost),
        TEST(steps_converge_with_order_two),
        TEST(long_steps_are_stable),
        TEST(without_volume_or_area_there_is_no_force),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
