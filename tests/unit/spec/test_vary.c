/* SPDX-License-Identifier: MIT */
/* trk_spec_vary(): factors and values, by pattern, all or nothing. */
#include "support.h"

#include <truckride/vehicle.h>

static double stiffness(const trk_spec *spec, const char *name)
{
    trk_link_options o;
    trk_link_options_init(&o, sizeof o);
    assert_int_equal(trk_spec_get_link(spec, trk_spec_find(spec, TRK_PART_LINK, name), &o), TRK_OK);
    return o.stiffness;
}

static trk_spec *truck(trk_context *context)
{
    trk_spec *spec;
    assert_ok(context, trk_vehicle_create_builtin(context, TRK_VEHICLE_REFERENCE_TRUCK,
                                                  TRK_VARIANT_THESIS_DAMPERS, &spec));
    return spec;
}

static void factors_and_values(void **state)
{
    trk_spec *spec = truck(*state);
    int32_t count = 0;
    double front = stiffness(spec, "front_left_tire"), rear = stiffness(spec, "rear_left_tire");
    assert_ok(*state, trk_spec_vary(spec, TRK_FIELD_STIFFNESS, "front_*_tire", TRK_MEANING_FACTOR,
                                    1.25, &count));
    assert_int_equal(count, 2);
    assert_true(stiffness(spec, "front_left_tire") == 1.25 * front);
    assert_true(stiffness(spec, "rear_left_tire") == rear);
    assert_ok(*state,
              trk_spec_vary(spec, TRK_FIELD_STIFFNESS, "*_tire", TRK_MEANING_VALUE, 7e5, &count));
    assert_int_equal(count, 4);
    assert_true(stiffness(spec, "rear_right_tire") == 7e5);
    trk_body_options before, after;
    trk_body_options_init(&before, sizeof before);
    trk_body_options_init(&after, sizeof after);
    int32_t cab = trk_spec_find(spec, TRK_PART_BODY, "cab");
    assert_int_equal(trk_spec_get_body(spec, cab, &before), TRK_OK);
    assert_ok(*state,
              trk_spec_vary(spec, TRK_FIELD_MASS_INERTIA, "cab", TRK_MEANING_FACTOR, 2, NULL));
    assert_int_equal(trk_spec_get_body(spec, cab, &after), TRK_OK);
    assert_true(after.mass == 2 * before.mass);
    for (int k = 0; k < 3; k++)
        assert_true(after.inertia[k] == 2 * before.inertia[k]);
    trk_spec_destroy(spec);
}

static void refusals_change_nothing(void **state)
{
    trk_spec *spec = truck(*state);
    double tire = stiffness(spec, "front_left_tire");
    int32_t count = -1;
    assert_int_equal(trk_spec_vary(NULL, 1, "*", 0, 1, NULL), TRK_E_ARGUMENT);
    assert_status(*state, trk_spec_vary(spec, 1, NULL, 0, 1, NULL), TRK_E_ARGUMENT);
    assert_status(*state, trk_spec_vary(spec, 0, "*", 0, 1, NULL), TRK_E_ARGUMENT);
    assert_status(*state, trk_spec_vary(spec, TRK_FIELD_BENDING + 1, "*", 0, 1, NULL),
                  TRK_E_ARGUMENT);
    assert_status(*state, trk_spec_vary(spec, 1, "*", 2, 1, NULL), TRK_E_ARGUMENT);
    assert_status(*state, trk_spec_vary(spec, 1, "*_tire", 0, NAN, NULL), TRK_E_RANGE);
    assert_status(*state, trk_spec_vary(spec, 1, "*_tire", 0, 1e308, NULL), TRK_E_RANGE);
    assert_status(*state, trk_spec_vary(spec, 1, "bridge", 0, 2, &count), TRK_E_NAME);
    assert_status(*state, trk_spec_vary(spec, TRK_FIELD_MASS, "*", 0, -1, NULL), TRK_E_RANGE);
    /* The tires come first and could be varied; the dampers have no stiffness. */
    assert_status(*state, trk_spec_vary(spec, 1, "front_left_*", 0, 2, NULL), TRK_E_MODEL);
    assert_status(
        *state,
        trk_spec_vary(spec, TRK_FIELD_DAMPING, "front_left_damper", TRK_MEANING_VALUE, 1, NULL),
        TRK_E_MODEL); /* a curve is no number */
    assert_status(*state, trk_spec_vary(spec, TRK_FIELD_INERTIA, "cab", TRK_MEANING_VALUE, 1, NULL),
                  TRK_E_MODEL);
    assert_int_equal(count, -1);
    assert_true(stiffness(spec, "front_left_tire") == tire);
    trk_spec_destroy(spec);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(factors_and_values),
        cmocka_unit_test(refusals_change_nothing),
    };
    return cmocka_run_group_tests(tests, support_setup, support_teardown);
}
