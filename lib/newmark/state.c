/* SPDX-License-Identifier: MIT */
/* Set and read the state of a stepper. */
#include "newmark/newmark.h"

#include <math.h>
#include <string.h>

/* Copy count values, zeros if from is NULL. TRK_E_RANGE: one is not finite, `what` names it. */
static trk_status take_values(trk_newmark *stepper, const char *what, trk_part part, int32_t count,
                              const double *from, double *to)
{
    if (!from) {
        memset(to, 0, (size_t)count * sizeof *to);
        return TRK_OK;
    }
    for (int32_t k = 0; k < count; k++)
        if (!isfinite(from[k]))
            return trk_fail(stepper->context, TRK_E_RANGE,
                            "%s: %s of '%s' is %g at t = %.9g s; a finite number is needed",
                            trk_model_name(stepper->model), what,
                            trk_model_part_name(stepper->model, part, k + 1), from[k],
                            trk_newmark_time(stepper));
    memcpy(to, from, (size_t)count * sizeof *to);
    return TRK_OK;
}

/* P p + w. */
static trk_status take_load(trk_newmark *stepper, const double *load)
{
    const trk_model *model = stepper->model;
    memcpy(stepper->load_row, model->weight, (size_t)model->n * sizeof *stepper->load_row);
    for (int32_t k = 0; load && k < model->ports.count; k++) {
        if (!isfinite(load[k]))
            return trk_fail(stepper->context, TRK_E_RANGE,
                            "%s: load on port '%s' is %g at t = %.9g s; a finite number is needed",
                            trk_model_name(model), trk_model_part_name(model, TRK_PART_PORT, k + 1),
                            load[k], trk_newmark_time(stepper));
        trk_rows_add(&model->ports, k, load[k], stepper->load_row);
    }
    return TRK_OK;
}

trk_status trk_newmark_take_inputs(trk_newmark *stepper, const double *height,
                                   const double *velocity, const double *load, trk_state *state)
{
    int32_t roads = trk_model_count(stepper->model, TRK_PART_ROAD);
    trk_status status =
        take_values(stepper, "road height", TRK_PART_ROAD, roads, height, state->height);
    if (status == TRK_OK)
        status =
            take_values(stepper, "road velocity", TRK_PART_ROAD, roads, velocity, state->velocity);
    return status == TRK_OK ? take_load(stepper, load) : status;
}

/* Forces of the non-linear links and the acceleration at a state given by q, v and road. */
static trk_status balance(trk_newmark *stepper, trk_state *state)
{
    const trk_model *model = stepper->model;
    double *b = stepper->residual;
    memcpy(b, stepper->load_row, (size_t)model->n * sizeof *b);
    trk_newmark_subtract_linear(stepper, state, b);
    for (int32_t j = 0; j < stepper->p; j++) {
        int32_t link = model->nonlinear[j];
        double e = trk_newmark_elongation(stepper, state, link);
        trk_law_point point;
        trk_link_law_relax(&model->laws[link], e, state->memory + model->memory[link]);
        trk_link_law_evaluate(&model->laws[link], e, trk_newmark_rate(stepper, state, link),
                              &stepper->hints[j], &point);
        state->force[j] = point.force;
        trk_rows_add(&model->links, link, -point.force, b);
    }
    for (int32_t i = 0; i < model->n; i++)
        state->rest[i] = -b[i];
    int32_t bad;
    trk_status status = trk_assembly_factorize(&stepper->assembly, 1, NULL, &bad);
    if (status == TRK_OK)
        status = trk_solver_solve(stepper->assembly.solver, b);
    if (status == TRK_OK)
        memcpy(state->a, b, (size_t)model->n * sizeof *b);
    trk_status refactored = trk_newmark_factorize(stepper);
    return status == TRK_OK ? refactored : status;
}

