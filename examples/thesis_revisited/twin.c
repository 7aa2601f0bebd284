/* SPDX-License-Identifier: MIT */
/* Two vehicles in one spec, so that one calibration sees both. */
#include "thesis_revisited.h"

#include <string.h>

static const char *prefixed(const char *prefix, const trk_spec *spec, trk_part part, int32_t id)
{
    static char name[160];
    snprintf(name, sizeof name, "%s%s", prefix, trk_spec_part_name(spec, part, id));
    return name;
}

/* Id in the common spec of what is number `id` in the twin. */
static int32_t moved(int32_t id, int32_t before)
{
    return id > 0 ? id + before : id;
}

static void add_links(trk_context *context, trk_spec *spec, const trk_spec *twin,
                      const char *prefix, int32_t bodies, int32_t roads)
{
    for (int32_t k = 1; k <= trk_spec_count(twin, TRK_PART_LINK); k++) {
        trk_link_options link;
        trk_link_options_init(&link, sizeof link);
        check(context, trk_spec_get_link(twin, k, &link));
        link.from_body = moved(link.from_body, bodies);
        link.to_body = moved(link.to_body, bodies);
        link.from_road = moved(link.from_road, roads);
        check(context,
              trk_spec_add_link(spec, prefixed(prefix, twin, TRK_PART_LINK, k), &link, NULL));
    }
}

static void add_sensors(trk_context *context, trk_spec *spec, const trk_spec *twin,
                        const char *prefix, int32_t bodies, int32_t links)
{
    for (int32_t k = 1; k <= trk_spec_count(twin, TRK_PART_SENSOR); k++) {
        trk_sensor_options sensor;
        trk_sensor_options_init(&sensor, sizeof sensor);
        check(context, trk_spec_get_sensor(twin, k, &sensor));
        sensor.body = moved(sensor.body, bodies);
        sensor.link = moved(sensor.link, links);
        check(context,
              trk_spec_add_sensor(spec, prefixed(prefix, twin, TRK_PART_SENSOR, k), &sensor, NULL));
    }
}

void add_twin(trk_context *context, trk_spec *spec, const trk_spec *twin, const char *prefix)
{
    int32_t bodies = trk_spec_count(spec, TRK_PART_BODY);
    int32_t roads = trk_spec_count(spec, TRK_PART_ROAD);
    int32_t links = trk_spec_count(spec, TRK_PART_LINK);
    for (int32_t k = 1; k <= trk_spec_count(twin, TRK_PART_BODY); k++) {
        trk_body_options body;
        trk_body_options_init(&body, sizeof body);
        check(context, trk_spec_get_body(twin, k, &body));
        check(context,
              trk_spec_add_body(spec, prefixed(prefix, twin, TRK_PART_BODY, k), &body, NULL));
    }
    for (int32_t k = 1; k <= trk_spec_count(twin, TRK_PART_ROAD); k++) {
        double x, y;
        check(context, trk_spec_get_road(twin, k, &x, &y));
        check(context,
              trk_spec_add_road(spec, prefixed(prefix, twin, TRK_PART_ROAD, k), x, y, NULL));
    }
    add_links(context, spec, twin, prefix, bodies, roads);
    add_sensors(context, spec, twin, prefix, bodies, links);
}
