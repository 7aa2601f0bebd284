/* SPDX-License-Identifier: MIT */
/* LU of small dense systems. */
#include "linalg/small.h"
#include "support.h"

static void one_unknown(void **state)
{
    (void)state;
    double a = -4.0, b = 2.0;
    assert_true(trk_small_solve(1, &a, &b));
    assert_near(b, -0.5, 1e-16);
}

/* The Hilbert-like matrix 1 / (i + j + 1) + I, whose solution is prescribed. */
static void prescribed_solutions(void **state)
{
    (void)state;
    double a[20 * 20], b[20];
    for (int n = 1; n <= 20; n++) {
        for (int i = 0; i < n; i++) {
            b[i] = 0.0;
            for (int j = 0; j < n; j++) {
                a[i * n + j] = 1.0 / (i + j + 1) + (i == j);
                b[i] += a[i * n + j] * (j - 2.5);
            }
        }
        assert_true(trk_small_solve(n, a, b));
        for (int j = 0; j < n; j++)
            assert_near(b[j], j - 2.5, 1e-13);
    }
}

static void zero_leading_pivots_need_swaps(void **state)
{
    (void)state;
    double a[] = {0, 0, 2, 3, 0, 0, 0, 5, 0}, b[] = {4, 9, 10};
    assert_true(trk_small_solve(3, a, b));
    assert_near(b[0], 3.0, 1e-15);
    assert_near(b[1], 2.0, 1e-15);
    assert_near(b[2], 2.0, 1e-15);
}

/* Without scaling the rows, the first equation written in other units would be the pivot. */
static void units_of_an_equation_do_not_matter(void **state)
{
    (void)state;
    double a[] = {10.0, 1e20, 1.0, 1.0}, b[] = {1e20, 2.0};
    assert_true(trk_small_solve(2, a, b));
    assert_near(b[0], 1.0, 1e-15);
    assert_near(b[1], 1.0, 1e-15);
}

static void singular_matrices(void **state)
{
    (void)state;
    double zero_row[] = {1, 2, 0, 0}, twice[] = {0.1, 0.2, 0.3, 0.6}, zero = 0.0;
    double sums[] = {0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9};
    double b[] = {1, 1, 1};
    assert_false(trk_small_solve(2, zero_row, b));
    assert_false(trk_small_solve(2, twice, b));
    assert_false(trk_small_solve(3, sums, b));
    assert_false(trk_small_solve(1, &zero, b));
}

static void not_finite(void **state)
{
    (void)state;
    const double wrong[] = {(double)NAN, (double)INFINITY, -(double)INFINITY};
    for (int w = 0; w < 3; w++)
        for (int place = 0; place < 6; place++) {
            double a[] = {2, 1, 1, 3}, b[] = {1, 1};
            *(place < 4 ? a + place : b + place - 4) = wrong[w];
            assert_false(trk_small_solve(2, a, b));
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(one_unknown),
        cmocka_unit_test(prescribed_solutions),
        cmocka_unit_test(zero_leading_pivots_need_swaps),
        cmocka_unit_test(units_of_an_equation_do_not_matter),
        cmocka_unit_test(singular_matrices),
        cmocka_unit_test(not_finite),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
