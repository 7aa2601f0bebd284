/* SPDX-License-Identifier: MIT */
#include "rig.h"

#include <stdlib.h>
#include <string.h>

static const double wheel_gain[RIG_ROADS] = {10, 6, -8, 5};

/* Copy a spec with its first `sensors` sensors only. */
static trk_spec *with_sensors(const bench *b, const trk_spec *from, int32_t sensors)
{
    trk_spec *to;
    bench_must(b, trk_spec_create(b->context, trk_spec_name(from), &to));
    for (int32_t k = 1; k <= trk_spec_count(from, TRK_PART_BODY); k++) {
        trk_body_options o = {.struct_size = sizeof o};
        bench_must(b, trk_spec_get_body(from, k, &o));
        bench_must(b, trk_spec_add_body(to, trk_spec_part_name(from, TRK_PART_BODY, k), &o, NULL));
    }
    for (int32_t k = 1; k <= trk_spec_count(from, TRK_PART_ROAD); k++) {
        double x, y;
        bench_must(b, trk_spec_get_road(from, k, &x, &y));
        bench_must(b,
                   trk_spec_add_road(to, trk_spec_part_name(from, TRK_PART_ROAD, k), x, y, NULL));
    }
    for (int32_t k = 1; k <= trk_spec_count(from, TRK_PART_LINK); k++) {
        trk_link_options o = {.struct_size = sizeof o};
        bench_must(b, trk_spec_get_link(from, k, &o));
        bench_must(b, trk_spec_add_link(to, trk_spec_part_name(from, TRK_PART_LINK, k), &o, NULL));
    }
    for (int32_t k = 1; k <= trk_spec_count(from, TRK_PART_PORT); k++) {
        trk_port_options o = {.struct_size = sizeof o};
        bench_must(b, trk_spec_get_port(from, k, &o));
        bench_must(b, trk_spec_add_port(to, trk_spec_part_name(from, TRK_PART_PORT, k), &o, NULL));
    }
    for (int32_t k = 1; k <= sensors; k++) {
        trk_sensor_options o = {.struct_size = sizeof o};
        bench_must(b, trk_spec_get_sensor(from, k, &o));
        bench_must(b,
                   trk_spec_add_sensor(to, trk_spec_part_name(from, TRK_PART_SENSOR, k), &o, NULL));
    }
    return to;
}

/* Friction on the links between the road's wheels and the frame that are called springs. */
static void add_leaves(const bench *b, trk_spec *spec)
{
    trk_law *leaf;
    trk_leaf_options options;
    trk_leaf_options_init(&options, sizeof options);
    options.friction = 2500;
    options.approach_bump = 0.002;
    bench_must(b, trk_law_create_leaf(b->context, "leaf", &options, &leaf));
    for (int32_t k = 1; k <= trk_spec_count(spec, TRK_PART_LINK); k++) {
        const char *name = trk_spec_part_name(spec, TRK_PART_LINK, k);
        trk_link_options o = {.struct_size = sizeof o};
        if (!strstr(name, "_spring") || strstr(name, "cab"))
            continue;
        bench_must(b, trk_spec_get_link(spec, k, &o));
        o.law = leaf;
        bench_must(b, trk_spec_set_link(spec, k, &o));
    }
    trk_law_destroy(leaf);
}

static void compile(rig *r, trk_vehicle vehicle, trk_variant variant, int32_t sensors,
                    bool on_leaves)
{
    const bench *b = r->bench;
    trk_spec *spec;
    bench_must(b, trk_vehicle_create_builtin(b->context, vehicle, variant, &spec));
    if (on_leaves)
        add_leaves(b, spec);
    if (sensors != RIG_ALL_SENSORS) {
        trk_spec *fewer = with_sensors(b, spec, sensors);
        trk_spec_destroy(spec);
        spec = fewer;
    }
    bench_must(b, trk_model_compile(b->context, spec, NULL, &r->model));
    r->curves = 0;
    for (int32_t k = 1; k <= trk_spec_count(spec, TRK_PART_LINK); k++) {
        trk_link_options o = {.struct_size = sizeof o};
        bench_must(b, trk_spec_get_link(spec, k, &o));
        r->curves += (o.spring_curve != NULL) + (o.damper_curve != NULL);
    }
    trk_spec_destroy(spec);
    r->n = trk_model_count(r->model, TRK_PART_COORDINATE);
    r->roads = trk_model_count(r->model, TRK_PART_ROAD);
    r->links = trk_model_count(r->model, TRK_PART_LINK);
    r->sensors = trk_model_count(r->model, TRK_PART_SENSOR);
}

