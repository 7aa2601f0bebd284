/* SPDX-License-Identifier: MIT */
/* Laws in links of a spec: owned copies, and the fields that reach into them. */
#include "support.h"

#include <truckride/spec.h>

/* One body on the ground, held by a link with everything and the law. */
static trk_spec *with_law(trk_context *context, const trk_law *law)
{
    trk_spec *spec;
    trk_body_options body;
    trk_link_options link;
    trk_body_options_init(&body, sizeof body);
    trk_link_options_init(&link, sizeof link);
    body.mass = 100;
    link.stiffness = 1e4;
    link.law = law;
    assert_ok(context, trk_spec_create(context, "pair", &spec));
    assert_ok(context, trk_spec_add_body(spec, "axle", &body, &link.to_body));
    assert_ok(context, trk_spec_add_link(spec, "spring", &link, NULL));
    return spec;
}

static const trk_law *law_of(const trk_spec *spec)
{
    trk_link_options link;
    trk_link_options_init(&link, sizeof link);
    assert_int_equal(trk_spec_get_link(spec, 1, &link), TRK_OK);
    return link.law;
}

static trk_law *leaf(trk_context *context, double friction, double slope, double bump,
                     double rebound)
{
    trk_law *law;
    trk_leaf_options o;
    trk_leaf_options_init(&o, sizeof o);
    o.friction = friction;
    o.friction_slope = slope;
    o.approach_bump = bump;
    o.approach_rebound = rebound;
    assert_ok(context, trk_law_create_leaf(context, "leaf", &o, &law));
    return law;
}

static trk_leaf_options leaf_of(const trk_spec *spec)
{
    trk_leaf_options o;
    trk_leaf_options_init(&o, sizeof o);
    assert_int_equal(trk_law_get_leaf(law_of(spec), &o), TRK_OK);
    return o;
}

static void a_spec_owns_its_laws(void **state)
{
    trk_law *law = leaf(*state, 2500, 1e4, 0.002, 0.003);
    trk_spec *spec = with_law(*state, law), *copy;
    trk_law_destroy(law);
    assert_ok(*state, trk_spec_copy(*state, spec, &copy));
    assert_true(law_of(copy) != law_of(spec));
    trk_spec_destroy(spec);
    assert_string_equal(trk_law_name(law_of(copy)), "leaf");
    assert_true(leaf_of(copy).friction == 2500 && leaf_of(copy).approach_rebound == 0.003);
    trk_link_options link;
    trk_link_options_init(&link, sizeof link);
    assert_ok(*state, trk_spec_get_link(copy, 1, &link));
    assert_ok(*state, trk_spec_set_link(copy, 1, &link)); /* with its own law */
    assert_true(leaf_of(copy).friction == 2500);
    link.law = NULL;
    assert_ok(*state, trk_spec_set_link(copy, 1, &link));
    assert_null(law_of(copy));
    trk_spec_destroy(copy);
}

/* Each field reaches its own numbers and leaves the others. */
static void fields_of_a_leaf(void **state)
{
    trk_law *law = leaf(*state, 2500, 1e4, 0.002, 0.003);
    trk_spec *spec = with_law(*state, law);
    assert_ok(*state, trk_spec_vary(spec, TRK_FIELD_FRICTION, "*", TRK_MEANING_FACTOR, 1.2, NULL));
    assert_ok(*state, trk_spec_vary(spec, TRK_FIELD_APPROACH, "*", TRK_MEANING_FACTOR, 0.5, NULL));
    trk_leaf_options o = leaf_of(spec);
    assert_true(o.friction == 1.2 * 2500 && o.friction_slope == 1.2 * 1e4);
    assert_true(o.approach_bump == 0.5 * 0.002 && o.approach_rebound == 0.5 * 0.003);
    assert_string_equal(trk_law_name(law_of(spec)), "leaf");
    assert_status(*state, trk_spec_vary(spec, TRK_FIELD_FRICTION, "*", TRK_MEANING_VALUE, 1, NULL),
                  TRK_E_MODEL); /* a friction and its slope: which? */
    assert_status(*state,
                  trk_spec_vary(spec, TRK_FIELD_FRICTION, "*", TRK_MEANING_FACTOR, -1, NULL),
                  TRK_E_RANGE);
    assert_true(leaf_of(spec).friction == 1.2 * 2500);
    trk_spec_destroy(spec);
    trk_law_destroy(law);
    /* One number each: values may replace them. */
    law = leaf(*state, 2500, 0, 0.002, 0);
    spec = with_law(*state, law);
    assert_ok(*state, trk_spec_vary(spec, TRK_FIELD_FRICTION, "*", TRK_MEANING_VALUE, 900, NULL));
    assert_ok(*state, trk_spec_vary(spec, TRK_FIELD_APPROACH, "*", TRK_MEANING_VALUE, 0.01, NULL));
    o = leaf_of(spec);
    assert_true(o.friction == 900 && o.approach_bump == 0.01);
    assert_true(o.approach_rebound == 0.01);
    trk_spec_destroy(spec);
    trk_law_destroy(law);
}

