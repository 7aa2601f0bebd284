/* SPDX-License-Identifier: MIT */
/* A truck with a flexible frame: the model of the reduction's tests. */
#ifndef TRK_TESTS_REDUCE_TRUCK_H
#define TRK_TESTS_REDUCE_TRUCK_H

#include "support.h"

#include <truckride/frame.h>
#include <truckride/reduce.h>

static const double two_pi = 6.283185307179586476925286766559;

enum { STATIONS = 15, WHEELS = 4 };

static inline trk_status add_frame(trk_spec *spec, trk_context *context, int32_t freedoms,
                                   double beta)
{
    double station[STATIONS], cross[] = {0, 2, 4.5, 7};
    trk_beam_options rail, member;
    trk_frame_options frame;
    trk_beam_options_init(&rail, sizeof rail);
    trk_beam_options_init(&member, sizeof member);
    trk_frame_options_init(&frame, sizeof frame);
    trk_status status =
        trk_beam_options_channel(context, 2.06e11, 7.9e10, 7850, 0.26, 0.08, 0.008, 0.008, &rail);
    if (status == TRK_OK)
        status = trk_beam_options_tube(context, 2.06e11, 7.9e10, 7850, 0.1, 0.006, &member);
    for (int k = 0; k < STATIONS; k++)
        station[k] = 0.5 * k;
    rail.stiffness_damping = member.stiffness_damping = beta;
    rail.mass_damping = member.mass_damping = beta > 0 ? 0.5 : 0;
    frame.freedoms = freedoms;
    frame.stations = STATIONS;
    frame.station = station;
    frame.crosses = 4;
    frame.cross = cross;
    frame.half_width = 0.425;
    frame.rail = &rail;
    frame.member = &member;
    frame.member_elements = 2;
    return status == TRK_OK ? trk_spec_add_frame(spec, "frame", &frame) : status;
}

static inline trk_status nearest(const trk_spec *spec, double x, double y, int32_t *out)
{
    const double point[] = {x, y, 0};
    return trk_spec_nearest_body(spec, "frame.*", point, out);
}

/* A wheel on its road and the spring from it to the frame. */
static inline trk_status add_wheel(trk_spec *spec, int k)
{
    char name[16];
    trk_body_options body;
    trk_link_options tire, spring;
    trk_body_options_init(&body, sizeof body);
    trk_link_options_init(&tire, sizeof tire);
    trk_link_options_init(&spring, sizeof spring);
    const double x = k < 2 ? 1 : 5.5, y = k % 2 ? -0.425 : 0.425;
    body.mass = 300;
    tire.stiffness = 9e5;
    tire.damping = 500;
    spring.stiffness = 2e5;
    spring.damping = 8e3;
    spring.to_point[0] = x;
    spring.to_point[1] = y;
    snprintf(name, sizeof name, "wheel%d", k);
    trk_status status = trk_spec_add_body(spec, name, &body, &spring.from_body);
    tire.to_body = spring.from_body;
    if (status == TRK_OK)
        status = trk_spec_add_road(spec, name, x, y, &tire.from_road);
    if (status == TRK_OK)
        status = nearest(spec, x, y, &spring.to_body);
    snprintf(name, sizeof name, "tire%d", k);
    if (status == TRK_OK)
        status = trk_spec_add_link(spec, name, &tire, NULL);
    snprintf(name, sizeof name, "spring%d", k);
    return status == TRK_OK ? trk_spec_add_link(spec, name, &spring, NULL) : status;
}

