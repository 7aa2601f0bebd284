/* SPDX-License-Identifier: MIT */
/* Static equilibrium (MODEL.5) with laws: tires drawn in the air, indeterminate axles, relaxed memory. */
#include "laws.h"
#include "support.h"

#include <truckride/model.h>

enum { WHEELS = 8 };

static trk_model *compile(trk_context *context, const trk_spec *spec)
{
    trk_model_options options;
    trk_model *model;
    trk_model_options_init(&options, sizeof options);
    options.gravity = TRK_STANDARD_GRAVITY;
    assert_ok(context, trk_model_compile(context, spec, &options, &model));
    return model;
}

/* A tire drawn just touching the road. */
static trk_law *tire(trk_context *context, double stiffness)
{
    trk_tire_options o;
    trk_law *law;
    trk_tire_options_init(&o, sizeof o);
    o.stiffness = stiffness;
    o.damping = 300;
    assert_ok(context, trk_law_create_tire(context, "tire", &o, &law));
    return law;
}

/* One drawn a clearance above it. */
static trk_law *far_tire(trk_context *context, double stiffness, double clearance)
{
    trk_stops_options o;
    trk_law *law;
    trk_stops_options_init(&o, sizeof o);
    o.bump_stiffness = stiffness;
    o.bump_clearance = clearance;
    assert_ok(context, trk_law_create_stops(context, "tire in the air", &o, &law));
    return law;
}

/* Forces carry the weight along z and its moments, all to 1e-9 of the weight. */
static void check_balance(const trk_model *model, int32_t tires, const double *x, const double *y,
                          double weight, double at_x)
{
    double force[64], sum = 0, pitch = 0, roll = 0;
    trk_model_get_static(model, NULL, force);
    for (int32_t k = 0; k < tires; k++) {
        assert_true(force[k] <= 0);
        sum -= force[k];
        pitch -= force[k] * x[k];
        roll -= force[k] * y[k];
    }
    assert_near(sum, weight, 1e-9 * weight);
    assert_near(pitch, weight * at_x, 1e-9 * weight * 5);
    assert_near(roll, 0, 1e-9 * weight);
}

/* A rigid vehicle on `axles` axles of two tires each, and friction on top: 3 and more are
 * statically indeterminate. The tires of axle `high` are drawn 30 mm above the road. */
static void on_axles(trk_context *context, int32_t axles, int32_t high, double clearance)
{
    const double mass = 4000.0 * axles, cg = -0.3;
    double x[WHEELS], y[WHEELS];
    trk_spec *spec;
    trk_body_options body;
    trk_link_options link;
    trk_law *near_law = tire(context, 9e5), *far_law = far_tire(context, 9e5, clearance),
            *leaf = support_law(context, TRK_LAW_LEAF);
    trk_body_options_init(&body, sizeof body);
    trk_link_options_init(&link, sizeof link);
    body.freedoms = TRK_FREE_Z | TRK_FREE_ROLL | TRK_FREE_PITCH;
    body.mass = mass;
    body.cg[0] = cg;
    body.cg[2] = 1;
    body.inertia[0] = 5000;
    body.inertia[1] = 50000;
    assert_ok(context, trk_spec_create(context, "lorry", &spec));
    assert_ok(context, trk_spec_add_body(spec, "frame", &body, &link.to_body));
    for (int32_t k = 0; k < 2 * axles; k++) {
        char name[24];
        x[k] = link.to_point[0] = 2.5 - 1.3 * (k / 2) - (k / 2 > 0 ? 1.5 : 0);
        y[k] = link.to_point[1] = k % 2 ? -1 : 1;
        snprintf(name, sizeof name, "tire %d", k);
        assert_ok(context, trk_spec_add_road(spec, name, x[k], y[k], &link.from_road));
        link.law = k / 2 == high ? far_law : near_law;
        assert_ok(context, trk_spec_add_link(spec, name, &link, NULL));
    }
    link.law = leaf; /* friction carries nothing at rest */
    assert_ok(context, trk_spec_add_link(spec, "rubbing", &link, NULL));
    trk_model *model = compile(context, spec);
    double force[WHEELS + 1];
    trk_model_get_static(model, NULL, force);
    assert_true(force[2 * axles] == 0);
    check_balance(model, 2 * axles, x, y, mass * TRK_STANDARD_GRAVITY, cg);
    trk_model_destroy(model);
    trk_spec_destroy(spec);
    trk_law_destroy(near_law);
    trk_law_destroy(far_law);
    trk_law_destroy(leaf);
}

static void vehicles_of_two_to_four_axles(void **state)
{
    for (int32_t axles = 2; axles <= 4; axles++)
        for (int32_t high = -1; high < axles; high++) {
            on_axles(*state, axles, high, 0.003); /* it still touches */
            if (axles > 2 && high > 0)
                on_axles(*state, axles, high, 0.5); /* a lifted axle: it carries nothing */
        }
}

