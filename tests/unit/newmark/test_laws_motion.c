/* SPDX-License-Identifier: MIT */
/* Laws with memory on the way through time against closed forms: stick and slip, a stuck leaf
 * spring, a bouncing mass, and a wheel thrown off the road. */
#include "support.h"
#include "vehicles.h"

static const double pi = 3.14159265358979323846;

/* A mass on a link from a road input, with a spring and the law. */
static trk_model *on_law(trk_context *context, double mass, double stiffness, const trk_law *law,
                         double gravity)
{
    trk_spec *spec;
    trk_body_options body;
    trk_link_options link;
    trk_model_options options;
    trk_model *model;
    trk_body_options_init(&body, sizeof body);
    trk_link_options_init(&link, sizeof link);
    trk_model_options_init(&options, sizeof options);
    body.mass = mass;
    link.stiffness = stiffness;
    link.law = law;
    options.gravity = gravity;
    assert_ok(context, trk_spec_create(context, "mass", &spec));
    assert_ok(context, trk_spec_add_road(spec, "floor", 0, 0, &link.from_road));
    assert_ok(context, trk_spec_add_body(spec, "mass", &body, &link.to_body));
    assert_ok(context, trk_spec_add_link(spec, "leg", &link, NULL));
    assert_ok(context, trk_model_compile(context, spec, &options, &model));
    trk_spec_destroy(spec);
    return model;
}

static trk_newmark *stepper_on(trk_context *context, const trk_model *model, double step, double q,
                               double v)
{
    trk_newmark_options options;
    trk_newmark *stepper;
    support_method(0, step, &options);
    assert_ok(context, trk_newmark_create(context, model, &options, &stepper));
    assert_ok(context, trk_newmark_set_state(stepper, 0, &q, &v, NULL, NULL, NULL));
    return stepper;
}

static trk_law *dry(trk_context *context, double friction, double stiffness)
{
    trk_friction_options o;
    trk_law *law;
    trk_friction_options_init(&o, sizeof o);
    o.friction = friction;
    o.stiffness = stiffness;
    assert_ok(context, trk_law_create_friction(context, "pad", &o, &law));
    return law;
}

/*
 * Step until v changes sign or `limit` steps are over: the extreme q on the parabola through both
 * points with their slopes; NAN: no extreme.
 */
static double next_extreme(trk_context *context, trk_newmark *stepper, int limit)
{
    double q0, v0, q1, v1, h = trk_newmark_step_size(stepper);
    trk_newmark_get_state(stepper, &q0, &v0, NULL);
    for (int k = 0; k < limit; k++) {
        assert_ok(context, trk_newmark_step(stepper, NULL, NULL, NULL));
        trk_newmark_get_state(stepper, &q1, &v1, NULL);
        if (v0 * v1 < 0)
            return q0 - 0.5 * h * v0 * v0 / (v1 - v0);
        q0 = q1;
        v0 = v1;
    }
    return NAN;
}

/*
 * Free decay: with r = R at a reversal at A the work of friction on the way to the next, B, is
 * R (A + B - 2 R / s), s the stiffness that sticks, whence k (A^2 - B^2) / 2 = R (A + B) - 2 R^2 / s:
 * 2 R / k of amplitude a half cycle, 4 R / k a cycle, if s is large.
 */
static double after_half_cycle(double a, double k, double friction, double sticking, double slack)
{
    double c = k * a * a / 2 - friction * a + slack * friction * friction / sticking;
    return (-friction + sqrt(friction * friction + 2 * k * c)) / k;
}

