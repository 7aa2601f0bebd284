/* SPDX-License-Identifier: MIT */
/* Which backend a solver gets. */
#include "linalg/solver.h"
#include "support.h"

static trk_backend chosen(trk_context *context, trk_backend wanted, int32_t n)
{
    trk_solver *solver = NULL;
    assert_ok(context, trk_solver_create(context, wanted, n, 0, NULL, NULL, NULL, &solver));
    trk_backend got = trk_solver_backend(solver);
    trk_solver_destroy(solver);
    return got;
}

static void automatic_choice(void **state)
{
    trk_context *context = *state;
    assert_int_equal(chosen(context, TRK_BACKEND_AUTO, 13), TRK_BACKEND_DENSE);
    assert_int_equal(chosen(context, TRK_BACKEND_AUTO, 500),
                     trk_has_feature(TRK_FEATURE_CHOLMOD) ? TRK_BACKEND_SPARSE : TRK_BACKEND_DENSE);
    assert_int_equal(chosen(context, TRK_BACKEND_DENSE, 500), TRK_BACKEND_DENSE);
}

static void sparse_needs_cholmod(void **state)
{
    trk_context *context = *state;
    if (trk_has_feature(TRK_FEATURE_CHOLMOD)) {
        assert_int_equal(chosen(context, TRK_BACKEND_SPARSE, 2), TRK_BACKEND_SPARSE);
        return;
    }
    trk_solver *solver = NULL;
    assert_status(context,
                  trk_solver_create(context, TRK_BACKEND_SPARSE, 2, 0, NULL, NULL, NULL, &solver),
                  TRK_E_UNSUPPORTED);
    assert_message(context, "no CHOLMOD");
    assert_null(solver);
}

static void unknown_backends_are_refused(void **state)
{
    trk_context *context = *state;
    trk_solver *solver = NULL;
    for (trk_backend wrong = -1; wrong <= 3; wrong += 4)
        assert_status(context, trk_solver_create(context, wrong, 2, 0, NULL, NULL, NULL, &solver),
                      TRK_E_ARGUMENT);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(automatic_choice, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(sparse_needs_cholmod, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(unknown_backends_are_refused, support_setup,
                                        support_teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