static void fields_of_a_tire(void **state)
{
    trk_law *law;
    trk_tire_options o;
    trk_tire_options_init(&o, sizeof o);
    o.stiffness = 1e6;
    o.stiffening = 1e7;
    o.damping = 400;
    assert_ok(*state, trk_law_create_tire(*state, "tire", &o, &law));
    trk_spec *spec = with_law(*state, law);
    assert_ok(*state, trk_spec_vary(spec, TRK_FIELD_STIFFNESS, "*", TRK_MEANING_FACTOR, 2, NULL));
    assert_ok(*state, trk_spec_vary(spec, TRK_FIELD_DAMPING, "*", TRK_MEANING_VALUE, 7, NULL));
    assert_int_equal(trk_law_get_tire(law_of(spec), &o), TRK_OK);
    assert_true(o.stiffness == 2e6 && o.stiffening == 2e7 && o.damping == 7);
    trk_link_options link;
    trk_link_options_init(&link, sizeof link);
    assert_ok(*state, trk_spec_get_link(spec, 1, &link));
    assert_true(link.stiffness == 2e4); /* of the link too */
    assert_status(*state, trk_spec_vary(spec, TRK_FIELD_FRICTION, "*", TRK_MEANING_FACTOR, 2, NULL),
                  TRK_E_MODEL);
    trk_spec_destroy(spec);
    trk_law_destroy(law);
}

static void fields_of_stops(void **state)
{
    const double x[] = {0, 0.01, 0.02}, y[] = {0, 1000, 5000};
    trk_law *law;
    trk_curve *curve;
    trk_stops_options o;
    trk_stops_options_init(&o, sizeof o);
    assert_ok(*state, trk_curve_create(*state, "bump", 3, x, y, NULL, &curve));
    o.bump_clearance = 0.05;
    o.bump_stiffness = 1e5;
    o.bump_curve = curve;
    o.rebound_stiffness = 2e5;
    assert_ok(*state, trk_law_create_stops(*state, "stop", &o, &law));
    trk_spec *spec = with_law(*state, law);
    assert_ok(*state, trk_spec_vary(spec, TRK_FIELD_STIFFNESS, "*", TRK_MEANING_FACTOR, 3, NULL));
    assert_int_equal(trk_law_get_stops(law_of(spec), &o), TRK_OK);
    assert_true(o.bump_clearance == 0.05 && o.bump_stiffness == 3e5);
    assert_true(o.rebound_stiffness == 6e5 && !o.rebound_curve);
    assert_near(trk_curve_value(o.bump_curve, 0.013), 3 * trk_curve_value(curve, 0.013), 1e-9);
    trk_spec_destroy(spec);
    trk_law_destroy(law);
    trk_curve_destroy(curve);
}

static void fields_of_friction_and_seal(void **state)
{
    trk_law *law;
    trk_friction_options f;
    trk_friction_options_init(&f, sizeof f);
    f.friction = 50;
    f.stiffness = 1e5;
    assert_ok(*state, trk_law_create_friction(*state, "pad", &f, &law));
    trk_spec *spec = with_law(*state, law);
    assert_ok(*state, trk_spec_vary(spec, TRK_FIELD_FRICTION, "*", TRK_MEANING_VALUE, 80, NULL));
    assert_int_equal(trk_law_get_friction(law_of(spec), &f), TRK_OK);
    assert_true(f.friction == 80 && f.stiffness == 1e5);
    trk_spec_destroy(spec);
    trk_law_destroy(law);
    trk_seal_options s;
    trk_seal_options_init(&s, sizeof s);
    s.sliding = 40;
    s.breakaway = 100;
    assert_ok(*state, trk_law_create_seal(*state, "seal", &s, &law));
    spec = with_law(*state, law);
    assert_ok(*state, trk_spec_vary(spec, TRK_FIELD_FRICTION, "*", TRK_MEANING_FACTOR, 2, NULL));
    assert_int_equal(trk_law_get_seal(law_of(spec), &s), TRK_OK);
    assert_true(s.sliding == 80 && s.breakaway == 200 && s.creep == 0.001);
    trk_spec_destroy(spec);
    trk_law_destroy(law);
}

