/* SPDX-License-Identifier: MIT */
#include "chain.h"

static void add_mass(const bench *b, trk_spec *spec, int32_t k)
{
    char name[32];
    trk_body_options o;
    trk_body_options_init(&o, sizeof o);
    o.freedoms = TRK_FREE_Z;
    o.mass = 10;
    snprintf(name, sizeof name, "m%d", (int)k);
    bench_must(b, trk_spec_add_body(spec, name, &o, NULL));
}

/* Between two bodies; from 0 is the road. */
static void add_spring(const bench *b, trk_spec *spec, int32_t from, int32_t to,
                       const trk_curve *damper)
{
    char name[32];
    trk_link_options o;
    trk_link_options_init(&o, sizeof o);
    o.from_body = from;
    o.from_road = from == 0 ? 1 : 0;
    o.to_body = to;
    o.stiffness = 1e5;
    o.damping = 50;
    o.damper_curve = damper;
    o.damper_scale = 0.1;
    snprintf(name, sizeof name, "k%d-%d", (int)from, (int)to);
    bench_must(b, trk_spec_add_link(spec, name, &o, NULL));
}

trk_model *chain_build(const bench *b, int32_t n, int32_t columns)
{
    trk_spec *spec;
    trk_model *model;
    trk_curve *curve;
    bench_must(b,
               trk_vehicle_create_curve(b->context, TRK_TABLE_THESIS_EXAMPLE_DAMPER, NULL, &curve));
    bench_must(b, trk_spec_create(b->context, "chain", &spec));
    bench_must(b, trk_spec_add_road(spec, "road", 0, 0, NULL));
    for (int32_t k = 1; k <= n; k++) {
        add_mass(b, spec, k);
        add_spring(b, spec, k > columns ? k - columns : 0, k, k <= CHAIN_CURVES ? curve : NULL);
        if ((k - 1) % columns > 0)
            add_spring(b, spec, k - 1, k, NULL);
    }
    trk_curve_destroy(curve);
    bench_must(b, trk_model_compile(b->context, spec, NULL, &model));
    trk_spec_destroy(spec);
    return model;
}