static void free_decay_under_dry_friction(void **state)
{
    const double m = 400, k = 2e5, friction = 900, amplitude = 0.06;
    for (double sticking = 1e7; sticking < 2e9; sticking *= 10) {
        trk_law *law = dry(*state, friction, sticking);
        trk_model *model = on_law(*state, m, k, law, 0);
        trk_newmark *stepper = stepper_on(*state, model, 2e-5, amplitude, 0);
        double expected = after_half_cycle(amplitude, k, friction, sticking, 0.5);
        int half_cycles = 0;
        for (double sign = -1; expected > 2 * friction / k; sign = -sign, half_cycles++) {
            double a = next_extreme(*state, stepper, 100000);
            assert_near(sign * a, expected, 2e-7);
            expected = after_half_cycle(expected, k, friction, sticking, 2);
        }
        assert_in_range(half_cycles, 5, 8);
        if (sticking > 5e8) /* rigid: 4 R / k a cycle */
            assert_near(amplitude - half_cycles * 2 * friction / k, expected + 2 * friction / k,
                        1e-4);
        for (int step = 0; step < 100000; step++)
            assert_ok(*state, trk_newmark_step(stepper, NULL, NULL, NULL));
        double q, force;
        trk_newmark_get_state(stepper, &q, NULL, NULL);
        trk_newmark_get_links(stepper, NULL, NULL, &force);
        assert_true(fabs(k * q) <= friction && fabs(q) > 1e-4); /* it stuck, off the middle */
        trk_newmark_destroy(stepper);
        trk_model_destroy(model);
        trk_law_destroy(law);
    }
}

/* Pulled slower than a quarter period through less than R / s: it comes back, elastic. */
static void stuck_friction_is_elastic(void **state)
{
    const double m = 100, friction = 500, sticking = 1e6, k = 1e5, amplitude = 4e-4;
    trk_law *law = dry(*state, friction, sticking);
    trk_model *model = on_law(*state, m, k, law, 0);
    double damping, stiffness, period = 2 * pi / sqrt((k + sticking) / m), h = period / 2000;
    trk_model_get_tangent(model, NULL, NULL, &damping, &stiffness);
    assert_true(damping == 0 && stiffness == k + sticking); /* where a model is linearised */
    trk_newmark *stepper = stepper_on(*state, model, h, amplitude, 0);
    /* Set at rest with relaxed friction at q0: it swings about what balances k q0. */
    double middle = amplitude * sticking / (k + sticking), q;
    for (int j = 0; j < 20000; j++)
        assert_ok(*state, trk_newmark_step(stepper, NULL, NULL, NULL));
    trk_newmark_get_state(stepper, &q, NULL, NULL);
    double omega = 2 / h * atan(pi / 2000); /* of the discrete oscillator (NEWMARK.8) */
    assert_near(q, middle + (amplitude - middle) * cos(omega * 20000 * h), 1e-12);
    trk_newmark_destroy(stepper);
    trk_model_destroy(model);
    trk_law_destroy(law);
}

/* A stuck leaf is a spring of R / beta more: the small oscillation of an axle shows it. */
static void a_stuck_leaf_is_stiff(void **state)
{
    const double m = 500, k = 2e5;
    trk_leaf_options o;
    trk_law *law;
    trk_leaf_options_init(&o, sizeof o);
    o.friction = 2500;
    o.approach_bump = 0.002;
    assert_ok(*state, trk_law_create_leaf(*state, "leaf", &o, &law));
    trk_model *model = on_law(*state, m, k, law, 0);
    double stiffness, stuck = k + o.friction / o.approach_bump;
    trk_model_get_tangent(model, NULL, NULL, NULL, &stiffness);
    assert_near(stiffness, stuck, 1e-9 * stuck);
    trk_newmark *stepper = stepper_on(*state, model, 1e-5, 0, 1e-6 * sqrt(stuck / m));
    double t[2];
    for (int i = 0; i < 2; i++) {
        next_extreme(*state, stepper, 100000);
        t[i] = trk_newmark_time(stepper);
    }
    assert_near(pi / (t[1] - t[0]) / sqrt(stuck / m), 1, 1e-3);
    trk_newmark_destroy(stepper);
    trk_model_destroy(model);
    trk_law_destroy(law);
}

static trk_law *tire(trk_context *context, double stiffness, double damping)
{
    trk_tire_options o;
    trk_law *law;
    trk_tire_options_init(&o, sizeof o);
    o.stiffness = stiffness;
    o.damping = damping;
    assert_ok(context, trk_law_create_tire(context, "tire", &o, &law));
    return law;
}

/*
 * Dropped from H above the floor: in the air for 2 v / g between contacts of (2 / w)(pi - atan(w v / g))
 * with v = sqrt(2 g H), again and again, as nothing is lost.
 */
