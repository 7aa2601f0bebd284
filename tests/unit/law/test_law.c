/* SPDX-License-Identifier: MIT */
/* Force law (LAW.1), (LAW.2) against numbers worked out by hand. */
#include "support.h"

#include "law/link_law.h"

static trk_curve *line(trk_context *context, double slope)
{
    const double x[] = {-1, 0, 1}, y[] = {-slope, 0, slope};
    trk_curve *curve;
    assert_ok(context, trk_curve_create(context, "line", 3, x, y, NULL, &curve));
    return curve;
}

static void linear_law(void **state)
{
    (void)state;
    trk_link_law law = {.stiffness = 1000, .damping = 20, .spring_scale = 1, .damper_scale = 1};
    assert_true(trk_link_law_is_linear(&law));
    assert_near(trk_link_law_force(&law, 0.5, -2), 460, 0);
    trk_law_hint hint = {0, 0};
    trk_law_point g;
    trk_link_law_evaluate(&law, 0.5, -2, &hint, &g);
    assert_near(g.force, 0, 0);
    assert_near(g.stiffness, 0, 0);
    assert_near(g.damping, 0, 0);
}

static void curves_add_with_scale_offset_and_rest(void **state)
{
    trk_link_law law = {.stiffness = 1000,
                        .damping = 20,
                        .spring_scale = 2,
                        .damper_scale = 3,
                        .spring_offset = 0.25,
                        .rest = 7};
    law.spring = line(*state, 100);
    law.damper = line(*state, 10);
    assert_false(trk_link_law_is_linear(&law));
    trk_law_hint hint = {0, 0};
    trk_law_point g;
    trk_link_law_evaluate(&law, 0.5, -0.5, &hint, &g);
    assert_near(g.force, 2 * 100 * 0.75 + 3 * 10 * -0.5 - 7, 1e-12);
    assert_near(g.stiffness, 200, 1e-12);
    assert_near(g.damping, 30, 1e-12);
    assert_near(trk_link_law_force(&law, 0.5, -0.5), 500 - 10 + g.force, 1e-12);
    trk_curve_destroy(law.spring);
    law.spring = NULL;
    assert_false(trk_link_law_is_linear(&law));
    trk_curve_destroy(law.damper);
}

static void zero_scale_switches_a_curve_off(void **state)
{
    trk_link_law law = {.spring_scale = 0, .damper_scale = 0};
    law.spring = law.damper = line(*state, 1e6);
    assert_near(trk_link_law_force(&law, 3, 4), 0, 0);
    trk_curve_destroy(law.spring);
}

#define TEST(f) cmocka_unit_test_setup_teardown(f, support_setup, support_teardown)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(linear_law),
        TEST(curves_add_with_scale_offset_and_rest),
        TEST(zero_scale_switches_a_curve_off),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
