/* SPDX-License-Identifier: MIT */
/* Every name that truckride/vehicle.h promises exists, with the place it stands for. */
#include "support.h"

#include <truckride/model.h>
#include <truckride/vehicle.h>

/* All names of a space separated list are parts of that kind, and there are no others. */
static void expect(const trk_spec *spec, trk_part part, const char *list)
{
    char text[2048];
    assert_true(strlen(list) < sizeof text);
    strcpy(text, list);
    int count = 0;
    for (char *name = strtok(text, " "); name; name = strtok(NULL, " "), count++)
        if (!trk_spec_find(spec, part, name)) {
            print_error("%s: there is no '%s'\n", trk_spec_name(spec), name);
            fail();
        }
    assert_int_equal(trk_spec_count(spec, part), count);
}

static void expect_coordinates(trk_context *context, const trk_spec *spec, const char *list)
{
    trk_model *model;
    assert_ok(context, trk_model_compile(context, spec, NULL, &model));
    char got[512] = "";
    for (int32_t k = 1; k <= trk_model_count(model, TRK_PART_COORDINATE); k++) {
        strcat(got, k > 1 ? " " : "");
        strcat(got, trk_model_part_name(model, TRK_PART_COORDINATE, k));
    }
    assert_string_equal(got, list);
    trk_model_destroy(model);
}

static void quarter_car(void **state)
{
    trk_context *context = *state;
    for (trk_variant variant = TRK_VARIANT_LINEAR; variant <= TRK_VARIANT_NONLINEAR; variant++) {
        trk_spec *spec;
        assert_ok(context,
                  trk_vehicle_create_builtin(context, TRK_VEHICLE_REFERENCE_FRONT, variant, &spec));
        expect(spec, TRK_PART_BODY, "sprung unsprung");
        expect(spec, TRK_PART_ROAD, "road");
        expect(spec, TRK_PART_LINK,
               variant == TRK_VARIANT_NONLINEAR ? "tire spring damper bump_stop"
                                                : "tire spring damper");
        expect(spec, TRK_PART_SENSOR, "sprung_z unsprung_z tire_force");
        expect_coordinates(context, spec, "sprung.z unsprung.z");
        trk_spec_destroy(spec);
    }
}

static void half_car(void **state)
{
    trk_context *context = *state;
    trk_half_car_parameters p;
    trk_half_car_parameters_init(&p, sizeof p);
    trk_spec *spec;
    assert_ok(context, trk_vehicle_create_half_car(context, NULL, &spec));
    expect(spec, TRK_PART_BODY, "body front_axle rear_axle");
    expect(spec, TRK_PART_ROAD, "front rear");
    expect(spec, TRK_PART_LINK,
           "front_tire front_spring front_damper rear_tire rear_spring rear_damper");
    expect(spec, TRK_PART_SENSOR,
           "body_front_z body_rear_z front_axle_z rear_axle_z front_tire_force "
           "rear_tire_force");
    expect_coordinates(context, spec, "body.z body.pitch front_axle.z rear_axle.z");
    trk_spec_destroy(spec);
    p.layout = TRK_HALF_CAR_ROLL;
    assert_ok(context, trk_vehicle_create_half_car(context, &p, &spec));
    expect(spec, TRK_PART_BODY, "body left_wheel right_wheel");
    expect(spec, TRK_PART_ROAD, "left right");
    expect(spec, TRK_PART_LINK,
           "left_tire left_spring left_damper right_tire right_spring right_damper");
    expect_coordinates(context, spec, "body.z body.roll left_wheel.z right_wheel.z");
    double x, y;
    assert_ok(context,
              trk_spec_get_road(spec, trk_spec_find(spec, TRK_PART_ROAD, "right"), &x, &y));
    assert_near(x, 0, 0);
    assert_near(y, p.position[1], 0);
    trk_spec_destroy(spec);
}

static void half_truck(void **state)
{
    trk_context *context = *state;
    trk_spec *spec;
    assert_ok(context, trk_vehicle_create_builtin(context, TRK_VEHICLE_REFERENCE_HALF,
                                                  TRK_VARIANT_NONLINEAR, &spec));
    expect(spec, TRK_PART_BODY, "cab frame front_axle rear_axle");
    expect(spec, TRK_PART_ROAD, "front rear");
    expect(spec, TRK_PART_PORT, "fifth_wheel_x fifth_wheel_z");
    expect(spec, TRK_PART_LINK,
           "front_tire front_spring front_damper front_bump_stop rear_tire rear_spring rear_damper "
           "rear_bump_stop cab_front_vertical cab_front_longitudinal cab_rear_vertical");
    expect(spec, TRK_PART_SENSOR,
           "cab_front_x cab_front_z cab_rear_z frame_front_x frame_front_z frame_rear_z "
           "frame_rear_axle_z front_axle_z rear_axle_z front_tire_force rear_tire_force");
    expect_coordinates(context, spec,
                       "cab.x cab.z cab.pitch frame.z frame.pitch front_axle.z rear_axle.z");
    trk_spec_destroy(spec);
}

