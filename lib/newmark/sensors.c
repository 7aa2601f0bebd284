/* SPDX-License-Identifier: MIT */
/* Sensors read straight from the raw state of the last step, four at a time. */
#include "newmark/newmark.h"

#include <string.h>

enum { TOGETHER = TRK_FAST_SENSORS };

typedef double pair __attribute__((vector_size(16)));

/* Columns of the row that some sensor of a group reads; coefficients of all of the group, out
 * NULL to count only. */
static int64_t pack_group(const double *dense, int64_t columns, int32_t sensors, int32_t first,
                          int32_t *column, double *factor)
{
    int64_t count = 0;
    for (int64_t k = 0; k < columns; k++) {
        double of[TOGETHER] = {0};
        bool is_read = false;
        for (int32_t l = 0; l < TOGETHER && first + l < sensors; l++) {
            of[l] = dense[(first + l) * columns + k];
            is_read |= of[l] != 0;
        }
        if (is_read && column) {
            column[count] = (int32_t)k;
            memcpy(factor + TOGETHER * count, of, sizeof of);
        }
        count += is_read;
    }
    return count;
}

/* The matrices of trk_newmark_get_sensor_rows() side by side, a sensor a row. */
static double *dense_rows(const trk_newmark *stepper, int64_t columns)
{
    int64_t sensors = stepper->model->sensors.count, roads = stepper->fast->roads,
            width = columns - 2 * roads;
    double *all = trk_new(stepper->context, 2 * sensors * columns, sizeof *all);
    if (!all)
        return NULL;
    double *row = all + sensors * columns, *height = row + sensors * width,
           *velocity = height + sensors * roads;
    trk_newmark_get_sensor_rows(stepper, row, height, velocity);
    for (int64_t k = 0; k < sensors; k++) {
        double *to = all + k * columns;
        memcpy(to, row + k * width, (size_t)width * sizeof *to);
        memcpy(to + width, height + k * roads, (size_t)roads * sizeof *to);
        memcpy(to + width + roads, velocity + k * roads, (size_t)roads * sizeof *to);
    }
    return all;
}

trk_status trk_fast_create_sensors(trk_newmark *stepper)
{
    trk_fast *s = stepper->fast;
    int32_t sensors = stepper->model->sensors.count;
    int64_t columns = trk_newmark_row_width(stepper) + 2 * s->roads, used = 0;
    double *dense = dense_rows(stepper, columns);
    if (!dense)
        return TRK_E_MEMORY;
    for (int32_t k = 0; k < sensors; k += TOGETHER)
        used += pack_group(dense, columns, sensors, k, NULL, NULL);
    s->sensor_end = trk_new(s->context, (sensors + TOGETHER - 1) / TOGETHER, sizeof *s->sensor_end);
    s->sensor_column = trk_new(s->context, used, sizeof *s->sensor_column);
    s->sensor_factor = trk_new(s->context, TOGETHER * used, sizeof *s->sensor_factor);
    bool is_whole = s->sensor_end && s->sensor_column && s->sensor_factor;
    used = 0;
    for (int32_t k = 0; is_whole && k < sensors; k += TOGETHER) {
        used += pack_group(dense, columns, sensors, k, s->sensor_column + used,
                           s->sensor_factor + TOGETHER * used);
        s->sensor_end[k / TOGETHER] = used;
    }
    trk_free(s->context, dense);
    return is_whole ? TRK_OK : TRK_E_MEMORY;
}

/* The row of record.c after a step of a kernel, and the road behind it. */
static void fill_row(const trk_newmark *stepper)
{
    const trk_fast *s = stepper->fast;
    const int64_t part = (s->modes + TRK_FAST_PADDING - 1) / TRK_FAST_PADDING * TRK_FAST_PADDING,
                  padded = (s->rows + TRK_FAST_PADDING - 1) / TRK_FAST_PADDING * TRK_FAST_PADDING;
    double *force = s->row + 3 * part, *road = s->row + trk_newmark_row_width(stepper);
    trk_fast_get_motion(s, s->row, s->row + part, s->row + 2 * part);
    for (int32_t k = 0; s->layers == 1 && k < s->rows; k++)
        force[k] = s->force[k];
    for (int32_t l = 0; s->layers > 1 && l < s->layers; l++) {
        const double *value = s->layer_value + l * s->row_stride,
                     *slope = s->layer_slope + l * s->row_stride;
        for (int32_t k = 0; k < s->rows; k++)
            force[l * padded + k] = value[k] + slope[k] * s->moved[k];
    }
    memcpy(road, stepper->now.height, (size_t)s->roads * sizeof *road);
    memcpy(road + s->roads, stepper->now.velocity, (size_t)s->roads * sizeof *road);
}

bool trk_fast_read_sensors(const trk_newmark *stepper, double *out_values)
{
    const trk_fast *s = stepper->fast;
    if (!s || !s->is_ahead)
        return false;
    int32_t sensors = stepper->model->sensors.count;
    const pair *factor = (const pair *)s->sensor_factor;
    fill_row(stepper);
    int64_t k = 0;
    for (int32_t first = 0; first < sensors; first += TOGETHER) {
        pair sum[TOGETHER / 2] = {{0}};
        for (const int64_t end = s->sensor_end[first / TOGETHER]; k < end; k++) {
            sum[0] += factor[2 * k] * s->row[s->sensor_column[k]];
            sum[1] += factor[2 * k + 1] * s->row[s->sensor_column[k]];
        }
        int32_t count = sensors - first < TOGETHER ? sensors - first : TOGETHER;
        memcpy(out_values + first, sum, (size_t)count * sizeof *out_values);
    }
    return true;
}
