/* SPDX-License-Identifier: MIT */
/* Bodies, masses, roads, ports and sensors of a model file. */
#include "modelfile/reader.h"

trk_status trk_make_body(trk_reader *reader, const trk_node *part)
{
    char room[TRK_NAME_ROOM];
    trk_body_options body;
    trk_body_options_init(&body, sizeof body);
    trk_status status =
        trk_reader_group(reader, part, (trk_subject){"body", part->key}, trk_body_entries, &body);
    if (status)
        return status;
    status = trk_spec_add_body(reader->spec, trk_reader_name(reader, part->key, room), &body, NULL);
    return trk_reader_pass(reader, part->key_place, status);
}

/* Body or frame that a part sits on. */
static trk_status find_body(const trk_reader *reader, const trk_node *part, trk_subject subject,
                            const double *point, int32_t *out_body)
{
    const trk_node *body = trk_node_find(part, "body"), *frame = trk_node_find(part, "frame");
    if (!body && !frame)
        return trk_reader_fail(reader, part->key_place, TRK_E_SYNTAX, "%s '%.80s' has no 'body'",
                               subject.what, subject.name);
    return trk_reader_body(reader, body, frame, subject, point, out_body);
}

trk_status trk_make_mass(trk_reader *reader, const trk_node *part)
{
    char room[TRK_NAME_ROOM];
    const trk_subject subject = {"mass", part->key};
    trk_file_mass mass = {0};
    trk_status status = trk_reader_group(reader, part, subject, trk_mass_entries, &mass);
    if (status == TRK_OK)
        status = find_body(reader, part, subject, mass.point, &mass.body);
    if (status)
        return status;
    status = trk_spec_add_mass(reader->spec, trk_reader_name(reader, part->key, room), mass.body,
                               mass.mass, mass.point, NULL);
    return trk_reader_pass(reader, part->key_place, status);
}

trk_status trk_make_road(trk_reader *reader, const trk_node *part)
{
    char room[TRK_NAME_ROOM];
    trk_file_road road = {0};
    trk_status status =
        trk_reader_group(reader, part, (trk_subject){"road", part->key}, trk_road_entries, &road);
    if (status)
        return status;
    if (reader->side == TRK_SIDE_RIGHT)
        road.y = 0 - road.y;
    status = trk_spec_add_road(reader->spec, trk_reader_name(reader, part->key, room), road.x,
                               road.y, NULL);
    return trk_reader_pass(reader, part->key_place, status);
}

trk_status trk_make_port(trk_reader *reader, const trk_node *part)
{
    char room[TRK_NAME_ROOM];
    const trk_subject subject = {"port", part->key};
    trk_port_options port;
    trk_port_options_init(&port, sizeof port);
    trk_status status = trk_reader_group(reader, part, subject, trk_port_entries, &port);
    if (status == TRK_OK)
        status = find_body(reader, part, subject, port.point, &port.body);
    if (status)
        return status;
    status = trk_spec_add_port(reader->spec, trk_reader_name(reader, part->key, room), &port, NULL);
    return trk_reader_pass(reader, part->key_place, status);
}

trk_status trk_make_sensor(trk_reader *reader, const trk_node *part)
{
    char room[TRK_NAME_ROOM];
    const trk_subject subject = {"sensor", part->key};
    trk_sensor_options sensor;
    trk_sensor_options_init(&sensor, sizeof sensor);
    trk_status status = trk_reader_group(reader, part, subject, trk_sensor_entries, &sensor);
    if (status)
        return status;
    const bool on_body = sensor.quantity <= TRK_QUANTITY_ACCELERATION;
    if (on_body || trk_node_find(part, "body"))
        status = find_body(reader, part, subject, sensor.point, &sensor.body);
    else if (!sensor.link)
        status = trk_reader_fail(reader, part->key_place, TRK_E_SYNTAX,
                                 "sensor '%.80s' has no 'link'", part->key);
    if (status)
        return status;
    status =
        trk_spec_add_sensor(reader->spec, trk_reader_name(reader, part->key, room), &sensor, NULL);
    return trk_reader_pass(reader, part->key_place, status);
}
