/* SPDX-License-Identifier: MIT */
/* Variants of a vehicle with other numbers, roads for them, and what a batch recorded. */
#ifndef TRK_TESTS_FLEET_H
#define TRK_TESTS_FLEET_H

#include "batch/batch.h"
#include "support.h"
#include "vehicles.h"

#include <truckride/simulate.h>

enum { FLEET_MOST = 24 };

typedef struct fleet {
    trk_context *context;
    int32_t count, sensors;
    int64_t samples;
    trk_newmark_options newmark;
    trk_batch_options options;
    int32_t kernel;
    trk_signal *signal[3];
    trk_model *model[FLEET_MOST];
    trk_excitation *road[FLEET_MOST];
    double *recorded[FLEET_MOST]; /* sensors x samples of each variant */
    int64_t received[FLEET_MOST]; /* samples                           */
    trk_status status[FLEET_MOST];
    int32_t cancel_variant; /* by the sink, once it has a sample; -1: none */
    int64_t cancel_sample;
} fleet;

/* Masses, stiffnesses and dampings of variant k, 10 to 40 % off. */
static inline trk_model *fleet_model(trk_context *context, trk_vehicle vehicle, trk_variant variant,
                                     double gravity, int32_t k)
{
    trk_spec *spec = support_spec(context, vehicle, variant);
    for (int32_t j = 1; j <= trk_spec_count(spec, TRK_PART_LINK); j++) {
        trk_link_options link;
        trk_link_options_init(&link, sizeof link);
        assert_ok(context, trk_spec_get_link(spec, j, &link));
        double factor = 1 + 0.25 * sin(3.7 * k + j);
        link.stiffness *= factor;
        link.damping *= factor;
        link.spring_scale *= factor;
        link.damper_scale *= 1 + 0.4 * sin(2.3 * k + 2 * j);
        assert_ok(context, trk_spec_set_link(spec, j, &link));
    }
    for (int32_t j = 1; j <= trk_spec_count(spec, TRK_PART_BODY); j++) {
        trk_body_options body;
        trk_body_options_init(&body, sizeof body);
        assert_ok(context, trk_spec_get_body(spec, j, &body));
        body.mass *= 1 + 0.1 * sin(1.9 * k + j);
        assert_ok(context, trk_spec_set_body(spec, j, &body));
    }
    trk_model_options options;
    trk_model_options_init(&options, sizeof options);
    options.gravity = gravity;
    trk_model *model;
    assert_ok(context, trk_model_compile(context, spec, &options, &model));
    trk_spec_destroy(spec);
    return model;
}

/* Three signals over the wheels, other gains and delays for every k, and a load on every port. */
static inline trk_excitation *fleet_road(fleet *f, int32_t k)
{
    trk_excitation *road;
    assert_ok(f->context, trk_excitation_create(f->context, f->model[k], &road));
    for (int32_t w = 1; w <= trk_excitation_roads(road); w++)
        for (int j = 0; j < 2; j++)
            assert_ok(f->context, trk_excitation_add_motion(road, w, f->signal[j],
                                                            1 + 0.3 * sin(k + w + j), 0.05 * w));
    for (int32_t p = 1; p <= trk_excitation_ports(road); p++)
        assert_ok(f->context, trk_excitation_add_load(road, p, f->signal[2], 1 + 0.1 * k, 0.1));
    return road;
}

/* `count` variants; of one road or of two taking turns, or one each. */
static inline void fleet_create(fleet *f, trk_context *context, trk_vehicle vehicle,
                                trk_variant variant, double gravity, int32_t count, int32_t roads)
{
    *f = (fleet){.context = context, .count = count, .cancel_variant = -1};
    f->kernel = TRK_BATCH_KERNEL_BEST;
    trk_newmark_options_init(&f->newmark, sizeof f->newmark);
    trk_batch_options_init(&f->options, sizeof f->options);
    f->options.duration = 0.7;
    assert_ok(context, trk_signal_create_sine(context, 0.012, 3.1, 0, 0.02, &f->signal[0]));
    assert_ok(context, trk_signal_create_step(context, 0.15, 0.1, 0.03, &f->signal[1]));
    assert_ok(context, trk_signal_create_sine(context, 2500, 1.3, 0, 0, &f->signal[2]));
    for (int32_t k = 0; k < count; k++) {
        f->model[k] = fleet_model(context, vehicle, variant, gravity, k);
        f->road[k] = k < roads ? fleet_road(f, k) : f->road[k % roads];
    }
    f->sensors = trk_model_count(f->model[0], TRK_PART_SENSOR);
}

