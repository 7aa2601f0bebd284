/* SPDX-License-Identifier: MIT */
/* Parameters: defaults that depend on each other, values that are refused. */
#include "support.h"

#include <truckride/vehicle.h>

/* The half car's defaults are one side of the reference tractor, cab and frame in one body. */
static void half_car_is_one_side_of_the_tractor(void **state)
{
    (void)state;
    trk_truck_parameters t;
    trk_half_car_parameters h;
    trk_truck_parameters_init(&t, sizeof t);
    trk_half_car_parameters_init(&h, sizeof h);
    double mass = t.cab_mass + t.frame_mass;
    double x = (t.cab_mass * t.cab_cg[0] + t.frame_mass * t.frame_cg[0]) / mass;
    double dx = t.cab_cg[0] - t.frame_cg[0], dz = t.cab_cg[2] - t.frame_cg[2];
    double steiner = t.cab_mass * t.frame_mass / mass * (dx * dx + dz * dz);
    assert_near(h.body_mass, mass / 2, 1e-9);
    assert_near(h.body_inertia, (t.cab_inertia[1] + t.frame_inertia[1] + steiner) / 2, 1e-3);
    for (int k = 0; k < 2; k++) {
        assert_near(h.position[k], t.axle_x[k] - x, 1e-6);
        assert_near(h.unsprung_mass[k], t.axle_mass[k] / 2, 1e-12 * t.axle_mass[k]);
        assert_near(h.spring_stiffness[k], t.spring_stiffness[k], 0);
        assert_near(h.damping[k], t.damping[k], 0);
        assert_near(h.tire_stiffness[k], t.tire_stiffness[k], 0);
        assert_near(h.tire_damping[k], t.tire_damping[k], 0);
    }
}

/* Lever rule (VEHICLE.5) in the axle's quarter cars: together they carry half of cab and frame. */
static void axle_quarter(void **state)
{
    trk_context *context = *state;
    trk_truck_parameters p;
    trk_truck_parameters_init(&p, sizeof p);
    p.axle_x[TRK_FRONT] = 0.3;
    double carried = 0, moment = 0;
    for (int axle = TRK_FRONT; axle <= TRK_REAR; axle++) {
        trk_spec *spec;
        trk_body_options body;
        trk_link_options link;
        trk_body_options_init(&body, sizeof body);
        trk_link_options_init(&link, sizeof link);
        assert_ok(context, trk_vehicle_create_axle_quarter(context, &p, axle, &spec));
        assert_ok(context,
                  trk_spec_get_body(spec, trk_spec_find(spec, TRK_PART_BODY, "sprung"), &body));
        carried += 2 * body.mass;
        moment += 2 * body.mass * p.axle_x[axle];
        assert_ok(context,
                  trk_spec_get_body(spec, trk_spec_find(spec, TRK_PART_BODY, "unsprung"), &body));
        assert_near(body.mass, p.axle_mass[axle] / 2, 0);
        assert_ok(context,
                  trk_spec_get_link(spec, trk_spec_find(spec, TRK_PART_LINK, "spring"), &link));
        assert_near(link.stiffness, p.spring_stiffness[axle], 0);
        assert_ok(context,
                  trk_spec_get_link(spec, trk_spec_find(spec, TRK_PART_LINK, "tire"), &link));
        assert_near(link.stiffness, p.tire_stiffness[axle], 0);
        assert_near(link.damping, p.tire_damping[axle], 0);
        trk_spec_destroy(spec);
    }
    assert_near(carried, p.cab_mass + p.frame_mass, 1e-9);
    assert_near(moment, p.cab_mass * p.cab_cg[0] + p.frame_mass * p.frame_cg[0], 1e-9);
}

