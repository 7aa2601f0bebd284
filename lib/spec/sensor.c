/* SPDX-License-Identifier: MIT */
/* Sensors and force ports of a spec: where the outside looks at, or acts on, a vehicle. */
#include "spec/spec.h"

static const trk_sensor_options sensor_defaults = {.struct_size = sizeof sensor_defaults,
                                                   .quantity = TRK_QUANTITY_ACCELERATION,
                                                   .direction = {0, 0, 1}};
static const trk_port_options port_defaults = {.struct_size = sizeof port_defaults,
                                               .direction = {0, 0, 1}};

void trk_sensor_options_init(trk_sensor_options *options, size_t struct_size)
{
    trk_write_defaults(options, struct_size, &sensor_defaults, sizeof sensor_defaults);
}

void trk_port_options_init(trk_port_options *options, size_t struct_size)
{
    trk_write_defaults(options, struct_size, &port_defaults, sizeof port_defaults);
}

/* A motion of a body point, as sensors and ports have it. */
static trk_status check_place(const trk_spec *spec, const char *what, const char *name,
                              int32_t body, trk_motion motion, const double *point,
                              const double *direction)
{
    if (motion != TRK_MOTION_TRANSLATION && motion != TRK_MOTION_ROTATION)
        return trk_fail(spec->context, TRK_E_ARGUMENT, "%s '%s': there is no motion %d", what, name,
                        motion);
    trk_status status = trk_check_id(spec, what, name, TRK_PART_BODY, body);
    if (status == TRK_OK)
        status = trk_check_finite(spec->context, what, name, "point", 3, point);
    if (status == TRK_OK)
        status = trk_check_direction(spec->context, what, name, direction);
    return status;
}

trk_status trk_spec_add_sensor(trk_spec *spec, const char *name, const trk_sensor_options *options,
                               int32_t *out_sensor)
{
    TRK_REQUIRE(NULL, spec, "trk_spec_add_sensor");
    TRK_REQUIRE(spec->context, options, "trk_spec_add_sensor");
    const char *shown = name ? name : "";
    trk_sensor_options sensor = sensor_defaults;
    trk_status status =
        trk_read_options(spec->context, "trk_sensor_options", options, &sensor, sizeof sensor);
    if (status != TRK_OK)
        return status;
    if (sensor.quantity < TRK_QUANTITY_DISPLACEMENT || sensor.quantity > TRK_QUANTITY_FORCE)
        return trk_fail(spec->context, TRK_E_ARGUMENT, "sensor '%s': there is no quantity %d",
                        shown, sensor.quantity);
    if (sensor.quantity <= TRK_QUANTITY_ACCELERATION)
        status = check_place(spec, "sensor", shown, sensor.body, sensor.motion, sensor.point,
                             sensor.direction);
    else
        status = trk_check_id(spec, "sensor", shown, TRK_PART_LINK, sensor.link);
    if (status == TRK_OK)
        status =
            trk_spec_append(spec, TRK_PART_SENSOR, name, (void **)&spec->sensors, sizeof sensor);
    if (status != TRK_OK)
        return status;
    int32_t id = trk_spec_count(spec, TRK_PART_SENSOR);
    spec->sensors[id - 1] = sensor;
    if (out_sensor)
        *out_sensor = id;
    return TRK_OK;
}

trk_status trk_spec_get_sensor(const trk_spec *spec, int32_t sensor,
                               trk_sensor_options *out_options)
{
    if (!out_options || sensor < 1 || sensor > trk_spec_count(spec, TRK_PART_SENSOR))
        return TRK_E_ARGUMENT;
    return trk_write_options(out_options, &spec->sensors[sensor - 1], sizeof *spec->sensors);
}

trk_status trk_spec_add_port(trk_spec *spec, const char *name, const trk_port_options *options,
                             int32_t *out_port)
{
    TRK_REQUIRE(NULL, spec, "trk_spec_add_port");
    TRK_REQUIRE(spec->context, options, "trk_spec_add_port");
    trk_port_options port = port_defaults;
    trk_status status =
        trk_read_options(spec->context, "trk_port_options", options, &port, sizeof port);
    if (status == TRK_OK)
        status = check_place(spec, "port", name ? name : "", port.body, port.motion, port.point,
                             port.direction);
    if (status == TRK_OK)
        status = trk_spec_append(spec, TRK_PART_PORT, name, (void **)&spec->ports, sizeof port);
    if (status != TRK_OK)
        return status;
    int32_t id = trk_spec_count(spec, TRK_PART_PORT);
    spec->ports[id - 1] = port;
    if (out_port)
        *out_port = id;
    return TRK_OK;
}

trk_status trk_spec_get_port(const trk_spec *spec, int32_t port, trk_port_options *out_options)
{
    if (!out_options || port < 1 || port > trk_spec_count(spec, TRK_PART_PORT))
        return TRK_E_ARGUMENT;
    return trk_write_options(out_options, &spec->ports[port - 1], sizeof *spec->ports);
}
