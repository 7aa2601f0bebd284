/* SPDX-License-Identifier: MIT */
/* One explicit step (RUNGEKUTTA.1). */
#include "rungekutta/rungekutta.h"

#include <math.h>
#include <string.h>

trk_status trk_rungekutta_accelerate(trk_rungekutta *stepper, const double *q, const double *v,
                                     const trk_action *action, double *out_a)
{
    const trk_model *model = stepper->model;
    memcpy(out_a, model->weight, (size_t)model->n * sizeof *out_a);
    for (int32_t k = 0; k < model->ports.count; k++)
        trk_rows_add(&model->ports, k, action->load[k], out_a);
    for (int32_t k = 0; k < model->links.count; k++) {
        const trk_law *law = &model->laws[k];
        trk_law_point point;
        double e =
            trk_rows_dot(&model->links, k, q) - trk_rows_dot(&model->roads, k, action->height);
        double rate =
            trk_rows_dot(&model->links, k, v) - trk_rows_dot(&model->roads, k, action->velocity);
        trk_law_evaluate(law, e, rate, &stepper->hints[k], &point);
        trk_rows_add(&model->links, k, -(law->stiffness * e + law->damping * rate + point.force),
                     out_a);
    }
    return trk_solver_solve(stepper->assembly.solver, out_a);
}

/* out := x + factor y */
static void advance(int32_t n, const double *x, double factor, const double *y, double *out)
{
    for (int32_t i = 0; i < n; i++)
        out[i] = x[i] + factor * y[i];
}

/* The stages after the first, whose acceleration is that of the state. */
static trk_status take_stages(trk_rungekutta *s)
{
    int32_t n = s->model->n;
    double h = s->step;
    advance(n, s->v, h / 2, s->a, s->v2);
    advance(n, s->q, h / 2, s->v, s->q_stage);
    trk_status status = trk_rungekutta_accelerate(s, s->q_stage, s->v2, &s->middle, s->a2);
    advance(n, s->v, h / 2, s->a2, s->v3);
    advance(n, s->q, h / 2, s->v2, s->q_stage);
    if (status == TRK_OK)
        status = trk_rungekutta_accelerate(s, s->q_stage, s->v3, &s->middle, s->a3);
    advance(n, s->v, h, s->a3, s->v4);
    advance(n, s->q, h, s->v3, s->q_stage);
    return status == TRK_OK ? trk_rungekutta_accelerate(s, s->q_stage, s->v4, &s->end, s->a4)
                            : status;
}

/* In the model's coordinates. */
static trk_status step_general(trk_rungekutta *s)
{
    int32_t n = s->model->n;
    double h = s->step, sum = 0;
    trk_status status = take_stages(s);
    if (status != TRK_OK)
        return status;
    for (int32_t i = 0; i < n; i++) {
        s->next_q[i] = s->q[i] + h / 6 * (s->v[i] + 2 * (s->v2[i] + s->v3[i]) + s->v4[i]);
        s->next_v[i] = s->v[i] + h / 6 * (s->a[i] + 2 * (s->a2[i] + s->a3[i]) + s->a4[i]);
    }
    status = trk_rungekutta_accelerate(s, s->next_q, s->next_v, &s->end, s->next_a);
    for (int32_t i = 0; i < n; i++)
        sum += 0 * (s->next_q[i] + s->next_v[i] + s->next_a[i]);
    return status == TRK_OK && sum != 0 ? TRK_E_RANGE : status;
}

/* In modal coordinates. */
static trk_status step_modal(trk_rungekutta *s)
{
    trk_explicit_set_drive(s->modal, s->model, 0, s->middle.height, s->middle.velocity,
                           s->middle.load);
    trk_explicit_set_drive(s->modal, s->model, 1, s->end.height, s->end.velocity, s->end.load);
    trk_explicit_states states = {s->q, s->v, s->a, s->next_q, s->next_v, s->next_a};
    if (s->kernel(s->modal, &states))
        return TRK_OK;
    size_t size = (size_t)s->modal->state_blocks * TRK_EXPLICIT_LANES * sizeof(double);
    memset(s->next_q, 0, size); /* what overflowed must not stay in the padding */
    memset(s->next_v, 0, size);
    memset(s->next_a, 0, size);
    return TRK_E_RANGE;
}

static void swap(double **a, double **b)
{
    double *kept = *a;
    *a = *b;
    *b = kept;
}

static void commit(trk_rungekutta *s)
{
    swap(&s->q, &s->next_q);
    swap(&s->v, &s->next_v);
    swap(&s->a, &s->next_a);
    trk_action before = s->now;
    s->now = s->end;
    s->end = before;
    s->taken++;
}

trk_status trk_rungekutta_step(trk_rungekutta *stepper, const double *middle_height,
                               const double *middle_velocity, const double *middle_load,
                               const double *height, const double *velocity, const double *load)
{
    TRK_REQUIRE(NULL, stepper, "trk_rungekutta_step");
    trk_status status = trk_rungekutta_take_action(stepper, middle_height, middle_velocity,
                                                   middle_load, &stepper->middle);
    if (status == TRK_OK)
        status = trk_rungekutta_take_action(stepper, height, velocity, load, &stepper->end);
    if (status != TRK_OK)
        return status;
    status = stepper->modal ? step_modal(stepper) : step_general(stepper);
    if (status == TRK_E_RANGE)
        return trk_fail(stepper->context, status,
                        "%s: the motion left the range of numbers in the step after t = %.9g s",
                        trk_model_name(stepper->model), trk_rungekutta_time(stepper));
    if (status == TRK_OK)
        commit(stepper);
    return status;
}
