/* SPDX-License-Identifier: MIT */
/* Built-in vehicles: which links bend, static equilibrium, errors, memory. */
#include "support.h"

#include <truckride/model.h>
#include <truckride/vehicle.h>

static trk_spec *builtin(trk_context *context, trk_vehicle vehicle, trk_variant variant)
{
    trk_spec *spec;
    assert_ok(context, trk_vehicle_create_builtin(context, vehicle, variant, &spec));
    return spec;
}

static trk_link_options link_called(trk_context *context, const trk_spec *spec, const char *name)
{
    trk_link_options link;
    trk_link_options_init(&link, sizeof link);
    assert_ok(context, trk_spec_get_link(spec, trk_spec_find(spec, TRK_PART_LINK, name), &link));
    return link;
}

/* The thesis's quarter car, tables 2 and 3. */
static void thesis_quarter(void **state)
{
    trk_context *context = *state;
    for (trk_variant variant = TRK_VARIANT_LINEAR; variant <= TRK_VARIANT_NONLINEAR; variant++) {
        trk_spec *spec = builtin(context, TRK_VEHICLE_THESIS_QUARTER, variant);
        trk_body_options body;
        trk_body_options_init(&body, sizeof body);
        assert_ok(context, trk_spec_get_body(spec, 1, &body));
        assert_near(body.mass, 5000, 0);
        assert_ok(context, trk_spec_get_body(spec, 2, &body));
        assert_near(body.mass, 500, 0);
        assert_near(link_called(context, spec, "spring").stiffness, 500e3, 0);
        assert_near(link_called(context, spec, "tire").stiffness, 1000e3, 0);
        assert_near(link_called(context, spec, "tire").damping, 500, 0);
        trk_link_options damper = link_called(context, spec, "damper");
        assert_near(damper.damping, 0, 0);
        assert_near(trk_curve_value(damper.damper_curve, -0.1), -2000, 1e-9);
        trk_spec_destroy(spec);
    }
}

static void expect_curve(trk_context *context, const trk_spec *spec, const char *link,
                         double velocity, double force)
{
    trk_link_options options = link_called(context, spec, link);
    assert_non_null(options.damper_curve);
    assert_near(options.damping, 0, 0);
    assert_near(options.damper_scale, 1, 0);
    assert_near(trk_curve_value(options.damper_curve, velocity), force, 1e-3 * fabs(force));
}

static void variants(void **state)
{
    trk_context *context = *state;
    trk_spec *spec = builtin(context, TRK_VEHICLE_REFERENCE_TRUCK, TRK_VARIANT_LINEAR);
    for (int32_t k = 1; k <= trk_spec_count(spec, TRK_PART_LINK); k++) {
        trk_link_options link =
            link_called(context, spec, trk_spec_part_name(spec, TRK_PART_LINK, k));
        assert_true(!link.spring_curve && !link.damper_curve);
    }
    trk_spec_destroy(spec);
    spec = builtin(context, TRK_VEHICLE_REFERENCE_TRUCK, TRK_VARIANT_THESIS_DAMPERS);
    expect_curve(context, spec, "front_right_damper", -0.4, -3000);
    expect_curve(context, spec, "rear_left_damper", 0.3, 9000);
    expect_curve(context, spec, "cab_front_left_vertical", 0.4, 250);
    expect_curve(context, spec, "cab_rear_right_vertical", -0.3, -60);
    assert_near(link_called(context, spec, "rear_left_spring").stiffness, 256061.9, 0);
    assert_near(link_called(context, spec, "cab_front_left_vertical").stiffness, 40000, 0);
    trk_spec_destroy(spec);
    spec = builtin(context, TRK_VEHICLE_REFERENCE_TRUCK, TRK_VARIANT_NONLINEAR);
    expect_curve(context, spec, "front_right_damper", 1, 98727.9 / 5.77954);
    expect_curve(context, spec, "rear_left_damper", -1, -52526.6 / 4);
    expect_curve(context, spec, "cab_front_left_vertical", 0.26, 2390);
    expect_curve(context, spec, "cab_rear_right_vertical", 0.26, 1820);
    assert_near(link_called(context, spec, "rear_left_spring").stiffness, 0, 0);
    assert_non_null(link_called(context, spec, "rear_right_bump_stop").spring_curve);
    trk_spec_destroy(spec);
}

static double force_of(const trk_model *model, const double *force, const char *link)
{
    int32_t id = trk_model_find(model, TRK_PART_LINK, link);
    assert_true(id > 0);
    return force[id - 1];
}

