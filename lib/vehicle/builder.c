/* SPDX-License-Identifier: MIT */
/* Spec calls with a sticky status and formatted names. */
#include "vehicle/builder.h"

#include <string.h>

enum { NAME_SIZE = 128 };

void trk_builder_begin(trk_builder *builder, trk_context *context, const char *name)
{
    *builder = (trk_builder){context, NULL, TRK_OK};
    builder->status = trk_spec_create(context, name, &builder->spec);
}

trk_status trk_builder_end(trk_builder *builder, trk_spec **out_spec)
{
    if (builder->status == TRK_OK) {
        *out_spec = builder->spec;
    } else {
        trk_spec_destroy(builder->spec);
        *out_spec = NULL;
    }
    builder->spec = NULL;
    return builder->status;
}

#define FORMAT_NAME(name, text)                                                                    \
    char text[NAME_SIZE];                                                                          \
    do {                                                                                           \
        va_list arguments;                                                                         \
        va_start(arguments, name);                                                                 \
        trk_format_list(text, sizeof text, name, arguments);                                       \
        va_end(arguments);                                                                         \
    } while (0)

int32_t trk_builder_body(trk_builder *builder, int32_t freedoms, double mass, const double *inertia,
                         const double *cg, const char *name, ...)
{
    FORMAT_NAME(name, text);
    trk_body_options body;
    trk_body_options_init(&body, sizeof body);
    body.freedoms = freedoms;
    body.mass = mass;
    memcpy(body.inertia, inertia, sizeof body.inertia);
    memcpy(body.cg, cg, sizeof body.cg);
    int32_t id = 0;
    if (builder->status == TRK_OK)
        builder->status = trk_spec_add_body(builder->spec, text, &body, &id);
    return id;
}

int32_t trk_builder_road(trk_builder *builder, double x, double y, const char *name, ...)
{
    FORMAT_NAME(name, text);
    int32_t id = 0;
    if (builder->status == TRK_OK)
        builder->status = trk_spec_add_road(builder->spec, text, x, y, &id);
    return id;
}

int32_t trk_builder_link(trk_builder *builder, const trk_link_options *link, const char *name, ...)
{
    FORMAT_NAME(name, text);
    int32_t id = 0;
    bool does_something =
        link->stiffness != 0 || link->damping != 0 || link->spring_curve || link->damper_curve;
    if (builder->status == TRK_OK && does_something)
        builder->status = trk_spec_add_link(builder->spec, text, link, &id);
    return id;
}

void trk_builder_port(trk_builder *builder, int32_t body, const double *point, int axis,
                      const char *name, ...)
{
    FORMAT_NAME(name, text);
    trk_port_options port;
    trk_port_options_init(&port, sizeof port);
    port.body = body;
    memcpy(port.point, point, sizeof port.point);
    memset(port.direction, 0, sizeof port.direction);
    port.direction[axis] = 1;
    if (builder->status == TRK_OK)
        builder->status = trk_spec_add_port(builder->spec, text, &port, NULL);
}

void trk_builder_accelerometer(trk_builder *builder, int32_t body, const double *point, int axis,
                               const char *name, ...)
{
    FORMAT_NAME(name, text);
    trk_sensor_options sensor;
    trk_sensor_options_init(&sensor, sizeof sensor);
    sensor.body = body;
    memcpy(sensor.point, point, sizeof sensor.point);
    memset(sensor.direction, 0, sizeof sensor.direction);
    sensor.direction[axis] = 1;
    if (builder->status == TRK_OK)
        builder->status = trk_spec_add_sensor(builder->spec, text, &sensor, NULL);
}

void trk_builder_force_sensor(trk_builder *builder, int32_t link, const char *name, ...)
{
    FORMAT_NAME(name, text);
    trk_sensor_options sensor;
    trk_sensor_options_init(&sensor, sizeof sensor);
    sensor.quantity = TRK_QUANTITY_FORCE;
    sensor.link = link;
    if (builder->status == TRK_OK && link)
        builder->status = trk_spec_add_sensor(builder->spec, text, &sensor, NULL);
}
