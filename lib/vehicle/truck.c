/* SPDX-License-Identifier: MIT */
/*
 * The 3D truck and its left half. One text for both: the half truck has half the
 * masses, the freedoms that a symmetric motion needs, and one side, with the mean of
 * the rates of both.
 */
#include "vehicle/builder.h"
#include "vehicle/parameters.h"

#include <string.h>

/* What is being built. */
typedef struct assembly {
    trk_builder b;
    const trk_truck_parameters *p;
    bool half;
    int32_t cab, frame, axle[2];
} assembly;

static const char *const end_word[2] = {"front", "rear"};

/* "left_", "right_", or nothing in the half truck. */
static const char *side_word(const assembly *a, int side)
{
    return a->half ? "" : side == 0 ? "left_" : "right_";
}

static int side_count(const assembly *a)
{
    return a->half ? 1 : 2;
}

/* Half truck: in the plane of symmetry. 3D: y > 0 on the left, side 0. */
static double side_y(const assembly *a, int side, double y)
{
    return a->half ? 0 : side == 0 ? y : -y;
}

/* Rate of one mount, or the mean of left and right. */
static double mount_rate(const assembly *a, const double *rate, int end, int side)
{
    return a->half ? (rate[2 * end] + rate[2 * end + 1]) / 2 : rate[2 * end + side];
}

/* Translational link along an axis between two bodies at one point. */
static trk_link_options link_at(int32_t from, int32_t to, int axis, double x, double y, double z)
{
    trk_link_options link;
    trk_link_options_init(&link, sizeof link);
    const double point[3] = {x, y, z};
    link.from_body = from;
    link.to_body = to;
    memcpy(link.from_point, point, sizeof point);
    memcpy(link.to_point, point, sizeof point);
    memset(link.direction, 0, sizeof link.direction);
    link.direction[axis] = 1;
    return link;
}

/* Torsional link about x between two bodies. */
static void add_anti_roll_bar(assembly *a, int32_t from, int32_t to, double stiffness,
                              const char *name)
{
    trk_link_options bar = link_at(from, to, 0, 0, 0, 0);
    bar.motion = TRK_MOTION_ROTATION;
    bar.stiffness = stiffness;
    if (!a->half)
        trk_builder_link(&a->b, &bar, "%s_anti_roll_bar", name);
}

static void add_bodies(assembly *a)
{
    const trk_truck_parameters *p = a->p;
    const int32_t flat = TRK_FREE_Z | TRK_FREE_PITCH;
    double share = a->half ? 0.5 : 1, cab[3], frame[3];
    for (int k = 0; k < 3; k++) {
        cab[k] = share * p->cab_inertia[k];
        frame[k] = share * p->frame_inertia[k];
    }
    a->cab = trk_builder_body(
        &a->b, TRK_FREE_X | flat | (a->half ? 0 : TRK_FREE_Y | TRK_FREE_ROLL | TRK_FREE_YAW),
        share * p->cab_mass, cab, p->cab_cg, "cab");
    a->frame = trk_builder_body(&a->b, flat | (a->half ? 0 : TRK_FREE_ROLL), share * p->frame_mass,
                                frame, p->frame_cg, "frame");
    for (int end = 0; end < 2; end++) {
        const double inertia[3] = {p->axle_roll_inertia[end], 0, 0};
        const double cg[3] = {p->axle_x[end], 0, p->axle_z[end]};
        a->axle[end] =
            trk_builder_body(&a->b, TRK_FREE_Z | (a->half ? 0 : TRK_FREE_ROLL),
                             share * p->axle_mass[end], inertia, cg, "%s_axle", end_word[end]);
    }
}

/* Tire, spring, damper and bump stop of one wheel. */
static int32_t add_wheel(assembly *a, int end, int side)
{
    const trk_truck_parameters *p = a->p;
    const char *front = end_word[end], *left = side_word(a, side);
    double x = p->axle_x[end], z = p->axle_z[end];

    double tire_y = side_y(a, side, p->tire_y[end]);
    trk_link_options tire = link_at(0, a->axle[end], 2, x, tire_y, z);
    tire.from_road = trk_builder_road(&a->b, x, tire_y, a->half ? "%s" : "%s_%.*s", front,
                                      (int)strlen(left) - 1, left);
    tire.stiffness = p->tire_stiffness[end];
    tire.damping = p->tire_damping[end];
    int32_t tire_id = trk_builder_link(&a->b, &tire, "%s_%stire", front, left);

    double spring_y = side_y(a, side, p->spring_y[end]);
    trk_link_options spring = link_at(a->axle[end], a->frame, 2, x, spring_y, z);
    spring.stiffness = p->spring_stiffness[end];
    spring.spring_curve = p->spring_curve[end];
    spring.spring_offset = p->spring_offset[end];
    trk_builder_link(&a->b, &spring, "%s_%sspring", front, left);

    trk_link_options damper =
        link_at(a->axle[end], a->frame, 2, x, side_y(a, side, p->damper_y[end]), z);
    damper.damping = p->damping[end];
    damper.damper_curve = p->damper_curve[end];
    damper.damper_scale = p->damper_scale[end];
    trk_builder_link(&a->b, &damper, "%s_%sdamper", front, left);

    trk_link_options stop = link_at(a->axle[end], a->frame, 2, x, spring_y, z);
    stop.spring_curve = p->bump_stop_curve[end];
    stop.spring_offset = p->bump_stop_offset[end];
    trk_builder_link(&a->b, &stop, "%s_%sbump_stop", front, left);
    return tire_id;
}

