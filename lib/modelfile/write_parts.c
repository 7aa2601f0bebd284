/* SPDX-License-Identifier: MIT */
/* Parts of a spec as groups of a model file. */
#include <string.h>

#include "modelfile/writer.h"

/* Name of the body of a mass, port or sensor. */
static void write_body(trk_writer *w, int32_t body)
{
    const char *name = trk_spec_part_name(w->spec, TRK_PART_BODY, body);
    if (name)
        trk_emit_text(&w->emit, "body", name);
}

static void write_end(trk_writer *w, const char *key, int32_t body, int32_t road,
                      const double *point)
{
    trk_emit *emit = &w->emit;
    const char *name = body ? trk_spec_part_name(w->spec, TRK_PART_BODY, body) : "ground";
    if (!point && !road && (!body || strcmp(name, "ground") != 0)) {
        trk_emit_text(emit, key, name);
        return;
    }
    trk_emit_open(emit, key, '{');
    if (road)
        trk_emit_text(emit, "road", trk_spec_part_name(w->spec, TRK_PART_ROAD, road));
    else if (body)
        trk_emit_text(emit, "body", name);
    else
        trk_emit_truth(emit, "ground", true);
    if (point)
        trk_write_triple(emit, "point", point);
    trk_emit_close(emit, '}');
}

void trk_write_body(trk_writer *w, int32_t id)
{
    trk_body_options body, defaults;
    trk_body_options_init(&defaults, sizeof defaults);
    body = defaults;
    if (trk_spec_get_body(w->spec, id, &body) == TRK_OK)
        trk_write_fields(w, trk_body_entries, &body, &defaults);
}

void trk_write_mass(trk_writer *w, int32_t id)
{
    trk_file_mass mass = {0};
    const trk_file_mass defaults = {0};
    if (trk_spec_get_mass(w->spec, id, &mass.body, &mass.mass, mass.point) == TRK_OK) {
        write_body(w, mass.body);
        trk_write_fields(w, trk_mass_entries, &mass, &defaults);
    }
}

void trk_write_road(trk_writer *w, int32_t id)
{
    trk_file_road road = {0};
    const trk_file_road defaults = {0};
    if (trk_spec_get_road(w->spec, id, &road.x, &road.y) == TRK_OK)
        trk_write_fields(w, trk_road_entries, &road, &defaults);
}

void trk_write_beam(trk_writer *w, int32_t id)
{
    trk_beam_options beam, defaults;
    trk_beam_options_init(&defaults, sizeof defaults);
    beam = defaults;
    if (trk_spec_get_beam(w->spec, id, &beam) == TRK_OK) {
        write_end(w, "from", beam.from_body, 0, beam.from_point);
        write_end(w, "to", beam.to_body, 0, beam.to_point);
        trk_write_fields(w, trk_beam_entries, &beam, &defaults);
    }
}

void trk_write_link(trk_writer *w, int32_t id)
{
    static const double origin[3];
    trk_link_options link, defaults;
    trk_link_options_init(&defaults, sizeof defaults);
    link = defaults;
    if (trk_spec_get_link(w->spec, id, &link))
        return;
    const bool one = memcmp(link.from_point, link.to_point, sizeof link.to_point) == 0;
    write_end(w, "from", link.from_body, link.from_road, one ? NULL : link.from_point);
    write_end(w, "to", link.to_body, 0, one ? NULL : link.to_point);
    if (one && memcmp(link.to_point, origin, sizeof origin) != 0)
        trk_write_triple(&w->emit, "point", link.to_point);
    trk_write_fields(w, trk_link_entries, &link, &defaults);
}

void trk_write_port(trk_writer *w, int32_t id)
{
    trk_port_options port, defaults;
    trk_port_options_init(&defaults, sizeof defaults);
    port = defaults;
    if (trk_spec_get_port(w->spec, id, &port) == TRK_OK) {
        write_body(w, port.body);
        trk_write_fields(w, trk_port_entries, &port, &defaults);
    }
}

void trk_write_sensor(trk_writer *w, int32_t id)
{
    trk_sensor_options sensor, defaults;
    trk_sensor_options_init(&defaults, sizeof defaults);
    sensor = defaults;
    if (trk_spec_get_sensor(w->spec, id, &sensor) == TRK_OK) {
        write_body(w, sensor.body);
        trk_write_fields(w, trk_sensor_entries, &sensor, &defaults);
    }
}
