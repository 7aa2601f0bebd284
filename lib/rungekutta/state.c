/* SPDX-License-Identifier: MIT */
/* Set and read the state of an explicit stepper. */
#include "rungekutta/rungekutta.h"

#include <math.h>
#include <string.h>

/* Copy count values, zeros if from is NULL. TRK_E_RANGE: one is not finite, `what` names it. */
static trk_status take_values(trk_rungekutta *stepper, const char *what, trk_part part,
                              int32_t count, const double *from, double *to)
{
    double sum = 0;
    for (int32_t k = 0; k < count; k++) {
        to[k] = from ? from[k] : 0;
        sum += 0 * to[k];
    }
    for (int32_t k = 0; sum != 0 && k < count; k++)
        if (!isfinite(to[k]))
            return trk_fail(stepper->context, TRK_E_RANGE,
                            "%s: %s of '%s' is %g after t = %.9g s; a finite number is needed",
                            trk_model_name(stepper->model), what,
                            trk_model_part_name(stepper->model, part, k + 1), to[k],
                            trk_rungekutta_time(stepper));
    return TRK_OK;
}

trk_status trk_rungekutta_take_action(trk_rungekutta *stepper, const double *height,
                                      const double *velocity, const double *load,
                                      trk_action *action)
{
    int32_t roads = stepper->model->names[TRK_PART_ROAD].count;
    trk_status status =
        take_values(stepper, "road height", TRK_PART_ROAD, roads, height, action->height);
    if (status == TRK_OK)
        status =
            take_values(stepper, "road velocity", TRK_PART_ROAD, roads, velocity, action->velocity);
    return status == TRK_OK ? take_values(stepper, "load", TRK_PART_PORT,
                                          stepper->model->ports.count, load, action->load)
                            : status;
}

/* The state of which out_q, out_v, out_a and end tell, into that of the steps. */
static void adopt(trk_rungekutta *s)
{
    size_t size = (size_t)s->model->n * sizeof(double);
    if (s->modal)
        trk_explicit_set_state(s->modal, s->model, s->out_q, s->out_v, s->out_a, s->end.height,
                               s->end.velocity);
    memcpy(s->q, s->out_q, size);
    memcpy(s->v, s->out_v, size);
    memcpy(s->a, s->out_a, size);
}

trk_status trk_rungekutta_set_state(trk_rungekutta *stepper, double time, const double *q,
                                    const double *v, const double *height, const double *velocity,
                                    const double *load)
{
    TRK_REQUIRE(NULL, stepper, "trk_rungekutta_set_state");
    const trk_model *model = stepper->model;
    if (!isfinite(time))
        return trk_fail(stepper->context, TRK_E_RANGE, "%s: time is %g; a finite number is needed",
                        trk_model_name(model), time);
    trk_status status = take_values(stepper, "displacement", TRK_PART_COORDINATE, model->n,
                                    q ? q : model->static_q, stepper->out_q);
    if (status == TRK_OK)
        status = take_values(stepper, "velocity", TRK_PART_COORDINATE, model->n, v, stepper->out_v);
    if (status == TRK_OK)
        status = trk_rungekutta_take_action(stepper, height, velocity, load, &stepper->end);
    if (status == TRK_OK)
        status = trk_rungekutta_accelerate(stepper, stepper->out_q, stepper->out_v, &stepper->end,
                                           stepper->out_a);
    if (status != TRK_OK)
        return status;
    for (int32_t i = 0; i < model->n; i++)
        if (!isfinite(stepper->out_a[i]))
            return trk_fail(
                stepper->context, TRK_E_RANGE, "%s: acceleration of '%s' is %g in the state to set",
                trk_model_name(model), trk_model_part_name(model, TRK_PART_COORDINATE, i + 1),
                stepper->out_a[i]);
    adopt(stepper);
    trk_action before = stepper->now;
    stepper->now = stepper->end;
    stepper->end = before;
    stepper->start = time;
    stepper->taken = 0;
    return TRK_OK;
}

double trk_rungekutta_step_size(const trk_rungekutta *stepper)
{
    return stepper ? stepper->step : NAN;
}

