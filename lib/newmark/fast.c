/* SPDX-License-Identifier: MIT */
/* Memory and layout of the step in modal coordinates: from the form to packed columns. */
#include "newmark/newmark.h"

#include "curve/curve.h"

#include <math.h>
#include <string.h>

/* More than these are a case for the general path. */
enum { MOST_CORRECTIONS = 8 };

static int64_t pad(int64_t count)
{
    return (count + TRK_FAST_PADDING - 1) / TRK_FAST_PADDING * TRK_FAST_PADDING;
}

static int32_t larger(int32_t a, int32_t b)
{
    return a > b ? a : b;
}

static bool equal_rows(const trk_modal_form *f, const trk_rows *rows, int32_t i, int32_t j)
{
    int32_t a = f->table[i].link, b = f->table[j].link;
    int64_t count = rows->start[a + 1] - rows->start[a];
    if (count != rows->start[b + 1] - rows->start[b])
        return false;
    size_t bytes = (size_t)count;
    return memcmp(rows->column + rows->start[a], rows->column + rows->start[b],
                  bytes * sizeof *rows->column) == 0 &&
           memcmp(rows->value + rows->start[a], rows->value + rows->start[b],
                  bytes * sizeof *rows->value) == 0;
}

/* Links at one place, as spring, bump stop and damper of a wheel, have one row: they share a
 * lane. false: more rows than lanes. */
static bool assign_lanes(trk_fast *s, const trk_model *model)
{
    for (int32_t j = 0; j < s->form->tables; j++) {
        int32_t row = 0;
        while (row < s->rows && !(equal_rows(s->form, &model->links, s->first[row], j) &&
                                  equal_rows(s->form, &model->roads, s->first[row], j)))
            row++;
        if (row == TRK_FAST_ROWS || j == TRK_FAST_ROWS * TRK_FAST_LAYERS)
            return false;
        if (row == s->rows)
            s->first[s->rows++] = j;
        s->lane[j] = row;
    }
    return true;
}

/* Layers of spring curves: the most on one row. */
static bool count_springs(trk_fast *s)
{
    int32_t count[TRK_FAST_ROWS] = {0};
    for (int32_t j = 0; j < s->form->tables; j++) {
        int32_t lane = s->lane[j];
        count[lane] += s->form->table[j].law->spring != NULL;
        s->springs = count[lane] > s->springs ? count[lane] : s->springs;
    }
    return s->springs <= TRK_FAST_LAYERS;
}

/* Put a curve into the first layer of its kind where its lane is free. */
static bool add_table(trk_fast *s, int32_t lane, const struct trk_fast_table *table, bool of_rate)
{
    int32_t first = of_rate ? s->springs : 0, last = of_rate ? TRK_FAST_LAYERS : s->springs;
    for (int32_t l = first; l < last; l++)
        if (!s->layer[l].table[lane].curve) {
            s->layer[l].table[lane] = *table;
            s->layers = l + 1 > s->layers ? l + 1 : s->layers;
            return true;
        }
    return false;
}

/* All curves of one kind; the weight at rest goes with the first curve of a link. */
static bool add_tables(trk_fast *s, bool of_rate)
{
    for (int32_t j = 0; j < s->form->tables; j++) {
        const trk_link_law *law = s->form->table[j].law;
        struct trk_fast_table table = {.nonlinear = j};
        if (of_rate) {
            table.curve = law->damper;
            table.scale = law->damper_scale;
            table.rest = law->spring ? 0 : law->rest;
        } else {
            table.curve = law->spring;
            table.scale = law->spring_scale;
            table.offset = law->spring_offset;
            table.rest = law->rest;
        }
        if (table.curve && !add_table(s, s->lane[j], &table, of_rate))
            return false;
    }
    return true;
}