/* A cab on two mounts, an engine of 800 kg fixed to the frame, a strut between nodes of it. */
static inline trk_status add_load(trk_spec *spec)
{
    trk_body_options cab;
    trk_link_options mount, strut;
    trk_body_options_init(&cab, sizeof cab);
    trk_link_options_init(&mount, sizeof mount);
    trk_link_options_init(&strut, sizeof strut);
    cab.mass = 700;
    cab.inertia[1] = 500;
    cab.freedoms = TRK_FREE_Z | TRK_FREE_PITCH;
    cab.cg[0] = 1;
    mount.stiffness = 1.5e5;
    mount.damping = 3e3;
    trk_status status = trk_spec_add_body(spec, "cab", &cab, &mount.to_body);
    for (int k = 0; status == TRK_OK && k < 2; k++) {
        mount.from_point[0] = mount.to_point[0] = 2 * k;
        status = nearest(spec, 2 * k, 0, &mount.from_body);
        if (status == TRK_OK)
            status = trk_spec_add_link(spec, k ? "rear mount" : "front mount", &mount, NULL);
    }
    const double engine[] = {1.5, 0.425, 0.1};
    int32_t node = 0;
    if (status == TRK_OK)
        status = nearest(spec, 1.5, 0.425, &node);
    if (status == TRK_OK)
        status = trk_spec_add_mass(spec, "engine", node, 800, engine, NULL);
    strut.stiffness = 3e5;
    strut.damping = 100;
    if (status == TRK_OK)
        status = nearest(spec, 6, 0.425, &strut.from_body);
    if (status == TRK_OK)
        status = nearest(spec, 6.5, -0.425, &strut.to_body);
    return status == TRK_OK ? trk_spec_add_link(spec, "strut", &strut, NULL) : status;
}

/* What is looked at: accelerations of cab and of the frame's end, displacement of its middle,
 * forces of a spring and of the strut; a port at the frame's end. */
static inline trk_status add_sensors(trk_spec *spec)
{
    trk_sensor_options sensor;
    trk_port_options port;
    trk_sensor_options_init(&sensor, sizeof sensor);
    trk_port_options_init(&port, sizeof port);
    sensor.body = trk_spec_find(spec, TRK_PART_BODY, "cab");
    trk_status status = trk_spec_add_sensor(spec, "cab", &sensor, NULL);
    if (status == TRK_OK)
        status = nearest(spec, 7, 0.425, &sensor.body);
    port.body = sensor.body;
    if (status == TRK_OK)
        status = trk_spec_add_sensor(spec, "end", &sensor, NULL);
    if (status == TRK_OK)
        status = trk_spec_add_port(spec, "end", &port, NULL);
    sensor.quantity = TRK_QUANTITY_DISPLACEMENT;
    if (status == TRK_OK)
        status = nearest(spec, 3.5, -0.425, &sensor.body);
    if (status == TRK_OK)
        status = trk_spec_add_sensor(spec, "middle", &sensor, NULL);
    sensor.quantity = TRK_QUANTITY_FORCE;
    sensor.body = 0;
    sensor.link = trk_spec_find(spec, TRK_PART_LINK, "spring0");
    if (status == TRK_OK)
        status = trk_spec_add_sensor(spec, "spring", &sensor, NULL);
    sensor.link = trk_spec_find(spec, TRK_PART_LINK, "strut");
    return status == TRK_OK ? trk_spec_add_sensor(spec, "strut", &sensor, NULL) : status;
}

/* beta: stiffness damping of the beams [s]. */
static inline trk_status try_truck(trk_context *context, double gravity, double beta,
                                   trk_model **out_model)
{
    trk_spec *spec;
    *out_model = NULL;
    trk_status status = trk_spec_create(context, "truck", &spec);
    if (status == TRK_OK)
        status = add_frame(spec, context, TRK_FREE_Z | TRK_FREE_ROLL | TRK_FREE_PITCH, beta);
    for (int k = 0; status == TRK_OK && k < WHEELS; k++)
        status = add_wheel(spec, k);
    if (status == TRK_OK)
        status = add_load(spec);
    if (status == TRK_OK)
        status = add_sensors(spec);
    trk_model_options options;
    trk_model_options_init(&options, sizeof options);
    options.gravity = gravity;
    if (status == TRK_OK)
        status = trk_model_compile(context, spec, &options, out_model);
    trk_spec_destroy(spec);
    return status;
}

static inline trk_model *truck(trk_context *context, double gravity, double beta)
{
    trk_model *model;
    assert_ok(context, try_truck(context, gravity, beta, &model));
    return model;
}

static inline trk_model *reduce(trk_context *context, const trk_model *model, int32_t modes,
                                int32_t interface_modes)
{
    trk_model *reduced;
    trk_reduce_options options;
    trk_reduce_options_init(&options, sizeof options);
    options.modes = modes;
    options.interface_modes = interface_modes;
    assert_ok(context, trk_model_reduce(context, model, &options, &reduced));
    return reduced;
}

#endif