/* Vertical mount, longitudinal and lateral arm at one corner of the cab. */
static void add_cab_mount(assembly *a, int end, int side)
{
    const trk_truck_parameters *p = a->p;
    const char *front = end_word[end], *left = side_word(a, side);
    trk_link_options mount = link_at(a->frame, a->cab, 2, p->cab_mount_x[end],
                                     side_y(a, side, p->cab_mount_y[end]), p->cab_mount_z[end]);
    mount.stiffness = mount_rate(a, p->cab_vertical_stiffness, end, side);
    mount.damping = mount_rate(a, p->cab_vertical_damping, end, side);
    mount.spring_curve = p->cab_spring_curve[end];
    mount.spring_offset = p->cab_spring_offset[end];
    mount.damper_curve = p->cab_damper_curve[end];
    mount.damper_scale = p->cab_damper_scale[end];
    trk_builder_link(&a->b, &mount, "cab_%s_%svertical", front, left);

    trk_link_options arm =
        link_at(a->frame, a->cab, 0, p->cab_longitudinal_x[end],
                side_y(a, side, p->cab_longitudinal_y[end]), p->cab_longitudinal_z[end]);
    arm.stiffness = mount_rate(a, p->cab_longitudinal_stiffness, end, side);
    arm.damping = mount_rate(a, p->cab_longitudinal_damping, end, side);
    trk_builder_link(&a->b, &arm, "cab_%s_%slongitudinal", front, left);

    if (a->half)
        return;
    arm = link_at(a->frame, a->cab, 1, p->cab_lateral_x[end],
                  side_y(a, side, p->cab_lateral_y[end]), p->cab_lateral_z[end]);
    arm.stiffness = mount_rate(a, p->cab_lateral_stiffness, end, side);
    arm.damping = mount_rate(a, p->cab_lateral_damping, end, side);
    trk_builder_link(&a->b, &arm, "cab_%s_%slateral", front, left);
}

/* Accelerometers on one body at a place on both sides, along the axes x, y, z that are wanted. */
static void add_accelerometers(assembly *a, int32_t body, double x, double y, double z,
                               const char *axes, const char *name)
{
    for (int side = 0; side < side_count(a); side++)
        for (const char *axis = axes; *axis; axis++) {
            const double point[3] = {x, side_y(a, side, y), z};
            if (!(a->half && *axis == 'y'))
                trk_builder_accelerometer(&a->b, body, point, *axis - 'x', "%s_%s%c", name,
                                          side_word(a, side), *axis);
        }
}

/* Table 4 of the thesis; the rear cab mount on both sides. */
static void add_sensors(assembly *a, int32_t tire[2][2])
{
    const trk_truck_parameters *p = a->p;
    const double *x = p->cab_mount_x, *y = p->cab_mount_y, *z = p->cab_mount_z;
    add_accelerometers(a, a->cab, x[TRK_FRONT], y[TRK_FRONT], z[TRK_FRONT], "xyz", "cab_front");
    add_accelerometers(a, a->cab, x[TRK_REAR], y[TRK_REAR], z[TRK_REAR], "yz", "cab_rear");
    add_accelerometers(a, a->frame, x[TRK_FRONT], y[TRK_FRONT], z[TRK_FRONT], "xyz", "frame_front");
    add_accelerometers(a, a->frame, x[TRK_REAR], y[TRK_REAR], z[TRK_REAR], "yz", "frame_rear");
    add_accelerometers(a, a->frame, p->axle_x[TRK_REAR], p->spring_y[TRK_REAR], p->frame_cg[2],
                       "yz", "frame_rear_axle");
    for (int end = 0; end < 2; end++)
        add_accelerometers(a, a->axle[end], p->axle_x[end], p->spring_y[end], p->axle_z[end], "z",
                           end == TRK_FRONT ? "front_axle" : "rear_axle");
    for (int end = 0; end < 2; end++)
        for (int side = 0; side < side_count(a); side++)
            trk_builder_force_sensor(&a->b, tire[end][side], "%s_%stire_force", end_word[end],
                                     side_word(a, side));
}