double trk_rungekutta_time(const trk_rungekutta *stepper)
{
    return stepper ? stepper->start + (double)stepper->taken * stepper->step : NAN;
}

/* Parts of the state in the model's coordinates. */
static const double *look_q(const trk_rungekutta *stepper)
{
    if (stepper->modal)
        trk_explicit_get_part(stepper->modal, 0, stepper->q);
    return stepper->q;
}

static const double *look_v(const trk_rungekutta *stepper)
{
    if (stepper->modal)
        trk_explicit_get_part(stepper->modal, 1, stepper->v);
    return stepper->v;
}

static const double *look_a(const trk_rungekutta *stepper)
{
    if (stepper->modal)
        trk_explicit_get_part(stepper->modal, 2, stepper->a);
    return stepper->a;
}

void trk_rungekutta_get_state(const trk_rungekutta *stepper, double *out_q, double *out_v,
                              double *out_a)
{
    if (!stepper)
        return;
    size_t size = (size_t)stepper->model->n * sizeof(double);
    if (out_q)
        memcpy(out_q, look_q(stepper), size);
    if (out_v)
        memcpy(out_v, look_v(stepper), size);
    if (out_a)
        memcpy(out_a, look_a(stepper), size);
}

/* Elongation and rate of a link, given q and v. */
static double elongation(const trk_rungekutta *stepper, const double *q, int32_t link)
{
    return trk_rows_dot(&stepper->model->links, link, q) -
           trk_rows_dot(&stepper->model->roads, link, stepper->now.height);
}

static double rate(const trk_rungekutta *stepper, const double *v, int32_t link)
{
    return trk_rows_dot(&stepper->model->links, link, v) -
           trk_rows_dot(&stepper->model->roads, link, stepper->now.velocity);
}

static double force(const trk_rungekutta *stepper, int32_t link, double e, double speed)
{
    const trk_link_law *law = &stepper->model->laws[link];
    trk_law_point point;
    trk_link_law_evaluate(law, e, speed, &stepper->hints[link], &point);
    return law->stiffness * e + law->damping * speed + point.force;
}

double trk_rungekutta_curve_force(const trk_rungekutta *stepper, int32_t link)
{
    trk_law_point point;
    trk_link_law_evaluate(&stepper->model->laws[link], elongation(stepper, stepper->q, link),
                          rate(stepper, stepper->v, link), &stepper->hints[link], &point);
    return point.force;
}

void trk_rungekutta_get_links(const trk_rungekutta *stepper, double *out_elongation,
                              double *out_rate, double *out_force)
{
    if (!stepper)
        return;
    const double *q = look_q(stepper);
    const double *v = look_v(stepper);
    for (int32_t k = 0; k < trk_model_named_links(stepper->model); k++) {
        double e = elongation(stepper, q, k), speed = rate(stepper, v, k);
        if (out_elongation)
            out_elongation[k] = e;
        if (out_rate)
            out_rate[k] = speed;
        if (out_force)
            out_force[k] = force(stepper, k, e, speed);
    }
}

void trk_rungekutta_read_sensors(const trk_rungekutta *stepper, double *out_values)
{
    if (!stepper || !out_values)
        return;
    const trk_model *model = stepper->model;
    const double *q = look_q(stepper);
    const double *v = look_v(stepper);
    const double *a = look_a(stepper);
    for (int32_t k = 0; k < model->sensors.count; k++) {
        int32_t link = model->sensor_link[k];
        switch (model->sensor_quantity[k]) {
        case TRK_QUANTITY_DISPLACEMENT: out_values[k] = trk_rows_dot(&model->sensors, k, q); break;
        case TRK_QUANTITY_VELOCITY: out_values[k] = trk_rows_dot(&model->sensors, k, v); break;
        case TRK_QUANTITY_ACCELERATION: out_values[k] = trk_rows_dot(&model->sensors, k, a); break;
        case TRK_QUANTITY_ELONGATION: out_values[k] = elongation(stepper, q, link); break;
        case TRK_QUANTITY_RATE: out_values[k] = rate(stepper, v, link); break;
        default:
            out_values[k] =
                force(stepper, link, elongation(stepper, q, link), rate(stepper, v, link));
            break;
        }
    }
}
