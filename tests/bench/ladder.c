/* SPDX-License-Identifier: MIT */
#include "ladder.h"

#include <stdlib.h>
#include <string.h>

#include <truckride/frame.h>

static const double spacing = 0.5, half_width = 0.4; /* [m] */

/* Two nodes of six coordinates a station, a cross member at every second one and at both ends. */
static void add_frame(const bench *b, trk_spec *spec, int32_t stations)
{
    trk_beam_options rail;
    trk_frame_options o;
    trk_beam_options_init(&rail, sizeof rail);
    trk_frame_options_init(&o, sizeof o);
    bench_must(b, trk_beam_options_channel(b->context, 2.1e11, 8.1e10, 7850, 0.27, 0.08, 0.008,
                                           0.008, &rail));
    rail.stiffness_damping = 1e-5;
    double *station = bench_zeros(stations), *cross = bench_zeros(stations);
    for (int32_t k = 0; k < stations; k++) {
        station[k] = -spacing * k;
        if (k % 2 == 0 || k == stations - 1)
            cross[o.crosses++] = station[k];
    }
    o.stations = stations;
    o.station = station;
    o.cross = cross;
    o.half_width = half_width;
    o.rail = o.member = &rail;
    bench_must(b, trk_spec_add_frame(spec, "frame", &o));
    free(station);
    free(cross);
}

static void add_link(const bench *b, trk_spec *spec, const char *name, int32_t body, int axis,
                     const trk_curve *damper)
{
    trk_link_options o;
    trk_link_options_init(&o, sizeof o);
    trk_body_options node;
    trk_body_options_init(&node, sizeof node);
    bench_must(b, trk_spec_get_body(spec, body, &node));
    memcpy(o.to_point, node.cg, sizeof o.to_point);
    o.to_body = body;
    o.from_road = damper ? 1 : 0;
    memset(o.direction, 0, sizeof o.direction);
    o.direction[axis] = 1;
    o.stiffness = 4e5;
    o.damper_curve = damper;
    bench_must(b, trk_spec_add_link(spec, name, &o, NULL));
}

trk_model *ladder_build(const bench *b, int32_t n)
{
    const int32_t stations = n / 12, corner[4] = {1, 2, 2 * stations - 1, 2 * stations};
    trk_spec *spec;
    trk_model *model;
    trk_curve *curve;
    bench_must(b,
               trk_vehicle_create_curve(b->context, TRK_TABLE_THESIS_EXAMPLE_DAMPER, NULL, &curve));
    bench_must(b, trk_spec_create(b->context, "ladder", &spec));
    bench_must(b, trk_spec_add_road(spec, "road", 0, 0, NULL));
    add_frame(b, spec, stations);
    for (int k = 0; k < 4; k++) {
        char name[32];
        snprintf(name, sizeof name, "tire.%d", k);
        add_link(b, spec, name, corner[k], 2, curve);
        snprintf(name, sizeof name, "tie.%d", k);
        add_link(b, spec, name, corner[k], k % 2, NULL);
    }
    trk_curve_destroy(curve);
    bench_must(b, trk_model_compile(b->context, spec, NULL, &model));
    trk_spec_destroy(spec);
    return model;
}