/* All arrays of doubles, in one block; counting first (block NULL), then dealing out. */
static int64_t deal(trk_fast *s)
{
    int64_t modes = s->mode_lanes, rows = s->row_lanes, used = 0;
    struct {
        double **array;
        int64_t size;
    } arrays[] = {{&s->to_rows, rows * s->modes},
                  {&s->to_modes, modes * s->modes},
                  {&s->elongation, rows * s->modes},
                  {&s->coupling, rows * rows},
                  {&s->diagonal, rows},
                  {&s->influence, modes * rows},
                  {&s->height_drive, modes * s->roads},
                  {&s->velocity_drive, modes * s->roads},
                  {&s->load_drive, modes * s->ports},
                  {&s->ratio, pad(s->roads)},
                  {&s->road_rows, rows * s->roads},
                  {&s->weight, modes},
                  {&s->restoring, modes},
                  {&s->curvature, rows},
                  {&s->reach, rows},
                  {&s->v1, modes},
                  {&s->v, modes},
                  {&s->z, modes},
                  {&s->old_v, modes},
                  {&s->old_z, modes},
                  {&s->free, modes},
                  {&s->past[0], rows},
                  {&s->past[1], rows},
                  {&s->past[2], rows},
                  {&s->past[3], rows},
                  {&s->past[4], rows},
                  {&s->past[5], rows},
                  {&s->force, rows},
                  {&s->work_modes, modes},
                  {&s->work_rows, rows},
                  {&s->worst, rows},
                  {&s->layer_value, rows * s->layers},
                  {&s->layer_slope, rows * s->layers},
                  {&s->moved, rows},
                  {&s->to_physical, modes * s->modes},
                  {&s->row, 3 * pad(s->modes) + s->layers * pad(s->rows) + pad(2 * s->roads)},
                  {&s->zeros, pad(s->roads + s->ports)}};
    for (size_t k = 0; k < sizeof arrays / sizeof *arrays; k++) {
        *arrays[k].array = s->block ? s->block + used : NULL;
        used += arrays[k].size;
    }
    for (int32_t l = 0; l < s->layers; l++) {
        trk_fast_layer *p = &s->layer[l];
        double **pieces[] = {&p->lower, &p->upper, &p->origin, &p->c0, &p->c1, &p->c2, &p->c3};
        for (size_t k = 0; k < sizeof pieces / sizeof *pieces; k++) {
            *pieces[k] = s->block ? s->block + used : NULL;
            used += rows;
        }
    }
    return used;
}

static bool lay_out(trk_fast *s, const trk_model *model)
{
    return assign_lanes(s, model) && count_springs(s) && add_tables(s, false) &&
           add_tables(s, true);
}

static bool fits(const trk_newmark *stepper)
{
    return trk_solver_backend(stepper->assembly.solver) == TRK_BACKEND_DENSE &&
           stepper->model->n <= TRK_FAST_MODES && trk_model_find_law(stepper->model) < 0;
}

static trk_status fill(trk_fast *s, const trk_newmark *stepper, bool *out_fits)
{
    const trk_model *model = stepper->model;
    trk_status status = trk_modal_form_create(s->context, model, &stepper->options, &s->form);
    *out_fits = s->form && lay_out(s, model);
    if (status != TRK_OK || !*out_fits)
        return status;
    const trk_modal_form *f = s->form;
    s->modes = f->n;
    s->roads = f->roads;
    s->ports = f->ports;
    s->r = f->r;
    s->inverse_kappa = 1 / f->kappa;
    double ahead = f->h * (0.5 - f->beta) / f->gamma; /* exact for average acceleration */
    s->c1 = 1 / f->gamma;
    s->c2 = 1 - s->c1;
    s->c3 = f->r + f->h + ahead - f->r * s->c1;
    s->c4 = -ahead - f->r * s->c2;
    s->tolerance = stepper->options.tolerance;
    s->floor = stepper->force_floor;
    s->most_corrections = stepper->options.max_iterations < MOST_CORRECTIONS
                              ? stepper->options.max_iterations
                              : MOST_CORRECTIONS;
    for (int32_t width = 2; width <= 8; width *= 2) {
        int32_t mode_blocks, row_blocks;
        trk_fast_choose_size(width, s->modes, s->rows, &mode_blocks, &row_blocks);
        s->mode_lanes = larger(s->mode_lanes, (int32_t)pad(mode_blocks * width));
        s->row_lanes = larger(s->row_lanes, (int32_t)pad(row_blocks * width));
    }
    s->size = deal(s);
    s->block = trk_new(s->context, s->size, sizeof *s->block);
    if (!s->block)
        return TRK_E_MEMORY;
    deal(s);
    return TRK_OK;
}

trk_status trk_fast_create(trk_newmark *stepper, trk_fast **out)
{
    *out = NULL;
    if (!fits(stepper))
        return TRK_OK;
    trk_fast *s = trk_new(stepper->context, 1, sizeof *s);
    if (!s)
        return TRK_E_MEMORY;
    bool is_small = false;
    s->context = stepper->context;
    trk_status status = fill(s, stepper, &is_small);
    if (status == TRK_OK && is_small)
        *out = s;
    else
        trk_fast_destroy(s);
    return status;
}

void trk_fast_destroy(trk_fast *fast)
{
    if (!fast)
        return;
    trk_modal_form_destroy(fast->form);
    trk_free(fast->context, fast->block);
    trk_free(fast->context, fast->sensor_end);
    trk_free(fast->context, fast->sensor_column);
    trk_free(fast->context, fast->sensor_factor);
    trk_free(fast->context, fast);
}
