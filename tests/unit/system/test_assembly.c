/* SPDX-License-Identifier: MIT */
/* S = a A^T diag(m) A + B^T diag(s) B, solved, against the matrix written out. */
#include "support.h"

#include "system/assembly.h"

enum { N = 6 };

static uint32_t seed = 1;

static double random_number(void)
{
    seed = seed * 1664525u + 1013904223u;
    return (double)(seed >> 8) / (1 << 24) * 2 - 1;
}

/* count rows of up to three random entries; row k holds coordinate k so that all occur. */
static void make_rows(trk_context *context, int32_t count, trk_rows *rows)
{
    for (int32_t k = 0; k < count; k++) {
        const int32_t column[] = {k % N, (k * 5 + 2) % N, (k * 3 + 1) % N};
        const double value[] = {1, random_number(), random_number()};
        assert_ok(context, trk_rows_append(context, rows, 3, column, value));
    }
}

static void check_backend(trk_context *context, trk_backend backend)
{
    trk_rows inertia = {0}, links = {0};
    make_rows(context, N + 2, &inertia);
    make_rows(context, 9, &links);
    double mass[N + 2], s[9];
    for (int k = 0; k < N + 2; k++)
        mass[k] = 1 + k;
    for (int k = 0; k < 9; k++)
        s[k] = 10 * k;
    trk_assembly assembly;
    assert_ok(context, trk_assembly_create(context, backend, N, &inertia, mass, &links, &assembly));
    for (int with_links = 1; with_links >= 0; with_links--) {
        double full[N * N] = {0}, x[N], b[N] = {0};
        for (int32_t r = 0; r < N + 2; r++)
            trk_rows_add_square(&inertia, r, 2.5 * mass[r], N, full);
        for (int32_t r = 0; with_links && r < 9; r++)
            trk_rows_add_square(&links, r, s[r], N, full);
        for (int i = 0; i < N; i++)
            x[i] = random_number();
        for (int i = 0; i < N; i++)
            for (int j = 0; j < N; j++)
                b[i] += full[i * N + j] * x[j];
        int32_t bad;
        assert_ok(context, trk_assembly_factorize(&assembly, 2.5, with_links ? s : NULL, &bad));
        assert_ok(context, trk_solver_solve(assembly.solver, b));
        for (int i = 0; i < N; i++)
            assert_near(b[i], x[i], 1e-10);
    }
    mass[2] = -1e6;
    int32_t bad = -1;
    assert_int_equal(trk_assembly_factorize(&assembly, 1, NULL, &bad), TRK_E_SINGULAR);
    assert_in_range(bad, 0, N - 1);
    trk_assembly_clear(&assembly);
    trk_rows_clear(context, &inertia);
    trk_rows_clear(context, &links);
}

static void dense_is_right(void **state)
{
    check_backend(*state, TRK_BACKEND_DENSE);
}

static void sparse_is_right(void **state)
{
    if (!trk_has_feature(TRK_FEATURE_CHOLMOD))
        skip();
    check_backend(*state, TRK_BACKEND_SPARSE);
}

static trk_status create(trk_context *context)
{
    trk_rows inertia = {0}, none = {0};
    trk_assembly assembly = {0};
    const double mass[] = {1, 1};
    trk_status status = trk_rows_append(context, &inertia, 1, (int32_t[]){0}, (double[]){1});
    if (status == TRK_OK)
        status = trk_rows_append(context, &inertia, 1, (int32_t[]){1}, (double[]){1});
    if (status == TRK_OK)
        status =
            trk_assembly_create(context, TRK_BACKEND_DENSE, 2, &inertia, mass, &none, &assembly);
    if (status == TRK_OK) {
        int32_t bad;
        status = trk_assembly_factorize(&assembly, 1, NULL, &bad);
        trk_assembly_clear(&assembly);
    }
    trk_rows_clear(context, &inertia);
    return status;
}

static void lack_of_memory(void **state)
{
    (void)state;
    support_exhaust_memory(create);
}

#define TEST(f) cmocka_unit_test_setup_teardown(f, support_setup, support_teardown)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(dense_is_right),
        TEST(sparse_is_right),
        TEST(lack_of_memory),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