static void truck(void **state)
{
    trk_context *context = *state;
    trk_truck_parameters p;
    trk_truck_parameters_init(&p, sizeof p);
    p.anti_roll_stiffness[TRK_REAR] = p.cab_anti_roll_stiffness = 1;
    trk_spec *spec;
    assert_ok(context, trk_vehicle_create_truck(context, &p, &spec));
    expect(spec, TRK_PART_BODY, "cab frame front_axle rear_axle");
    expect(spec, TRK_PART_ROAD, "front_left front_right rear_left rear_right");
    expect(spec, TRK_PART_PORT, "fifth_wheel_x fifth_wheel_z");
    expect(
        spec, TRK_PART_LINK,
        "front_left_tire front_left_spring front_left_damper front_right_tire front_right_spring "
        "front_right_damper rear_left_tire rear_left_spring rear_left_damper rear_right_tire "
        "rear_right_spring rear_right_damper cab_front_left_vertical cab_front_right_vertical "
        "cab_rear_left_vertical cab_rear_right_vertical cab_front_left_longitudinal "
        "cab_front_right_longitudinal cab_rear_left_lateral cab_rear_right_lateral "
        "front_anti_roll_bar rear_anti_roll_bar cab_anti_roll_bar");
    expect(spec, TRK_PART_SENSOR,
           "cab_front_left_x cab_front_left_y cab_front_left_z cab_front_right_x cab_front_right_y "
           "cab_front_right_z cab_rear_left_y cab_rear_left_z cab_rear_right_y cab_rear_right_z "
           "frame_front_left_x frame_front_left_y frame_front_left_z frame_front_right_x "
           "frame_front_right_y frame_front_right_z frame_rear_left_y frame_rear_left_z "
           "frame_rear_right_y frame_rear_right_z frame_rear_axle_left_y frame_rear_axle_left_z "
           "frame_rear_axle_right_y frame_rear_axle_right_z front_axle_left_z front_axle_right_z "
           "rear_axle_left_z rear_axle_right_z front_left_tire_force front_right_tire_force "
           "rear_left_tire_force rear_right_tire_force");
    expect_coordinates(
        context, spec,
        "cab.x cab.y cab.z cab.roll cab.pitch cab.yaw frame.z frame.roll frame.pitch "
        "front_axle.z front_axle.roll rear_axle.z rear_axle.roll");
    double x, y;
    assert_ok(context,
              trk_spec_get_road(spec, trk_spec_find(spec, TRK_PART_ROAD, "rear_right"), &x, &y));
    assert_near(x, -4.5, 0);
    assert_near(y, -1.035, 0);
    trk_spec_destroy(spec);
}

/* Links that could never carry a force are left out. */
static void empty_links(void **state)
{
    trk_context *context = *state;
    trk_truck_parameters p;
    trk_truck_parameters_init(&p, sizeof p);
    p.damping[TRK_REAR] = 0;
    p.anti_roll_stiffness[TRK_FRONT] = 0;
    p.cab_lateral_stiffness[TRK_REAR_LEFT] = p.cab_lateral_damping[TRK_REAR_LEFT] = 0;
    trk_spec *spec;
    assert_ok(context, trk_vehicle_create_truck(context, &p, &spec));
    const char *const gone[] = {"rear_left_damper", "rear_right_damper", "front_anti_roll_bar",
                                "cab_rear_left_lateral", "front_left_bump_stop"};
    for (size_t k = 0; k < sizeof gone / sizeof *gone; k++)
        assert_int_equal(trk_spec_find(spec, TRK_PART_LINK, gone[k]), 0);
    assert_int_not_equal(trk_spec_find(spec, TRK_PART_LINK, "cab_rear_right_lateral"), 0);
    trk_spec_destroy(spec);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(quarter_car, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(half_car, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(half_truck, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(truck, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(empty_links, support_setup, support_teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