static void a_bouncing_mass(void **state)
{
    const double m = 300, k = 1e6, g = TRK_STANDARD_GRAVITY, drop = 0.05, h = 1e-5;
    trk_law *law = tire(*state, k, 0);
    trk_model *model = on_law(*state, m, 0, law, g);
    double q, force, v = sqrt(2 * g * drop), w = sqrt(k / m);
    trk_model_get_static(model, &q, &force);
    assert_near(q, -m * g / k, 1e-12);
    assert_near(force, -m * g, 1e-9);
    const double contact = 2 / w * (pi - atan(w * v / g)), flight = 2 * v / g;
    trk_newmark *stepper = stepper_on(*state, model, h, drop, 0);
    double expected = flight / 2, before = drop, highest = 0;
    for (int event = 0; event < 8;) {
        double t = trk_newmark_time(stepper), f;
        assert_ok(*state, trk_newmark_step(stepper, NULL, NULL, NULL));
        trk_newmark_get_state(stepper, &q, NULL, NULL);
        trk_newmark_get_links(stepper, NULL, NULL, &f);
        assert_true(q > 0 ? f == 0 : f <= 0); /* a tire only pushes */
        highest = fmax(highest, q);
        if ((q > 0) != (before > 0)) {
            t += h * before / (before - q);
            assert_near(t, expected, 2e-7 * (event + 1));
            expected += event % 2 ? flight : contact;
            event++;
        }
        before = q;
    }
    assert_near(highest, drop, 1e-8);
    trk_newmark_destroy(stepper);
    trk_model_destroy(model);
    trk_law_destroy(law);
}

/* A quarter car over a bump that throws the wheel up: off the road everything falls with g. */
static void a_wheel_leaves_the_road(void **state)
{
    trk_law *law = tire(*state, 9e5, 300);
    trk_spec *spec;
    trk_body_options body;
    trk_link_options link;
    trk_model_options gravity;
    trk_model *model;
    trk_body_options_init(&body, sizeof body);
    trk_link_options_init(&link, sizeof link);
    trk_model_options_init(&gravity, sizeof gravity);
    gravity.gravity = TRK_STANDARD_GRAVITY;
    assert_ok(*state, trk_spec_create(*state, "quarter", &spec));
    assert_ok(*state, trk_spec_add_road(spec, "road", 0, 0, &link.from_road));
    body.mass = 350;
    assert_ok(*state, trk_spec_add_body(spec, "axle", &body, &link.to_body));
    link.law = law;
    assert_ok(*state, trk_spec_add_link(spec, "tire", &link, NULL));
    body.mass = 3000;
    link.from_road = 0;
    link.law = NULL;
    link.stiffness = 2e5;
    link.damping = 1e4;
    link.from_body = 1;
    assert_ok(*state, trk_spec_add_body(spec, "frame", &body, &link.to_body));
    assert_ok(*state, trk_spec_add_link(spec, "spring", &link, NULL));
    assert_ok(*state, trk_model_compile(*state, spec, &gravity, &model));
    trk_newmark *stepper;
    assert_ok(*state, trk_newmark_create(*state, model, NULL, &stepper));
    int in_air = 0, landings = 0;
    for (int step = 1; step <= 2000; step++) {
        double x = 2 * pi * step * 1e-3 / 0.12, u = 0.06 * (1 - cos(x)) / 2,
               du = 0.06 * pi / 0.12 * sin(x), a[2], f[2];
        if (x > 2 * pi)
            u = du = 0;
        assert_ok(*state, trk_newmark_step(stepper, &u, &du, NULL));
        trk_newmark_get_state(stepper, NULL, NULL, a);
        trk_newmark_get_links(stepper, NULL, NULL, f);
        assert_true(f[0] <= 0);
        if (f[0] == 0)
            assert_near((350 * a[0] + 3000 * a[1]) / 3350, -TRK_STANDARD_GRAVITY, 1e-8);
        landings += in_air && f[0] < 0;
        in_air = f[0] == 0;
    }
    assert_in_range(landings, 1, 10);
    trk_newmark_destroy(stepper);
    trk_model_destroy(model);
    trk_spec_destroy(spec);
    trk_law_destroy(law);
}

#define TEST(f) cmocka_unit_test_setup_teardown(f, support_setup, support_teardown)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(free_decay_under_dry_friction), TEST(stuck_friction_is_elastic),
        TEST(a_stuck_leaf_is_stiff),         TEST(a_bouncing_mass),
        TEST(a_wheel_leaves_the_road),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
