/* SPDX-License-Identifier: MIT */
/* The raw state as a row of numbers, and the sensors as matrices on it. */
#include "newmark/newmark.h"

#include <string.h>

static int64_t pad(int64_t count)
{
    return (count + TRK_FAST_PADDING - 1) / TRK_FAST_PADDING * TRK_FAST_PADDING;
}

int64_t trk_newmark_row_width(const trk_newmark *stepper)
{
    const trk_fast *s = stepper->fast;
    return 3 * pad(stepper->model->n) + (s ? s->layers * pad(s->rows) : pad(stepper->p));
}

/* Place of table forces of a link in a row: the spring's, the damper's; -1: none. */
static void find_forces(const trk_newmark *stepper, int32_t nonlinear, int64_t *out_spring,
                        int64_t *out_damper)
{
    const trk_fast *s = stepper->fast;
    int64_t first = 3 * pad(stepper->model->n);
    *out_spring = s ? -1 : first + nonlinear;
    *out_damper = -1;
    for (int32_t l = 0; s && l < s->layers; l++) {
        const struct trk_fast_table *t = &s->layer[l].table[s->lane[nonlinear]];
        if (t->curve && t->nonlinear == nonlinear)
            *(l < s->springs ? out_spring : out_damper) =
                first + l * pad(s->rows) + s->lane[nonlinear];
    }
}

/* Forces of the curves at stepper->now, which is settled. */
static void put_forces(const trk_newmark *stepper, double *row)
{
    const trk_model *model = stepper->model;
    for (int32_t j = 0; j < stepper->p; j++) {
        int64_t spring, damper;
        int32_t link = model->nonlinear[j];
        const trk_link_law *law = &model->laws[link];
        find_forces(stepper, j, &spring, &damper);
        double whole = stepper->now.force[j], of_damper = 0;
        if (spring >= 0 && damper >= 0) {
            of_damper =
                law->damper_scale *
                trk_curve_value(law->damper, trk_newmark_rate(stepper, &stepper->now, link));
            row[damper] = of_damper;
            row[spring] = whole - of_damper;
        } else {
            row[spring >= 0 ? spring : damper] = whole;
        }
    }
}

void trk_newmark_get_row(const trk_newmark *stepper, double *out_row)
{
    int64_t n = stepper->model->n, part = pad(n);
    double *q = out_row, *v = out_row + part, *a = out_row + 2 * part;
    trk_fast_settle(stepper);
    memset(out_row, 0, (size_t)trk_newmark_row_width(stepper) * sizeof *out_row);
    put_forces(stepper, out_row);
    if (stepper->fast) {
        trk_fast_get_motion(stepper->fast, q, v, a);
        return;
    }
    memcpy(q, stepper->now.q, (size_t)n * sizeof *q);
    memcpy(v, stepper->now.v, (size_t)n * sizeof *v);
    memcpy(a, stepper->now.a, (size_t)n * sizeof *a);
}

/* out[0 .. n - 1] += factor row, on the coordinates of the stepper. */
static void add_row(const trk_newmark *stepper, const trk_rows *rows, int32_t row, double factor,
                    double *out)
{
    int32_t n = stepper->model->n;
    if (!stepper->fast) {
        trk_rows_add(rows, row, factor, out);
        return;
    }
    const double *phi = stepper->fast->form->phi;
    for (int64_t k = rows->start[row]; k < rows->start[row + 1]; k++)
        for (int32_t i = 0; i < n; i++)
            out[i] += factor * rows->value[k] * phi[rows->column[k] * n + i];
}

/* Force of a link: k e + c e' + g. */
static void add_force(const trk_newmark *stepper, int32_t link, double *on_row, double *on_height,
                      double *on_velocity)
{
    const trk_model *model = stepper->model;
    const trk_link_law *law = &model->laws[link];
    add_row(stepper, &model->links, link, law->stiffness, on_row);
    add_row(stepper, &model->links, link, law->damping, on_row + pad(model->n));
    trk_rows_add(&model->roads, link, -law->stiffness, on_height);
    trk_rows_add(&model->roads, link, -law->damping, on_velocity);
    if (stepper->nonlinear_index[link] >= 0) {
        int64_t spring, damper;
        find_forces(stepper, stepper->nonlinear_index[link], &spring, &damper);
        if (spring >= 0)
            on_row[spring] += 1;
        if (damper >= 0)
            on_row[damper] += 1;
    }
}

void trk_newmark_get_sensor_rows(const trk_newmark *stepper, double *out_on_row,
                                 double *out_on_height, double *out_on_velocity)
{
    const trk_model *model = stepper->model;
    int64_t width = trk_newmark_row_width(stepper), part = pad(model->n),
            roads = model->names[TRK_PART_ROAD].count, sensors = model->sensors.count;
    memset(out_on_row, 0, (size_t)(sensors * width) * sizeof(double));
    memset(out_on_height, 0, (size_t)(sensors * roads) * sizeof(double));
    memset(out_on_velocity, 0, (size_t)(sensors * roads) * sizeof(double));
    for (int32_t k = 0; k < sensors; k++) {
        double *row = out_on_row + k * width, *height = out_on_height + k * roads,
               *velocity = out_on_velocity + k * roads;
        int32_t link = model->sensor_link[k];
        switch (model->sensor_quantity[k]) {
        case TRK_QUANTITY_DISPLACEMENT: add_row(stepper, &model->sensors, k, 1, row); break;
        case TRK_QUANTITY_VELOCITY: add_row(stepper, &model->sensors, k, 1, row + part); break;
        case TRK_QUANTITY_ACCELERATION:
            add_row(stepper, &model->sensors, k, 1, row + 2 * part);
            break;
        case TRK_QUANTITY_ELONGATION:
            add_row(stepper, &model->links, link, 1, row);
            trk_rows_add(&model->roads, link, -1, height);
            break;
        case TRK_QUANTITY_RATE:
            add_row(stepper, &model->links, link, 1, row + part);
            trk_rows_add(&model->roads, link, -1, velocity);
            break;
        default: add_force(stepper, link, row, height, velocity); break;
        }
    }
}
