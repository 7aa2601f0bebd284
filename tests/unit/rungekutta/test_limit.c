/* SPDX-License-Identifier: MIT */
/* Needs LAPACK. The limit of stability: exact where known, sharp on random chains, told in refusals. */
#include "support.h"
#include "vehicles.h"

#include "linalg/complex.h"
#include "rungekutta/limit.h"
#include "rungekutta/rungekutta.h"

static double limit_of(trk_context *context, const trk_model *model, int32_t *link)
{
    double limit;
    assert_ok(context, trk_rungekutta_find_limit(context, model, &limit, link));
    return limit;
}

static void test_known_limits(void **state)
{
    /* One spring: omega h = 2 sqrt(2). One damper: c h / m = 2.7852935634. */
    trk_model *model = support_oscillator(*state, 2, 800, 0);
    int32_t link = 0;
    assert_near(limit_of(*state, model, &link), sqrt(8) / 20, 1e-9);
    assert_int_equal(link, 1);
    trk_model_destroy(model);
    model = support_oscillator(*state, 2, 1e-9, 800);
    assert_near(limit_of(*state, model, &link), 2.7852935634052818 / 400, 1e-9);
    trk_model_destroy(model);
    assert_true(isinf(trk_rungekutta_stable_step(0)));
    /* 1 + z + z^2/2 + z^3/6 + z^4/24 on the ray through -1 + i: |R| = 1 */
    double complex z = trk_complex(-1, 1) * trk_rungekutta_stable_step(trk_complex(-1, 1));
    assert_near(cabs(1 + z + z * z / 2 + z * z * z / 6 + z * z * z * z / 24), 1, 1e-9);
}

/* A chain of n masses from ground, all numbers at random over a decade; the same in every run. */
static trk_model *random_chain(trk_context *context, int32_t n, uint32_t *seed)
{
    trk_spec *spec;
    trk_body_options body;
    trk_link_options link;
    assert_ok(context, trk_spec_create(context, "chain", &spec));
    trk_body_options_init(&body, sizeof body);
    trk_link_options_init(&link, sizeof link);
    double number[3];
    for (int32_t k = 0; k < n; k++) {
        for (int i = 0; i < 3; i++) {
            *seed = *seed * 1664525u + 1013904223u;
            number[i] = pow(10, (*seed >> 8) / 16777216.0);
        }
        char name[16];
        snprintf(name, sizeof name, "m%d", (int)k);
        body.mass = number[0];
        link.from_body = link.to_body;
        assert_ok(context, trk_spec_add_body(spec, name, &body, &link.to_body));
        link.stiffness = 1e4 * number[1];
        link.damping = (*seed & 1024 ? 20 : 0.5) * number[2];
        assert_ok(context, trk_spec_add_link(spec, name, &link, NULL));
    }
    trk_model *model;
    assert_ok(context, trk_model_compile(context, spec, NULL, &model));
    trk_spec_destroy(spec);
    return model;
}

/* Largest displacement at the end of many steps over that at the start; infinite if it overflowed. */
static double growth(trk_context *context, const trk_model *model, double step, bool modal)
{
    enum { MAX = 64, STEPS = 4000 };
    double q[MAX], v[MAX], largest = 0;
    int32_t n = trk_model_count(model, TRK_PART_COORDINATE);
    trk_rungekutta *stepper;
    assert_ok(context, trk_rungekutta_build(context, model, step, &stepper));
    assert_true((stepper->modal != NULL) == (n <= 32));
    if (!modal && stepper->modal) {
        trk_explicit_destroy(stepper->modal);
        stepper->modal = NULL;
    }
    for (int32_t i = 0; i < n; i++) {
        q[i] = i % 2 ? -1e-3 : 1e-3;
        v[i] = 0;
    }
    assert_ok(context, trk_rungekutta_set_state(stepper, 0, q, v, NULL, NULL, NULL));
    for (int k = 0; k < STEPS; k++)
        if (trk_rungekutta_step(stepper, NULL, NULL, NULL, NULL, NULL, NULL) != TRK_OK) {
            trk_rungekutta_destroy(stepper);
            return INFINITY;
        }
    trk_rungekutta_get_state(stepper, q, v, NULL);
    for (int32_t i = 0; i < n; i++)
        largest = fmax(largest, fabs(q[i]));
    trk_rungekutta_destroy(stepper);
    return largest / 1e-3;
}

static void test_limit_is_sharp(void **state)
{
    static const int32_t sizes[] = {1, 2, 3, 5, 8, 13, 21, 32, 40, 60};
    uint32_t seed = 5;
    for (int k = 0; k < 30; k++) {
        trk_model *model = random_chain(*state, sizes[k % 10], &seed);
        double limit = limit_of(*state, model, NULL);
        for (int modal = 0; modal < 2; modal++) {
            assert_true(growth(*state, model, 0.999 * limit, modal) < 1);
            assert_true(growth(*state, model, 1.03 * limit, modal) > 1e6);
        }
        trk_model_destroy(model);
    }
}

