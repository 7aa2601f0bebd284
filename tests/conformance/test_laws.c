/* SPDX-License-Identifier: MIT */
/*
 * What every force law must obey, on every built-in table in every interpolation: tangents are
 * derivatives, results do not depend on the hint, a closed cycle of a damper takes energy out
 * and one of a spring none.
 */
#include "support.h"

#include "law/link_law.h"
#include <truckride/vehicle.h>

enum { TABLES = TRK_TABLE_REFERENCE_REAR_CAB_DAMPER };

static const double two_pi = 6.283185307179586476925286766559;

static bool is_damper(trk_table table)
{
    return table <= TRK_TABLE_REFERENCE_AXLE_DAMPER ||
           table >= TRK_TABLE_REFERENCE_FRONT_CAB_DAMPER;
}

/* The table as a law; interpolation -1 is the table's own. */
static trk_link_law make(trk_context *context, trk_table table, trk_interpolation interpolation)
{
    trk_curve_options options;
    trk_curve_options_init(&options, sizeof options);
    options.interpolation = interpolation;
    trk_curve *curve;
    assert_ok(context, trk_vehicle_create_curve(context, table, interpolation < 0 ? NULL : &options,
                                                &curve));
    trk_link_law law = {.stiffness = 1e5,
                        .damping = 1e3,
                        .spring_scale = 1.25,
                        .damper_scale = 0.75,
                        .spring_offset = 0.001,
                        .rest = 10};
    if (is_damper(table))
        law.damper = curve;
    else
        law.spring = curve;
    return law;
}

static void drop(trk_link_law *law)
{
    trk_curve_destroy(law->spring);
    trk_curve_destroy(law->damper);
}

/* For every law: table, its argument's range a bit beyond the table. */
typedef void (*check)(const trk_link_law *law, trk_table table, double low, double high);

static void for_each(trk_context *context, check work)
{
    for (trk_table table = 1; table <= TABLES; table++)
        for (trk_interpolation i = -1; i <= TRK_INTERPOLATION_LINEAR; i++) {
            trk_link_law law = make(context, table, i);
            const trk_curve *curve = law.damper ? law.damper : law.spring;
            const double *x = trk_curve_x(curve);
            double first = x[0], last = x[trk_curve_count(curve) - 1], more = 0.2 * (last - first);
            work(&law, table, first - more, last + more);
            drop(&law);
        }
}

/* Distance to the nearest corner of the law, where a central difference means nothing. */
static double to_corner(const trk_link_law *law, double x)
{
    const trk_curve *curve = law->damper ? law->damper : law->spring;
    double nearest = INFINITY, place = law->damper ? x : x + law->spring_offset;
    for (int64_t k = 0; k < trk_curve_count(curve); k++)
        nearest = fmin(nearest, fabs(trk_curve_x(curve)[k] - place));
    return nearest;
}

static void tangents_hold(const trk_link_law *law, trk_table table, double low, double high)
{
    double h = 1e-5 * (high - low);
    for (int k = 0; k < 400; k++) {
        double x = low + (high - low) * (k + 0.37) / 400, e = x, v = x;
        if (to_corner(law, x) < 2 * h)
            continue;
        trk_law_hint hint = {0, 0};
        trk_law_point g;
        trk_link_law_evaluate(law, e, v, &hint, &g);
        double de =
            (trk_link_law_force(law, e + h, v) - trk_link_law_force(law, e - h, v)) / (2 * h);
        double dv =
            (trk_link_law_force(law, e, v + h) - trk_link_law_force(law, e, v - h)) / (2 * h);
        double scale = fabs(law->stiffness) + fabs(g.stiffness) + fabs(g.damping);
        assert_near(law->stiffness + g.stiffness, de, 1e-4 * scale);
        assert_near(law->damping + g.damping, dv, 1e-4 * scale);
        (void)table;
    }
}

static void tangents_are_derivatives(void **state)
{
    for_each(*state, tangents_hold);
}

static void hints_do_not_matter(const trk_link_law *law, trk_table table, double low, double high)
{
    const trk_curve *curve = law->damper ? law->damper : law->spring;
    int32_t count = (int32_t)trk_curve_count(curve);
    (void)table;
    for (int k = 0; k < 60; k++) {
        double x = low + (high - low) * k / 59;
        trk_law_hint none = {0, 0};
        trk_law_point expected, got;
        trk_link_law_evaluate(law, x, x, &none, &expected);
        for (int32_t h = 0; h <= count; h++) {
            trk_law_hint hint = {h, h};
            for (int again = 0; again < 2; again++) {
                trk_link_law_evaluate(law, x, x, &hint, &got);
                assert_memory_equal(&got, &expected, sizeof got);
            }
        }
        assert_near(trk_link_law_force(law, x, x),
                    law->stiffness * x + law->damping * x + got.force, 0);
    }
}

static void results_do_not_depend_on_the_hint(void **state)
{
    for_each(*state, hints_do_not_matter);
}

/* Work of g done on the link over e = a sin, v = a w cos, by the rectangle rule over a period. */
static double cycle_work(const trk_link_law *law, double e_amplitude, double v_amplitude)
{
    enum { STEPS = 2000 };
    double work = 0;
    trk_law_hint hint = {0, 0};
    for (int k = 0; k < STEPS; k++) {
        double angle = two_pi * (k + 0.5) / STEPS;
        double v = v_amplitude * cos(angle);
        trk_law_point g;
        trk_link_law_evaluate(law, e_amplitude * sin(angle), v, &hint, &g);
        work += g.force * v / STEPS;
    }
    return work;
}

static void cycles_take_energy(const trk_link_law *law, trk_table table, double low, double high)
{
    double reach = fmax(-low, high);
    for (int k = 1; k <= 20; k++) {
        double amplitude = reach * k / 20;
        double work = cycle_work(law, amplitude, amplitude);
        double scale = fabs(trk_link_law_force(law, amplitude, amplitude)) * amplitude;
        if (is_damper(table))
            assert_true(work > -1e-12 * scale);
        else
            assert_near(work, 0, 1e-3 * scale);
    }
}

static void closed_cycles_dissipate(void **state)
{
    for_each(*state, cycles_take_energy);
}

/* Stronger, for the table's own interpolation: never a push, at no velocity. */
static void dampers_oppose_motion(void **state)
{
    for (trk_table table = 1; table <= TABLES; table++) {
        if (!is_damper(table))
            continue;
        trk_link_law law = make(*state, table, -1);
        law.rest = 0;
        law.stiffness = law.damping = 0;
        for (int k = -1000; k <= 1000; k++)
            assert_true(trk_link_law_force(&law, 0, k * 0.003) * k >= 0);
        assert_near(trk_link_law_force(&law, 0, 0), 0, 0);
        drop(&law);
    }
}

#define TEST(f) cmocka_unit_test_setup_teardown(f, support_setup, support_teardown)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(tangents_are_derivatives),
        TEST(results_do_not_depend_on_the_hint),
        TEST(closed_cycles_dissipate),
        TEST(dampers_oppose_motion),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
