/* SPDX-License-Identifier: MIT */
/* Beams of a spec: added, read, replaced, copied, refused; memory that runs out. */
#include "support.h"

#include <truckride/spec.h>

static trk_spec *make(trk_context *context)
{
    trk_spec *spec;
    trk_body_options body;
    trk_body_options_init(&body, sizeof body);
    assert_ok(context, trk_spec_create(context, "van", &spec));
    assert_ok(context, trk_spec_add_body(spec, "a", &body, NULL));
    assert_ok(context, trk_spec_add_body(spec, "b", &body, NULL));
    return spec;
}

static trk_beam_options good(void)
{
    trk_beam_options o;
    trk_beam_options_init(&o, sizeof o);
    o.from_body = 1;
    o.to_body = 2;
    o.to_point[0] = 2;
    o.axial = 1;
    o.stiffness_damping = 1e-4;
    return o;
}

static void defaults(void **state)
{
    (void)state;
    trk_beam_options o;
    memset(&o, 0xff, sizeof o);
    trk_beam_options_init(&o, sizeof o);
    assert_int_equal(o.struct_size, sizeof o);
    assert_true(o.up[0] == 0 && o.up[1] == 0 && o.up[2] == 1);
    assert_true(o.from_body == 0 && o.to_body == 0 && o.axial == 0 && o.stiffness_damping == 0);
}

static void add_get_set_copy(void **state)
{
    trk_spec *spec = make(*state), *copy;
    trk_beam_options o = good(), back;
    trk_beam_options_init(&back, sizeof back);
    int32_t id = 0;
    assert_int_equal(trk_spec_count(spec, TRK_PART_BEAM), 0);
    assert_ok(*state, trk_spec_add_beam(spec, "rail", &o, &id));
    assert_int_equal(id, 1);
    assert_ok(*state, trk_spec_add_beam(spec, "strut", &o, NULL));
    assert_int_equal(trk_spec_count(spec, TRK_PART_BEAM), 2);
    assert_int_equal(trk_spec_find(spec, TRK_PART_BEAM, "strut"), 2);
    assert_string_equal(trk_spec_part_name(spec, TRK_PART_BEAM, 1), "rail");
    o.torsion = 5;
    assert_ok(*state, trk_spec_set_beam(spec, 2, &o));
    assert_ok(*state, trk_spec_copy(*state, spec, &copy));
    trk_spec_destroy(spec);
    assert_ok(*state, trk_spec_get_beam(copy, 1, &back));
    assert_true(back.torsion == 0 && back.axial == 1 && back.to_point[0] == 2);
    assert_ok(*state, trk_spec_get_beam(copy, 2, &back));
    assert_memory_equal(&back, &o, sizeof o);
    trk_spec_destroy(copy);
}

#define REFUSED(call, status, text)                                                                \
    do {                                                                                           \
        assert_status(*state, call, status);                                                       \
        assert_message(*state, text);                                                              \
        o = good();                                                                                \
    } while (0)

#define REFUSED_FIELD(field, value, text)                                                          \
    do {                                                                                           \
        o.field = value;                                                                           \
        REFUSED(trk_spec_add_beam(spec, "rail", &o, NULL), TRK_E_RANGE, "beam 'rail': " text);     \
    } while (0)

static void refused_values(void **state)
{
    trk_spec *spec = make(*state);
    trk_beam_options o = good();
    REFUSED_FIELD(axial, -1, "axial is -1; a finite number >= 0");
    REFUSED_FIELD(torsion, NAN, "torsion is nan");
    REFUSED_FIELD(bending_y, INFINITY, "bending_y is inf");
    REFUSED_FIELD(bending_z, -2, "bending_z is -2");
    REFUSED_FIELD(shear_y, -2, "shear_y is -2");
    REFUSED_FIELD(shear_z, -2, "shear_z is -2");
    REFUSED_FIELD(mass_per_length, -2, "mass_per_length is -2");
    REFUSED_FIELD(inertia_x, -2, "inertia_x is -2");
    REFUSED_FIELD(inertia_y, -2, "inertia_y is -2");
    REFUSED_FIELD(inertia_z, -2, "inertia_z is -2");
    REFUSED_FIELD(mass_damping, -2, "mass_damping is -2");
    REFUSED_FIELD(stiffness_damping, -2, "stiffness_damping is -2");
    REFUSED_FIELD(from_point[1], NAN, "from_point is nan");
    REFUSED_FIELD(to_point[2], INFINITY, "to_point is inf");
    REFUSED_FIELD(up[0], NAN, "up is nan");
    REFUSED_FIELD(to_point[0], 0, "length is 0 m; its ends must be apart");
    REFUSED_FIELD(up[2], 0, "up is (0, 0, 0), zero or along the beam");
    o.up[0] = 1;
    REFUSED_FIELD(up[2], 1e-7, "up is (1, 0, 1e-07), zero or along the beam");
    assert_int_equal(trk_spec_count(spec, TRK_PART_BEAM), 0);
    trk_spec_destroy(spec);
}

