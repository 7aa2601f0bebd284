/* SPDX-License-Identifier: MIT */
/* Needs LAPACK. Frequency response of the 3D truck: reciprocity, delays, static limits, modes. */
#include "models.h"

#include <complex.h>

enum { SENSORS = 64 };

static double complex response_of(double (*y)[2], int32_t sensor)
{
    return y[sensor - 1][0] + I * y[sensor - 1][1];
}

/* A port and a displacement sensor at the same place, both called `name`. */
static void add_place(trk_context *context, trk_spec *spec, const char *name, const char *body,
                      trk_motion motion, const double *point, const double *direction)
{
    trk_port_options port;
    trk_sensor_options sensor;
    trk_port_options_init(&port, sizeof port);
    trk_sensor_options_init(&sensor, sizeof sensor);
    port.body = sensor.body = trk_spec_find(spec, TRK_PART_BODY, body);
    port.motion = sensor.motion = motion;
    sensor.quantity = TRK_QUANTITY_DISPLACEMENT;
    memcpy(port.point, point, sizeof port.point);
    memcpy(sensor.point, point, sizeof port.point);
    memcpy(port.direction, direction, sizeof port.direction);
    memcpy(sensor.direction, direction, sizeof port.direction);
    assert_ok(context, trk_spec_add_port(spec, name, &port, NULL));
    assert_ok(context, trk_spec_add_sensor(spec, name, &sensor, NULL));
}

static trk_model *truck_with_places(trk_context *context)
{
    trk_spec *spec;
    assert_ok(context, trk_vehicle_create_builtin(context, TRK_VEHICLE_REFERENCE_TRUCK,
                                                  TRK_VARIANT_LINEAR, &spec));
    add_place(context, spec, "roof", "cab", TRK_MOTION_TRANSLATION, (double[]){0.2, 0.9, 2.8},
              (double[]){1, -2, 0.5});
    add_place(context, spec, "hub", "rear_axle", TRK_MOTION_TRANSLATION, (double[]){-4.5, -1, 0},
              (double[]){0, 0, 1});
    add_place(context, spec, "twist", "frame", TRK_MOTION_ROTATION, (double[]){0, 0, 0},
              (double[]){1, 1, 0});
    return compile(context, spec);
}

/* The dynamic stiffness is symmetric: what A does at B, B does at A; moments and angles too. */
static void reciprocity(void **state)
{
    trk_context *context = *state;
    trk_model *model = truck_with_places(context);
    const char *const places[] = {"roof", "hub", "twist"};
    const double frequency[] = {0, 0.7, 2.3, 7.1, 25};
    for (int f = 0; f < 5; f++) {
        double complex receptance[3][3];
        for (int a = 0; a < 3; a++) {
            double load[8] = {0}, y[SENSORS][2];
            load[trk_model_find(model, TRK_PART_PORT, places[a]) - 1] = 1;
            assert_ok(context, trk_frequency_response(context, model, NULL, NULL, 1, &frequency[f],
                                                      NULL, NULL, load, &y[0][0]));
            for (int b = 0; b < 3; b++)
                receptance[a][b] =
                    response_of(y, trk_model_find(model, TRK_PART_SENSOR, places[b]));
        }
        for (int a = 0; a < 3; a++)
            for (int b = 0; b < a; b++) {
                double size = sqrt(cabs(receptance[a][a]) * cabs(receptance[b][b]));
                assert_near(cabs(receptance[a][b] - receptance[b][a]), 0, 1e-12 * size);
                assert_true(cabs(receptance[a][b]) > 1e-6 * size); /* not merely both zero */
            }
    }
    trk_model_destroy(model);
}

/* Each road alone, turned by its own delay, adds up to all of them together. */
static void delays(void **state)
{
    trk_context *context = *state;
    trk_model *model = truck_with_places(context);
    const double gain[] = {1, 0.8, -0.4, 0.5}, delay[] = {0, 0.01, 0.2, -0.21}, f = 3.3;
    int sensors = trk_model_count(model, TRK_PART_SENSOR);
    double together[SENSORS][2], alone[SENSORS][2];
    double complex sum[SENSORS] = {0};
    assert_ok(context, trk_frequency_response(context, model, NULL, NULL, 1, &f, gain, delay, NULL,
                                              &together[0][0]));
    for (int road = 0; road < 4; road++) {
        double one[4] = {0};
        one[road] = gain[road];
        assert_ok(context, trk_frequency_response(context, model, NULL, NULL, 1, &f, one, NULL,
                                                  NULL, &alone[0][0]));
        for (int k = 0; k < sensors; k++)
            sum[k] += response_of(alone, k + 1) * cexp(-I * two_pi * f * delay[road]);
    }
    for (int k = 0; k < sensors; k++)
        assert_near(cabs(response_of(together, k + 1) - sum[k]), 0, 1e-12 * (1 + cabs(sum[k])));
    trk_model_destroy(model);
}

