/* SPDX-License-Identifier: MIT */
/* One step: predict, solve the linear part, solve the few non-linear forces, correct. */
#include "newmark/newmark.h"

#include <math.h>
#include <string.h>

void trk_newmark_subtract_linear(const trk_newmark *stepper, const trk_state *state, double *r)
{
    const trk_model *model = stepper->model;
    for (int32_t k = 0; k < model->links.count; k++) {
        const trk_law *law = &model->laws[k];
        double f = law->stiffness * trk_newmark_elongation(stepper, state, k) +
                   law->damping * trk_newmark_rate(stepper, state, k);
        trk_rows_add(&model->links, k, -f, r);
    }
}

double trk_newmark_largest_force(const trk_newmark *stepper, const trk_state *state)
{
    const trk_model *model = stepper->model;
    double largest = 0;
    for (int32_t k = 0; k < model->links.count; k++) {
        const trk_law *law = &model->laws[k];
        int32_t j = stepper->nonlinear_index[k];
        double f = law->stiffness * trk_newmark_elongation(stepper, state, k) +
                   law->damping * trk_newmark_rate(stepper, state, k) +
                   (j >= 0 ? state->force[j] : 0);
        largest = fmax(largest, fabs(f));
    }
    return largest;
}

void trk_newmark_add_inertia(const trk_newmark *stepper, double factor, const double *x, double *y)
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
        trk_newmark_add_inertia(stepper, -o->alpha_m, stepper->now.a, b);
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
    trk_newmark_add_inertia(stepper, -(1 - o->alpha_m), next->a, next->rest);
    if (o->alpha_m != 0)
        trk_newmark_add_inertia(stepper, -o->alpha_m, now->a, next->rest);
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

/* Road and loads into the drives of the dense step. false: one is not finite. */
static bool take_drives(trk_newmark *stepper, const double *height, const double *velocity,
                        const double *load)
{
    int32_t roads = stepper->model->names[TRK_PART_ROAD].count, ports = stepper->model->ports.count;
    double *drive = stepper->dense->drive, not_finite = 0;
    for (int32_t k = 0; k < roads; k++) {
        double u = height ? height[k] : 0, v = velocity ? velocity[k] : 0;
        stepper->next.height[k] = drive[k] = u;
        stepper->next.velocity[k] = drive[roads + k] = v;
        not_finite += 0 * u + 0 * v;
    }
    for (int32_t k = 0; k < ports; k++) {
        drive[2 * roads + k] = load ? load[k] : 0;
        not_finite += 0 * drive[2 * roads + k];
    }
    return not_finite == 0;
}

/* Link of the table that was furthest off before the last correction. */
static int32_t worst_link(const trk_newmark *stepper)
{
    const trk_dense_step *dense = stepper->dense;
    int32_t worst = 0;
    for (int32_t k = 1; k < dense->tables; k++)
        if (fabs(dense->mismatch[k]) > fabs(dense->mismatch[worst]))
            worst = k;
    return stepper->model->nonlinear[dense->table[worst].link] + 1;
}

/* The step by the dense products; false: they do not suffice, nothing has happened. */
static bool step_dense(trk_newmark *stepper, const double *height, const double *velocity,
                       const double *load)
{
    trk_dense_step *dense = stepper->dense;
    if (!take_drives(stepper, height, velocity, load))
        return false;
    const trk_state *now = &stepper->now;
    trk_state *next = &stepper->next;
    int32_t corrections = stepper->kernel(
        dense, &(trk_dense_states){now->q, now->v, now->a, next->q, next->v, next->a});
    if (corrections < 0) { /* what overflowed must not stay in the padding */
        for (int32_t k = dense->n; k < dense->state_blocks * TRK_DENSE_LANES; k++)
            next->q[k] = next->v[k] = next->a[k] = 0;
        return false;
    }
    stepper->force_scale = dense->force_scale;
    double *oldest = dense->force[3];
    for (int k = 3; k > 0; k--)
        dense->force[k] = dense->force[k - 1];
    dense->force[0] = dense->force[4];
    dense->force[4] = oldest;
    memset(next->force, 0, (size_t)stepper->p * sizeof *next->force);
    for (int32_t k = 0; k < dense->tables; k++)
        next->force[dense->table[k].link] += dense->force[0][k];
    stepper->statistics.iterations += corrections;
    if (corrections > stepper->statistics.max_iterations) {
        stepper->statistics.max_iterations = corrections;
        stepper->statistics.worst_link = worst_link(stepper);
    }
    return true;
}

static trk_status step_general(trk_newmark *stepper, const double *height, const double *velocity,
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

trk_status trk_newmark_step(trk_newmark *stepper, const double *height, const double *velocity,
                            const double *load)
{
    TRK_REQUIRE(NULL, stepper, "trk_newmark_step");
    if (stepper->dense && step_dense(stepper, height, velocity, load)) {
        commit(stepper);
        return TRK_OK;
    }
    trk_status status = step_general(stepper, height, velocity, load);
    if (status != TRK_OK)
        return status;
    commit(stepper);
    if (stepper->dense)
        trk_dense_adopt(stepper->dense, stepper, false);
    return TRK_OK;
}
