/* SPDX-License-Identifier: MIT */
/* Forming the matrices of the modal steps (RUNGEKUTTA.6). */
#include "rungekutta/modal.h"

#include "model/modal_basis.h"

#include <math.h>
#include <string.h>

static int32_t count_tables(const trk_model *model, bool springs_only)
{
    int32_t count = 0;
    for (int32_t j = 0; j < model->nonlinear_count; j++) {
        const trk_link_law *law = &model->laws[model->nonlinear[j]];
        count += (law->spring != NULL) + (!springs_only && law->damper != NULL);
    }
    return count;
}

/* Small enough, and no spring that pushes away from its rest. */
static bool is_fit(const trk_model *model)
{
    if (model->n > TRK_EXPLICIT_STATE_BLOCKS * TRK_EXPLICIT_LANES ||
        count_tables(model, false) > TRK_EXPLICIT_TABLES)
        return false;
    for (int32_t k = 0; k < model->links.count; k++)
        if (model->laws[k].stiffness < 0)
            return false;
    return true;
}

static int32_t blocks_of(int32_t count)
{
    return (count + TRK_EXPLICIT_LANES - 1) / TRK_EXPLICIT_LANES;
}

static int64_t padded(int64_t count)
{
    return (count + TRK_EXPLICIT_LANES - 1) / TRK_EXPLICIT_LANES * TRK_EXPLICIT_LANES;
}

/* All arrays, in one block; counting first (block NULL), then dealing out. */
static int64_t deal(trk_explicit *s)
{
    int64_t state = trk_explicit_part(s), table = (int64_t)s->table_blocks * TRK_EXPLICIT_LANES,
            roads = s->inputs[0], ports = s->inputs[2], used = 0;
    struct {
        double **array;
        int64_t size;
    } arrays[] = {{&s->phi, (int64_t)s->n * s->n},
                  {&s->inverse, (int64_t)s->n * s->n},
                  {&s->kappa, state},
                  {&s->damping, state * s->n},
                  {&s->from_v, table * s->n},
                  {&s->from_q, table * s->n},
                  {&s->influence, state * s->tables},
                  {&s->drive[0], state * roads},
                  {&s->drive[1], state * roads},
                  {&s->drive[2], state * ports},
                  {&s->shift[0], table * roads},
                  {&s->shift[1], table * roads},
                  {&s->shift[2], table * ports},
                  {&s->weight, state},
                  {&s->zeros, roads > ports ? roads : ports},
                  {&s->row, trk_explicit_width(s)},
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
        used += padded(arrays[k].size);
    }
    return used;
}

static void list_tables(trk_explicit *s, const trk_model *model)
{
    trk_explicit_table *t = s->table;
    for (int32_t j = 0; j < model->nonlinear_count; j++) {
        int32_t link = model->nonlinear[j];
        const trk_link_law *law = &model->laws[link];
        double rest = law->rest; /* goes to the first table of the link */
        if (law->spring) {
            *t++ = (trk_explicit_table){.curve = law->spring,
                                        .link = link,
                                        .scale = law->spring_scale,
                                        .offset = law->spring_offset,
                                        .rest = rest};
            rest = 0;
        }
        if (law->damper)
            *t++ = (trk_explicit_table){.curve = law->damper,
                                        .link = link,
                                        .of_rate = true,
                                        .scale = law->damper_scale,
                                        .rest = rest};
        s->is_shifted |= model->roads.start[link + 1] > model->roads.start[link];
    }
    for (int32_t k = 0; k < TRK_EXPLICIT_LANES * s->table_blocks; k++) {
        bool empty = k >= s->tables; /* the padding is a table of zeros that is never left */
        s->pieces.lower[k] = empty ? -INFINITY : INFINITY;
        s->pieces.upper[k] = INFINITY;
    }
}

static int64_t count_pieces(const trk_model *model)
{
    int64_t count = 0;
    for (int32_t j = 0; j < model->nonlinear_count; j++) {
        const trk_link_law *law = &model->laws[model->nonlinear[j]];
        count +=
            (law->spring ? law->spring->count + 1 : 0) + (law->damper ? law->damper->count + 1 : 0);
    }
    return count;
}

/* The pieces of force over x. */
static void list_pieces(trk_explicit *s)
{
    trk_piece *out = s->all_pieces;
    for (int32_t k = 0; k < s->tables; k++) {
        trk_explicit_table *t = &s->table[k];
        t->piece = out;
        for (int32_t i = 0; i <= t->curve->count; i++) {
            const trk_piece *piece = &t->curve->pieces[i];
            *out++ = (trk_piece){.lower = piece->lower - t->offset,
                                 .upper = piece->upper - t->offset,
                                 .origin = piece->origin - t->offset,
                                 .c0 = t->scale * piece->c0 - t->rest,
                                 .c1 = t->scale * piece->c1,
                                 .c2 = t->scale * piece->c2,
                                 .c3 = t->scale * piece->c3};
        }
    }
}

