/* SPDX-License-Identifier: MIT */
/* Create a stepper: memory, factors of the linear part, influence of the non-linear links. */
#include "newmark/newmark.h"
#include "newmark/options.h"

#include <float.h>
#include <math.h>

/* Every array starts on a cache line. */
static int64_t padded(int64_t count)
{
    return (count + 7) / 8 * 8;
}

/* Take `count` doubles from the block at *cursor. */
static double *take(double **cursor, int64_t count)
{
    double *array = *cursor;
    *cursor += padded(count);
    return array;
}

static void take_state(trk_state *state, double **cursor, int32_t n, int32_t roads, int32_t p,
                       int32_t memory)
{
    state->q = take(cursor, n);
    state->v = take(cursor, n);
    state->a = take(cursor, n);
    state->height = take(cursor, roads);
    state->velocity = take(cursor, roads);
    state->force = take(cursor, p);
    state->memory = take(cursor, memory);
    state->rest = take(cursor, n);
}

static trk_status allocate(trk_newmark *stepper)
{
    const trk_model *model = stepper->model;
    int32_t n = model->n, p = model->nonlinear_count, roads = model->names[TRK_PART_ROAD].count,
            memory = model->memory[model->links.count];
    int64_t square = padded((int64_t)p * p);
    int64_t state = 4 * padded(n) + 2 * padded(roads) + padded(p) + padded(memory);
    int64_t doubles = 2 * state + 2 * padded(n) + padded((int64_t)p * n) + 2 * square +
                      11 * padded(p) + padded(model->links.count);
    stepper->block = trk_new(stepper->context, doubles, sizeof *stepper->block);
    stepper->nonlinear_index =
        trk_new(stepper->context, model->links.count, sizeof *stepper->nonlinear_index);
    stepper->hints = trk_new(stepper->context, p, sizeof *stepper->hints);
    if (!stepper->block || !stepper->nonlinear_index || !stepper->hints)
        return TRK_E_MEMORY;
    double *cursor = stepper->block;
    take_state(&stepper->now, &cursor, n, roads, p, memory);
    take_state(&stepper->next, &cursor, n, roads, p, memory);
    stepper->p = p;
    stepper->load_row = take(&cursor, n);
    stepper->residual = take(&cursor, n);
    stepper->link_factor = take(&cursor, model->links.count);
    stepper->influence = take(&cursor, (int64_t)p * n);
    stepper->coupling = take(&cursor, (int64_t)p * p);
    stepper->jacobian = take(&cursor, (int64_t)p * p);
    stepper->e_free = take(&cursor, p);
    stepper->v_free = take(&cursor, p);
    for (int k = 0; k < 3; k++)
        stepper->past[k] = take(&cursor, p);
    stepper->trial = take(&cursor, p);
    stepper->mismatch = take(&cursor, p);
    stepper->pull = take(&cursor, p);
    stepper->reach = take(&cursor, p);
    stepper->root = take(&cursor, p);
    stepper->slope = take(&cursor, p);
    for (int32_t k = 0; k < model->links.count; k++)
        stepper->nonlinear_index[k] = -1;
    for (int32_t j = 0; j < p; j++)
        stepper->nonlinear_index[model->nonlinear[j]] = j;
    return TRK_OK;
}

trk_status trk_newmark_factorize(trk_newmark *stepper)
{
    const trk_model *model = stepper->model;
    const trk_newmark_options *o = &stepper->options;
    double *s = stepper->link_factor;
    for (int32_t k = 0; k < model->links.count; k++)
        s[k] = (1 - o->alpha_f) * o->step *
               (o->gamma * model->laws[k].damping + o->beta * o->step * model->laws[k].stiffness);
    int32_t bad = 0;
    trk_status status = trk_assembly_factorize(&stepper->assembly, 1 - o->alpha_m, s, &bad);
    return status == TRK_E_SINGULAR
               ? trk_model_fail_singular(stepper->context, model, "matrix of the step", s, bad)
               : status;
}

