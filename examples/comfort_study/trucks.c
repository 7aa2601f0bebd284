/* SPDX-License-Identifier: MIT */
/* The truck, its front dampers and what it records. */
#include "comfort_study.h"

#include <stdlib.h>

const char *const truck_names[TRUCKS] = {"thesis_dampers", "linear"};
const char *const damper_names[DAMPERS] = {"standard", "harder", "undamped"};
const char *const channel_names[CHANNELS] = {
    "cab_x", "cab_y", "cab_z", "front_tire", "rear_tire", "front_travel", "rear_travel"};

static const trk_variant variants[TRUCKS] = {TRK_VARIANT_THESIS_DAMPERS, TRK_VARIANT_LINEAR};
static const double factor[DAMPERS] = {1, 2, 0};

/* On the floor of the cab, left, where a driver's seat would stand [m]. */
static const double driver[3] = {0.6, 0.6, 1.2};

/* Left wheels: the right ones differ by chance alone. */
static const char *const tires[AXLES] = {"front_left_tire", "rear_left_tire"};
static const char *const springs[AXLES] = {"front_left_spring", "rear_left_spring"};

static void add_link_sensor(trk_context *context, trk_spec *spec, int channel, const char *link,
                            trk_quantity quantity)
{
    trk_sensor_options sensor;
    trk_sensor_options_init(&sensor, sizeof sensor);
    sensor.quantity = quantity;
    sensor.link = trk_spec_find(spec, TRK_PART_LINK, link);
    check(context, trk_spec_add_sensor(spec, channel_names[channel], &sensor, NULL));
}

static void add_sensors(trk_context *context, trk_spec *spec)
{
    trk_sensor_options cab;
    trk_sensor_options_init(&cab, sizeof cab);
    cab.body = trk_spec_find(spec, TRK_PART_BODY, "cab");
    for (int i = 0; i < 3; i++)
        cab.point[i] = driver[i];
    for (int axis = 0; axis < 3; axis++) {
        for (int i = 0; i < 3; i++)
            cab.direction[i] = i == axis;
        check(context, trk_spec_add_sensor(spec, channel_names[CAB_X + axis], &cab, NULL));
    }
    for (int axle = 0; axle < AXLES; axle++) {
        add_link_sensor(context, spec, FRONT_TIRE + axle, tires[axle], TRK_QUANTITY_FORCE);
        add_link_sensor(context, spec, FRONT_TRAVEL + axle, springs[axle], TRK_QUANTITY_ELONGATION);
    }
}

trk_model *create_truck(trk_context *context, int truck, int damper)
{
    trk_spec *spec;
    trk_model *model;
    trk_model_options weight;
    trk_model_options_init(&weight, sizeof weight);
    weight.gravity = TRK_STANDARD_GRAVITY;
    check(context,
          trk_vehicle_create_builtin(context, TRK_VEHICLE_REFERENCE_TRUCK, variants[truck], &spec));
    check(context, trk_spec_vary(spec, TRK_FIELD_DAMPING, "front_*_damper", TRK_MEANING_FACTOR,
                                 factor[damper], NULL));
    add_sensors(context, spec);
    check(context, trk_model_compile(context, spec, &weight, &model));
    trk_spec_destroy(spec);
    return model;
}

int32_t sensor_of(const trk_model *model, int channel)
{
    return trk_model_find(model, TRK_PART_SENSOR, channel_names[channel]);
}

trk_axis axis_of(int channel)
{
    static const trk_axis axes[] = {TRK_AXIS_SEAT_X, TRK_AXIS_SEAT_Y, TRK_AXIS_SEAT_Z};
    return axes[channel - CAB_X];
}

double static_load(const trk_model *model, int axle)
{
    double *force = allocate((size_t)trk_model_count(model, TRK_PART_LINK) * sizeof *force);
    trk_model_get_static(model, NULL, force);
    double load = -force[trk_model_find(model, TRK_PART_LINK, tires[axle]) - 1];
    free(force);
    return load;
}