/* Lifted on all wheels, everything rises by the same height and no tire is loaded. */
static void static_limit(void **state)
{
    trk_context *context = *state;
    trk_model *model = truck_with_places(context);
    const double gain[] = {1, 1, 1, 1}, f = 0;
    double y[SENSORS][2];
    assert_ok(context, trk_frequency_response(context, model, NULL, NULL, 1, &f, gain, NULL, NULL,
                                              &y[0][0]));
    assert_near(cabs(response_of(y, trk_model_find(model, TRK_PART_SENSOR, "hub")) - 1), 0, 1e-12);
    assert_near(
        cabs(response_of(y, trk_model_find(model, TRK_PART_SENSOR, "roof")) - 0.5 / sqrt(5.25)), 0,
        1e-12);
    assert_near(cabs(response_of(y, trk_model_find(model, TRK_PART_SENSOR, "twist"))), 0, 1e-12);
    assert_near(
        cabs(response_of(y, trk_model_find(model, TRK_PART_SENSOR, "rear_left_tire_force"))), 0,
        1e-12 * 817500);
    assert_near(cabs(response_of(y, trk_model_find(model, TRK_PART_SENSOR, "cab_front_left_z"))), 0,
                0);
    trk_model_destroy(model);
}

/* Without damping: H = sum of phi_a phi_b / (w_j^2 - w^2) over the modes. */
static void sum_of_modes(void **state)
{
    trk_context *context = *state;
    trk_truck_parameters p;
    trk_truck_parameters_init(&p, sizeof p);
    memset(p.damping, 0, sizeof p.damping);
    memset(p.tire_damping, 0, sizeof p.tire_damping);
    memset(p.cab_vertical_damping, 0, sizeof p.cab_vertical_damping);
    memset(p.cab_longitudinal_damping, 0, sizeof p.cab_longitudinal_damping);
    memset(p.cab_lateral_damping, 0, sizeof p.cab_lateral_damping);
    trk_spec *spec;
    assert_ok(context, trk_vehicle_create_truck(context, &p, &spec));
    const double place[] = {0.2, 0.9, 2.8}, up[] = {0, 0, 1};
    add_place(context, spec, "roof", "cab", TRK_MOTION_TRANSLATION, place, up);
    trk_model *model = compile(context, spec);
    trk_modes *modes;
    assert_ok(context, trk_modes_create_undamped(context, model, NULL, &modes));
    int32_t port = trk_model_find(model, TRK_PART_PORT, "fifth_wheel_z");
    int32_t sensor = trk_model_find(model, TRK_PART_SENSOR, "roof");
    double at_port[13], at_sensor[13], phi[13], load[8] = {0}, y[SENSORS][2];
    assert_ok(context, trk_model_get_row(model, TRK_PART_PORT, port, at_port));
    assert_ok(context, trk_model_get_row(model, TRK_PART_SENSOR, sensor, at_sensor));
    load[port - 1] = 1;
    for (double f = 0.1; f < 30; f *= 1.7) {
        double sum = 0, size = 0;
        for (int j = 1; j <= 13; j++) {
            double a = 0, b = 0, w = two_pi * trk_modes_frequency(modes, j);
            assert_ok(context, trk_modes_get_shape(modes, j, phi, NULL));
            for (int i = 0; i < 13; i++) {
                a += at_port[i] * phi[i];
                b += at_sensor[i] * phi[i];
            }
            sum += a * b / (w * w - two_pi * f * two_pi * f);
            size += fabs(a * b / (w * w - two_pi * f * two_pi * f));
        }
        assert_ok(context, trk_frequency_response(context, model, NULL, NULL, 1, &f, NULL, NULL,
                                                  load, &y[0][0]));
        assert_near(y[sensor - 1][0], sum, 1e-10 * size);
        assert_near(y[sensor - 1][1], 0, 0);
    }
    trk_modes_destroy(modes);
    trk_model_destroy(model);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(reciprocity, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(delays, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(static_limit, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(sum_of_modes, support_setup, support_teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