static void axle_quarter_errors(void **state)
{
    trk_context *context = *state;
    trk_truck_parameters p;
    trk_truck_parameters_init(&p, sizeof p);
    for (int32_t axle = -1; axle <= 2; axle += 3) {
        trk_spec *spec = (trk_spec *)state;
        assert_status(context, trk_vehicle_create_axle_quarter(context, NULL, axle, &spec),
                      TRK_E_ARGUMENT);
        assert_null(spec);
        assert_message(context, "there is no axle");
    }
    trk_spec *spec;
    p.frame_cg[0] = 2;
    assert_status(context, trk_vehicle_create_axle_quarter(context, &p, TRK_REAR, &spec),
                  TRK_E_RANGE);
    assert_message(context, "the rear axle carries");
    p.cab_mass = 0;
    p.frame_cg[0] = p.axle_x[TRK_FRONT];
    assert_status(context, trk_vehicle_create_axle_quarter(context, &p, TRK_REAR, &spec),
                  TRK_E_RANGE);
    assert_message(context, "the rear axle carries 0 kg");
    p.axle_x[TRK_REAR] = p.axle_x[TRK_FRONT];
    assert_status(context, trk_vehicle_create_axle_quarter(context, &p, TRK_FRONT, &spec),
                  TRK_E_RANGE);
    assert_status(context, trk_vehicle_create_axle_quarter(context, &p, 0, NULL), TRK_E_ARGUMENT);
    assert_int_equal(trk_vehicle_create_axle_quarter(NULL, &p, 0, &spec), TRK_E_ARGUMENT);
}

/* Each of these fields, alone, is refused with a message that names part and field. */
static void truck_values(void **state)
{
    trk_context *context = *state;
    trk_truck_parameters p;
    const struct {
        double *field, value;
        const char *message;
    } wrong[] = {
        {&p.cab_mass, -1, "body 'cab': mass is -1"},
        {&p.cab_inertia[1], NAN, "body 'cab': pitch inertia is nan"},
        {&p.frame_cg[2], INFINITY, "body 'frame': centre of gravity is inf"},
        {&p.axle_mass[1], -3, "body 'rear_axle': mass is -3"},
        {&p.axle_x[0], NAN, "body 'front_axle': centre of gravity is nan"},
        {&p.tire_y[1], NAN, "road 'rear_left'"},
        {&p.tire_stiffness[0], NAN, "link 'front_left_tire': stiffness"},
        {&p.tire_damping[0], -1, "link 'front_left_tire': damping is -1"},
        {&p.spring_y[1], INFINITY, "link 'rear_left_spring'"},
        {&p.damping[1], -5, "link 'rear_left_damper': damping is -5"},
        {&p.damper_scale[0], -1, "link 'front_left_damper': damper_scale is -1"},
        {&p.cab_mount_z[0], NAN, "link 'cab_front_left_vertical'"},
        {&p.cab_vertical_damping[3], -1, "link 'cab_rear_right_vertical': damping is -1"},
        {&p.cab_lateral_stiffness[2], NAN, "link 'cab_rear_left_lateral': stiffness is nan"},
        {&p.cab_longitudinal_damping[1], -1, "link 'cab_front_right_longitudinal': damping is -1"},
        {&p.anti_roll_stiffness[1], INFINITY, "link 'rear_anti_roll_bar': stiffness is inf"},
        {&p.fifth_wheel[1], NAN, "port 'fifth_wheel_x'"},
    };
    for (size_t k = 0; k < sizeof wrong / sizeof *wrong; k++) {
        trk_truck_parameters_init(&p, sizeof p);
        *wrong[k].field = wrong[k].value;
        trk_spec *spec = (trk_spec *)state;
        assert_status(context, trk_vehicle_create_truck(context, &p, &spec), TRK_E_RANGE);
        assert_null(spec);
        assert_message(context, wrong[k].message);
    }
    trk_spec *spec;
    trk_truck_parameters_init(&p, sizeof p);
    p.frame_mass = -1;
    assert_status(context, trk_vehicle_create_half_truck(context, &p, &spec), TRK_E_RANGE);
    assert_null(spec);
}

