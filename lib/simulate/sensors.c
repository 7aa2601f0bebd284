/* SPDX-License-Identifier: MIT */
/* Rows into columns, columns into channels. */
#include "simulate/sensors.h"

#include "base/processor.h"

static trk_sensor_kernel choose_kernel(void)
{
#ifdef TRK_X86_KERNELS
    if (trk_processor() == TRK_PROCESSOR_AVX512)
        return trk_sensor_kernel_avx512;
    if (trk_processor() == TRK_PROCESSOR_AVX2)
        return trk_sensor_kernel_avx2;
#endif
    return trk_sensor_kernel_base;
}

/* The non-zero entries of a row, appended to a sum whose columns begin at `first`. */
static void append(trk_sensor_sum *sum, double *coefficient, int32_t *column, const double *row,
                   int64_t length, int64_t first)
{
    for (int64_t k = 0; k < length; k++)
        if (row[k] != 0) {
            coefficient[sum->count] = row[k];
            column[sum->count++] = (int32_t)(first + k);
        }
}

trk_status trk_sensors_create(trk_context *context, int32_t sensors, int64_t width, int32_t roads,
                              const double *on_row, const double *on_height,
                              const double *on_velocity, trk_sensors **out)
{
    *out = NULL;
    int64_t columns = width + 2 * (int64_t)roads;
    trk_sensors *s = trk_new(context, 1, sizeof *s);
    if (!s)
        return TRK_E_MEMORY;
    *s = (trk_sensors){
        .context = context, .sensors = sensors, .roads = roads, .width = width, .road_rows = 1};
    s->sums = trk_new(context, sensors, sizeof *s->sums);
    s->coefficients = trk_new(context, sensors * columns, sizeof *s->coefficients);
    s->columns = trk_new(context, sensors * columns, sizeof *s->columns);
    s->block = trk_new(context, columns * TRK_SENSORS_STRIDE, sizeof *s->block);
    if (!s->sums || !s->coefficients || !s->columns || !s->block) {
        trk_sensors_destroy(s);
        return TRK_E_MEMORY;
    }
    for (int64_t k = 0; k < sensors; k++) {
        double *coefficient = s->coefficients + k * columns;
        int32_t *column = s->columns + k * columns;
        s->sums[k] = (trk_sensor_sum){0, coefficient, column};
        append(&s->sums[k], coefficient, column, on_row + k * width, width, 0);
        append(&s->sums[k], coefficient, column, on_height + k * roads, roads, width);
        append(&s->sums[k], coefficient, column, on_velocity + k * roads, roads, width + roads);
    }
    *out = s;
    return TRK_OK;
}

void trk_sensors_destroy(trk_sensors *sensors)
{
    if (!sensors)
        return;
    trk_free(sensors->context, sensors->sums);
    trk_free(sensors->context, sensors->coefficients);
    trk_free(sensors->context, sensors->columns);
    trk_free(sensors->context, sensors->block);
    trk_free(sensors->context, sensors);
}

typedef double pair __attribute__((vector_size(16), may_alias));

/*
 * Transpose rows of even width, a cache line of steps at a time and two by two; rows and block
 * are aligned. Steps past the last repeat it.
 */
static void transpose_pairs(const double *rows, int64_t stride, int64_t width, int64_t count,
                            double *block)
{
    for (int64_t first = 0; first < count; first += TRK_SENSORS_LANES)
        for (int64_t c = 0; c < width; c += 2)
            for (int64_t j = first; j < first + TRK_SENSORS_LANES; j += 2) {
                const double *row = rows + (j < count ? j : count - 1) * stride + c;
                pair a = *(const pair *)row,
                     b = *(const pair *)(j + 1 < count ? row + stride : row);
                double *even = block + c * TRK_SENSORS_STRIDE + j, *odd = even + TRK_SENSORS_STRIDE;
                *(pair *)even = (pair){a[0], b[0]};
                *(pair *)odd = (pair){a[1], b[1]};
            }
}

static void transpose(const double *rows, int64_t stride, int64_t width, int64_t count,
                      double *block)
{
    for (int64_t c = 0; c < width; c++)
        for (int64_t j = 0; j < count; j++)
            block[c * TRK_SENSORS_STRIDE + j] = rows[j * stride + c];
}

void trk_sensors_read(trk_sensors *sensors, int64_t count, int64_t every, const double *rows,
                      const double *height, const double *velocity, double *const *channel,
                      int64_t at)
{
    trk_sensor_kernel kernel = choose_kernel();
    int64_t width = sensors->width, roads = sensors->roads;
    int64_t road_stride = every * sensors->road_rows * roads;
    double *on_road = sensors->block + width * TRK_SENSORS_STRIDE;
    transpose_pairs(rows, every * width, width, count, sensors->block);
    transpose(height, road_stride, roads, count, on_road);
    transpose(velocity, road_stride, roads, count, on_road + roads * TRK_SENSORS_STRIDE);
    for (int32_t k = 0; k < sensors->sensors; k++)
        kernel(&sensors->sums[k], sensors->block, count, sensors->stream, channel[k] + at);
}
