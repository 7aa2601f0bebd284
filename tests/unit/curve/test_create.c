/* SPDX-License-Identifier: MIT */
/* Creation, copies, questions, and everything that is refused. */
#include "tables.h"

static void refuse(trk_context *context, int64_t count, const double *x, const double *y,
                   const trk_curve_options *options, trk_status status, const char *message)
{
    trk_curve *curve = (trk_curve *)context; /* must be overwritten */
    assert_status(context, trk_curve_create(context, "rear", count, x, y, options, &curve), status);
    assert_null(curve);
    assert_message(context, message);
    assert_int_equal(trk_context_blocks(context), 0);
}

static void test_null_pointers(void **state)
{
    double x[] = {0.0, 1.0};
    trk_curve *curve;
    assert_status(*state, trk_curve_create(NULL, "a", 2, x, x, NULL, &curve), TRK_E_ARGUMENT);
    assert_null(curve);
    assert_status(*state, trk_curve_create(*state, NULL, 2, x, x, NULL, &curve), TRK_E_ARGUMENT);
    assert_message(*state, "name is NULL");
    assert_status(*state, trk_curve_create(*state, "a", 2, x, x, NULL, NULL), TRK_E_ARGUMENT);
    assert_status(*state, trk_curve_copy(*state, NULL, &curve), TRK_E_ARGUMENT);
    assert_status(*state, trk_curve_copy(*state, curve, NULL), TRK_E_ARGUMENT);
    refuse(*state, 2, NULL, x, NULL, TRK_E_ARGUMENT, "x is NULL");
    refuse(*state, 2, x, NULL, NULL, TRK_E_ARGUMENT, "y is NULL");
    trk_curve_destroy(NULL);
}

static void test_tables_refused(void **state)
{
    double x[] = {0.0, 1.0, 0.5}, y[] = {0.0, 1.0, 2.0}, bad[] = {0.0, NAN, INFINITY};
    refuse(*state, 1, x, y, NULL, TRK_E_RANGE, "curve 'rear': 1 points, expected 2");
    refuse(*state, INT32_MAX, x, y, NULL, TRK_E_RANGE, "2147483647 points");
    refuse(*state, 3, x, y, NULL, TRK_E_RANGE, "x must increase (point 3: 0.5 after 1)");
    refuse(*state, 2, x, bad, NULL, TRK_E_RANGE, "point 2 is (1, nan)");
    refuse(*state, 3, bad, y, NULL, TRK_E_RANGE, "point 2 is (nan, 1)");
}

static void test_overflow_is_refused(void **state)
{
    double x[] = {0.0, 1.0, 2.0, 3.0}, y[] = {0.0, 1e308, -1e308, 0.0};
    double near[] = {0.0, 1e-300, 2.0, 3.0};
    trk_curve_options options;
    trk_curve_options_init(&options, sizeof options);
    for (options.interpolation = 0; options.interpolation < KINDS; options.interpolation++) {
        refuse(*state, 4, x, y, &options, TRK_E_RANGE, "slope overflows between points");
        refuse(*state, 4, near, y, &options, TRK_E_RANGE, "slope overflows between points");
    }
    double ends[] = {-1e308, 1e308};
    refuse(*state, 2, ends, x, NULL, TRK_E_RANGE, "slope overflows between points 1 and 2");
}

static void test_options_refused(void **state)
{
    double x[] = {0.0, 1.0};
    trk_curve_options options;
    trk_curve_options_init(&options, sizeof options);
    assert_int_equal(options.interpolation, TRK_INTERPOLATION_PCHIP);
    assert_int_equal(options.extrapolation, TRK_EXTRAPOLATION_SLOPE);
    options.interpolation = 5;
    refuse(*state, 2, x, x, &options, TRK_E_ARGUMENT, "interpolation is 5, expected 0 to 4");
    options.interpolation = 0;
    options.extrapolation = -1;
    refuse(*state, 2, x, x, &options, TRK_E_ARGUMENT, "extrapolation is -1, expected 0 to 1");

    struct {
        trk_curve_options known;
        int32_t later[4];
    } newer;
    trk_curve_options_init(&newer.known, sizeof newer);
    trk_curve *curve;
    assert_ok(*state, trk_curve_create(*state, "rear", 2, x, x, &newer.known, &curve));
    trk_curve_destroy(curve);
    newer.later[1] = 1;
    refuse(*state, 2, x, x, &newer.known, TRK_E_OPTIONS, "trk_curve_options");
}

static void test_questions_and_copy(void **state)
{
    trk_context *other;
    assert_ok(*state, trk_context_create(NULL, NULL, &other));
    trk_curve *first = new_curve(*state, DAMPER_POINTS, damper_x, damper_y, TRK_INTERPOLATION_AKIMA,
                                 TRK_EXTRAPOLATION_CLAMP);
    trk_curve *copy;
    assert_ok(other, trk_curve_copy(other, first, &copy));
    for (int k = -600; k <= 600; k++)
        assert_true(trk_curve_value(first, k / 1000.0) == trk_curve_value(copy, k / 1000.0));
    trk_curve_destroy(first);
    assert_int_equal(trk_curve_count(copy), DAMPER_POINTS);
    assert_memory_equal(trk_curve_x(copy), damper_x, sizeof damper_x);
    assert_memory_equal(trk_curve_y(copy), damper_y, sizeof damper_y);
    assert_string_equal(trk_curve_name(copy), "table");
    assert_int_equal(trk_curve_interpolation(copy), TRK_INTERPOLATION_AKIMA);
    assert_int_equal(trk_curve_extrapolation(copy), TRK_EXTRAPOLATION_CLAMP);
    trk_curve_destroy(copy);
    assert_int_equal(trk_context_blocks(other), 0);
    trk_context_destroy(other);
}

static trk_status create_and_copy(trk_context *context)
{
    trk_curve_options options;
    trk_curve_options_init(&options, sizeof options);
    options.interpolation = TRK_INTERPOLATION_NOT_A_KNOT;
    trk_curve *curve, *copy = NULL;
    trk_status status =
        trk_curve_create(context, "front", DAMPER_POINTS, damper_x, damper_y, &options, &curve);
    if (status == TRK_OK)
        status = trk_curve_copy(context, curve, &copy);
    assert_true(status == TRK_OK || copy == NULL);
    trk_curve_destroy(copy);
    trk_curve_destroy(curve);
    return status;
}

static void test_out_of_memory(void **state)
{
    (void)state;
    support_exhaust_memory(create_and_copy);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_null_pointers),       cmocka_unit_test(test_tables_refused),
        cmocka_unit_test(test_overflow_is_refused), cmocka_unit_test(test_options_refused),
        cmocka_unit_test(test_questions_and_copy),  cmocka_unit_test(test_out_of_memory),
    };
    return cmocka_run_group_tests(tests, support_setup, support_teardown);
}
