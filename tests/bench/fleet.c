/* SPDX-License-Identifier: MIT */
#include "fleet.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static trk_model *build_variant(const bench *b, trk_vehicle vehicle, double share)
{
    trk_spec *spec;
    trk_model *model;
    bench_must(b,
               trk_vehicle_create_builtin(b->context, vehicle, TRK_VARIANT_THESIS_DAMPERS, &spec));
    for (int32_t k = 1; k <= trk_spec_count(spec, TRK_PART_LINK); k++) {
        trk_link_options o = {.struct_size = sizeof o};
        bench_must(b, trk_spec_get_link(spec, k, &o));
        o.stiffness *= o.from_road ? 1 + 0.2 * share : 1;
        bench_must(b, trk_spec_set_link(spec, k, &o));
    }
    bench_must(b, trk_model_compile(b->context, spec, NULL, &model));
    trk_spec_destroy(spec);
    return model;
}

void fleet_create(const bench *b, trk_vehicle vehicle, int32_t count, double seconds, fleet *f)
{
    *f = (fleet){.bench = b, .count = count, .threads = 1, .record_every = 1};
    rig_create(b, vehicle, TRK_VARIANT_THESIS_DAMPERS, RIG_ALL_SENSORS, seconds, &f->rig);
    f->models = calloc((size_t)count, sizeof *f->models);
    f->roads = calloc((size_t)count, sizeof *f->roads);
    if (!f->models || !f->roads)
        exit(1);
    for (int32_t k = 0; k < count; k++) {
        f->models[k] = build_variant(b, vehicle, (double)k / count);
        f->roads[k] = f->rig.road;
    }
    f->square = bench_zeros((int64_t)count * f->rig.sensors);
}

void fleet_destroy(fleet *f)
{
    for (int32_t k = 0; k < f->count; k++)
        trk_model_destroy(f->models[k]);
    free(f->models);
    free(f->roads);
    free(f->square);
    rig_destroy(&f->rig);
}

static int32_t add_squares(void *user, int32_t variant, int64_t first, int64_t count,
                           const double *values)
{
    const fleet *f = user;
    (void)first;
    for (int32_t s = 0; s < f->rig.sensors; s++) {
        double sum = 0;
        for (int64_t k = 0; k < count; k++)
            sum += values[s * count + k] * values[s * count + k];
        f->square[variant * f->rig.sensors + s] += sum;
    }
    return 0;
}

void fleet_run(fleet *f)
{
    trk_batch_options options;
    trk_batch_options_init(&options, sizeof options);
    options.duration = f->rig.seconds;
    options.threads = f->threads;
    options.record_every = f->record_every;
    memset(f->square, 0, (size_t)f->count * (size_t)f->rig.sensors * sizeof *f->square);
    bench_must(f->bench,
               trk_batch_run(f->bench->context, f->count, (const trk_model *const *)f->models,
                             f->roads, NULL, &options, add_squares, f, NULL, NULL, NULL));
}

void fleet_run_single(const fleet *f, int32_t variant, double *square)
{
    trk_simulate_options options;
    trk_series *series;
    trk_simulate_options_init(&options, sizeof options);
    options.duration = f->rig.seconds;
    bench_must(f->bench, trk_simulate(f->bench->context, f->models[variant], f->rig.road, NULL,
                                      &options, NULL, NULL, &series));
    for (int32_t s = 0; s < f->rig.sensors; s++) {
        const double *x = trk_series_data(series, s + 1);
        square[s] = 0;
        for (int64_t k = 0; k < trk_series_samples(series); k++)
            square[s] += x[k] * x[k];
    }
    trk_series_destroy(series);
}

double fleet_error(const fleet *f)
{
    double worst = 0, *wanted = bench_zeros(f->rig.sensors);
    for (int side = 0; side < 2; side++) {
        int32_t variant = side ? f->count - 1 : 0;
        const double *x = f->square + (int64_t)variant * f->rig.sensors;
        fleet_run_single(f, variant, wanted);
        for (int32_t s = 0; s < f->rig.sensors; s++)
            worst = fmax(worst, fabs(x[s] - wanted[s]) / wanted[s]);
    }
    free(wanted);
    return worst;
}
