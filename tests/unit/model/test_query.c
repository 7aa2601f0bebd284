/* SPDX-License-Identifier: MIT */
/* What a model tells about itself: names, units, places, rows, forces. */
#include "support.h"

#include <truckride/model.h>

/* A body with z, roll and yaw on a road, one sensor of each quantity, two ports. */
static trk_model *make(trk_context *context)
{
    trk_spec *spec;
    assert_ok(context, trk_spec_create(context, "trike", &spec));
    trk_body_options body;
    trk_body_options_init(&body, sizeof body);
    body.freedoms = TRK_FREE_YAW | TRK_FREE_Z | TRK_FREE_ROLL;
    body.mass = 10;
    body.inertia[0] = 2;
    body.inertia[2] = 3;
    assert_ok(context, trk_spec_add_body(spec, "body", &body, NULL));
    assert_ok(context, trk_spec_add_road(spec, "left", 1.5, -0.5, NULL));
    trk_link_options link;
    trk_link_options_init(&link, sizeof link);
    link.from_road = 1;
    link.to_body = 1;
    link.stiffness = 100;
    link.damping = 5;
    assert_ok(context, trk_spec_add_link(spec, "tire", &link, NULL));
    link.from_road = 0;
    link.motion = TRK_MOTION_ROTATION;
    link.direction[0] = 1;
    assert_ok(context, trk_spec_add_link(spec, "twist", &link, NULL));
    trk_sensor_options sensor;
    for (trk_quantity k = TRK_QUANTITY_DISPLACEMENT; k <= TRK_QUANTITY_FORCE; k++)
        for (int rotation = 0; rotation < 2; rotation++) {
            char name[32];
            snprintf(name, sizeof name, "s%d%d", k, rotation);
            trk_sensor_options_init(&sensor, sizeof sensor);
            sensor.quantity = k;
            sensor.body = 1;
            sensor.motion = rotation;
            sensor.link = 1 + rotation;
            assert_ok(context, trk_spec_add_sensor(spec, name, &sensor, NULL));
        }
    trk_port_options port;
    trk_port_options_init(&port, sizeof port);
    port.body = 1;
    port.point[1] = 2;
    assert_ok(context, trk_spec_add_port(spec, "push", &port, NULL));
    port.motion = TRK_MOTION_ROTATION;
    assert_ok(context, trk_spec_add_port(spec, "turn", &port, NULL));
    trk_model *model;
    assert_ok(context, trk_model_compile(context, spec, NULL, &model));
    trk_spec_destroy(spec);
    return model;
}

static void names_and_counts(void **state)
{
    static const char *const coordinates[] = {"body.z", "body.roll", "body.yaw"};
    trk_model *model = make(*state);
    assert_string_equal(trk_model_name(model), "trike");
    assert_int_equal(trk_model_count(model, TRK_PART_COORDINATE), 3);
    for (int32_t k = 1; k <= 3; k++) {
        assert_string_equal(trk_model_part_name(model, TRK_PART_COORDINATE, k), coordinates[k - 1]);
        assert_int_equal(trk_model_find(model, TRK_PART_COORDINATE, coordinates[k - 1]), k);
    }
    assert_int_equal(trk_model_count(model, TRK_PART_SENSOR), 12);
    assert_int_equal(trk_model_find(model, TRK_PART_LINK, "twist"), 2);
    assert_int_equal(trk_model_find(model, TRK_PART_LINK, "body"), 0);
    assert_null(trk_model_part_name(model, TRK_PART_LINK, 3));
    assert_int_equal(trk_model_count(model, 0), 0);
    assert_int_equal(trk_model_count(model, 8), 0);
    assert_near(trk_model_gravity(model), 0, 0);
    trk_model_destroy(model);
    trk_model_destroy(NULL);
}

static void units(void **state)
{
    static const char *const sensors[] = {"m", "rad", "m/s", "rad/s", "m/s^2", "rad/s^2",
                                          "m", "rad", "m/s", "rad/s", "N",     "N m"};
    trk_model *model = make(*state);
    for (int32_t k = 1; k <= 12; k++)
        assert_string_equal(trk_model_unit(model, TRK_PART_SENSOR, k), sensors[k - 1]);
    assert_string_equal(trk_model_unit(model, TRK_PART_COORDINATE, 1), "m");
    assert_string_equal(trk_model_unit(model, TRK_PART_COORDINATE, 3), "rad");
    assert_string_equal(trk_model_unit(model, TRK_PART_LINK, 1), "N");
    assert_string_equal(trk_model_unit(model, TRK_PART_LINK, 2), "N m");
    assert_string_equal(trk_model_unit(model, TRK_PART_PORT, 1), "N");
    assert_string_equal(trk_model_unit(model, TRK_PART_PORT, 2), "N m");
    assert_string_equal(trk_model_unit(model, TRK_PART_ROAD, 1), "m");
    assert_null(trk_model_unit(model, TRK_PART_BODY, 1));
    assert_null(trk_model_unit(model, TRK_PART_ROAD, 2));
    assert_null(trk_model_unit(model, TRK_PART_LINK, 0));
    assert_null(trk_model_unit(NULL, TRK_PART_LINK, 1));
    trk_model_destroy(model);
}

