/* SPDX-License-Identifier: MIT */
/* The raw state as a row of numbers, and the sensors as matrices on it. */
#include "rungekutta/rungekutta.h"

#include "model/sensor_rows.h"

#include <string.h>

static int64_t pad(int64_t count)
{
    return (count + TRK_EXPLICIT_LANES - 1) / TRK_EXPLICIT_LANES * TRK_EXPLICIT_LANES;
}

int64_t trk_rungekutta_row_width(const trk_rungekutta *stepper)
{
    const trk_model *model = stepper->model;
    return stepper->modal ? trk_explicit_width(stepper->modal)
                          : 3 * pad(model->n) + pad(model->nonlinear_count);
}

void trk_rungekutta_get_row(const trk_rungekutta *stepper, double *out_row)
{
    const trk_model *model = stepper->model;
    int64_t n = model->n, part = pad(n);
    memset(out_row, 0, (size_t)trk_rungekutta_row_width(stepper) * sizeof *out_row);
    if (stepper->modal) {
        memcpy(out_row, stepper->modal->row,
               (size_t)trk_explicit_width(stepper->modal) * sizeof *out_row);
        return;
    }
    memcpy(out_row, stepper->q, (size_t)n * sizeof *out_row);
    memcpy(out_row + part, stepper->v, (size_t)n * sizeof *out_row);
    memcpy(out_row + 2 * part, stepper->a, (size_t)n * sizeof *out_row);
    for (int32_t j = 0; j < model->nonlinear_count; j++)
        out_row[3 * part + j] = trk_rungekutta_curve_force(stepper, model->nonlinear[j]);
}

void trk_rungekutta_get_sensor_rows(const trk_rungekutta *stepper, double *out_on_row,
                                    double *out_on_height, double *out_on_velocity)
{
    const trk_model *model = stepper->model;
    const trk_explicit *modal = stepper->modal;
    int32_t *spring = stepper->spring_column, *damper = stepper->damper_column;
    const trk_row_layout layout = {trk_rungekutta_row_width(stepper),
                                   modal ? trk_explicit_part(modal) : pad(model->n),
                                   modal ? modal->phi : NULL, spring, damper};
    int32_t first = (int32_t)(3 * layout.part);
    for (int32_t k = 0; k < model->links.count; k++)
        spring[k] = damper[k] = -1;
    for (int32_t k = 0; modal && k < modal->tables; k++)
        (modal->table[k].of_rate ? damper : spring)[modal->table[k].link] = first + k;
    for (int32_t j = 0; !modal && j < model->nonlinear_count; j++)
        spring[model->nonlinear[j]] = first + j;
    trk_model_get_sensor_rows(model, &layout, out_on_row, out_on_height, out_on_velocity);
}
