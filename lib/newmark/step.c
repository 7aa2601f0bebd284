/* SPDX-License-Identifier: MIT */
/* One step of any system: predict, solve the linear part, solve the few non-linear forces, correct. */
#include "newmark/newmark.h"

#include <math.h>
#include <string.h>

void trk_newmark_subtract_linear(const trk_newmark *stepper, const trk_state *state, double *r)
{
    const trk_model *model = stepper->model;
    for (int32_t k = 0; k < model->links.count; k++) {
        double f = trk_newmark_linear_force(stepper, state, k);
        if (f != 0)
            trk_rows_add(&model->links, k, -f, r);
    }
}

double trk_newmark_largest_force(const trk_newmark *stepper, const trk_state *state)
{
    const trk_model *model = stepper->model;
    double largest = 0;
    for (int32_t k = 0; k < model->links.count; k++) {
        int32_t j = stepper->nonlinear_index[k];
        double f =
            fabs(trk_newmark_linear_force(stepper, state, k) + (j >= 0 ? state->force[j] : 0));
        largest = f > largest ? f : largest;
    }
    return largest;
}

/* y := y + factor M x */
static void add_inertia(const trk_newmark *stepper, double factor, const double *x, double *y)
{
    const trk_model *model = stepper->model;
    for (int32_t r = 0; r < model->inertia.count; r++)
        trk_rows_add(&model->inertia, r,
                     factor * model->mass[r] * trk_rows_dot(&model->inertia, r, x), y);
}

/* (NEWMARK.2), (NEWMARK.3) with a1 = 0. */
static void predict(const trk_newmark *stepper)
{
    const trk_newmark_options *o = &stepper->options;
    const trk_state *now = &stepper->now;
    double h = o->step, q_factor = h * h * (0.5 - o->beta), v_factor = h * (1 - o->gamma);
    for (int32_t i = 0; i < stepper->model->n; i++) {
        stepper->next.q[i] = now->q[i] + h * now->v[i] + q_factor * now->a[i];
        stepper->next.v[i] = now->v[i] + v_factor * now->a[i];
    }
}

/* a of (NEWMARK.4) with all non-linear forces zero, into next.a, from the predicted state. */
static trk_status solve_linear_part(trk_newmark *stepper)
{
    const trk_newmark_options *o = &stepper->options;
    int32_t n = stepper->model->n;
    double *b = stepper->next.a;
    memcpy(b, stepper->load_row, (size_t)n * sizeof *b);
    trk_newmark_subtract_linear(stepper, &stepper->next, b);
    if (o->alpha_f != 0)
        for (int32_t i = 0; i < n; i++)
            b[i] = (1 - o->alpha_f) * b[i] - o->alpha_f * stepper->now.rest[i];
    if (o->alpha_m != 0)
        add_inertia(stepper, -o->alpha_m, stepper->now.a, b);
    return trk_solver_solve(stepper->assembly.solver, b);
}

/* Where the non-linear links would be were their forces zero, and where their forces seem to go. */
static void start_newton(trk_newmark *stepper)
{
    const trk_newmark_options *o = &stepper->options;
    double q_factor = o->beta * o->step * o->step, v_factor = o->gamma * o->step;
    for (int32_t j = 0; j < stepper->p; j++) {
        int32_t link = stepper->model->nonlinear[j];
        double a = trk_rows_dot(&stepper->model->links, link, stepper->next.a);
        stepper->e_free[j] = trk_newmark_elongation(stepper, &stepper->next, link) + q_factor * a;
        stepper->v_free[j] = trk_newmark_rate(stepper, &stepper->next, link) + v_factor * a;
        stepper->next.force[j] = 4 * (stepper->now.force[j] + stepper->past[1][j]) -
                                 6 * stepper->past[0][j] - stepper->past[2][j];
    }
}