/*
 * One mass on a spring, damped by a curve whose slope is that of a damping ratio of 0.545 below
 * 2 m/s, where the region of stability is narrowest, and 0.9 above. Near the limit it must come
 * to rest, not ring at the border between the two.
 */
static void test_limit_between_the_slopes(void **state)
{
    const double critical = 2 * sqrt(1e6 * 100), low = 0.545 * critical * 2,
                 high = low + 0.9 * critical * 2;
    const double rate[] = {-10, -4, -2, 2, 4, 10}, force[] = {-high, -high, -low, low, high, high};
    trk_curve_options options;
    trk_curve_options_init(&options, sizeof options);
    options.interpolation = TRK_INTERPOLATION_LINEAR;
    trk_curve *curve;
    trk_spec *spec;
    trk_model *model;
    trk_body_options body;
    trk_link_options link;
    trk_body_options_init(&body, sizeof body);
    trk_link_options_init(&link, sizeof link);
    body.mass = 100;
    link.stiffness = 1e6;
    assert_ok(*state, trk_curve_create(*state, "damper", 6, rate, force, &options, &curve));
    link.damper_curve = curve;
    assert_ok(*state, trk_spec_create(*state, "narrow", &spec));
    assert_ok(*state, trk_spec_add_body(spec, "mass", &body, &link.to_body));
    assert_ok(*state, trk_spec_add_link(spec, "strut", &link, NULL));
    assert_ok(*state, trk_model_compile(*state, spec, NULL, &model));
    trk_spec_destroy(spec);
    trk_curve_destroy(curve);
    trk_rungekutta_options stepping;
    trk_rungekutta_options_init(&stepping, sizeof stepping);
    stepping.step = 0.999 * limit_of(*state, model, NULL);
    trk_rungekutta *stepper;
    const double q = 1e-6;
    double v = 1;
    assert_ok(*state, trk_rungekutta_create(*state, model, &stepping, &stepper));
    assert_ok(*state, trk_rungekutta_set_state(stepper, 0, &q, NULL, NULL, NULL, NULL));
    for (int k = 0; k < 20000; k++)
        assert_ok(*state, trk_rungekutta_step(stepper, NULL, NULL, NULL, NULL, NULL, NULL));
    trk_rungekutta_get_state(stepper, NULL, &v, NULL);
    assert_near(v, 0, 1e-9);
    trk_rungekutta_destroy(stepper);
    trk_model_destroy(model);
}

static void test_refusal_names_limit_and_link(void **state)
{
    trk_model *model = support_oscillator(*state, 2, 800, 0);
    trk_rungekutta_options options;
    trk_rungekutta_options_init(&options, sizeof options);
    trk_rungekutta *stepper;
    options.step = 0.15;
    assert_status(*state, trk_rungekutta_create(*state, model, &options, &stepper), TRK_E_RANGE);
    assert_null(stepper);
    assert_message(*state, "0.141421");
    assert_message(*state, "'spring'");
    options.step = 0.141421;
    assert_ok(*state, trk_rungekutta_create(*state, model, &options, &stepper));
    trk_rungekutta_destroy(stepper);
    trk_model_destroy(model);
}

/* Curves count with their largest slopes: the thesis's dampers are steepest near rest. */
static void test_curves_count(void **state)
{
    trk_model *linear = support_model(*state, TRK_VEHICLE_REFERENCE_TRUCK, TRK_VARIANT_LINEAR, 0);
    trk_model *curved =
        support_model(*state, TRK_VEHICLE_REFERENCE_TRUCK, TRK_VARIANT_THESIS_DAMPERS, 0);
    int32_t link;
    double limit = limit_of(*state, curved, &link);
    assert_true(limit < limit_of(*state, linear, NULL) / 3);
    assert_non_null(strstr(trk_model_part_name(curved, TRK_PART_LINK, link), "damper"));
    trk_model_destroy(linear);
    trk_model_destroy(curved);
}

static void test_null(void **state)
{
    trk_model *model = support_oscillator(*state, 1, 1, 0);
    double limit;
    assert_status(*state, trk_rungekutta_find_limit(*state, NULL, &limit, NULL), TRK_E_ARGUMENT);
    assert_status(*state, trk_rungekutta_find_limit(*state, model, NULL, NULL), TRK_E_ARGUMENT);
    assert_int_equal(trk_rungekutta_find_limit(NULL, model, &limit, NULL), TRK_E_ARGUMENT);
    trk_model_destroy(model);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_known_limits, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(test_limit_is_sharp, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(test_limit_between_the_slopes, support_setup,
                                        support_teardown),
        cmocka_unit_test_setup_teardown(test_refusal_names_limit_and_link, support_setup,
                                        support_teardown),
        cmocka_unit_test_setup_teardown(test_curves_count, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(test_null, support_setup, support_teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
