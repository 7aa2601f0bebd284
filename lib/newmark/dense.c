/* SPDX-License-Identifier: MIT */
/* Forming the matrices of the dense step, and what surrounds its kernels. */
#include "newmark/newmark.h"

#include "curve/curve.h"

#include <math.h>
#include <string.h>

/* More than these are a case for the general path, which takes shorter steps when it must. */
enum { MOST_CORRECTIONS = 8 };

static int32_t count_tables(const trk_model *model)
{
    int32_t count = 0;
    for (int32_t j = 0; j < model->nonlinear_count; j++) {
        const trk_law *law = &model->laws[model->nonlinear[j]];
        count += (law->spring != NULL) + (law->damper != NULL);
    }
    return count;
}

static bool fits(const trk_newmark *stepper)
{
    const trk_newmark_options *o = &stepper->options;
    return trk_solver_backend(stepper->assembly.solver) == TRK_BACKEND_DENSE && o->alpha_f == 0 &&
           o->alpha_m == 0 && stepper->model->n <= TRK_DENSE_STATE_BLOCKS * TRK_DENSE_LANES &&
           count_tables(stepper->model) <= TRK_DENSE_TABLES;
}

static int32_t blocks_of(int32_t count)
{
    return (count + TRK_DENSE_LANES - 1) / TRK_DENSE_LANES;
}

/* All arrays, in one block; counting first (block NULL), then dealing out. */
static int64_t deal(trk_dense_step *s)
{
    int64_t state = (int64_t)s->state_blocks * TRK_DENSE_LANES,
            table = (int64_t)s->table_blocks * TRK_DENSE_LANES;
    int64_t rows = state + table, drives = (int64_t)blocks_of(s->columns) * TRK_DENSE_LANES,
            used = 0;
    struct {
        double **array;
        int64_t size;
    } arrays[] = {{&s->from_q, rows * s->n},
                  {&s->from_v, rows * s->n},
                  {&s->from_drive, rows * s->columns},
                  {&s->drive, drives},
                  {&s->influence, state * s->tables},
                  {&s->coupling, table * s->tables},
                  {&s->diagonal, table},
                  {&s->kappa, table},
                  {&s->force_bound, state},
                  {&s->scratch, table},
                  {&s->mismatch, table},
                  {&s->force[0], table},
                  {&s->force[1], table},
                  {&s->force[2], table},
                  {&s->force[3], table},
                  {&s->force[4], table},
                  {&s->pieces.lower, table},
                  {&s->pieces.upper, table},
                  {&s->pieces.origin, table},
                  {&s->pieces.c0, table},
                  {&s->pieces.c1, table},
                  {&s->pieces.c2, table},
                  {&s->pieces.c3, table}};
    for (size_t k = 0; k < sizeof arrays / sizeof *arrays; k++) {
        *arrays[k].array = s->block ? s->block + used : NULL;
        used += arrays[k].size;
    }
    return used;
}

static void list_tables(trk_dense_step *s, const trk_newmark *stepper)
{
    const trk_model *model = stepper->model;
    struct trk_dense_table *t = s->table;
    for (int32_t j = 0; j < model->nonlinear_count; j++) {
        const trk_law *law = &model->laws[model->nonlinear[j]];
        double rest = law->rest; /* goes to the first table of the link */
        if (law->spring) {
            *t++ = (struct trk_dense_table){law->spring,        j,   false, law->spring_scale,
                                            law->spring_offset, rest};
            rest = 0;
        }
        if (law->damper)
            *t++ = (struct trk_dense_table){law->damper, j, true, law->damper_scale, 0, rest};
    }
    for (int32_t k = 0; k < s->tables; k++)
        s->kappa[k] = s->table[k].of_rate ? s->v_factor : s->q_factor;
}

/* Argument of a table at a state. */
static double argument(const trk_dense_step *s, const trk_newmark *stepper, const trk_state *state,
                       int32_t table)
{
    int32_t link = stepper->model->nonlinear[s->table[table].link];
    return s->table[table].of_rate ? trk_newmark_rate(stepper, state, link)
                                   : trk_newmark_elongation(stepper, state, link);
}

/*
 * One column of L_q, L_v or L_d: what stepper->next, unit in one entry, and load_row do to
 * the acceleration and to the arguments of the tables.
 */
