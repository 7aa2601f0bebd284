/* SPDX-License-Identifier: MIT */
/* One face for both steppers. */
#include "simulate/stepper.h"

#include "newmark/newmark.h"
#include "rungekutta/rungekutta.h"

static trk_status create_rungekutta(trk_context *context, const trk_model *model,
                                    const trk_newmark_options *newmark, trk_rungekutta **out)
{
    trk_newmark_options known;
    trk_rungekutta_options options;
    trk_newmark_options_init(&known, sizeof known);
    trk_rungekutta_options_init(&options, sizeof options);
    trk_status status =
        trk_read_options(context, "trk_newmark_options", newmark, &known, sizeof known);
    options.step = known.step;
    return status == TRK_OK ? trk_rungekutta_create(context, model, &options, out) : status;
}

trk_status trk_stepper_create(trk_context *context, const trk_model *model, trk_method method,
                              const trk_newmark_options *newmark, trk_stepper *out)
{
    *out = (trk_stepper){NULL, NULL};
    switch (method) {
    case TRK_METHOD_NEWMARK: return trk_newmark_create(context, model, newmark, &out->newmark);
    case TRK_METHOD_RUNGE_KUTTA:
        return create_rungekutta(context, model, newmark, &out->rungekutta);
    default:
        return trk_fail(context, TRK_E_ARGUMENT,
                        "trk_simulate_options: method is %d; a TRK_METHOD_... is needed", method);
    }
}

void trk_stepper_destroy(trk_stepper *stepper)
{
    trk_newmark_destroy(stepper->newmark);
    trk_rungekutta_destroy(stepper->rungekutta);
}

double trk_stepper_step_size(const trk_stepper *stepper)
{
    return stepper->newmark ? trk_newmark_step_size(stepper->newmark)
                            : trk_rungekutta_step_size(stepper->rungekutta);
}

double trk_stepper_time(const trk_stepper *stepper)
{
    return stepper->newmark ? trk_newmark_time(stepper->newmark)
                            : trk_rungekutta_time(stepper->rungekutta);
}

void trk_stepper_read_sensors(const trk_stepper *stepper, double *out_values)
{
    trk_newmark_read_sensors(stepper->newmark, out_values);
    trk_rungekutta_read_sensors(stepper->rungekutta, out_values);
}

trk_status trk_drive_create(trk_context *context, const trk_excitation *excitation, int64_t steps,
                            trk_drive *out)
{
    *out = (trk_drive){.context = context,
                       .excitation = excitation,
                       .roads = trk_excitation_roads(excitation),
                       .ports = trk_excitation_ports(excitation)};
    out->height = trk_new(context, 2 * steps * out->roads, sizeof(double));
    out->velocity = trk_new(context, 2 * steps * out->roads, sizeof(double));
    out->load = trk_new(context, 2 * steps * out->ports, sizeof(double));
    return out->height && out->velocity && out->load ? TRK_OK : TRK_E_MEMORY;
}

void trk_drive_clear(trk_drive *drive)
{
    trk_free(drive->context, drive->height);
    trk_free(drive->context, drive->velocity);
    trk_free(drive->context, drive->load);
}

void trk_drive_evaluate(trk_drive *drive, const trk_stepper *stepper, int64_t count, double start,
                        int64_t first)
{
    double step = trk_stepper_step_size(stepper);
    if (stepper->newmark)
        trk_excitation_evaluate(drive->excitation, count, start + (double)(first + 1) * step, step,
                                drive->height, drive->velocity, drive->load);
    else
        trk_excitation_evaluate(drive->excitation, 2 * count, start + ((double)first + 0.5) * step,
                                step / 2, drive->height, drive->velocity, drive->load);
}

trk_status trk_stepper_start(trk_stepper *stepper, trk_drive *drive, double start, const double *q,
                             const double *v)
{
    trk_excitation_evaluate(drive->excitation, 1, start, 0, drive->height, drive->velocity,
                            drive->load);
    return stepper->newmark ? trk_newmark_set_state(stepper->newmark, start, q, v, drive->height,
                                                    drive->velocity, drive->load)
                            : trk_rungekutta_set_state(stepper->rungekutta, start, q, v,
                                                       drive->height, drive->velocity, drive->load);
}

int64_t trk_stepper_row_width(const trk_stepper *stepper)
{
    return stepper->newmark ? trk_newmark_row_width(stepper->newmark)
                            : trk_rungekutta_row_width(stepper->rungekutta);
}

void trk_stepper_get_sensor_rows(const trk_stepper *stepper, double *out_on_row,
                                 double *out_on_height, double *out_on_velocity)
{
    if (stepper->newmark)
        trk_newmark_get_sensor_rows(stepper->newmark, out_on_row, out_on_height, out_on_velocity);
    else
        trk_rungekutta_get_sensor_rows(stepper->rungekutta, out_on_row, out_on_height,
                                       out_on_velocity);
}

int64_t trk_stepper_drive_rows(const trk_stepper *stepper)
{
    return stepper->newmark ? 1 : 2;
}

trk_status trk_stepper_record(trk_stepper *stepper, const trk_drive *drive, int64_t count,
                              double *out_rows)
{
    int64_t taken;
    return stepper->newmark ? trk_newmark_record(stepper->newmark, count, drive->height,
                                                 drive->velocity, drive->load, out_rows, &taken)
                            : trk_rungekutta_record(stepper->rungekutta, count, drive->height,
                                                    drive->velocity, drive->load, out_rows, &taken);
}

trk_status trk_stepper_step(trk_stepper *stepper, const trk_drive *drive, int64_t k)
{
    int64_t roads = drive->roads, ports = drive->ports;
    if (stepper->newmark)
        return trk_newmark_step(stepper->newmark, drive->height + k * roads,
                                drive->velocity + k * roads, drive->load + k * ports);
    int64_t middle = 2 * k, end = middle + 1;
    return trk_rungekutta_step(stepper->rungekutta, drive->height + middle * roads,
                               drive->velocity + middle * roads, drive->load + middle * ports,
                               drive->height + end * roads, drive->velocity + end * roads,
                               drive->load + end * ports);
}
