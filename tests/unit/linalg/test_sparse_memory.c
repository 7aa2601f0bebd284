/* SPDX-License-Identifier: MIT */
/* CHOLMOD's own memory, counted and refused through its process-wide hooks. Needs CHOLMOD. */
#include "linalg/solver.h"
#include "support.h"

#include <SuiteSparse_config.h>

static int64_t requests, refuse_at, live; /* refuse_at 0: never */

static bool refused(void)
{
    requests++;
    return refuse_at && requests >= refuse_at;
}

static void *counted(void *block)
{
    live += block != NULL;
    return block;
}

static void *hook_malloc(size_t size)
{
    return refused() ? NULL : counted(malloc(size));
}

static void *hook_calloc(size_t count, size_t size)
{
    return refused() ? NULL : counted(calloc(count, size));
}

static void *hook_realloc(void *block, size_t size)
{
    if (!block)
        return hook_malloc(size);
    return refused() ? NULL : realloc(block, size);
}

static void hook_free(void *block)
{
    live -= block != NULL;
    free(block);
}

static int install(void **state)
{
    SuiteSparse_config.malloc_func = hook_malloc;
    SuiteSparse_config.calloc_func = hook_calloc;
    SuiteSparse_config.realloc_func = hook_realloc;
    SuiteSparse_config.free_func = hook_free;
    requests = refuse_at = live = 0;
    return support_setup(state);
}

static int remove_hooks(void **state)
{
    SuiteSparse_config.malloc_func = malloc;
    SuiteSparse_config.calloc_func = calloc;
    SuiteSparse_config.realloc_func = realloc;
    SuiteSparse_config.free_func = free;
    return support_teardown(state) || live != 0;
}

enum { N = 50 };

static trk_status create_tridiagonal(trk_context *context, trk_solver **out_solver)
{
    int32_t row[2 * N - 1], column[2 * N - 1];
    int64_t slot[2 * N - 1];
    for (int32_t i = 0; i < N; i++) {
        row[i] = column[i] = i;
        if (i > 0) {
            row[N + i - 1] = i;
            column[N + i - 1] = i - 1;
        }
    }
    trk_status status =
        trk_solver_create(context, TRK_BACKEND_SPARSE, N, 2 * N - 1, row, column, slot, out_solver);
    if (status == TRK_OK)
        for (int k = 0; k < 2 * N - 1; k++)
            trk_solver_values(*out_solver)[slot[k]] = k < N ? 2.0 : -1.0;
    return status;
}

static void solving_takes_no_memory(void **state)
{
    trk_context *context = *state;
    trk_solver *solver = NULL;
    double x[N] = {1.0};
    int32_t bad;
    assert_ok(context, create_tridiagonal(context, &solver));
    assert_true(requests > 0); /* the hooks are seen */
    assert_ok(context, trk_solver_factorize(solver, &bad));
    assert_ok(context, trk_solver_solve(solver, x));
    int64_t before = requests, blocks = live;
    for (int k = 0; k < 100; k++)
        assert_ok(context, trk_solver_solve(solver, x));
    assert_int_equal(requests, before);
    /* Factorizing again takes scratch, but gives all of it back. */
    for (int k = 0; k < 10; k++)
        assert_ok(context, trk_solver_factorize(solver, &bad));
    assert_ok(context, trk_solver_solve(solver, x));
    assert_int_equal(live, blocks);
    trk_solver_destroy(solver);
    assert_int_equal(live, 0);
}

/* Every request of a whole life is refused once; what was there before still works. */
static void every_refusal_is_reported(void **state)
{
    trk_context *context = *state;
    for (int64_t limit = 1;; limit++) {
        trk_solver *solver = NULL;
        double x[N] = {1.0};
        int32_t bad = -1;
        requests = 0;
        refuse_at = limit;
        trk_status status = create_tridiagonal(context, &solver);
        if (status == TRK_OK)
            status = trk_solver_factorize(solver, &bad);
        if (status == TRK_OK)
            status = trk_solver_solve(solver, x);
        refuse_at = 0;
        bool refused_one = requests >= limit;
        if (refused_one) {
            assert_status(context, status, TRK_E_MEMORY);
            assert_message(context, "CHOLMOD");
            assert_int_equal(bad, -1);
        }
        if (solver) { /* memory is back: the same solver goes on */
            memset(x, 0, sizeof x);
            x[0] = 1.0;
            assert_ok(context, trk_solver_factorize(solver, &bad));
            assert_ok(context, trk_solver_solve(solver, x));
            assert_near(x[0], (double)N / (N + 1), 1e-14);
        }
        trk_solver_destroy(solver);
        assert_int_equal(live, 0);
        if (!refused_one) {
            assert_true(limit > 10);
            return;
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(solving_takes_no_memory, install, remove_hooks),
        cmocka_unit_test_setup_teardown(every_refusal_is_reported, install, remove_hooks),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