static void bending_of_beams(void **state)
{
    trk_spec *spec;
    trk_body_options body;
    trk_beam_options beam;
    trk_body_options_init(&body, sizeof body);
    trk_beam_options_init(&beam, sizeof beam);
    body.mass = 10;
    assert_ok(*state, trk_spec_create(*state, "frame", &spec));
    assert_ok(*state, trk_spec_add_body(spec, "a", &body, &beam.from_body));
    assert_ok(*state, trk_spec_add_body(spec, "b", &body, &beam.to_body));
    beam.to_point[0] = 1;
    beam.axial = 1e8;
    beam.bending_y = 2e5;
    beam.mass_per_length = 20;
    assert_ok(*state, trk_spec_add_beam(spec, "rail", &beam, NULL));
    assert_ok(*state, trk_spec_vary(spec, TRK_FIELD_BENDING, "r*", TRK_MEANING_FACTOR, 0.5, NULL));
    assert_ok(*state, trk_spec_get_beam(spec, 1, &beam));
    assert_true(beam.axial == 5e7 && beam.bending_y == 1e5 && beam.mass_per_length == 20);
    assert_status(*state, trk_spec_vary(spec, TRK_FIELD_BENDING, "*", TRK_MEANING_VALUE, 1, NULL),
                  TRK_E_MODEL);
    assert_status(*state, trk_spec_vary(spec, TRK_FIELD_BENDING, "b", TRK_MEANING_FACTOR, 1, NULL),
                  TRK_E_NAME);
    assert_message(*state, "no beam of 'frame'");
    trk_spec_destroy(spec);
}

/* All or nothing: the second of two links cannot be varied. */
static void refusal_changes_no_law(void **state)
{
    trk_law *law = leaf(*state, 2500, 0, 0.002, 0);
    trk_spec *spec = with_law(*state, law);
    trk_link_options link;
    trk_link_options_init(&link, sizeof link);
    link.to_body = 1;
    link.damping = 5;
    assert_ok(*state, trk_spec_add_link(spec, "damper", &link, NULL));
    assert_status(*state, trk_spec_vary(spec, TRK_FIELD_FRICTION, "*", TRK_MEANING_FACTOR, 2, NULL),
                  TRK_E_MODEL);
    assert_message(*state, "'damper' has nothing to scale");
    assert_true(leaf_of(spec).friction == 2500);
    trk_spec_destroy(spec);
    trk_law_destroy(law);
}

static trk_status work(trk_context *context)
{
    trk_law *law = NULL;
    trk_spec *spec = NULL;
    trk_body_options body;
    trk_link_options link;
    trk_leaf_options o;
    trk_leaf_options_init(&o, sizeof o);
    trk_body_options_init(&body, sizeof body);
    trk_link_options_init(&link, sizeof link);
    o.friction = 10;
    o.approach_bump = 0.01;
    body.mass = 1;
    link.to_body = 1;
    trk_status status = trk_law_create_leaf(context, "l", &o, &law);
    link.law = law;
    if (status == TRK_OK)
        status = trk_spec_create(context, "s", &spec);
    if (status == TRK_OK)
        status = trk_spec_add_body(spec, "b", &body, NULL);
    if (status == TRK_OK)
        status = trk_spec_add_link(spec, "k", &link, NULL);
    if (status == TRK_OK)
        status = trk_spec_set_link(spec, 1, &link);
    if (status == TRK_OK) {
        status = trk_spec_vary(spec, TRK_FIELD_FRICTION, "k", TRK_MEANING_FACTOR, 2, NULL);
        assert_true(leaf_of(spec).friction == (status == TRK_OK ? 20 : 10));
    }
    trk_spec_destroy(spec);
    trk_law_destroy(law);
    return status;
}

static void lack_of_memory(void **state)
{
    (void)state;
    support_exhaust_memory(work);
}

#define TEST(f) cmocka_unit_test_setup_teardown(f, support_setup, support_teardown)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(a_spec_owns_its_laws),
        TEST(fields_of_a_leaf),
        TEST(fields_of_a_tire),
        TEST(fields_of_stops),
        TEST(fields_of_friction_and_seal),
        TEST(bending_of_beams),
        TEST(refusal_changes_no_law),
        cmocka_unit_test(lack_of_memory),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
