/* SPDX-License-Identifier: MIT */
/* Excitation in blocks, steps one by one, sensors into channels. */
#include "base/base.h"

#include <truckride/simulate.h>

#include <math.h>

enum { BLOCK = 256 }; /* steps whose excitation is evaluated at once */

static const trk_simulate_options defaults = {
    .struct_size = sizeof defaults, .duration = 10, .record_every = 1};

void trk_simulate_options_init(trk_simulate_options *options, size_t struct_size)
{
    trk_write_defaults(options, struct_size, &defaults, sizeof defaults);
}

/* One run. */
typedef struct run {
    trk_context *context;
    const trk_model *model;
    const trk_excitation *excitation;
    trk_simulate_options options;
    double step; /* [s]                              */
    int64_t steps;
    trk_newmark *stepper;
    trk_series *series;
    double **channel;                 /* samples of each sensor           */
    double *values;                   /* of all sensors now               */
    double *height, *velocity, *load; /* BLOCK x roads, roads, ports      */
    trk_progress progress;
    void *user;
} run;

static trk_status check(run *r, const trk_simulate_options *options)
{
    trk_context *context = r->context;
    r->options = defaults;
    trk_status status =
        trk_read_options(context, "trk_simulate_options", options, &r->options, sizeof r->options);
    if (status != TRK_OK)
        return status;
    if (!isfinite(r->options.duration) || r->options.duration <= 0)
        return trk_fail(context, TRK_E_RANGE,
                        "trk_simulate_options: duration is %g s; a finite number > 0 is needed",
                        r->options.duration);
    if (!isfinite(r->options.start))
        return trk_fail(context, TRK_E_RANGE,
                        "trk_simulate_options: start is %g s; a finite number is needed",
                        r->options.start);
    if (r->options.record_every < 1)
        return trk_fail(context, TRK_E_RANGE,
                        "trk_simulate_options: record_every is %lld; at least 1 is needed",
                        (long long)r->options.record_every);
    double steps = round(r->options.duration / r->step);
    if (steps < 1 || steps > 1e15)
        return trk_fail(
            context, TRK_E_RANGE,
            "trk_simulate_options: duration %g s is %g steps of %g s; 1 to 1e15 are needed",
            r->options.duration, r->options.duration / r->step, r->step);
    r->steps = (int64_t)steps;
    if (trk_excitation_roads(r->excitation) != trk_model_count(r->model, TRK_PART_ROAD) ||
        trk_excitation_ports(r->excitation) != trk_model_count(r->model, TRK_PART_PORT))
        return trk_fail(context, TRK_E_ARGUMENT,
                        "%s: the excitation has %d roads and %d ports, the model %d and %d",
                        trk_model_name(r->model), trk_excitation_roads(r->excitation),
                        trk_excitation_ports(r->excitation),
                        trk_model_count(r->model, TRK_PART_ROAD),
                        trk_model_count(r->model, TRK_PART_PORT));
    if (trk_model_count(r->model, TRK_PART_SENSOR) == 0)
        return trk_fail(context, TRK_E_MODEL,
                        "%s: the model has no sensor, nothing would be recorded",
                        trk_model_name(r->model));
    return TRK_OK;
}

static trk_status create_series(run *r)
{
    int32_t sensors = trk_model_count(r->model, TRK_PART_SENSOR);
    trk_status status = trk_series_create(
        r->context, sensors, r->steps / r->options.record_every + 1,
        1 / (r->step * (double)r->options.record_every), r->options.start, &r->series);
    for (int32_t k = 1; status == TRK_OK && k <= sensors; k++) {
        status = trk_series_label(r->series, k, trk_model_part_name(r->model, TRK_PART_SENSOR, k),
                                  trk_model_unit(r->model, TRK_PART_SENSOR, k));
        r->channel[k - 1] = trk_series_data_mutable(r->series, k);
    }
    return status;
}

