/* SPDX-License-Identifier: MIT */
/* Options structs from older and newer headers, through the private functions and a real caller. */
#include "support.h"

#include "base/base.h"
#include <truckride/spec.h>

typedef struct older {
    size_t struct_size;
    double a;
} older;

typedef struct known {
    size_t struct_size;
    double a;
    int64_t b;
    double c;
} known;

typedef struct newer {
    size_t struct_size;
    double a;
    int64_t b;
    double c;
    double d;
} newer;

static const known defaults = {sizeof defaults, 1, 2, 3};

static void older_struct_keeps_new_defaults(void **state)
{
    struct {
        older options;
        double behind;
    } caller = {{sizeof(older), 10}, 77};
    known got = defaults;
    assert_ok(*state, trk_read_options(*state, "x", &caller.options, &got, sizeof got));
    assert_int_equal(got.struct_size, sizeof got);
    assert_near(got.a, 10, 0);
    assert_int_equal(got.b, 2);
    assert_near(got.c, 3, 0);

    trk_write_defaults(&caller.options, sizeof(older), &defaults, sizeof defaults);
    assert_int_equal(caller.options.struct_size, sizeof(older));
    assert_near(caller.options.a, 1, 0);
    assert_near(caller.behind, 77, 0);
    assert_int_equal(
        trk_write_options(&caller.options, &(known){sizeof(known), 5, 6, 7}, sizeof(known)),
        TRK_OK);
    assert_near(caller.options.a, 5, 0);
    assert_near(caller.behind, 77, 0);
}

static void newer_struct_must_leave_unknown_fields_zero(void **state)
{
    newer caller;
    memset(&caller, 0xff, sizeof caller);
    trk_write_defaults(&caller, sizeof caller, &defaults, sizeof defaults);
    assert_int_equal(caller.struct_size, sizeof caller);
    assert_near(caller.d, 0, 0);
    caller.c = 30;
    known got = defaults;
    assert_ok(*state, trk_read_options(*state, "x", &caller, &got, sizeof got));
    assert_int_equal(got.struct_size, sizeof got);
    assert_near(got.c, 30, 0);
    caller.d = 1;
    got = defaults;
    assert_status(*state, trk_read_options(*state, "trk_x_options", &caller, &got, sizeof got),
                  TRK_E_OPTIONS);
    assert_message(*state, "trk_x_options: byte ");
    assert_message(*state, trk_version_text());
    assert_memory_equal(&got, &defaults, sizeof got);
}

static void null_means_defaults(void **state)
{
    known got = defaults;
    assert_ok(*state, trk_read_options(*state, "x", NULL, &got, sizeof got));
    assert_memory_equal(&got, &defaults, sizeof got);
    trk_write_defaults(NULL, sizeof got, &defaults, sizeof defaults);
}

static void garbage_size_is_refused(void **state)
{
    static const size_t sizes[] = {0, 1, sizeof(size_t) - 1, 65537, SIZE_MAX};
    for (size_t k = 0; k < sizeof sizes / sizeof *sizes; k++) {
        known caller = {sizes[k], -1, -1, -1}, got = defaults;
        assert_status(*state, trk_read_options(*state, "trk_x_options", &caller, &got, sizeof got),
                      TRK_E_OPTIONS);
        assert_message(*state, "trk_x_options: struct_size is ");
        assert_message(*state, "call its init function");
        assert_memory_equal(&got, &defaults, sizeof got);
        assert_int_equal(trk_write_options(&caller, &defaults, sizeof defaults), TRK_E_OPTIONS);
        trk_write_defaults(&caller, sizes[k], &defaults, sizeof defaults);
        assert_near(caller.a, -1, 0);
    }
}

/* init(p, sizeof p) sets the size of a pointer: whoever reads the struct then refuses it. */
static void size_of_a_pointer_is_refused(void **state)
{
    known caller = {7, -1, -1, -1}, got = defaults;
    trk_write_defaults(&caller, sizeof(known *), &defaults, sizeof defaults);
    assert_int_equal(caller.struct_size, sizeof(known *));
    assert_status(*state, trk_read_options(*state, "trk_x_options", &caller, &got, sizeof got),
                  TRK_E_OPTIONS);
    assert_message(*state, "not of a pointer");
}

/* A body of a caller whose header ended after the mass, and of one with a field more. */
static void a_real_caller(void **state)
{
    typedef struct later {
        trk_body_options now;
        double added;
    } later;
    trk_spec *spec;
    assert_ok(*state, trk_spec_create(*state, "s", &spec));
    trk_body_options body;
    memset(&body, 0xee, sizeof body);
    trk_body_options_init(&body, offsetof(trk_body_options, inertia));
    body.mass = 5;
    assert_ok(*state, trk_spec_add_body(spec, "early", &body, NULL));
    trk_body_options back;
    trk_body_options_init(&back, sizeof back);
    assert_ok(*state, trk_spec_get_body(spec, 1, &back));
    assert_near(back.mass, 5, 0);
    assert_near(back.inertia[0], 0, 0);
    assert_int_equal(back.freedoms, TRK_FREE_Z);
    later ahead;
    trk_body_options_init(&ahead.now, sizeof ahead);
    ahead.now.mass = 6;
    assert_ok(*state, trk_spec_add_body(spec, "ahead", &ahead.now, NULL));
    ahead.added = 1;
    assert_status(*state, trk_spec_add_body(spec, "refused", &ahead.now, NULL), TRK_E_OPTIONS);
    assert_message(*state, "trk_body_options: byte ");
    assert_ok(*state, trk_spec_get_body(spec, 2, &ahead.now));
    assert_near(ahead.now.mass, 6, 0);
    assert_near(ahead.added, 0, 0);
    assert_int_equal(trk_spec_count(spec, TRK_PART_BODY), 2);
    trk_spec_destroy(spec);
}

#define TEST(f) cmocka_unit_test_setup_teardown(f, support_setup, support_teardown)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(older_struct_keeps_new_defaults),
        TEST(newer_struct_must_leave_unknown_fields_zero),
        TEST(null_means_defaults),
        TEST(garbage_size_is_refused),
        TEST(size_of_a_pointer_is_refused),
        TEST(a_real_caller),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