/* Z and D of (NEWMARK.5). */
static trk_status find_influence(trk_newmark *stepper)
{
    const trk_model *model = stepper->model;
    for (int32_t j = 0; j < stepper->p; j++) {
        double *z = stepper->influence + (int64_t)j * model->n;
        trk_rows_expand(&model->links, model->nonlinear[j], model->n, z);
        trk_status status = trk_solver_solve(stepper->assembly.solver, z);
        if (status != TRK_OK)
            return status;
        for (int32_t k = 0; k < stepper->p; k++)
            stepper->coupling[(int64_t)j * stepper->p + k] =
                trk_rows_dot(&model->links, model->nonlinear[k], z);
    }
    return TRK_OK;
}

/* Largest force of a table, 0 without one. */
static double largest_of(const trk_curve *curve)
{
    double largest = 0;
    for (int64_t k = 0; curve && k < trk_curve_count(curve); k++)
        largest = fmax(largest, fabs(trk_curve_y(curve)[k]));
    return largest;
}

/* What rounding leaves of a force computed as a difference of larger ones, of tables or at rest. */
static double find_force_floor(const trk_model *model)
{
    double largest = 0;
    for (int32_t j = 0; j < model->nonlinear_count; j++) {
        const trk_link_law *law = &model->laws[model->nonlinear[j]];
        double at_rest =
            law->law ? fabs(law->rest) + fabs(model->static_force[model->nonlinear[j]]) : 0;
        largest = fmax(largest, at_rest + law->spring_scale * largest_of(law->spring) +
                                    law->damper_scale * largest_of(law->damper));
    }
    return 8 * DBL_EPSILON * largest;
}

static trk_status prepare(trk_newmark *stepper)
{
    const trk_model *model = stepper->model;
    trk_status status = allocate(stepper);
    if (status == TRK_OK)
        status =
            trk_assembly_create(stepper->context, stepper->options.backend, model->n,
                                &model->inertia, model->mass, &model->links, &stepper->assembly);
    if (status == TRK_OK)
        status = trk_newmark_factorize(stepper);
    if (status == TRK_OK)
        status = find_influence(stepper);
    stepper->force_floor = find_force_floor(model);
    if (status == TRK_OK)
        status = trk_fast_create(stepper, &stepper->fast);
    if (status == TRK_OK && stepper->fast)
        status = trk_fast_create_sensors(stepper);
    if (status == TRK_OK)
        status = trk_newmark_set_state(stepper, 0, NULL, NULL, NULL, NULL, NULL);
    if (status != TRK_OK)
        return status;
    trk_newmark_choose_kernel(stepper);
    stepper->statistics.nonlinear_links = stepper->p;
    stepper->statistics.coordinates = model->n;
    stepper->statistics.backend = trk_solver_backend(stepper->assembly.solver);
    stepper->statistics.factor_entries = trk_solver_factor_entries(stepper->assembly.solver);
    return TRK_OK;
}

trk_status trk_newmark_create(trk_context *context, const trk_model *model,
                              const trk_newmark_options *options, trk_newmark **out_stepper)
{
    TRK_REQUIRE(context, out_stepper, "trk_newmark_create");
    *out_stepper = NULL;
    TRK_REQUIRE(context, context, "trk_newmark_create");
    TRK_REQUIRE(context, model, "trk_newmark_create");
    trk_newmark_options known;
    trk_status status = trk_newmark_read_options(context, options, &known);
    if (status != TRK_OK)
        return status;
    trk_newmark *stepper = trk_new(context, 1, sizeof *stepper);
    if (!stepper)
        return TRK_E_MEMORY;
    stepper->context = context;
    stepper->model = model;
    stepper->options = known;
    status = prepare(stepper);
    if (status != TRK_OK) {
        trk_newmark_destroy(stepper);
        return status;
    }
    *out_stepper = stepper;
    return TRK_OK;
}

void trk_newmark_destroy(trk_newmark *stepper)
{
    if (!stepper)
        return;
    trk_context *context = stepper->context;
    if (stepper->assembly.context)
        trk_assembly_clear(&stepper->assembly);
    trk_fast_destroy(stepper->fast);
    trk_free(context, stepper->block);
    trk_free(context, stepper->nonlinear_index);
    trk_free(context, stepper->hints);
    trk_free(context, stepper);
}