static trk_status allocate(run *r)
{
    int64_t sensors = trk_model_count(r->model, TRK_PART_SENSOR);
    int64_t roads = trk_model_count(r->model, TRK_PART_ROAD);
    int64_t ports = trk_model_count(r->model, TRK_PART_PORT);
    r->channel = trk_new(r->context, sensors, sizeof *r->channel);
    r->values = trk_new(r->context, sensors, sizeof *r->values);
    r->height = trk_new(r->context, BLOCK * roads, sizeof *r->height);
    r->velocity = trk_new(r->context, BLOCK * roads, sizeof *r->velocity);
    r->load = trk_new(r->context, BLOCK * ports, sizeof *r->load);
    if (!r->channel || !r->values || !r->height || !r->velocity || !r->load)
        return TRK_E_MEMORY;
    return create_series(r);
}

static void record(run *r, int64_t sample)
{
    int32_t sensors = trk_series_channels(r->series);
    trk_newmark_read_sensors(r->stepper, r->values);
    for (int32_t k = 0; k < sensors; k++)
        r->channel[k][sample] = r->values[k];
}

/* The steps first + 1 .. first + count, whose excitation lies in the block. */
static trk_status advance(run *r, int64_t first, int64_t count)
{
    int32_t roads = trk_excitation_roads(r->excitation),
            ports = trk_excitation_ports(r->excitation);
    trk_excitation_evaluate(r->excitation, count, r->options.start + (double)(first + 1) * r->step,
                            r->step, r->height, r->velocity, r->load);
    for (int64_t k = 0; k < count; k++) {
        trk_status status = trk_newmark_step(r->stepper, r->height + k * roads,
                                             r->velocity + k * roads, r->load + k * ports);
        if (status != TRK_OK)
            return status;
        if ((first + k + 1) % r->options.record_every == 0)
            record(r, (first + k + 1) / r->options.record_every);
    }
    return TRK_OK;
}

static trk_status go(run *r)
{
    trk_excitation_evaluate(r->excitation, 1, r->options.start, r->step, r->height, r->velocity,
                            r->load);
    trk_status status =
        trk_newmark_set_state(r->stepper, r->options.start, r->options.initial_q,
                              r->options.initial_velocity, r->height, r->velocity, r->load);
    if (status != TRK_OK)
        return status;
    record(r, 0);
    int64_t report_every = (r->steps / 100 / BLOCK + 1) * BLOCK;
    for (int64_t done = 0; status == TRK_OK && done < r->steps; done += BLOCK) {
        if (r->progress && done % report_every == 0 &&
            r->progress(r->user, (double)done / (double)r->steps))
            return trk_fail(r->context, TRK_E_CANCELLED, "%s: run cancelled at t = %.9g s",
                            trk_model_name(r->model), trk_newmark_time(r->stepper));
        status = advance(r, done, r->steps - done < BLOCK ? r->steps - done : BLOCK);
    }
    if (status == TRK_OK && r->progress)
        (void)r->progress(r->user, 1);
    return status;
}

trk_status trk_simulate(trk_context *context, const trk_model *model,
                        const trk_excitation *excitation, const trk_newmark_options *newmark,
                        const trk_simulate_options *options, trk_progress progress, void *user,
                        trk_series **out_series)
{
    TRK_REQUIRE(context, out_series, "trk_simulate");
    *out_series = NULL;
    TRK_REQUIRE(context, context, "trk_simulate");
    TRK_REQUIRE(context, model, "trk_simulate");
    TRK_REQUIRE(context, excitation, "trk_simulate");
    run r = {.context = context,
             .model = model,
             .excitation = excitation,
             .progress = progress,
             .user = user};
    trk_status status = trk_newmark_create(context, model, newmark, &r.stepper);
    if (status != TRK_OK)
        return status;
    r.step = trk_newmark_step_size(r.stepper);
    status = check(&r, options);
    if (status == TRK_OK)
        status = allocate(&r);
    if (status == TRK_OK)
        status = go(&r);
    trk_newmark_destroy(r.stepper);
    trk_free(context, r.channel);
    trk_free(context, r.values);
    trk_free(context, r.height);
    trk_free(context, r.velocity);
    trk_free(context, r.load);
    if (status != TRK_OK) {
        trk_series_destroy(r.series);
        return status;
    }
    *out_series = r.series;
    return TRK_OK;
}
