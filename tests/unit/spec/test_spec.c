/* SPDX-License-Identifier: MIT */
/* Parts are added, found, read back, changed and copied. */
#include "support.h"

#include <truckride/spec.h>

static trk_curve *make_curve(trk_context *context, double slope)
{
    const double x[] = {-1, 1}, y[] = {-slope, slope};
    trk_curve *curve;
    assert_ok(context, trk_curve_create(context, "line", 2, x, y, NULL, &curve));
    return curve;
}

/* One part of each kind, all fields away from their defaults. */
static trk_spec *make(trk_context *context)
{
    trk_spec *spec;
    int32_t id = -1;
    assert_ok(context, trk_spec_create(context, "van", &spec));
    trk_body_options body;
    trk_body_options_init(&body, sizeof body);
    body.freedoms = TRK_FREE_Z | TRK_FREE_PITCH;
    body.mass = 100;
    body.inertia[1] = 50;
    body.cg[2] = 0.5;
    assert_ok(context, trk_spec_add_body(spec, "cab", &body, &id));
    assert_int_equal(id, 1);
    assert_ok(context, trk_spec_add_body(spec, "frame", &body, &id));
    assert_int_equal(id, 2);
    assert_ok(context, trk_spec_add_mass(spec, "engine", 2, 250, (double[]){1, 2, 3}, &id));
    assert_int_equal(id, 1);
    assert_ok(context, trk_spec_add_road(spec, "left", -4.5, 1.5, &id));
    assert_int_equal(id, 1);
    trk_link_options link;
    trk_link_options_init(&link, sizeof link);
    link.from_road = 1;
    link.to_body = 2;
    link.to_point[0] = -4.5;
    link.stiffness = 1e6;
    link.damping = 500;
    link.spring_offset = -0.01;
    link.spring_scale = 0.5;
    link.damper_scale = 0;
    trk_curve *spring = make_curve(context, 10), *damper = make_curve(context, 20);
    link.spring_curve = spring;
    link.damper_curve = damper;
    assert_ok(context, trk_spec_add_link(spec, "tire", &link, &id));
    assert_int_equal(id, 1);
    trk_curve_destroy(spring); /* the spec has its own */
    trk_curve_destroy(damper);
    trk_port_options port;
    trk_port_options_init(&port, sizeof port);
    port.body = 1;
    port.motion = TRK_MOTION_ROTATION;
    port.direction[1] = 2;
    assert_ok(context, trk_spec_add_port(spec, "hand", &port, &id));
    assert_int_equal(id, 1);
    trk_sensor_options sensor;
    trk_sensor_options_init(&sensor, sizeof sensor);
    sensor.quantity = TRK_QUANTITY_FORCE;
    sensor.link = 1;
    assert_ok(context, trk_spec_add_sensor(spec, "load", &sensor, &id));
    assert_int_equal(id, 1);
    return spec;
}

static void check(const trk_spec *spec)
{
    assert_string_equal(trk_spec_name(spec), "van");
    assert_int_equal(trk_spec_count(spec, TRK_PART_BODY), 2);
    for (trk_part part = TRK_PART_LINK; part <= TRK_PART_MASS; part++)
        assert_int_equal(trk_spec_count(spec, part), 1);
    trk_body_options body;
    trk_body_options_init(&body, sizeof body);
    assert_int_equal(trk_spec_get_body(spec, 1, &body), TRK_OK);
    assert_int_equal(body.freedoms, TRK_FREE_Z | TRK_FREE_PITCH);
    assert_near(body.mass, 100, 0);
    assert_near(body.inertia[1], 50, 0);
    assert_near(body.cg[2], 0.5, 0);
    int32_t owner;
    double mass, point[3], x, y;
    assert_int_equal(trk_spec_get_mass(spec, 1, &owner, &mass, point), TRK_OK);
    assert_int_equal(owner, 2);
    assert_near(mass, 250, 0);
    assert_near(point[2], 3, 0);
    assert_int_equal(trk_spec_get_mass(spec, 1, NULL, NULL, NULL), TRK_OK);
    assert_int_equal(trk_spec_get_road(spec, 1, &x, &y), TRK_OK);
    assert_near(x, -4.5, 0);
    assert_near(y, 1.5, 0);
    assert_int_equal(trk_spec_get_road(spec, 1, NULL, NULL), TRK_OK);
    trk_link_options link;
    trk_link_options_init(&link, sizeof link);
    assert_int_equal(trk_spec_get_link(spec, 1, &link), TRK_OK);
    assert_int_equal(link.from_road, 1);
    assert_near(link.spring_offset, -0.01, 0);
    assert_near(link.spring_scale, 0.5, 0);
    assert_near(link.damper_scale, 0, 0);
    assert_near(trk_curve_value(link.spring_curve, 0.5), 5, 1e-14);
    assert_near(trk_curve_value(link.damper_curve, 0.5), 10, 1e-14);
    trk_port_options port;
    trk_port_options_init(&port, sizeof port);
    assert_int_equal(trk_spec_get_port(spec, 1, &port), TRK_OK);
    assert_int_equal(port.motion, TRK_MOTION_ROTATION);
    assert_near(port.direction[1], 2, 0);
    trk_sensor_options sensor;
    trk_sensor_options_init(&sensor, sizeof sensor);
    assert_int_equal(trk_spec_get_sensor(spec, 1, &sensor), TRK_OK);
    assert_int_equal(sensor.quantity, TRK_QUANTITY_FORCE);
    assert_int_equal(sensor.link, 1);
}

static void parts_are_read_back(void **state)
{
    trk_spec *spec = make(*state);
    check(spec);
    trk_spec_destroy(spec);
    trk_spec_destroy(NULL);
}