static inline void fleet_forget(fleet *f)
{
    for (int32_t k = 0; k < f->count; k++) {
        free(f->recorded[k]);
        f->recorded[k] = NULL;
        f->received[k] = 0;
        f->status[k] = -1;
    }
}

static inline void fleet_destroy(fleet *f)
{
    fleet_forget(f);
    for (int32_t k = 0; k < f->count; k++) {
        bool shared = false;
        for (int32_t j = 0; j < k; j++)
            shared = shared || f->road[j] == f->road[k];
        if (!shared)
            trk_excitation_destroy(f->road[k]);
    }
    for (int32_t k = 0; k < f->count; k++)
        trk_model_destroy(f->model[k]);
    for (int j = 0; j < 3; j++)
        trk_signal_destroy(f->signal[j]);
}

/* Called from any thread, so it does not assert: what comes out of order is missing later. */
static inline int32_t fleet_sink(void *user, int32_t variant, int64_t first, int64_t count,
                                 const double *values)
{
    fleet *f = user;
    if (variant == f->cancel_variant && first >= f->cancel_sample)
        return 1;
    if (variant < 0 || variant >= f->count || first != f->received[variant] || count < 1 ||
        first + count > f->samples)
        return 1;
    for (int32_t s = 0; s < f->sensors; s++)
        memcpy(f->recorded[variant] + s * f->samples + first, values + s * count,
               (size_t)count * sizeof *values);
    f->received[variant] += count;
    return 0;
}

static inline trk_status fleet_run(fleet *f, trk_progress progress, void *user)
{
    fleet_forget(f);
    f->samples = trk_batch_samples(&f->newmark, &f->options);
    for (int32_t k = 0; k < f->count; k++) {
        f->recorded[k] = calloc((size_t)(f->sensors * f->samples), sizeof(double));
        assert_non_null(f->recorded[k]);
    }
    return trk_batch_run_with(f->kernel, f->context, f->count, (const trk_model *const *)f->model,
                              (const trk_excitation *const *)f->road, &f->newmark, &f->options,
                              fleet_sink, f, progress, user, f->status);
}

static inline size_t fleet_bytes(const fleet *f)
{
    return (size_t)(f->sensors * f->samples) * sizeof(double);
}

/*
 * Largest difference from trk_simulate() of a variant's sensors, each over its peak. What the
 * tolerance leaves adds up over many steps, in the stepper as in the lanes: these are compared
 * with a run of a tighter one, the stepper with itself.
 */
static inline double fleet_difference(const fleet *f, int32_t k)
{
    trk_simulate_options options;
    trk_simulate_options_init(&options, sizeof options);
    options.duration = f->options.duration;
    options.start = f->options.start;
    options.record_every = f->options.record_every;
    trk_newmark_options newmark = f->newmark;
    if (f->kernel != TRK_BATCH_KERNEL_NONE)
        newmark.tolerance = 1e-12;
    trk_series *series;
    assert_ok(f->context, trk_simulate(f->context, f->model[k], f->road[k], &newmark, &options,
                                       NULL, NULL, &series));
    assert_int_equal(trk_series_samples(series), f->samples);
    double worst = 0;
    for (int32_t s = 0; s < f->sensors; s++) {
        const double *wanted = trk_series_data(series, s + 1),
                     *got = f->recorded[k] + s * f->samples;
        double off = 0, peak = 0;
        for (int64_t j = 0; j < f->samples; j++) {
            peak = fmax(peak, fabs(wanted[j]));
            off = fabs(wanted[j] - got[j]) <= off ? off : fabs(wanted[j] - got[j]);
        }
        double ratio = off == 0 ? 0 : off / peak;
        worst = ratio <= worst ? worst : ratio;
    }
    trk_series_destroy(series);
    return worst;
}

/* The kernels that this build and this processor have, and the stepper, by number. */
static inline bool fleet_has_kernel(const fleet *f, int32_t kernel)
{
    return kernel == TRK_BATCH_KERNEL_NONE || trk_lanes_find_kernel(kernel, f->model[0]) != NULL;
}

#endif
