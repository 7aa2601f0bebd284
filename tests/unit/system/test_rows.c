/* SPDX-License-Identifier: MIT */
/* Sparse rows against the same numbers written out. */
#include "support.h"

#include "system/rows.h"

static void rows_are_sorted_summed_and_without_zeros(void **state)
{
    trk_rows rows = {0};
    const int32_t column[] = {4, 1, 4, 0};
    const double value[] = {2, -1, 3, 0};
    assert_ok(*state, trk_rows_append(*state, &rows, 4, column, value));
    assert_ok(*state, trk_rows_append(*state, &rows, 0, NULL, NULL));
    assert_ok(*state, trk_rows_append(*state, &rows, 1, column, value));
    assert_int_equal(rows.count, 3);
    assert_int_equal(rows.entries, 3);
    assert_int_equal(rows.column[0], 1);
    assert_int_equal(rows.column[1], 4);
    double out[5];
    trk_rows_expand(&rows, 0, 5, out);
    assert_memory_equal(out, ((double[]){0, -1, 0, 0, 5}), sizeof out);
    trk_rows_expand(&rows, 1, 5, out);
    assert_memory_equal(out, ((double[5]){0}), sizeof out);
    trk_rows_expand(&rows, 2, 5, out);
    assert_memory_equal(out, ((double[]){0, 0, 0, 0, 2}), sizeof out);
    trk_rows_clear(*state, &rows);
    assert_int_equal(rows.count, 0);
}

static void products(void **state)
{
    trk_rows rows = {0};
    const int32_t column[] = {2, 0};
    const double value[] = {3, -2}, x[] = {1, 10, 100};
    assert_ok(*state, trk_rows_append(*state, &rows, 2, column, value));
    assert_near(trk_rows_dot(&rows, 0, x), 298, 0);
    double y[] = {1, 1, 1};
    trk_rows_add(&rows, 0, 0.5, y);
    assert_memory_equal(y, ((double[]){0, 1, 2.5}), sizeof y);
    double a[9] = {0};
    trk_rows_add_square(&rows, 0, 10, 3, a);
    assert_memory_equal(a, ((double[]){40, 0, -60, 0, 0, 0, -60, 0, 90}), sizeof a);
    trk_rows_clear(*state, &rows);
}

static trk_status fill(trk_context *context)
{
    trk_rows rows = {0};
    trk_status status = TRK_OK;
    for (int32_t k = 0; status == TRK_OK && k < 30; k++)
        status = trk_rows_append(context, &rows, 2, (int32_t[]){k, k + 1}, (double[]){1, 2});
    if (status == TRK_OK)
        assert_int_equal(rows.start[30], 60);
    trk_rows_clear(context, &rows);
    return status;
}

static void lack_of_memory(void **state)
{
    (void)state;
    support_exhaust_memory(fill);
}

#define TEST(f) cmocka_unit_test_setup_teardown(f, support_setup, support_teardown)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(rows_are_sorted_summed_and_without_zeros),
        TEST(products),
        TEST(lack_of_memory),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