trk_status trk_newmark_set_state(trk_newmark *stepper, double time, const double *q,
                                 const double *v, const double *height, const double *velocity,
                                 const double *load)
{
    TRK_REQUIRE(NULL, stepper, "trk_newmark_set_state");
    const trk_model *model = stepper->model;
    trk_state *state = &stepper->next;
    if (!isfinite(time))
        return trk_fail(stepper->context, TRK_E_RANGE, "%s: time is %g; a finite number is needed",
                        trk_model_name(model), time);
    trk_status status = take_values(stepper, "displacement", TRK_PART_COORDINATE, model->n,
                                    q ? q : model->static_q, state->q);
    if (status == TRK_OK)
        status = take_values(stepper, "velocity", TRK_PART_COORDINATE, model->n, v, state->v);
    if (status == TRK_OK)
        status = trk_newmark_take_inputs(stepper, height, velocity, load, state);
    if (status == TRK_OK)
        status = balance(stepper, state);
    if (status != TRK_OK)
        return status;
    for (int32_t i = 0; i < model->n; i++)
        if (!isfinite(state->a[i]))
            return trk_fail(stepper->context, TRK_E_RANGE,
                            "%s: acceleration of '%s' is %g in the state to set",
                            trk_model_name(model),
                            trk_model_part_name(model, TRK_PART_COORDINATE, i + 1), state->a[i]);
    trk_state before = stepper->now;
    stepper->now = stepper->next;
    stepper->next = before;
    stepper->start = time;
    stepper->taken = 0;
    /* No past to extrapolate from: the forces seem to stay. */
    for (int k = 0; k < 3; k++)
        memcpy(stepper->past[k], stepper->now.force, (size_t)stepper->p * sizeof(double));
    stepper->force_scale = trk_newmark_largest_force(stepper, &stepper->now);
    if (stepper->fast)
        trk_fast_adopt(stepper->fast, stepper, true);
    return TRK_OK;
}

double trk_newmark_step_size(const trk_newmark *stepper)
{
    return stepper ? stepper->options.step : NAN;
}

double trk_newmark_time(const trk_newmark *stepper)
{
    return stepper ? stepper->start + (double)stepper->taken * stepper->options.step : NAN;
}

void trk_newmark_get_state(const trk_newmark *stepper, double *out_q, double *out_v, double *out_a)
{
    if (!stepper)
        return;
    if (stepper->fast && stepper->fast->is_ahead) {
        trk_fast_get_state(stepper->fast, out_q, out_v, out_a);
        return;
    }
    size_t size = (size_t)stepper->model->n * sizeof(double);
    if (out_q)
        memcpy(out_q, stepper->now.q, size);
    if (out_v)
        memcpy(out_v, stepper->now.v, size);
    if (out_a)
        memcpy(out_a, stepper->now.a, size);
}

/* Whole force of a link. */
static double link_force(const trk_newmark *stepper, int32_t link)
{
    int32_t j = stepper->nonlinear_index[link];
    return trk_newmark_linear_force(stepper, &stepper->now, link) +
           (j >= 0 ? stepper->now.force[j] : 0);
}

void trk_newmark_get_links(const trk_newmark *stepper, double *out_elongation, double *out_rate,
                           double *out_force)
{
    if (!stepper)
        return;
    trk_fast_settle(stepper);
    for (int32_t k = 0; k < trk_model_named_links(stepper->model); k++) {
        if (out_elongation)
            out_elongation[k] = trk_newmark_elongation(stepper, &stepper->now, k);
        if (out_rate)
            out_rate[k] = trk_newmark_rate(stepper, &stepper->now, k);
        if (out_force)
            out_force[k] = link_force(stepper, k);
    }
}

void trk_newmark_read_sensors(const trk_newmark *stepper, double *out_values)
{
    if (!stepper || !out_values || trk_fast_read_sensors(stepper, out_values))
        return;
    const trk_model *model = stepper->model;
    const trk_state *now = &stepper->now;
    trk_fast_settle(stepper);
    for (int32_t k = 0; k < model->sensors.count; k++) {
        int32_t link = model->sensor_link[k];
        switch (model->sensor_quantity[k]) {
        case TRK_QUANTITY_DISPLACEMENT:
            out_values[k] = trk_rows_dot(&model->sensors, k, now->q);
            break;
        case TRK_QUANTITY_VELOCITY: out_values[k] = trk_rows_dot(&model->sensors, k, now->v); break;
        case TRK_QUANTITY_ACCELERATION:
            out_values[k] = trk_rows_dot(&model->sensors, k, now->a);
            break;
        case TRK_QUANTITY_ELONGATION:
            out_values[k] = trk_newmark_elongation(stepper, now, link);
            break;
        case TRK_QUANTITY_RATE: out_values[k] = trk_newmark_rate(stepper, now, link); break;
        default: out_values[k] = link_force(stepper, link); break;
        }
    }
}

trk_status trk_newmark_get_statistics(const trk_newmark *stepper,
                                      trk_newmark_statistics *out_statistics)
{
    if (!stepper || !out_statistics)
        return TRK_E_ARGUMENT;
    return trk_write_options(out_statistics, &stepper->statistics, sizeof stepper->statistics);
}
