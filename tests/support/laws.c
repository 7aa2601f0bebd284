/* SPDX-License-Identifier: MIT */
#include "laws.h"

#include "support.h"

#include <truckride/vehicle.h>

static trk_law *tire(trk_context *context)
{
    trk_law *law;
    trk_tire_options o;
    trk_tire_options_init(&o, sizeof o);
    o.stiffness = 8e5;
    o.stiffening = 4e6;
    o.damping = 500;
    assert_ok(context, trk_law_create_tire(context, "tire", &o, &law));
    return law;
}

/* Touched by hard strokes about the static deflection of the spring, 0.07 m. */
static trk_law *stop(trk_context *context)
{
    const double x[] = {0, 0.02, 0.05}, y[] = {0, 8e3, 5e4};
    trk_law *law;
    trk_curve *rubber;
    trk_stops_options o;
    trk_stops_options_init(&o, sizeof o);
    assert_ok(context, trk_curve_create(context, "rubber", 3, x, y, NULL, &rubber));
    o.bump_clearance = 0.08;
    o.bump_curve = rubber;
    o.rebound_clearance = 0;
    o.rebound_stiffness = 3e5;
    assert_ok(context, trk_law_create_stops(context, "stop", &o, &law));
    trk_curve_destroy(rubber);
    return law;
}

static trk_law *leaf(trk_context *context)
{
    trk_law *law;
    trk_leaf_options o;
    trk_leaf_options_init(&o, sizeof o);
    o.friction = 1500;
    o.friction_slope = 3e3;
    o.approach_bump = 0.002;
    o.approach_rebound = 0.003;
    assert_ok(context, trk_law_create_leaf(context, "leaf", &o, &law));
    return law;
}

static trk_law *pad(trk_context *context)
{
    trk_law *law;
    trk_friction_options o;
    trk_friction_options_init(&o, sizeof o);
    o.friction = 60;
    o.stiffness = 2e5;
    assert_ok(context, trk_law_create_friction(context, "pad", &o, &law));
    return law;
}

static trk_law *air(trk_context *context)
{
    trk_law *law;
    trk_air_spring_options o;
    trk_air_spring_options_init(&o, sizeof o);
    o.pressure = 5e5;
    o.volume = 2e-3;
    o.area = 1e-2;
    o.area_slope = -0.02;
    o.auxiliary_volume = 4e-3;
    o.conductance = 2e-7;
    assert_ok(context, trk_law_create_air_spring(context, "air", &o, &law));
    return law;
}

static trk_law *seal(trk_context *context)
{
    trk_law *law;
    trk_seal_options o;
    trk_seal_options_init(&o, sizeof o);
    o.sliding = 80;
    o.breakaway = 120;
    o.creep = 0.01;
    assert_ok(context, trk_law_create_seal(context, "seal", &o, &law));
    return law;
}

trk_law *support_law(trk_context *context, trk_law_kind kind)
{
    trk_law *(*const make[])(trk_context *) = {tire, stop, leaf, pad, air, seal};
    trk_law *law = make[kind - 1](context);
    assert_int_equal(trk_law_get_kind(law), kind);
    return law;
}

static void add_link(trk_context *context, trk_spec *spec, trk_law_kind kind, int32_t to,
                     double stiffness, double damping)
{
    trk_law *law = support_law(context, kind);
    trk_link_options link;
    trk_link_options_init(&link, sizeof link);
    link.from_road = kind == TRK_LAW_TIRE;
    link.from_body = to - 1;
    link.to_body = to;
    link.stiffness = stiffness;
    link.damping = damping;
    link.law = law;
    assert_ok(context, trk_spec_add_link(spec, trk_law_name(law), &link, NULL));
    trk_law_destroy(law);
}

static void add_sensor(trk_context *context, trk_spec *spec, const char *link)
{
    trk_sensor_options sensor;
    trk_sensor_options_init(&sensor, sizeof sensor);
    sensor.link = trk_spec_find(spec, TRK_PART_LINK, link);
    sensor.quantity = TRK_QUANTITY_FORCE;
    assert_ok(context, trk_spec_add_sensor(spec, link, &sensor, NULL));
}

trk_spec *support_every_law(trk_context *context)
{
    static const char *const name[] = {"axle", "frame", "cab"};
    static const double mass[] = {350, 3000, 400};
    trk_spec *spec;
    trk_body_options body;
    trk_sensor_options sensor;
    trk_body_options_init(&body, sizeof body);
    trk_sensor_options_init(&sensor, sizeof sensor);
    assert_ok(context, trk_spec_create(context, "every law", &spec));
    assert_ok(context, trk_spec_add_road(spec, "road", 0, 0, NULL));
    for (int k = 0; k < 3; k++) {
        body.mass = mass[k];
        assert_ok(context, trk_spec_add_body(spec, name[k], &body, NULL));
    }
    add_link(context, spec, TRK_LAW_TIRE, 1, 0, 0);
    add_link(context, spec, TRK_LAW_LEAF, 2, 5e5, 0);
    add_link(context, spec, TRK_LAW_STOPS, 2, 0, 0);
    add_link(context, spec, TRK_LAW_SEAL, 2, 0, 6e3);
    add_link(context, spec, TRK_LAW_AIR_SPRING, 3, 0, 0);
    add_link(context, spec, TRK_LAW_FRICTION, 3, 0, 1200);
    add_sensor(context, spec, "tire");
    add_sensor(context, spec, "leaf");
    add_sensor(context, spec, "air");
    sensor.body = 3;
    assert_ok(context, trk_spec_add_sensor(spec, "cab", &sensor, NULL));
    return spec;
}

trk_spec *support_truck_on_leaves(trk_context *context)
{
    static const char *const name[] = {"front_left_spring", "front_right_spring",
                                       "rear_left_spring", "rear_right_spring"};
    trk_spec *spec;
    trk_law *law = support_law(context, TRK_LAW_LEAF);
    assert_ok(context, trk_vehicle_create_builtin(context, TRK_VEHICLE_REFERENCE_TRUCK,
                                                  TRK_VARIANT_THESIS_DAMPERS, &spec));
    for (int k = 0; k < 4; k++) {
        trk_link_options link;
        trk_link_options_init(&link, sizeof link);
        int32_t id = trk_spec_find(spec, TRK_PART_LINK, name[k]);
        assert_ok(context, trk_spec_get_link(spec, id, &link));
        link.law = law;
        assert_ok(context, trk_spec_set_link(spec, id, &link));
    }
    trk_law_destroy(law);
    return spec;
}

trk_spec *support_truck_with_tail(trk_context *context)
{
    trk_spec *spec = support_truck_on_leaves(context);
    trk_body_options tail;
    trk_beam_options beam;
    trk_body_options_init(&tail, sizeof tail);
    trk_beam_options_init(&beam, sizeof beam);
    tail.freedoms = TRK_FREE_Z | TRK_FREE_PITCH;
    tail.cg[0] = -6;
    tail.mass = 300;
    tail.inertia[1] = 50;
    beam.from_body = trk_spec_find(spec, TRK_PART_BODY, "frame");
    beam.from_point[0] = -5;
    beam.to_point[0] = -6;
    beam.bending_y = 2e5;
    beam.mass_per_length = 60;
    beam.stiffness_damping = 1e-4;
    assert_ok(context, trk_spec_add_body(spec, "tail", &tail, &beam.to_body));
    assert_ok(context, trk_spec_add_beam(spec, "tail", &beam, NULL));
    return spec;
}
