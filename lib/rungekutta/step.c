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
        const trk_link_law *law = &model->laws[k];
        trk_law_point point;
        double e =
            trk_rows_dot(&model->links, k, q) - trk_rows_dot(&model->roads, k, action->height);
        double rate =
            trk_rows_dot(&model->links, k, v) - trk_rows_dot(&model->roads, k, action->velocity);
        trk_link_law_evaluate(law, e, rate, &stepper->hints[k], &point);
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

/* Row k of an input at the middle (0) or end (1) of a step; NULL if it is missing. */
static const double *find_row(const trk_explicit_run *run, int when, int input, int64_t k)
{
    const double *first = run->input[when][input];
    return first ? first + k * run->stride[input] : NULL;
}

/* Step k in the model's coordinates; of a modal stepper only why it cannot be taken. */
static trk_status take_step(trk_rungekutta *s, const trk_explicit_run *run, int64_t k)
{
    trk_action *actions[] = {&s->middle, &s->end};
    trk_status status = TRK_OK;
    for (int when = 0; when < 2 && status == TRK_OK; when++)
        status = trk_rungekutta_take_action(s, find_row(run, when, 0, k), find_row(run, when, 1, k),
                                            find_row(run, when, 2, k), actions[when]);
    if (status != TRK_OK)
        return status;
    status = s->modal ? TRK_E_RANGE : step_general(s);
    if (status == TRK_E_RANGE)
        return trk_fail(s->context, status,
                        "%s: the motion left the range of numbers in the step after t = %.9g s",
                        trk_model_name(s->model), trk_rungekutta_time(s));
    if (status == TRK_OK)
        commit(s);
    return status;
}

/* As many steps as the motion stays finite. */
static int64_t run_modal(trk_rungekutta *s, const trk_explicit_run *run)
{
    trk_explicit_run whole = *run;
    for (int input = 0; input < TRK_EXPLICIT_INPUTS; input++)
        for (int when = 0; when < 2; when++)
            if (!whole.input[when][input]) {
                whole.input[when][input] = s->modal->zeros;
                whole.stride[input] = 0;
            }
    int64_t taken = s->kernel(s->modal, &whole);
    if (taken > 0)
        for (int32_t r = 0; r < s->modal->inputs[0]; r++) {
            s->now.height[r] = find_row(&whole, 1, 0, taken - 1)[r];
            s->now.velocity[r] = find_row(&whole, 1, 1, taken - 1)[r];
        }
    s->taken += taken;
    return taken;
}

static trk_status take_steps(trk_rungekutta *s, const trk_explicit_run *run, int64_t *out_taken)
{
    *out_taken = s->modal ? run_modal(s, run) : 0;
    for (; *out_taken < run->count; ++*out_taken) {
        trk_status status = take_step(s, run, *out_taken);
        if (status != TRK_OK)
            return status;
        if (run->rows)
            trk_rungekutta_get_row(s, run->rows + *out_taken * trk_rungekutta_row_width(s));
    }
    return TRK_OK;
}

trk_status trk_rungekutta_record(trk_rungekutta *stepper, int64_t count, const double *height,
                                 const double *velocity, const double *load, double *out_rows,
                                 int64_t *out_taken)
{
    int32_t roads = stepper->model->names[TRK_PART_ROAD].count, ports = stepper->model->ports.count;
    const trk_explicit_run run = {
        count,
        {{height, velocity, load},
         {height ? height + roads : NULL, velocity ? velocity + roads : NULL,
          load ? load + ports : NULL}},
        {2 * (int64_t)roads, 2 * (int64_t)roads, 2 * (int64_t)ports},
        out_rows};
    return take_steps(stepper, &run, out_taken);
}

trk_status trk_rungekutta_step(trk_rungekutta *stepper, const double *middle_height,
                               const double *middle_velocity, const double *middle_load,
                               const double *height, const double *velocity, const double *load)
{
    TRK_REQUIRE(NULL, stepper, "trk_rungekutta_step");
    const trk_explicit_run run = {
        1, {{middle_height, middle_velocity, middle_load}, {height, velocity, load}}, {0}, NULL};
    int64_t taken;
    return take_steps(stepper, &run, &taken);
}
