/* SPDX-License-Identifier: MIT */
/*
 * Sensors as matrices on the raw state of a stepper and on the road:
 *
 *     sensor = on_row . row + on_height . u + on_velocity . u'
 *
 * with row = (y, y', y'', forces of curves), each part padded, where q = Phi y.
 */
#ifndef TRK_MODEL_SENSOR_ROWS_H
#define TRK_MODEL_SENSOR_ROWS_H

#include "model/model.h"

/* What a row holds, and where. */
typedef struct trk_row_layout {
    int64_t width, part; /* of a row; of y, y' and y'' in it            */
    const double *phi;   /* n x n row-major; NULL: y = q                */
    /* By link: column of the force of its spring curve and of its damper curve, -1: none. A
     * force g that is one number for both curves stands in the first. */
    const int32_t *spring, *damper;
} trk_row_layout;

/* on_row is sensors x width, the others are sensors x roads; all row-major. */
void trk_model_get_sensor_rows(const trk_model *model, const trk_row_layout *layout,
                               double *out_on_row, double *out_on_height, double *out_on_velocity);

#endif
