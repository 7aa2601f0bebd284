/* SPDX-License-Identifier: MIT */
/* Sensor sums over blocks of steps: every kernel against the plain sum, any count of steps. */
#include "support.h"

#include "base/processor.h"
#include "simulate/sensors.h"

#include <math.h>
#include <string.h>

enum { SENSORS = 7, WIDTH = 24, ROADS = 3, MOST = TRK_SENSORS_BLOCK };

typedef struct fixture {
    double on_row[SENSORS * WIDTH], on_height[SENSORS * ROADS], on_velocity[SENSORS * ROADS];
    _Alignas(64) double rows[MOST * WIDTH];
    double height[MOST * ROADS], velocity[MOST * ROADS];
} fixture;

/* Every third number is zero, as in real sensors. */
static void fill(double *x, int64_t count, uint32_t *seed)
{
    for (int64_t k = 0; k < count; k++) {
        *seed = *seed * 1664525u + 1013904223u;
        x[k] = k % 3 == 2 ? 0 : (double)(int32_t)*seed / 1e9;
    }
}

static void fill_all(fixture *f)
{
    uint32_t seed = 1;
    fill(f->on_row, SENSORS * WIDTH, &seed);
    fill(f->on_height, SENSORS * ROADS, &seed);
    fill(f->on_velocity, SENSORS * ROADS, &seed);
    fill(f->rows, MOST * WIDTH, &seed);
    fill(f->height, MOST * ROADS, &seed);
    fill(f->velocity, MOST * ROADS, &seed);
}

static double plain(const fixture *f, int64_t sensor, int64_t step)
{
    double sum = 0;
    for (int64_t k = 0; k < WIDTH; k++)
        sum += f->on_row[sensor * WIDTH + k] * f->rows[step * WIDTH + k];
    for (int64_t k = 0; k < ROADS; k++)
        sum += f->on_height[sensor * ROADS + k] * f->height[step * ROADS + k] +
               f->on_velocity[sensor * ROADS + k] * f->velocity[step * ROADS + k];
    return sum;
}

static void reads_what_a_plain_sum_reads(void **state)
{
    static fixture f;
    trk_sensors *sensors;
    fill_all(&f);
    assert_ok(*state, trk_sensors_create(*state, SENSORS, WIDTH, ROADS, f.on_row, f.on_height,
                                         f.on_velocity, &sensors));
    const int64_t counts[] = {1, 2, 3, 7, 8, 31, 32, 33, 255, 256};
    for (size_t c = 0; c < sizeof counts / sizeof *counts; c++) {
        double values[SENSORS][MOST + 2], *channel[SENSORS];
        for (int k = 0; k < SENSORS; k++) {
            channel[k] = values[k];
            for (int j = 0; j < MOST + 2; j++)
                values[k][j] = 4711;
        }
        trk_sensors_read(sensors, counts[c], 1, f.rows, f.height, f.velocity, channel, 1);
        for (int k = 0; k < SENSORS; k++) {
            assert_near(values[k][0], 4711, 0); /* nothing before, nothing behind */
            assert_near(values[k][counts[c] + 1], 4711, 0);
            for (int64_t j = 0; j < counts[c]; j++)
                assert_near(values[k][j + 1], plain(&f, k, j), 1e-14);
        }
    }
    trk_sensors_destroy(sensors);
}

static void skips_steps_that_are_not_recorded(void **state)
{
    static fixture f;
    trk_sensors *sensors;
    fill_all(&f);
    assert_ok(*state, trk_sensors_create(*state, SENSORS, WIDTH, ROADS, f.on_row, f.on_height,
                                         f.on_velocity, &sensors));
    double values[SENSORS][MOST], *channel[SENSORS];
    for (int k = 0; k < SENSORS; k++)
        channel[k] = values[k];
    trk_sensors_read(sensors, MOST / 5, 5, f.rows + 2 * WIDTH, f.height + 2 * ROADS,
                     f.velocity + 2 * ROADS, channel, 3);
    for (int k = 0; k < SENSORS; k++)
        for (int j = 0; j < MOST / 5; j++)
            assert_near(values[k][3 + j], plain(&f, k, 2 + 5 * j), 1e-14);
    trk_sensors_destroy(sensors);
}

static void kernels_agree(void **state)
{
    static fixture f;
    trk_sensors *sensors;
    fill_all(&f);
    assert_ok(*state, trk_sensors_create(*state, SENSORS, WIDTH, ROADS, f.on_row, f.on_height,
                                         f.on_velocity, &sensors));
    double values[SENSORS][MOST], *channel[SENSORS];
    _Alignas(64) double other[MOST];
    for (int k = 0; k < SENSORS; k++)
        channel[k] = values[k];
    trk_sensors_read(sensors, MOST, 1, f.rows, f.height, f.velocity, channel, 0);
    trk_sensor_kernel kernels[3] = {trk_sensor_kernel_base};
#ifdef TRK_X86_KERNELS
    if (trk_processor() >= TRK_PROCESSOR_AVX2)
        kernels[1] = trk_sensor_kernel_avx2;
    if (trk_processor() >= TRK_PROCESSOR_AVX512)
        kernels[2] = trk_sensor_kernel_avx512;
#endif
    for (int way = 0; way < 6 && kernels[way / 2]; way++)
        for (int k = 0; k < SENSORS; k++) {
            kernels[way / 2](&sensors->sums[k], sensors->block, MOST, way % 2, other);
            for (int j = 0; j < MOST; j++)
                assert_near(other[j], values[k][j], 1e-14);
        }
    trk_sensors_destroy(sensors);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(reads_what_a_plain_sum_reads, support_setup,
                                        support_teardown),
        cmocka_unit_test_setup_teardown(skips_steps_that_are_not_recorded, support_setup,
                                        support_teardown),
        cmocka_unit_test_setup_teardown(kernels_agree, support_setup, support_teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