static trk_status column(trk_dense_step *s, trk_newmark *stepper, double *out)
{
    const trk_model *model = stepper->model;
    double *a = stepper->next.a;
    memcpy(a, stepper->load_row, (size_t)s->n * sizeof *a);
    trk_newmark_subtract_linear(stepper, &stepper->next, a);
    trk_status status = trk_solver_solve(stepper->assembly.solver, a);
    memcpy(out, a, (size_t)s->n * sizeof *a);
    double *x = out + (int64_t)s->state_blocks * TRK_DENSE_LANES;
    for (int32_t k = 0; k < s->tables; k++)
        x[k] = argument(s, stepper, &stepper->next, k) +
               s->kappa[k] * trk_rows_dot(&model->links, model->nonlinear[s->table[k].link], a);
    return status;
}

/* Columns for unit values of `count` entries. */
static trk_status columns(trk_dense_step *s, trk_newmark *stepper, double *entry, int32_t count,
                          double **out)
{
    trk_status status = TRK_OK;
    for (int32_t k = 0; status == TRK_OK && k < count; k++) {
        entry[k] = 1;
        status = column(s, stepper, *out);
        entry[k] = 0;
        *out += (int64_t)(s->state_blocks + s->table_blocks) * TRK_DENSE_LANES;
    }
    return status;
}

static trk_status form_matrices(trk_dense_step *s, trk_newmark *stepper)
{
    const trk_model *model = stepper->model;
    trk_state *unit = &stepper->next; /* zero here */
    int32_t roads = model->names[TRK_PART_ROAD].count;
    double *from_q = s->from_q, *from_v = s->from_v, *from_drive = s->from_drive;
    memset(stepper->load_row, 0, (size_t)s->n * sizeof(double));
    trk_status status = columns(s, stepper, unit->q, s->n, &from_q);
    if (status == TRK_OK)
        status = columns(s, stepper, unit->v, s->n, &from_v);
    if (status == TRK_OK)
        status = columns(s, stepper, unit->height, roads, &from_drive);
    if (status == TRK_OK)
        status = columns(s, stepper, unit->velocity, roads, &from_drive);
    for (int32_t k = 0; status == TRK_OK && k < model->ports.count; k++) {
        double ignored = 0;
        trk_rows_expand(&model->ports, k, s->n, stepper->load_row);
        status = columns(s, stepper, &ignored, 1, &from_drive);
    }
    memcpy(stepper->load_row, model->weight, (size_t)s->n * sizeof(double));
    if (status == TRK_OK)
        status = column(s, stepper, from_drive);
    s->drive[s->columns - 1] = 1; /* the weight always acts */
    memset(unit->a, 0, (size_t)s->n * sizeof *unit->a);
    return status;
}

/* Z and D of (NEWMARK.5), a column a table. */
static void copy_influence(trk_dense_step *s, const trk_newmark *stepper)
{
    for (int32_t k = 0; k < s->tables; k++) {
        int32_t j = s->table[k].link;
        double *z = s->influence + (int64_t)k * s->state_blocks * TRK_DENSE_LANES;
        double *d = s->coupling + (int64_t)k * s->table_blocks * TRK_DENSE_LANES;
        memcpy(z, stepper->influence + (int64_t)j * s->n, (size_t)s->n * sizeof *z);
        for (int32_t l = 0; l < s->tables; l++)
            d[l] = stepper->coupling[(int64_t)j * stepper->p + s->table[l].link];
        s->diagonal[k] = d[k];
    }
}

/*
 * |M a|_i = |B^T f - loads|_i <= max |f| sum_k |B_ki| for an unloaded coordinate i without
 * mass coupling: a lower bound of the largest link force at no cost.
 */
static void find_force_bound(trk_dense_step *s, const trk_model *model)
{
    const trk_rows *inertia = &model->inertia, *links = &model->links;
    for (int32_t r = 0; r < inertia->count; r++) {
        bool coupled = inertia->start[r + 1] - inertia->start[r] > 1;
        for (int64_t k = inertia->start[r]; k < inertia->start[r + 1]; k++)
            s->force_bound[inertia->column[k]] +=
                coupled ? -INFINITY : model->mass[r] * inertia->value[k] * inertia->value[k];
    }
    for (int32_t i = 0; i < s->n; i++) {
        double sum = 0;
        bool loaded = model->weight[i] != 0;
        for (int64_t k = 0; k < links->entries; k++)
            sum += links->column[k] == i ? fabs(links->value[k]) : 0;
        for (int64_t k = 0; k < model->ports.entries; k++)
            loaded |= model->ports.column[k] == i;
        s->force_bound[i] = sum > 0 && !loaded ? fmax(s->force_bound[i], 0) / sum : 0;
    }
}