static void car_values(void **state)
{
    trk_context *context = *state;
    trk_quarter_car_parameters q;
    trk_half_car_parameters h;
    trk_spec *spec;
    trk_quarter_car_parameters_init(&q, sizeof q);
    q.unsprung_mass = -1;
    assert_status(context, trk_vehicle_create_quarter_car(context, &q, &spec), TRK_E_RANGE);
    assert_message(context, "body 'unsprung': mass is -1");
    trk_quarter_car_parameters_init(&q, sizeof q);
    q.tire_stiffness = NAN;
    assert_status(context, trk_vehicle_create_quarter_car(context, &q, &spec), TRK_E_RANGE);
    assert_message(context, "link 'tire': stiffness");
    trk_half_car_parameters_init(&h, sizeof h);
    h.position[1] = NAN;
    assert_status(context, trk_vehicle_create_half_car(context, &h, &spec), TRK_E_RANGE);
    assert_message(context, "body 'rear_axle'");
    for (int32_t layout = -1; layout <= 2; layout += 3) {
        trk_half_car_parameters_init(&h, sizeof h);
        h.layout = layout;
        spec = (trk_spec *)state;
        assert_status(context, trk_vehicle_create_half_car(context, &h, &spec), TRK_E_ARGUMENT);
        assert_null(spec);
        assert_message(context, "there is no layout");
    }
}

/* A struct that no init function has seen, and one from a newer header. */
static void struct_sizes(void **state)
{
    trk_context *context = *state;
    trk_spec *spec;
    trk_quarter_car_parameters quarter = {0};
    trk_half_car_parameters half = {0};
    struct {
        trk_truck_parameters known;
        double news;
    } truck;
    trk_truck_parameters_init(&truck.known, sizeof truck);
    assert_ok(context, trk_vehicle_create_truck(context, &truck.known, &spec));
    trk_spec_destroy(spec);
    truck.news = 1;
    assert_status(context, trk_vehicle_create_truck(context, &truck.known, &spec), TRK_E_OPTIONS);
    assert_status(context, trk_vehicle_create_half_truck(context, &truck.known, &spec),
                  TRK_E_OPTIONS);
    assert_status(context, trk_vehicle_create_axle_quarter(context, &truck.known, 0, &spec),
                  TRK_E_OPTIONS);
    assert_status(context, trk_vehicle_create_quarter_car(context, &quarter, &spec), TRK_E_OPTIONS);
    assert_status(context, trk_vehicle_create_half_car(context, &half, &spec), TRK_E_OPTIONS);
    assert_null(spec);
}

static void null_pointers(void **state)
{
    trk_context *context = *state;
    trk_spec *spec;
    assert_status(context, trk_vehicle_create_quarter_car(context, NULL, NULL), TRK_E_ARGUMENT);
    assert_status(context, trk_vehicle_create_half_car(context, NULL, NULL), TRK_E_ARGUMENT);
    assert_status(context, trk_vehicle_create_half_truck(context, NULL, NULL), TRK_E_ARGUMENT);
    assert_status(context, trk_vehicle_create_truck(context, NULL, NULL), TRK_E_ARGUMENT);
    assert_int_equal(trk_vehicle_create_quarter_car(NULL, NULL, &spec), TRK_E_ARGUMENT);
    assert_int_equal(trk_vehicle_create_half_car(NULL, NULL, &spec), TRK_E_ARGUMENT);
    assert_int_equal(trk_vehicle_create_half_truck(NULL, NULL, &spec), TRK_E_ARGUMENT);
    assert_int_equal(trk_vehicle_create_truck(NULL, NULL, &spec), TRK_E_ARGUMENT);
    assert_null(spec);
}

static trk_status half_car_work(trk_context *context)
{
    trk_spec *spec;
    trk_status status = trk_vehicle_create_half_car(context, NULL, &spec);
    assert_true((status == TRK_OK) == (spec != NULL));
    trk_spec_destroy(spec);
    return status;
}

static void out_of_memory(void **state)
{
    (void)state;
    support_exhaust_memory(half_car_work);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(half_car_is_one_side_of_the_tractor),
        cmocka_unit_test_setup_teardown(axle_quarter, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(axle_quarter_errors, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(truck_values, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(car_values, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(struct_sizes, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(null_pointers, support_setup, support_teardown),
        cmocka_unit_test(out_of_memory),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