/*
 * Drawn in static equilibrium: under gravity every spring keeps its length and carries
 * its share (VEHICLE.5), found here from the balance of moments with numbers only.
 */
static void nonlinear_is_drawn_at_rest(void **state)
{
    trk_context *context = *state;
    const double g = 9.80665, cab = 1242.63, frame = 5842.370;
    double rear = (cab * -0.4969 + frame * 2.22547) / 4.5, front = cab + frame - rear;
    double cab_rear = cab * (1.325 - 0.4969) / 1.8, cab_front = cab - cab_rear;
    trk_spec *spec = builtin(context, TRK_VEHICLE_REFERENCE_TRUCK, TRK_VARIANT_NONLINEAR);
    trk_model_options gravity;
    trk_model_options_init(&gravity, sizeof gravity);
    gravity.gravity = TRK_STANDARD_GRAVITY;
    trk_model *model;
    assert_ok(context, trk_model_compile(context, spec, &gravity, &model));
    trk_spec_destroy(spec);
    double q[13], force[64], b[13];
    assert_true(trk_model_count(model, TRK_PART_LINK) <= 64);
    trk_model_get_static(model, q, force);
    for (int32_t k = 1; k <= trk_model_count(model, TRK_PART_LINK); k++) {
        const char *name = trk_model_part_name(model, TRK_PART_LINK, k);
        double e = 0;
        assert_ok(context, trk_model_get_link_row(model, k, b, NULL));
        for (int i = 0; i < 13; i++)
            e += b[i] * q[i];
        if (strstr(name, "_tire"))
            assert_near(e, force[k - 1] / 817500, 1e-9);
        else
            assert_near(e, 0, 1e-9);
    }
    assert_near(force_of(model, force, "front_left_spring"), -front * g / 2, 1e-3);
    assert_near(force_of(model, force, "rear_right_spring"), -rear * g / 2, 1e-3);
    assert_near(force_of(model, force, "cab_front_right_vertical"), -cab_front * g / 2, 1e-3);
    assert_near(force_of(model, force, "cab_rear_left_vertical"), -cab_rear * g / 2, 1e-3);
    assert_near(force_of(model, force, "front_left_bump_stop"), 0, 0);
    assert_near(force_of(model, force, "rear_left_tire"), -(rear + 1097.581) * g / 2, 1e-3);
    trk_model_destroy(model);
}

static void errors(void **state)
{
    trk_context *context = *state;
    const int32_t wrong[][2] = {{0, 0}, {6, 0}, {-1, 0}, {5, -1}, {5, 3}, {1, 3}};
    for (size_t k = 0; k < sizeof wrong / sizeof *wrong; k++) {
        trk_spec *spec = (trk_spec *)state;
        assert_status(context, trk_vehicle_create_builtin(context, wrong[k][0], wrong[k][1], &spec),
                      TRK_E_ARGUMENT);
        assert_null(spec);
        assert_message(context, k < 3 ? "there is no vehicle" : "there is no variant");
    }
    trk_spec *spec;
    assert_status(context, trk_vehicle_create_builtin(context, 1, 0, NULL), TRK_E_ARGUMENT);
    assert_int_equal(trk_vehicle_create_builtin(NULL, 1, 0, &spec), TRK_E_ARGUMENT);
}

static trk_vehicle vehicle_in_work;
static trk_variant variant_in_work;

static trk_status work(trk_context *context)
{
    trk_spec *spec;
    trk_status status =
        trk_vehicle_create_builtin(context, vehicle_in_work, variant_in_work, &spec);
    assert_true((status == TRK_OK) == (spec != NULL));
    trk_spec_destroy(spec);
    return status;
}

static void out_of_memory(void **state)
{
    (void)state;
    for (vehicle_in_work = TRK_VEHICLE_THESIS_QUARTER;
         vehicle_in_work <= TRK_VEHICLE_REFERENCE_TRUCK; vehicle_in_work++)
        for (variant_in_work = TRK_VARIANT_LINEAR; variant_in_work <= TRK_VARIANT_NONLINEAR;
             variant_in_work++)
            support_exhaust_memory(work);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(thesis_quarter, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(variants, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(nonlinear_is_drawn_at_rest, support_setup,
                                        support_teardown),
        cmocka_unit_test_setup_teardown(errors, support_setup, support_teardown),
        cmocka_unit_test(out_of_memory),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