/* a1 = a_free - (1 - alpha_f) Z^T g, then (NEWMARK.2) and (NEWMARK.3). false: not finite. */
static bool correct(trk_newmark *stepper)
{
    const trk_newmark_options *o = &stepper->options;
    trk_state *next = &stepper->next;
    int32_t n = stepper->model->n;
    double q_factor = o->beta * o->step * o->step, v_factor = o->gamma * o->step, sum = 0;
    for (int32_t j = 0; j < stepper->p; j++) {
        double g = (1 - o->alpha_f) * next->force[j];
        const double *z = stepper->influence + (int64_t)j * n;
        for (int32_t i = 0; i < n; i++)
            next->a[i] -= g * z[i];
    }
    for (int32_t i = 0; i < n; i++) {
        next->q[i] += q_factor * next->a[i];
        next->v[i] += v_factor * next->a[i];
        sum += fabs(next->q[i]) + fabs(next->v[i]) + fabs(next->a[i]);
    }
    return isfinite(sum);
}

/* r at the new time out of (NEWMARK.1), which holds now. */
static void update_rest(trk_newmark *stepper)
{
    const trk_newmark_options *o = &stepper->options;
    trk_state *now = &stepper->now, *next = &stepper->next;
    int32_t n = stepper->model->n;
    for (int32_t i = 0; i < n; i++)
        next->rest[i] = -o->alpha_f * now->rest[i];
    add_inertia(stepper, -(1 - o->alpha_m), next->a, next->rest);
    if (o->alpha_m != 0)
        add_inertia(stepper, -o->alpha_m, now->a, next->rest);
    for (int32_t i = 0; i < n; i++)
        next->rest[i] /= 1 - o->alpha_f;
}

static void commit(trk_newmark *stepper)
{
    double *oldest = stepper->past[2];
    stepper->past[2] = stepper->past[1];
    stepper->past[1] = stepper->past[0];
    stepper->past[0] = oldest;
    memcpy(oldest, stepper->now.force, (size_t)stepper->p * sizeof *oldest);
    trk_state before = stepper->now;
    stepper->now = stepper->next;
    stepper->next = before;
    stepper->taken++;
    stepper->statistics.steps++;
}

static trk_status advance(trk_newmark *stepper, const double *height, const double *velocity,
                          const double *load)
{
    trk_status status = trk_newmark_take_inputs(stepper, height, velocity, load, &stepper->next);
    if (status != TRK_OK)
        return status;
    predict(stepper);
    status = solve_linear_part(stepper);
    if (status == TRK_OK && stepper->p > 0) {
        start_newton(stepper);
        status = trk_newmark_solve_forces(stepper);
    }
    if (status != TRK_OK)
        return status;
    if (!correct(stepper))
        return trk_fail(stepper->context, TRK_E_RANGE,
                        "%s: the motion left the range of numbers in the step after t = %.9g s",
                        trk_model_name(stepper->model), trk_newmark_time(stepper));
    if (stepper->options.alpha_f != 0)
        update_rest(stepper);
    if (stepper->p > 0) /* for the next step: at the predicted state stiff links say far too much */
        stepper->force_scale = trk_newmark_largest_force(stepper, &stepper->next);
    return TRK_OK;
}

/* Before the general path follows the modal one: its forces have no past. */
static void leave_fast(trk_newmark *stepper)
{
    trk_fast_settle(stepper);
    for (int k = 0; k < 3; k++)
        memcpy(stepper->past[k], stepper->now.force, (size_t)stepper->p * sizeof(double));
    stepper->force_scale = trk_newmark_largest_force(stepper, &stepper->now);
}

trk_status trk_newmark_step_general(trk_newmark *stepper, const double *height,
                                    const double *velocity, const double *load)
{
    if (stepper->fast && stepper->fast->is_ahead)
        leave_fast(stepper);
    trk_status status = advance(stepper, height, velocity, load);
    if (status != TRK_OK)
        return status;
    commit(stepper);
    if (stepper->fast)
        trk_fast_adopt(stepper->fast, stepper, false);
    return TRK_OK;
}
