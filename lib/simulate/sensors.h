/* SPDX-License-Identifier: MIT */
/*
 * Sensors of a run, a block of steps at a time. What a stepper records after each step is a row
 * of numbers (newmark.h); a block of rows is turned into columns, one a number, and each sensor
 * is then a sum of few columns, so that every loop runs along the steps.
 */
#ifndef TRK_SIMULATE_SENSORS_H
#define TRK_SIMULATE_SENSORS_H

#include "base/base.h"

enum {
    TRK_SENSORS_LANES = 8,   /* a row has a multiple of these, blocks are aligned to them */
    TRK_SENSORS_BLOCK = 256, /* steps in a block                                          */
    /* Between two columns; one of 256 would send all columns to the same few cache lines. */
    TRK_SENSORS_STRIDE = TRK_SENSORS_BLOCK + TRK_SENSORS_LANES
};

/* One sensor: sum of coefficient * column. */
typedef struct trk_sensor_sum {
    int32_t count;
    const double *coefficient;
    const int32_t *column;
} trk_sensor_sum;

typedef struct trk_sensors {
    trk_context *context;
    int32_t sensors, roads;
    int64_t width;        /* of a row                                             */
    int64_t road_rows;    /* of height and velocity a step, default 1             */
    bool stream;          /* the channels are longer than the caches, default no  */
    trk_sensor_sum *sums; /* sensors                                              */
    double *coefficients; /* of all sums                                          */
    int32_t *columns;     /* the same                                             */
    double *block;        /* (width + 2 roads) columns at TRK_SENSORS_STRIDE      */
} trk_sensors;

/*
 * on_row: sensors x width, on_height, on_velocity: sensors x roads; copied, without their zeros.
 */
trk_status trk_sensors_create(trk_context *context, int32_t sensors, int64_t width, int32_t roads,
                              const double *on_row, const double *on_height,
                              const double *on_velocity, trk_sensors **out);
void trk_sensors_destroy(trk_sensors *sensors);

/*
 * Samples at .. at + count - 1 of each channel from the rows 0, every, 2 every ... and height and
 * velocity of the same steps; rows of width, the others of roads numbers, road_rows of them a step.
 * count <= TRK_SENSORS_BLOCK.
 */
void trk_sensors_read(trk_sensors *sensors, int64_t count, int64_t every, const double *rows,
                      const double *height, const double *velocity, double *const *channel,
                      int64_t at);

/*
 * out[0 .. count - 1] of one sensor from the columns; one function a register width. `stream`:
 * where out is aligned, write it past the caches, which it would only pass through.
 */
typedef void (*trk_sensor_kernel)(const trk_sensor_sum *sum, const double *block, int64_t count,
                                  bool stream, double *out);
void trk_sensor_kernel_base(const trk_sensor_sum *sum, const double *block, int64_t count,
                            bool stream, double *out);
void trk_sensor_kernel_avx2(const trk_sensor_sum *sum, const double *block, int64_t count,
                            bool stream, double *out);
void trk_sensor_kernel_avx512(const trk_sensor_sum *sum, const double *block, int64_t count,
                              bool stream, double *out);

#endif
