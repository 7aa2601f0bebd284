/* SPDX-License-Identifier: MIT */
/* Excitation in blocks, steps, sensors into channels. */
#include "simulate/sensors.h"
#include "simulate/stepper.h"

#include <truckride/simulate.h>

#include <math.h>

enum {
    BLOCK = TRK_SENSORS_BLOCK, /* steps whose excitation is evaluated at once              */
    WIDEST_ROW = 256,          /* of a stepper whose sensors are read a block at a time: a
                                  block of wider rows leaves the cache before it is read   */
    LONG_SERIES = 1 << 21      /* samples of all channels that no cache keeps              */
};

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
    trk_stepper stepper;
    trk_series *series;
    double **channel;     /* samples of each sensor           */
    double *values;       /* of all sensors now               */
    trk_drive drive;      /* of BLOCK steps                   */
    trk_sensors *sensors; /* of a small model, else NULL       */
    double *rows;         /* BLOCK steps, for them            */
    trk_progress progress;
    void *user;
} run;

static trk_status read_options(run *r, const trk_simulate_options *options)
{
    r->options = defaults;
    trk_status status = trk_read_options(r->context, "trk_simulate_options", options, &r->options,
                                         sizeof r->options);
    if (status == TRK_OK && r->options.reserved != 0)
        return trk_fail(r->context, TRK_E_ARGUMENT,
                        "trk_simulate_options: reserved is %d; 0 is needed", r->options.reserved);
    return status;
}

static trk_status check(run *r)
{
    trk_context *context = r->context;
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

static trk_status create_sensors(run *r)
{
    int64_t sensors = trk_model_count(r->model, TRK_PART_SENSOR);
    int64_t width = trk_stepper_row_width(&r->stepper);
    if (width > WIDEST_ROW)
        return TRK_OK;
    r->rows = trk_new(r->context, BLOCK * width, sizeof *r->rows);
    double *on_row = trk_new(r->context, sensors * width, sizeof *on_row);
    double *on_road = trk_new(r->context, 2 * sensors * r->drive.roads, sizeof *on_road);
    trk_status status = TRK_E_MEMORY;
    if (r->rows && on_row && on_road) {
        double *on_velocity = on_road + sensors * r->drive.roads;
        trk_stepper_get_sensor_rows(&r->stepper, on_row, on_road, on_velocity);
        status = trk_sensors_create(r->context, (int32_t)sensors, width, (int32_t)r->drive.roads,
                                    on_row, on_road, on_velocity, &r->sensors);
        if (status == TRK_OK) {
            r->sensors->road_rows = trk_stepper_drive_rows(&r->stepper);
            r->sensors->stream = sensors > LONG_SERIES / (r->steps / r->options.record_every + 1);
        }
    }
    trk_free(r->context, on_row);
    trk_free(r->context, on_road);
    return status;
}

static trk_status allocate(run *r)
{
    int64_t sensors = trk_model_count(r->model, TRK_PART_SENSOR);
    r->channel = trk_new(r->context, sensors, sizeof *r->channel);
    r->values = trk_new(r->context, sensors, sizeof *r->values);
    if (!r->channel || !r->values)
        return TRK_E_MEMORY;
    trk_status status = trk_drive_create(r->context, r->excitation, BLOCK, &r->drive);
    if (status == TRK_OK)
        status = create_sensors(r);
    return status == TRK_OK ? create_series(r) : status;
}

static void record(run *r, int64_t sample)
{
    int32_t sensors = trk_series_channels(r->series);
    trk_stepper_read_sensors(&r->stepper, r->values);
    for (int32_t k = 0; k < sensors; k++)
        r->channel[k][sample] = r->values[k];
}

/* The steps first + 1 .. first + count, one by one. */
static trk_status take_steps(run *r, int64_t first, int64_t count)
{
    for (int64_t k = 0; k < count; k++) {
        trk_status status = trk_stepper_step(&r->stepper, &r->drive, k);
        if (status != TRK_OK)
            return status;
        if ((first + k + 1) % r->options.record_every == 0)
            record(r, (first + k + 1) / r->options.record_every);
    }
    return TRK_OK;
}

/* The same steps at once, and then their sensors. */
static trk_status take_block(run *r, int64_t first, int64_t count)
{
    const trk_drive *d = &r->drive;
    int64_t every = r->options.record_every;
    int64_t skip = every - 1 - first % every; /* steps before the first that is recorded */
    int64_t end = ((skip + 1) * trk_stepper_drive_rows(&r->stepper) - 1) * d->roads;
    trk_status status = trk_stepper_record(&r->stepper, d, count, skip < count ? r->rows : NULL);
    if (status == TRK_OK && skip < count)
        trk_sensors_read(r->sensors, (count - skip - 1) / every + 1, every,
                         r->rows + skip * r->sensors->width, d->height + end, d->velocity + end,
                         r->channel, first / every + 1);
    return status;
}

static trk_status advance(run *r, int64_t first, int64_t count)
{
    trk_drive_evaluate(&r->drive, &r->stepper, count, r->options.start, first);
    return r->sensors ? take_block(r, first, count) : take_steps(r, first, count);
}

static trk_status go(run *r)
{
    trk_status status = trk_stepper_start(&r->stepper, &r->drive, r->options.start,
                                          r->options.initial_q, r->options.initial_velocity);
    if (status != TRK_OK)
        return status;
    record(r, 0);
    /* The first block is one shorter: with the initial state it fills whole cache lines. */
    int64_t report = 0, end = BLOCK - 1;
    for (int64_t done = 0; status == TRK_OK && done < r->steps; done = end, end += BLOCK) {
        if (r->progress && done >= report) {
            report += r->steps / 100;
            if (r->progress(r->user, (double)done / (double)r->steps))
                return trk_fail(r->context, TRK_E_CANCELLED, "%s: run cancelled at t = %.9g s",
                                trk_model_name(r->model), trk_stepper_time(&r->stepper));
        }
        status = advance(r, done, (end < r->steps ? end : r->steps) - done);
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
    trk_status status = read_options(&r, options);
    if (status == TRK_OK)
        status = trk_stepper_create(context, model, r.options.method, newmark, &r.stepper);
    if (status != TRK_OK)
        return status;
    r.step = trk_stepper_step_size(&r.stepper);
    status = check(&r);
    if (status == TRK_OK)
        status = allocate(&r);
    if (status == TRK_OK)
        status = go(&r);
    trk_stepper_destroy(&r.stepper);
    trk_drive_clear(&r.drive);
    trk_sensors_destroy(r.sensors);
    trk_free(context, r.rows);
    trk_free(context, r.channel);
    trk_free(context, r.values);
    if (status != TRK_OK) {
        trk_series_destroy(r.series);
        return status;
    }
    *out_series = r.series;
    return TRK_OK;
}
