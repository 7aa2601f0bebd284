/* SPDX-License-Identifier: MIT */
/* Quarter car and half car. */
#include "vehicle/builder.h"
#include "vehicle/parameters.h"

static const double no_inertia[3];

/* A vertical link between two bodies, or from a road if from_road is set. */
static trk_link_options vertical(int32_t from_body, int32_t from_road, int32_t to_body, double x,
                                 double y)
{
    trk_link_options link;
    trk_link_options_init(&link, sizeof link);
    link.from_body = from_body;
    link.from_road = from_road;
    link.to_body = to_body;
    link.from_point[0] = link.to_point[0] = x;
    link.from_point[1] = link.to_point[1] = y;
    return link;
}

trk_status trk_vehicle_create_quarter_car(trk_context *context,
                                          const trk_quarter_car_parameters *parameters,
                                          trk_spec **out_spec)
{
    TRK_REQUIRE(context, out_spec, "trk_vehicle_create_quarter_car");
    *out_spec = NULL;
    TRK_REQUIRE(context, context, "trk_vehicle_create_quarter_car");
    trk_quarter_car_parameters p;
    trk_status status = trk_quarter_car_read(context, parameters, &p);
    if (status != TRK_OK)
        return status;
    const double origin[3] = {0, 0, 0};
    trk_builder b;
    trk_builder_begin(&b, context, "quarter car");
    int32_t sprung = trk_builder_body(&b, TRK_FREE_Z, p.sprung_mass, no_inertia, origin, "sprung");
    int32_t unsprung =
        trk_builder_body(&b, TRK_FREE_Z, p.unsprung_mass, no_inertia, origin, "unsprung");
    int32_t road = trk_builder_road(&b, 0, 0, "road");

    trk_link_options tire = vertical(0, road, unsprung, 0, 0);
    tire.stiffness = p.tire_stiffness;
    tire.damping = p.tire_damping;
    int32_t tire_id = trk_builder_link(&b, &tire, "tire");

    trk_link_options spring = vertical(unsprung, 0, sprung, 0, 0);
    spring.stiffness = p.spring_stiffness;
    spring.spring_curve = p.spring_curve;
    spring.spring_offset = p.spring_offset;
    trk_builder_link(&b, &spring, "spring");

    trk_link_options damper = vertical(unsprung, 0, sprung, 0, 0);
    damper.damping = p.damping;
    damper.damper_curve = p.damper_curve;
    damper.damper_scale = p.damper_scale;
    trk_builder_link(&b, &damper, "damper");

    trk_link_options stop = vertical(unsprung, 0, sprung, 0, 0);
    stop.spring_curve = p.bump_stop_curve;
    stop.spring_offset = p.bump_stop_offset;
    trk_builder_link(&b, &stop, "bump_stop");

    trk_builder_accelerometer(&b, sprung, origin, 2, "sprung_z");
    trk_builder_accelerometer(&b, unsprung, origin, 2, "unsprung_z");
    trk_builder_force_sensor(&b, tire_id, "tire_force");
    return trk_builder_end(&b, out_spec);
}

/* One wheel of the half car, under the body at `place` from its cg. */
static void add_wheel(trk_builder *b, const trk_half_car_parameters *p, int32_t body, int k,
                      const char *wheel)
{
    bool pitch = p->layout == TRK_HALF_CAR_PITCH;
    double x = pitch ? p->position[k] : 0, y = pitch ? 0 : p->position[k];
    const double place[3] = {x, y, 0};
    const char *end = pitch ? (k == 0 ? "front" : "rear") : (k == 0 ? "left" : "right");
    int32_t mass =
        trk_builder_body(b, TRK_FREE_Z, p->unsprung_mass[k], no_inertia, place, "%s", wheel);
    int32_t road = trk_builder_road(b, x, y, "%s", end);

    trk_link_options tire = vertical(0, road, mass, x, y);
    tire.stiffness = p->tire_stiffness[k];
    tire.damping = p->tire_damping[k];
    int32_t tire_id = trk_builder_link(b, &tire, "%s_tire", end);

    trk_link_options spring = vertical(mass, 0, body, x, y);
    spring.stiffness = p->spring_stiffness[k];
    trk_builder_link(b, &spring, "%s_spring", end);

    trk_link_options damper = vertical(mass, 0, body, x, y);
    damper.damping = p->damping[k];
    damper.damper_curve = p->damper_curve[k];
    damper.damper_scale = p->damper_scale[k];
    trk_builder_link(b, &damper, "%s_damper", end);

    trk_builder_accelerometer(b, body, place, 2, "body_%s_z", end);
    trk_builder_accelerometer(b, mass, place, 2, "%s_z", wheel);
    trk_builder_force_sensor(b, tire_id, "%s_tire_force", end);
}

trk_status trk_vehicle_create_half_car(trk_context *context,
                                       const trk_half_car_parameters *parameters,
                                       trk_spec **out_spec)
{
    TRK_REQUIRE(context, out_spec, "trk_vehicle_create_half_car");
    *out_spec = NULL;
    TRK_REQUIRE(context, context, "trk_vehicle_create_half_car");
    trk_half_car_parameters p;
    trk_status status = trk_half_car_read(context, parameters, &p);
    if (status != TRK_OK)
        return status;
    if (p.layout != TRK_HALF_CAR_PITCH && p.layout != TRK_HALF_CAR_ROLL)
        return trk_fail(context, TRK_E_ARGUMENT, "half car: there is no layout %d", p.layout);
    bool pitch = p.layout == TRK_HALF_CAR_PITCH;
    const double origin[3] = {0, 0, 0}, inertia[3] = {p.body_inertia, p.body_inertia, 0};
    trk_builder b;
    trk_builder_begin(&b, context, pitch ? "half car" : "half car in roll");
    int32_t body = trk_builder_body(&b, TRK_FREE_Z | (pitch ? TRK_FREE_PITCH : TRK_FREE_ROLL),
                                    p.body_mass, inertia, origin, "body");
    add_wheel(&b, &p, body, 0, pitch ? "front_axle" : "left_wheel");
    add_wheel(&b, &p, body, 1, pitch ? "rear_axle" : "right_wheel");
    return trk_builder_end(&b, out_spec);
}