static trk_status fill(trk_dense_step *s, trk_newmark *stepper)
{
    const trk_newmark_options *o = &stepper->options;
    s->n = stepper->model->n;
    s->tables = count_tables(stepper->model);
    s->columns = 2 * stepper->model->names[TRK_PART_ROAD].count + stepper->model->ports.count + 1;
    s->state_blocks = blocks_of(s->n);
    s->table_blocks = blocks_of(s->tables);
    s->block = trk_new(s->context, deal(s), sizeof *s->block);
    if (!s->block)
        return TRK_E_MEMORY;
    deal(s);
    s->h = o->step;
    s->q_predict = o->step * o->step * (0.5 - o->beta);
    s->v_predict = o->step * (1 - o->gamma);
    s->q_factor = o->step * o->step * o->beta;
    s->v_factor = o->step * o->gamma;
    s->tolerance = o->tolerance;
    s->floor = stepper->force_floor;
    s->most_corrections =
        o->max_iterations < MOST_CORRECTIONS ? o->max_iterations : MOST_CORRECTIONS;
    list_tables(s, stepper);
    copy_influence(s, stepper);
    find_force_bound(s, stepper->model);
    for (int32_t k = 0; k < TRK_DENSE_LANES * s->table_blocks; k++) {
        bool empty = k >= s->tables; /* the padding is a table of zeros that is never left */
        s->pieces.lower[k] = empty ? -INFINITY : INFINITY;
        s->pieces.upper[k] = INFINITY;
    }
    return form_matrices(s, stepper);
}

trk_status trk_dense_create(trk_newmark *stepper, trk_dense_step **out)
{
    *out = NULL;
    if (!fits(stepper))
        return TRK_OK;
    trk_dense_step *s = trk_new(stepper->context, 1, sizeof *s);
    if (!s)
        return TRK_E_MEMORY;
    s->context = stepper->context;
    trk_status status = fill(s, stepper);
    if (status == TRK_OK)
        *out = s;
    else
        trk_dense_destroy(s);
    return status;
}

void trk_dense_destroy(trk_dense_step *step)
{
    if (!step)
        return;
    trk_free(step->context, step->block);
    trk_free(step->context, step);
}

void trk_dense_fetch_pieces(trk_dense_step *step, const double *x)
{
    const trk_dense_pieces *p = &step->pieces;
    for (int32_t k = 0; k < step->tables; k++) {
        if (x[k] >= p->lower[k] && x[k] < p->upper[k])
            continue;
        const struct trk_dense_table *t = &step->table[k];
        const trk_piece *piece = &t->curve->pieces[trk_curve_locate(t->curve, x[k] + t->offset, 0)];
        p->lower[k] = piece->lower - t->offset;
        p->upper[k] = piece->upper - t->offset;
        p->origin[k] = piece->origin - t->offset;
        p->c0[k] = t->scale * piece->c0 - t->rest;
        p->c1[k] = t->scale * piece->c1;
        p->c2[k] = t->scale * piece->c2;
        p->c3[k] = t->scale * piece->c3;
    }
}

void trk_dense_adopt(trk_dense_step *step, const trk_newmark *stepper, bool steady)
{
    double *oldest = step->force[3];
    for (int k = 3; k > 0; k--)
        step->force[k] = step->force[k - 1];
    step->force[0] = oldest;
    for (int32_t k = 0; k < step->tables; k++) {
        const struct trk_dense_table *t = &step->table[k];
        double x = argument(step, stepper, &stepper->now, k);
        step->force[0][k] = t->scale * trk_curve_value(t->curve, x + t->offset) - t->rest;
    }
    step->force_scale = stepper->force_scale;
    for (int k = 1; steady && k < 4; k++)
        memcpy(step->force[k], step->force[0], (size_t)step->tables * sizeof(double));
}

trk_dense_kernel trk_dense_choose_kernel(void)
{
#ifdef TRUCKRIDE_X86_KERNELS
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq"))
        return trk_dense_kernel_avx512;
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
        return trk_dense_kernel_avx2;
#endif
    return trk_dense_kernel_base;
}