static void refused_ends(void **state)
{
    trk_spec *spec = make(*state);
    trk_beam_options o = good();
    o.from_body = 3;
    REFUSED(trk_spec_add_beam(spec, "rail", &o, NULL), TRK_E_ARGUMENT,
            "beam 'rail': there is no body 3");
    o.to_body = -1;
    REFUSED(trk_spec_add_beam(spec, "rail", &o, NULL), TRK_E_ARGUMENT, "there is no body -1");
    o.to_body = 1;
    REFUSED(trk_spec_add_beam(spec, "rail", &o, NULL), TRK_E_ARGUMENT, "both ends are on body 'a'");
    o.from_body = o.to_body = 0;
    REFUSED(trk_spec_add_beam(spec, "rail", &o, NULL), TRK_E_ARGUMENT,
            "both ends are on the ground");
    REFUSED(trk_spec_add_beam(spec, "", &o, NULL), TRK_E_NAME, "a beam needs a name");
    REFUSED(trk_spec_add_beam(spec, NULL, &o, NULL), TRK_E_NAME, "a beam needs a name");
    REFUSED(trk_spec_add_beam(spec, "rail", NULL, NULL), TRK_E_ARGUMENT, "options is NULL");
    assert_int_equal(trk_spec_add_beam(NULL, "rail", &o, NULL), TRK_E_ARGUMENT);
    o.struct_size = 3;
    REFUSED(trk_spec_add_beam(spec, "rail", &o, NULL), TRK_E_OPTIONS,
            "trk_beam_options: struct_size is 3");
    assert_ok(*state, trk_spec_add_beam(spec, "rail", &o, NULL));
    REFUSED(trk_spec_add_beam(spec, "rail", &o, NULL), TRK_E_NAME,
            "beam name 'rail' is already used");
    o.from_body = 0; /* the ground */
    assert_ok(*state, trk_spec_add_beam(spec, "clamp", &o, NULL));
    trk_spec_destroy(spec);
}

static void refused_changes(void **state)
{
    trk_spec *spec = make(*state);
    trk_beam_options o = good(), back;
    trk_beam_options_init(&back, sizeof back);
    assert_ok(*state, trk_spec_add_beam(spec, "rail", &o, NULL));
    REFUSED(trk_spec_set_beam(spec, 2, &o), TRK_E_ARGUMENT, "there is no beam 2");
    o.axial = -3;
    REFUSED(trk_spec_set_beam(spec, 1, &o), TRK_E_RANGE, "beam 'rail': axial is -3");
    REFUSED(trk_spec_set_beam(spec, 1, NULL), TRK_E_ARGUMENT, "options is NULL");
    assert_int_equal(trk_spec_set_beam(NULL, 1, &o), TRK_E_ARGUMENT);
    assert_ok(*state, trk_spec_get_beam(spec, 1, &back));
    assert_true(back.axial == 1);
    assert_int_equal(trk_spec_get_beam(spec, 0, &back), TRK_E_ARGUMENT);
    assert_int_equal(trk_spec_get_beam(spec, 2, &back), TRK_E_ARGUMENT);
    assert_int_equal(trk_spec_get_beam(spec, 1, NULL), TRK_E_ARGUMENT);
    assert_int_equal(trk_spec_get_beam(NULL, 1, &back), TRK_E_ARGUMENT);
    back.struct_size = 0;
    assert_int_equal(trk_spec_get_beam(spec, 1, &back), TRK_E_OPTIONS);
    trk_spec_destroy(spec);
}

static trk_status add_and_copy(trk_context *context)
{
    trk_spec *spec, *copy = NULL;
    trk_body_options body;
    trk_body_options_init(&body, sizeof body);
    trk_beam_options o = good();
    trk_status status = trk_spec_create(context, "van", &spec);
    if (status != TRK_OK)
        return status;
    status = trk_spec_add_body(spec, "a", &body, NULL);
    if (status == TRK_OK)
        status = trk_spec_add_body(spec, "b", &body, NULL);
    if (status == TRK_OK)
        status = trk_spec_add_beam(spec, "rail", &o, NULL);
    if (status == TRK_OK)
        status = trk_spec_copy(context, spec, &copy);
    trk_spec_destroy(copy);
    trk_spec_destroy(spec);
    return status;
}

static void out_of_memory(void **state)
{
    (void)state;
    support_exhaust_memory(add_and_copy);
}

#define TEST(name) cmocka_unit_test_setup_teardown(name, support_setup, support_teardown)

int main(void)
{
    const struct CMUnitTest tests[] = {TEST(defaults),        TEST(add_get_set_copy),
                                       TEST(refused_values),  TEST(refused_ends),
                                       TEST(refused_changes), TEST(out_of_memory)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