static void matrices_and_rows(void **state)
{
    trk_model *model = make(*state);
    double m[9], c[9], k[9], row[3], g[1], x, y;
    trk_model_get_mass(model, m);
    assert_memory_equal(m, ((double[]){10, 0, 0, 0, 2, 0, 0, 0, 3}), sizeof m);
    trk_model_get_tangent(model, NULL, NULL, c, k);
    const double half = 50; /* 100 (1, 0, 1)^T (1, 0, 1) / 2 over roll and yaw */
    const double expected[] = {100, 0, 0, 0, half, half, 0, half, half};
    for (int i = 0; i < 9; i++) {
        assert_near(k[i], expected[i], 1e-13);
        assert_near(c[i], expected[i] / 20, 1e-14);
    }
    assert_ok(*state, trk_model_get_row(model, TRK_PART_PORT, 1, row));
    assert_memory_equal(row, ((double[]){1, 2, 0}), sizeof row);
    assert_ok(*state, trk_model_get_row(model, TRK_PART_PORT, 2, row));
    assert_memory_equal(row, ((double[]){0, 0, 1}), sizeof row);
    assert_ok(*state, trk_model_get_row(model, TRK_PART_SENSOR, 11, row)); /* force of the tire */
    assert_memory_equal(row, ((double[]){1, 0, 0}), sizeof row);
    assert_ok(*state, trk_model_get_link_row(model, 1, row, g));
    assert_near(g[0], 1, 0);
    assert_ok(*state, trk_model_get_link_row(model, 2, row, NULL));
    assert_ok(*state, trk_model_get_road_place(model, 1, &x, &y));
    assert_near(x, 1.5, 0);
    assert_near(y, -0.5, 0);
    assert_ok(*state, trk_model_get_road_place(model, 1, NULL, NULL));
    trk_model_destroy(model);
}

static void link_forces(void **state)
{
    trk_model *model = make(*state);
    const double e[] = {0.5, -2}, rate[] = {3, 4};
    double f[2];
    trk_model_get_link_force(model, e, rate, f);
    assert_near(f[0], 65, 0);
    assert_near(f[1], -180, 0);
    trk_model_destroy(model);
}

static void wrong_ids(void **state)
{
    trk_model *model = make(*state);
    double row[3];
    assert_int_equal(trk_model_get_row(model, TRK_PART_SENSOR, 0, row), TRK_E_ARGUMENT);
    assert_int_equal(trk_model_get_row(model, TRK_PART_SENSOR, 13, row), TRK_E_ARGUMENT);
    assert_int_equal(trk_model_get_row(model, TRK_PART_BODY, 1, row), TRK_E_ARGUMENT);
    assert_int_equal(trk_model_get_row(model, 99, 1, row), TRK_E_ARGUMENT);
    assert_int_equal(trk_model_get_row(model, TRK_PART_PORT, 1, NULL), TRK_E_ARGUMENT);
    assert_int_equal(trk_model_get_row(NULL, TRK_PART_PORT, 1, row), TRK_E_ARGUMENT);
    assert_int_equal(trk_model_get_link_row(model, 3, row, NULL), TRK_E_ARGUMENT);
    assert_int_equal(trk_model_get_link_row(model, 1, NULL, NULL), TRK_E_ARGUMENT);
    assert_int_equal(trk_model_get_road_place(model, 0, row, NULL), TRK_E_ARGUMENT);
    assert_int_equal(trk_model_get_road_place(NULL, 1, row, NULL), TRK_E_ARGUMENT);
    trk_model_destroy(model);
}

#define TEST(f) cmocka_unit_test_setup_teardown(f, support_setup, support_teardown)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(names_and_counts), TEST(units),     TEST(matrices_and_rows),
        TEST(link_forces),      TEST(wrong_ids),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