/* out := Phi^T row^T */
static void project(const trk_explicit *s, const trk_rows *rows, int32_t row, double *out)
{
    memset(out, 0, (size_t)s->n * sizeof *out);
    for (int64_t k = rows->start[row]; k < rows->start[row + 1]; k++)
        for (int32_t i = 0; i < s->n; i++)
            out[i] += rows->value[k] * s->phi[(int64_t)rows->column[k] * s->n + i];
}

/* C, and what the road does through the linear parts of the links. */
static void fill_links(trk_explicit *s, const trk_model *model, double *b)
{
    int64_t state = trk_explicit_part(s);
    for (int32_t k = 0; k < model->links.count; k++) {
        const trk_link_law *law = &model->laws[k];
        project(s, &model->links, k, b);
        for (int32_t j = 0; j < s->n; j++)
            for (int32_t i = 0; i < s->n; i++)
                s->damping[j * state + i] += law->damping * b[i] * b[j];
        for (int64_t r = model->roads.start[k]; r < model->roads.start[k + 1]; r++)
            for (int32_t i = 0; i < s->n; i++) {
                int64_t place = model->roads.column[r] * state + i;
                s->drive[0][place] += law->stiffness * b[i] * model->roads.value[r];
                s->drive[1][place] += law->damping * b[i] * model->roads.value[r];
            }
    }
}

/* X_q, X_v, Z, and what the road adds to the arguments. */
static void fill_tables(trk_explicit *s, const trk_model *model)
{
    int64_t state = trk_explicit_part(s), table = (int64_t)s->table_blocks * TRK_EXPLICIT_LANES;
    for (int32_t k = 0; k < s->tables; k++) {
        const trk_explicit_table *t = &s->table[k];
        double *z = s->influence + k * state;
        project(s, &model->links, t->link, z);
        for (int32_t j = 0; j < s->n; j++)
            (t->of_rate ? s->from_v : s->from_q)[j * table + k] = z[j];
        for (int64_t r = model->roads.start[t->link]; r < model->roads.start[t->link + 1]; r++)
            s->shift[t->of_rate][model->roads.column[r] * table + k] -= model->roads.value[r];
    }
}

static void fill(trk_explicit *s, const trk_model *model)
{
    list_tables(s, model);
    list_pieces(s);
    fill_links(s, model, s->scratch_v);
    memset(s->scratch_v, 0, (size_t)s->n * sizeof(double));
    fill_tables(s, model);
    for (int32_t k = 0; k < model->ports.count; k++)
        project(s, &model->ports, k, s->drive[2] + k * trk_explicit_part(s));
    for (int32_t i = 0; i < s->n; i++)
        for (int32_t j = 0; j < s->n; j++)
            s->weight[i] += s->phi[(int64_t)j * s->n + i] * model->weight[j];
}

static trk_status form(trk_explicit *s, const trk_model *model)
{
    s->n = model->n;
    s->tables = count_tables(model, false);
    s->springs = count_tables(model, true);
    s->inputs[0] = s->inputs[1] = model->names[TRK_PART_ROAD].count;
    s->inputs[2] = model->ports.count;
    int32_t state = blocks_of(s->n), table = blocks_of(s->tables);
    s->state_blocks = state == 3 ? 4 : state; /* rounded up to the sizes the kernels are made for */
    s->table_blocks = table == 2 ? 3 : table;
    s->block = trk_new(s->context, deal(s), sizeof *s->block);
    s->all_pieces = trk_new(s->context, count_pieces(model), sizeof *s->all_pieces);
    if (!s->block || !s->all_pieces)
        return TRK_E_MEMORY;
    deal(s);
    trk_status status = trk_modal_basis(s->context, model, s->phi, s->inverse, s->kappa);
    if (status == TRK_OK)
        fill(s, model);
    return status;
}

trk_status trk_explicit_create(trk_context *context, const trk_model *model, double h,
                               trk_explicit **out)
{
    *out = NULL;
    if (!is_fit(model))
        return TRK_OK;
    trk_explicit *s = trk_new(context, 1, sizeof *s);
    if (!s)
        return TRK_E_MEMORY;
    s->context = context;
    s->h = h;
    trk_status status = form(s, model);
    if (status == TRK_OK) {
        *out = s;
        return TRK_OK;
    }
    trk_explicit_destroy(s);
    return status == TRK_E_SINGULAR ? TRK_OK : status; /* no modes: the general path does it */
}

void trk_explicit_destroy(trk_explicit *s)
{
    if (!s)
        return;
    trk_free(s->context, s->block);
    trk_free(s->context, s->all_pieces);
    trk_free(s->context, s);
}
