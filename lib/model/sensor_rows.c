/* SPDX-License-Identifier: MIT */
/* Sensors as matrices on the raw state of a stepper. */
#include "model/sensor_rows.h"

#include <string.h>

/* out += factor * row, on the coordinates of the layout. */
static void add_row(const trk_row_layout *layout, const trk_rows *rows, int32_t n, int32_t row,
                    double factor, double *out)
{
    if (!layout->phi) {
        trk_rows_add(rows, row, factor, out);
        return;
    }
    for (int64_t k = rows->start[row]; k < rows->start[row + 1]; k++)
        for (int32_t i = 0; i < n; i++)
            out[i] += factor * rows->value[k] * layout->phi[(int64_t)rows->column[k] * n + i];
}

/* Of one sensor. */
typedef struct sensor_row {
    double *on_row, *on_height, *on_velocity;
} sensor_row;

/* factor * elongation of a link */
static void add_elongation(const trk_model *model, const trk_row_layout *layout, int32_t link,
                           double factor, const sensor_row *out)
{
    add_row(layout, &model->links, model->n, link, factor, out->on_row);
    trk_rows_add(&model->roads, link, -factor, out->on_height);
}

/* factor * rate of a link */
static void add_rate(const trk_model *model, const trk_row_layout *layout, int32_t link,
                     double factor, const sensor_row *out)
{
    add_row(layout, &model->links, model->n, link, factor, out->on_row + layout->part);
    trk_rows_add(&model->roads, link, -factor, out->on_velocity);
}

/* Force of a link: k e + c e' + g (LAW.1). */
static void add_force(const trk_model *model, const trk_row_layout *layout, int32_t link,
                      const sensor_row *out)
{
    add_elongation(model, layout, link, model->laws[link].stiffness, out);
    add_rate(model, layout, link, model->laws[link].damping, out);
    if (layout->spring[link] >= 0)
        out->on_row[layout->spring[link]] += 1;
    if (layout->damper[link] >= 0)
        out->on_row[layout->damper[link]] += 1;
}

void trk_model_get_sensor_rows(const trk_model *model, const trk_row_layout *layout,
                               double *out_on_row, double *out_on_height, double *out_on_velocity)
{
    const trk_rows *rows = &model->sensors;
    int64_t sensors = rows->count, roads = model->names[TRK_PART_ROAD].count;
    memset(out_on_row, 0, (size_t)(sensors * layout->width) * sizeof(double));
    memset(out_on_height, 0, (size_t)(sensors * roads) * sizeof(double));
    memset(out_on_velocity, 0, (size_t)(sensors * roads) * sizeof(double));
    for (int32_t k = 0; k < sensors; k++) {
        const sensor_row out = {out_on_row + k * layout->width, out_on_height + k * roads,
                                out_on_velocity + k * roads};
        int32_t link = model->sensor_link[k];
        int64_t part = layout->part;
        switch (model->sensor_quantity[k]) {
        case TRK_QUANTITY_DISPLACEMENT: add_row(layout, rows, model->n, k, 1, out.on_row); break;
        case TRK_QUANTITY_VELOCITY: add_row(layout, rows, model->n, k, 1, out.on_row + part); break;
        case TRK_QUANTITY_ACCELERATION:
            add_row(layout, rows, model->n, k, 1, out.on_row + 2 * part);
            break;
        case TRK_QUANTITY_ELONGATION: add_elongation(model, layout, link, 1, &out); break;
        case TRK_QUANTITY_RATE: add_rate(model, layout, link, 1, &out); break;
        default: add_force(model, layout, link, &out); break;
        }
    }
}