static trk_status create(trk_context *context, const trk_truck_parameters *p, bool half,
                         trk_spec **out_spec)
{
    assembly a = {.p = p, .half = half};
    int32_t tire[2][2] = {{0}};
    trk_builder_begin(&a.b, context, half ? "half truck" : "truck");
    add_bodies(&a);
    for (int end = 0; end < 2; end++)
        for (int side = 0; side < side_count(&a); side++)
            tire[end][side] = add_wheel(&a, end, side);
    for (int end = 0; end < 2; end++)
        for (int side = 0; side < side_count(&a); side++)
            add_cab_mount(&a, end, side);
    add_anti_roll_bar(&a, a.axle[TRK_FRONT], a.frame, p->anti_roll_stiffness[TRK_FRONT], "front");
    add_anti_roll_bar(&a, a.axle[TRK_REAR], a.frame, p->anti_roll_stiffness[TRK_REAR], "rear");
    add_anti_roll_bar(&a, a.frame, a.cab, p->cab_anti_roll_stiffness, "cab");
    trk_builder_port(&a.b, a.frame, p->fifth_wheel, 0, "fifth_wheel_x");
    trk_builder_port(&a.b, a.frame, p->fifth_wheel, 2, "fifth_wheel_z");
    add_sensors(&a, tire);
    return trk_builder_end(&a.b, out_spec);
}

trk_status trk_vehicle_create_truck(trk_context *context, const trk_truck_parameters *parameters,
                                    trk_spec **out_spec)
{
    TRK_REQUIRE(context, out_spec, "trk_vehicle_create_truck");
    *out_spec = NULL;
    TRK_REQUIRE(context, context, "trk_vehicle_create_truck");
    trk_truck_parameters p;
    trk_status status = trk_truck_read(context, parameters, &p);
    return status == TRK_OK ? create(context, &p, false, out_spec) : status;
}

trk_status trk_vehicle_create_half_truck(trk_context *context,
                                         const trk_truck_parameters *parameters,
                                         trk_spec **out_spec)
{
    TRK_REQUIRE(context, out_spec, "trk_vehicle_create_half_truck");
    *out_spec = NULL;
    TRK_REQUIRE(context, context, "trk_vehicle_create_half_truck");
    trk_truck_parameters p;
    trk_status status = trk_truck_read(context, parameters, &p);
    return status == TRK_OK ? create(context, &p, true, out_spec) : status;
}

trk_status trk_vehicle_create_axle_quarter(trk_context *context,
                                           const trk_truck_parameters *parameters, int32_t axle,
                                           trk_spec **out_spec)
{
    TRK_REQUIRE(context, out_spec, "trk_vehicle_create_axle_quarter");
    *out_spec = NULL;
    TRK_REQUIRE(context, context, "trk_vehicle_create_axle_quarter");
    if (axle != TRK_FRONT && axle != TRK_REAR)
        return trk_fail(context, TRK_E_ARGUMENT,
                        "trk_vehicle_create_axle_quarter: there is no axle %d", axle);
    trk_truck_parameters p;
    trk_status status = trk_truck_read(context, parameters, &p);
    if (status != TRK_OK)
        return status;
    double share[2];
    trk_truck_axle_share(&p, share);
    if (!(share[axle] > 0))
        return trk_fail(context, TRK_E_RANGE,
                        "truck: the %s axle carries %g kg of cab and frame; > 0 is needed",
                        end_word[axle], share[axle]);
    trk_quarter_car_parameters q;
    trk_quarter_car_parameters_init(&q, sizeof q);
    q.sprung_mass = share[axle] / 2;
    q.unsprung_mass = p.axle_mass[axle] / 2;
    q.spring_stiffness = p.spring_stiffness[axle];
    q.damping = p.damping[axle];
    q.tire_stiffness = p.tire_stiffness[axle];
    q.tire_damping = p.tire_damping[axle];
    q.spring_curve = p.spring_curve[axle];
    q.spring_offset = p.spring_offset[axle];
    q.damper_curve = p.damper_curve[axle];
    q.damper_scale = p.damper_scale[axle];
    q.bump_stop_curve = p.bump_stop_curve[axle];
    q.bump_stop_offset = p.bump_stop_offset[axle];
    return trk_vehicle_create_quarter_car(context, &q, out_spec);
}