static void create(const bench *b, trk_vehicle vehicle, trk_variant variant, int32_t sensors,
                   bool on_leaves, double seconds, rig *out)
{
    trk_sweep_options options;
    *out = (rig){.bench = b, .seconds = seconds, .steps = (int64_t)(1000 * seconds)};
    compile(out, vehicle, variant, sensors, on_leaves);
    trk_sweep_options_init(&options, sizeof options);
    options.duration = seconds;
    bench_must(b, trk_signal_create_sweep(b->context, &options, &out->sweep));
    bench_must(b, trk_excitation_create(b->context, out->model, &out->road));
    for (int32_t k = 0; k < out->roads; k++) {
        out->gain[k] = wheel_gain[k];
        bench_must(b, trk_excitation_add_motion(out->road, k + 1, out->sweep, wheel_gain[k], 0));
    }
    out->height = bench_zeros((out->steps + 1) * out->roads);
    out->velocity = bench_zeros((out->steps + 1) * out->roads);
    trk_excitation_evaluate(out->road, out->steps + 1, 0, 1e-3, out->height, out->velocity, NULL);
}

void rig_create(const bench *b, trk_vehicle vehicle, trk_variant variant, int32_t sensors,
                double seconds, rig *out)
{
    create(b, vehicle, variant, sensors, false, seconds, out);
}

void rig_create_on_leaves(const bench *b, trk_vehicle vehicle, trk_variant variant, double seconds,
                          rig *out)
{
    create(b, vehicle, variant, RIG_ALL_SENSORS, true, seconds, out);
}

void rig_destroy(rig *r)
{
    free(r->height);
    free(r->velocity);
    trk_excitation_destroy(r->road);
    trk_signal_destroy(r->sweep);
    trk_model_destroy(r->model);
}

trk_newmark *rig_stepper(const rig *r, double step)
{
    trk_newmark_options options;
    trk_newmark *stepper;
    trk_newmark_options_init(&options, sizeof options);
    options.step = step;
    bench_must(r->bench, trk_newmark_create(r->bench->context, r->model, &options, &stepper));
    bench_must(r->bench,
               trk_newmark_set_state(stepper, 0, NULL, NULL, r->height, r->velocity, NULL));
    return stepper;
}

double rig_drive(const rig *r, trk_newmark *stepper, double *out_q)
{
    double start = bench_cpu();
    for (int64_t k = 1; k <= r->steps; k++) {
        bench_must(r->bench, trk_newmark_step(stepper, r->height + k * r->roads,
                                              r->velocity + k * r->roads, NULL));
        if (out_q && k % RIG_EVERY == 0)
            trk_newmark_get_state(stepper, out_q + k / RIG_EVERY * r->n, NULL, NULL);
    }
    return bench_cpu() - start;
}

double rig_run_stepper(const rig *r, double *out_q, trk_newmark_statistics *out_statistics)
{
    trk_newmark *stepper = rig_stepper(r, 1e-3);
    double seconds = rig_drive(r, stepper, out_q);
    *out_statistics = (trk_newmark_statistics){.struct_size = sizeof *out_statistics};
    bench_must(r->bench, trk_newmark_get_statistics(stepper, out_statistics));
    trk_newmark_destroy(stepper);
    return seconds;
}

double rig_run_simulate(const rig *r)
{
    trk_simulate_options options;
    trk_simulate_options_init(&options, sizeof options);
    options.duration = r->seconds;
    trk_series *series;
    double start = bench_cpu();
    bench_must(r->bench, trk_simulate(r->bench->context, r->model, r->road, NULL, &options, NULL,
                                      NULL, &series));
    double seconds = bench_cpu() - start;
    trk_series_destroy(series);
    return seconds;
}
