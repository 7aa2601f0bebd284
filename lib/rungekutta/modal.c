/* SPDX-License-Identifier: MIT */
/* Forming the matrices of the modal step (RUNGEKUTTA.7), and what surrounds its kernels. */
#include "rungekutta/jacobi.h"
#include "rungekutta/rungekutta.h"

#include "curve/curve.h"

#include <math.h>
#include <string.h>

static int32_t count_tables(const trk_model *model, bool springs_only)
{
    int32_t count = 0;
    for (int32_t j = 0; j < model->nonlinear_count; j++) {
        const trk_law *law = &model->laws[model->nonlinear[j]];
        count += (law->spring != NULL) + (!springs_only && law->damper != NULL);
    }
    return count;
}

static int32_t blocks_of(int32_t count)
{
    return (count + TRK_EXPLICIT_LANES - 1) / TRK_EXPLICIT_LANES;
}

/* All arrays, in one block; counting first (block NULL), then dealing out. */
static int64_t deal(trk_explicit_step *s)
{
    int64_t state = (int64_t)s->state_blocks * TRK_EXPLICIT_LANES,
            table = (int64_t)s->table_blocks * TRK_EXPLICIT_LANES,
            square = (int64_t)blocks_of(s->n * s->n) * TRK_EXPLICIT_LANES, used = 0,
            drives = (int64_t)blocks_of(s->columns) * TRK_EXPLICIT_LANES;
    struct {
        double **array;
        int64_t size;
    } arrays[] = {{&s->phi, square},
                  {&s->inverse, square},
                  {&s->kappa, state},
                  {&s->from_v, (state + table) * s->n},
                  {&s->from_q, table * s->n},
                  {&s->influence, state * s->tables},
                  {&s->from_drive, state * s->columns},
                  {&s->weight, state},
                  {&s->drive[0], drives},
                  {&s->drive[1], drives},
                  {&s->shift[0], table},
                  {&s->shift[1], table},
                  {&s->scratch_q, state},
                  {&s->scratch_v, state},
                  {&s->scratch_x, table},
                  {&s->scratch_g, table},
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

static void list_tables(trk_explicit_step *s, const trk_model *model)
{
    struct trk_explicit_table *t = s->table;
    for (int32_t j = 0; j < model->nonlinear_count; j++) {
        int32_t link = model->nonlinear[j];
        const trk_law *law = &model->laws[link];
        double rest = law->rest; /* goes to the first table of the link */
        if (law->spring) {
            *t++ = (struct trk_explicit_table){law->spring,        link, false, law->spring_scale,
                                               law->spring_offset, rest};
            rest = 0;
        }
        if (law->damper)
            *t++ = (struct trk_explicit_table){law->damper, link, true, law->damper_scale, 0, rest};
        s->is_shifted |= model->roads.start[link + 1] > model->roads.start[link];
    }
    for (int32_t k = 0; k < TRK_EXPLICIT_LANES * s->table_blocks; k++) {
        bool empty = k >= s->tables; /* the padding is a table of zeros that is never left */
        s->pieces.lower[k] = empty ? -INFINITY : INFINITY;
        s->pieces.upper[k] = INFINITY;
    }
}

/* Links on the road whose linear part moves with it, then all ports. */
static void list_columns(trk_explicit_step *s, const trk_model *model, int32_t *source)
{
    s->road_links = 0;
    for (int32_t k = 0; k < model->links.count; k++)
        if (model->roads.start[k + 1] > model->roads.start[k] &&
            (model->laws[k].stiffness != 0 || model->laws[k].damping != 0))
            source[s->road_links++] = k;
    s->columns = s->road_links + model->ports.count;
    for (int32_t k = 0; k < model->ports.count; k++)
        source[s->road_links + k] = k;
}

void trk_explicit_transform(int32_t n, const double *a, const double *x, double *out)
{
    for (int32_t i = 0; i < n; i++) {
        double sum = 0;
        for (int32_t j = 0; j < n; j++)
            sum += a[(int64_t)i * n + j] * x[j];
        out[i] = sum;
    }
}

/* out := Phi^T row^T */
static void project(const trk_explicit_step *s, const trk_rows *rows, int32_t row, double *out)
{
    for (int64_t k = rows->start[row]; k < rows->start[row + 1]; k++)
        for (int32_t i = 0; i < s->n; i++)
            out[i] += rows->value[k] * s->phi[(int64_t)rows->column[k] * s->n + i];
}

/* Phi, Phi^-1 and kappa of the linear springs; work: 2 n x n. */
static void find_modes(trk_explicit_step *s, const trk_model *model, double *work)
{
    int64_t n = s->n;
    double *k = work, *u = work + n * n, *m = s->inverse;
    memset(k, 0, (size_t)(n * n) * sizeof *k);
    for (int32_t j = 0; j < model->links.count; j++)
        trk_rows_add_square(&model->links, j, model->laws[j].stiffness, s->n, k);
    trk_model_get_mass(model, m);
    trk_jacobi_modes(s->n, k, m, s->kappa, s->phi, u);
    trk_model_get_mass(model, m);
    memcpy(k, m, (size_t)(n * n) * sizeof *k);
    for (int64_t i = 0; i < n; i++)
        for (int64_t j = 0; j < n; j++) {
            double sum = 0;
            for (int64_t l = 0; l < n; l++)
                sum += s->phi[l * n + i] * k[l * n + j];
            s->inverse[i * n + j] = sum;
        }
}

/* C of the linear dampers, X_q, X_v, Z, and the columns of what acts. */
static void fill(trk_explicit_step *s, const trk_model *model, double *row)
{
    int32_t n = s->n;
    int64_t state = (int64_t)s->state_blocks * TRK_EXPLICIT_LANES,
            table = (int64_t)s->table_blocks * TRK_EXPLICIT_LANES, rows = state + table;
    for (int32_t k = 0; k < model->links.count; k++) {
        memset(row, 0, (size_t)n * sizeof *row);
        project(s, &model->links, k, row);
        for (int32_t j = 0; model->laws[k].damping != 0 && j < n; j++)
            for (int32_t i = 0; i < n; i++)
                s->from_v[j * rows + i] += model->laws[k].damping * row[i] * row[j];
    }
    for (int32_t k = 0; k < s->tables; k++) {
        double *z = s->influence + k * state;
        project(s, &model->links, s->table[k].link, z);
        for (int32_t j = 0; j < n; j++)
            *(s->table[k].of_rate ? &s->from_v[j * rows + state + k] : &s->from_q[j * table + k]) =
                z[j];
    }
    for (int32_t c = 0; c < s->columns; c++)
        project(s, c < s->road_links ? &model->links : &model->ports, s->source[c],
                s->from_drive + c * state);
    for (int32_t i = 0; i < n; i++)
        for (int32_t j = 0; j < n; j++)
            s->weight[i] += s->phi[(int64_t)j * n + i] * model->weight[j];
}

static trk_status form(trk_explicit_step *s, const trk_model *model)
{
    int64_t n = model->n;
    s->n = model->n;
    s->tables = count_tables(model, false);
    s->springs = count_tables(model, true);
    int32_t state = blocks_of(s->n), table = blocks_of(s->tables);
    s->state_blocks = state == 3 ? 4 : state; /* rounded up to the sizes the kernels are made for */
    s->table_blocks = table == 2 ? 3 : table;
    s->source =
        trk_new(s->context, (int64_t)model->links.count + model->ports.count, sizeof *s->source);
    if (!s->source)
        return TRK_E_MEMORY;
    list_columns(s, model, s->source);
    s->block = trk_new(s->context, deal(s), sizeof *s->block);
    double *work = trk_new(s->context, 2 * n * n, sizeof *work);
    if (s->block && work) {
        deal(s);
        list_tables(s, model);
        find_modes(s, model, work);
        fill(s, model, work);
    }
    trk_free(s->context, work);
    return s->block && work ? TRK_OK : TRK_E_MEMORY;
}

trk_status trk_explicit_create(trk_rungekutta *stepper, trk_explicit_step **out)
{
    const trk_model *model = stepper->model;
    if (model->n > TRK_EXPLICIT_STATE_BLOCKS * TRK_EXPLICIT_LANES ||
        count_tables(model, false) > TRK_EXPLICIT_TABLES)
        return TRK_OK;
    trk_explicit_step *s = trk_new(stepper->context, 1, sizeof *s);
    if (!s)
        return TRK_E_MEMORY;
    s->context = stepper->context;
    s->h = stepper->step;
    trk_status status = form(s, model);
    if (status == TRK_OK)
        *out = s;
    else
        trk_explicit_destroy(s);
    return status;
}

void trk_explicit_destroy(trk_explicit_step *step)
{
    if (!step)
        return;
    trk_free(step->context, step->source);
    trk_free(step->context, step->block);
    trk_free(step->context, step);
}

void trk_explicit_set_drive(trk_explicit_step *step, const trk_model *model, int when,
                            const double *height, const double *velocity, const double *load)
{
    double *drive = step->drive[when];
    for (int32_t c = 0; c < step->road_links; c++) {
        int32_t link = step->source[c];
        drive[c] = model->laws[link].stiffness * trk_rows_dot(&model->roads, link, height) +
                   model->laws[link].damping * trk_rows_dot(&model->roads, link, velocity);
    }
    for (int32_t c = step->road_links; c < step->columns; c++)
        drive[c] = load[step->source[c]];
    for (int32_t k = 0; step->is_shifted && k < step->tables; k++)
        step->shift[when][k] = -trk_rows_dot(&model->roads, step->table[k].link,
                                             step->table[k].of_rate ? velocity : height);
}

void trk_explicit_fetch_pieces(trk_explicit_step *step, const double *x)
{
    const trk_explicit_pieces *p = &step->pieces;
    for (int32_t k = 0; k < step->tables; k++) {
        if (x[k] >= p->lower[k] && x[k] < p->upper[k])
            continue;
        const struct trk_explicit_table *t = &step->table[k];
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

trk_explicit_kernel trk_explicit_choose_kernel(void)
{
#ifdef TRUCKRIDE_X86_KERNELS
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq"))
        return trk_explicit_kernel_avx512;
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
        return trk_explicit_kernel_avx2;
#endif
    return trk_explicit_kernel_base;
}