static void names_go_both_ways(void **state)
{
    static const char *const names[] = {"cab", "tire", "left", "hand", "load", "engine"};
    trk_spec *spec = make(*state);
    for (trk_part part = TRK_PART_BODY; part <= TRK_PART_MASS; part++) {
        const char *name = names[part - TRK_PART_BODY];
        assert_int_equal(trk_spec_find(spec, part, name), 1);
        assert_string_equal(trk_spec_part_name(spec, part, 1), name);
        assert_int_equal(trk_spec_find(spec, part, "nobody"), 0);
        assert_int_equal(trk_spec_find(spec, part, NULL), 0);
        assert_null(trk_spec_part_name(spec, part, 0));
        assert_null(trk_spec_part_name(spec, part, 99));
    }
    static const trk_part unknown[] = {0, -1, TRK_PART_COORDINATE, 100, INT32_MAX, INT32_MIN};
    for (size_t k = 0; k < sizeof unknown / sizeof *unknown; k++) {
        assert_int_equal(trk_spec_count(spec, unknown[k]), 0);
        assert_int_equal(trk_spec_find(spec, unknown[k], "cab"), 0);
        assert_null(trk_spec_part_name(spec, unknown[k], 1));
    }
    trk_spec_destroy(spec);
}

static void copy_is_equal_and_independent(void **state)
{
    trk_context *other;
    assert_int_equal(trk_context_create(NULL, NULL, &other), TRK_OK);
    trk_spec *spec = make(*state), *copy;
    assert_ok(other, trk_spec_copy(other, spec, &copy));
    trk_spec_destroy(spec);
    assert_int_equal(trk_context_blocks(*state), 0);
    check(copy);
    trk_spec_destroy(copy);
    assert_int_equal(trk_context_blocks(other), 0);
    trk_context_destroy(other);
}

static void parts_can_be_changed(void **state)
{
    trk_spec *spec = make(*state);
    trk_body_options body;
    trk_body_options_init(&body, sizeof body);
    body.mass = 7;
    assert_ok(*state, trk_spec_set_body(spec, 1, &body));
    body.mass = -1;
    assert_status(*state, trk_spec_set_body(spec, 1, &body), TRK_E_RANGE);
    assert_message(*state, "body 'cab': mass is -1");
    assert_ok(*state, trk_spec_get_body(spec, 1, &body));
    assert_near(body.mass, 7, 0);

    trk_link_options link;
    trk_link_options_init(&link, sizeof link);
    assert_ok(*state, trk_spec_get_link(spec, 1, &link));
    link.stiffness = 5; /* the curves are those of the spec itself */
    assert_ok(*state, trk_spec_set_link(spec, 1, &link));
    assert_ok(*state, trk_spec_get_link(spec, 1, &link));
    assert_near(link.stiffness, 5, 0);
    assert_near(trk_curve_value(link.spring_curve, 0.5), 5, 1e-14);
    link.damping = -3;
    assert_status(*state, trk_spec_set_link(spec, 1, &link), TRK_E_RANGE);
    assert_message(*state, "link 'tire': damping is -3");
    assert_ok(*state, trk_spec_get_link(spec, 1, &link));
    assert_near(link.damping, 500, 0);
    link.spring_curve = link.damper_curve = NULL;
    assert_ok(*state, trk_spec_set_link(spec, 1, &link));
    assert_ok(*state, trk_spec_get_link(spec, 1, &link));
    assert_null(link.spring_curve);
    trk_spec_destroy(spec);
}

static void defaults_are_documented_ones(void **state)
{
    (void)state;
    trk_body_options body;
    trk_link_options link;
    trk_sensor_options sensor;
    trk_port_options port;
    trk_body_options_init(&body, sizeof body);
    trk_link_options_init(&link, sizeof link);
    trk_sensor_options_init(&sensor, sizeof sensor);
    trk_port_options_init(&port, sizeof port);
    assert_int_equal(body.struct_size, sizeof body);
    assert_int_equal(body.freedoms, TRK_FREE_Z);
    assert_near(link.direction[2], 1, 0);
    assert_near(link.spring_scale, 1, 0);
    assert_near(link.damper_scale, 1, 0);
    assert_int_equal(link.motion, TRK_MOTION_TRANSLATION);
    assert_int_equal(sensor.quantity, TRK_QUANTITY_ACCELERATION);
    assert_near(sensor.direction[2], 1, 0);
    assert_near(port.direction[2], 1, 0);
    trk_body_options_init(NULL, sizeof body);
    trk_link_options_init(NULL, sizeof link);
    trk_sensor_options_init(NULL, sizeof sensor);
    trk_port_options_init(NULL, sizeof port);
}

static void many_parts(void **state)
{
    trk_spec *spec;
    assert_ok(*state, trk_spec_create(*state, "many", &spec));
    for (int32_t k = 1; k <= 1000; k++) {
        char name[20];
        int32_t id;
        snprintf(name, sizeof name, "r%d", k);
        assert_ok(*state, trk_spec_add_road(spec, name, k, -k, &id));
        assert_int_equal(id, k);
    }
    double x;
    assert_ok(*state,
              trk_spec_get_road(spec, trk_spec_find(spec, TRK_PART_ROAD, "r777"), &x, NULL));
    assert_near(x, 777, 0);
    trk_spec_destroy(spec);
}

#define TEST(f) cmocka_unit_test_setup_teardown(f, support_setup, support_teardown)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(parts_are_read_back),           TEST(names_go_both_ways),
        TEST(copy_is_equal_and_independent), TEST(parts_can_be_changed),
        TEST(defaults_are_documented_ones),  TEST(many_parts),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