/* All tires in the air: the fall is found, from 1 mm to 10 m. */
static void drawn_in_the_air(void **state)
{
    for (double height = 1e-3; height < 20; height *= 10) {
        trk_law *law = far_tire(*state, 1e6, height);
        trk_spec *spec;
        trk_body_options body;
        trk_link_options link;
        trk_body_options_init(&body, sizeof body);
        trk_link_options_init(&link, sizeof link);
        body.mass = 800;
        link.law = law;
        assert_ok(*state, trk_spec_create(*state, "axle", &spec));
        assert_ok(*state, trk_spec_add_road(spec, "road", 0, 0, &link.from_road));
        assert_ok(*state, trk_spec_add_body(spec, "axle", &body, &link.to_body));
        assert_ok(*state, trk_spec_add_link(spec, "tire", &link, NULL));
        trk_model *model = compile(*state, spec);
        double q, force, weight = 800 * TRK_STANDARD_GRAVITY;
        trk_model_get_static(model, &q, &force);
        assert_near(force, -weight, 1e-9 * weight);
        assert_near(q, -height - weight / 1e6, 1e-12);
        trk_model_destroy(model);
        trk_spec_destroy(spec);
        trk_law_destroy(law);
    }
}

/* Air springs are open to their auxiliary volume at rest, and closed where a model is linearised. */
static void statics_and_tangents_of_air(void **state)
{
    trk_law *law = support_law(*state, TRK_LAW_AIR_SPRING);
    trk_air_spring_options o;
    trk_air_spring_options_init(&o, sizeof o);
    assert_int_equal(trk_law_get_air_spring(law, &o), TRK_OK);
    trk_spec *spec;
    trk_body_options body;
    trk_link_options link;
    trk_body_options_init(&body, sizeof body);
    trk_link_options_init(&link, sizeof link);
    link.to_body = 1;
    link.law = law;
    double over = o.pressure - o.ambient, stiffness;
    body.mass = over * o.area / TRK_STANDARD_GRAVITY; /* carried at e = 0 */
    assert_ok(*state, trk_spec_create(*state, "bellows", &spec));
    assert_ok(*state, trk_spec_add_body(spec, "cab", &body, NULL));
    assert_ok(*state, trk_spec_add_link(spec, "air", &link, NULL));
    trk_model *model = compile(*state, spec);
    double q, e, v = 0, force, more, less;
    trk_model_get_static(model, &q, &force);
    assert_near(q, 0, 1e-12);
    trk_model_get_tangent(model, NULL, NULL, NULL, &stiffness);
    double closed = o.exponent * o.pressure * o.area * o.area / o.volume - over * o.area_slope;
    assert_near(stiffness / closed, 1, 1e-9);
    e = 1e-6;
    trk_model_get_link_force(model, &e, &v, &more);
    e = -1e-6;
    trk_model_get_link_force(model, &e, &v, &less);
    double open = o.exponent * o.pressure * o.area * o.area / (o.volume + o.auxiliary_volume) -
                  over * o.area_slope;
    assert_near((more - less) / 2e-6 / open, 1, 1e-6);
    trk_model_destroy(model);
    body.mass *= 1.3; /* and away from there */
    assert_ok(*state, trk_spec_set_body(spec, 1, &body));
    model = compile(*state, spec);
    trk_model_get_static(model, &q, &force);
    assert_near(force / (1.3 * over * o.area), -1, 1e-9);
    trk_model_destroy(model);
    trk_spec_destroy(spec);
    trk_law_destroy(law);
}

/* Friction alone carries nothing: the mass would slide down. */
static void friction_does_not_carry(void **state)
{
    trk_law *law = support_law(*state, TRK_LAW_FRICTION);
    trk_spec *spec;
    trk_model *model;
    trk_body_options body;
    trk_link_options link;
    trk_model_options options;
    trk_body_options_init(&body, sizeof body);
    trk_link_options_init(&link, sizeof link);
    trk_model_options_init(&options, sizeof options);
    body.mass = 1;
    link.to_body = 1;
    link.law = law;
    assert_ok(*state, trk_spec_create(*state, "brake", &spec));
    assert_ok(*state, trk_spec_add_body(spec, "block", &body, NULL));
    assert_ok(*state, trk_spec_add_link(spec, "pad", &link, NULL));
    assert_ok(*state, trk_model_compile(*state, spec, &options, &model)); /* a tie all the same */
    trk_model_destroy(model);
    options.gravity = TRK_STANDARD_GRAVITY;
    assert_status(*state, trk_model_compile(*state, spec, &options, &model), TRK_E_CONVERGENCE);
    assert_message(*state, "no static equilibrium");
    assert_null(model);
    trk_spec_destroy(spec);
    trk_law_destroy(law);
}

static void a_law_of_every_kind(void **state)
{
    trk_spec *spec = support_every_law(*state);
    trk_model *model = compile(*state, spec);
    double force[6], g = TRK_STANDARD_GRAVITY;
    trk_model_get_static(model, NULL, force);
    assert_near(force[0], -3750 * g, 1e-9 * 3750 * g);
    assert_near(force[1] + force[2] + force[3], -3400 * g, 1e-9 * 3750 * g);
    assert_near(force[4] + force[5], -400 * g, 1e-9 * 3750 * g);
    trk_model_destroy(model);
    trk_spec_destroy(spec);
}

#define TEST(f) cmocka_unit_test_setup_teardown(f, support_setup, support_teardown)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(vehicles_of_two_to_four_axles), TEST(drawn_in_the_air),
        TEST(statics_and_tangents_of_air),   TEST(friction_does_not_carry),
        TEST(a_law_of_every_kind),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
