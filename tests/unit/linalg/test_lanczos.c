/* SPDX-License-Identifier: MIT */
/* Needs ARPACK. Lowest modes of a pencil by shift-invert Lanczos (LINALG.7). */
#include "linalg/eigen.h"
#include "support.h"

static const double pi = 3.14159265358979323846;

enum { N = 200 };

/* Masses 2 on springs 3, ends held, `copies` of it side by side: multiple eigenvalues. */
typedef struct problem {
    trk_solver *solver;
    double *mass;
    trk_pencil pencil;
} problem;

static void problem_free(problem *p)
{
    trk_solver_destroy(p->solver);
    free(p->mass);
}

static trk_status problem_create(trk_context *context, int copies, double sigma, problem *p)
{
    int32_t row[2 * N], column[2 * N], count = 0, bad, length = N / copies;
    int64_t slot[2 * N];
    memset(p, 0, sizeof *p);
    for (int32_t i = 0; i < N; i++)
        row[i] = column[i] = i;
    for (int32_t i = 0; i < N; i++)
        if (i % length > 0) {
            row[N + count] = i;
            column[N + count++] = i - 1;
        }
    trk_status status =
        trk_solver_create(context, TRK_BACKEND_AUTO, N, N + count, row, column, slot, &p->solver);
    if (status != TRK_OK)
        return status;
    p->mass = calloc((size_t)trk_solver_pattern(p->solver)->start[N], sizeof *p->mass);
    for (int32_t k = 0; k < N + count; k++) {
        trk_solver_values(p->solver)[slot[k]] = k < N ? 6 + 2 * sigma : -3;
        p->mass[slot[k]] = k < N ? 2 : 0;
    }
    p->pencil = (trk_pencil){p->solver, p->mass, sigma};
    return trk_solver_factorize(p->solver, &bad);
}

static double exact(int mode, int length)
{
    return 4 * 3.0 / 2 * pow(sin(mode * pi / (2 * (length + 1))), 2);
}

static double product(const double *x, const double *y)
{
    double sum = 0;
    for (int i = 0; i < N; i++)
        sum += 2 * x[i] * y[i];
    return sum;
}

static void chain_has_its_closed_form(void **state)
{
    trk_context *context = *state;
    enum { COUNT = 12 };
    static double phi[COUNT][N], again[COUNT][N];
    double lambda[COUNT];
    problem p;
    assert_ok(context, problem_create(context, 1, 1e-4, &p));
    assert_ok(context, trk_eigen_lowest(context, &p.pencil, 0, NULL, COUNT, lambda, phi[0]));
    for (int k = 0; k < COUNT; k++) {
        assert_near(lambda[k] / exact(k + 1, N), 1, 1e-11);
        for (int j = 0; j <= k; j++)
            assert_near(product(phi[j], phi[k]), j == k, 1e-12);
        double norm = sqrt(product(phi[k], phi[k])), sign = phi[k][0] < 0 ? -1 : 1;
        for (int i = 0; i < N; i++)
            assert_near(phi[k][i] * sign / norm,
                        sin((k + 1) * (i + 1) * pi / (N + 1)) / sqrt(N + 1.0), 1e-10);
    }
    assert_ok(context, trk_eigen_lowest(context, &p.pencil, 0, NULL, COUNT, lambda, again[0]));
    assert_memory_equal(phi, again, sizeof phi);
    problem_free(&p);
}

/* Known modes are left out, and each call finds the next copies of a fourfold eigenvalue. */
static void known_modes_are_left_out(void **state)
{
    trk_context *context = *state;
    enum { COPIES = 4, EACH = 3, COUNT = COPIES * EACH };
    static double phi[2 * COUNT][N];
    double lambda[2 * COUNT];
    int found = 0;
    problem p;
    assert_ok(context, problem_create(context, COPIES, 1e-4, &p));
    for (int call = 0; call < 2 * COPIES; call++, found += EACH)
        assert_ok(context, trk_eigen_lowest(context, &p.pencil, found, phi[0], EACH, lambda + found,
                                            phi[found]));
    int lowest = 0;
    for (int k = 0; k < found; k++) {
        lowest += lambda[k] < 1.0001 * exact(1, N / COPIES);
        for (int j = 0; j < k; j++)
            assert_near(product(phi[j], phi[k]), 0, 1e-9);
    }
    assert_int_equal(lowest, COPIES);
    problem_free(&p);
}

static void too_many_modes(void **state)
{
    trk_context *context = *state;
    double lambda[1], phi[1];
    problem p;
    assert_ok(context, problem_create(context, 1, 1, &p));
    const int32_t wrong[][2] = {{0, 0}, {0, N / 2}, {N - 2, 1}, {-1, 1}};
    for (size_t k = 0; k < sizeof wrong / sizeof *wrong; k++) {
        assert_status(
            context,
            trk_eigen_lowest(context, &p.pencil, wrong[k][0], NULL, wrong[k][1], lambda, phi),
            TRK_E_RANGE);
        assert_message(context, "of 200 unknowns, expected 1 to");
    }
    problem_free(&p);
}

static trk_status full_life(trk_context *context)
{
    static double phi[4 * N];
    double lambda[4];
    problem p;
    trk_status status = problem_create(context, 1, 1, &p);
    if (status == TRK_OK)
        status = trk_eigen_lowest(context, &p.pencil, 0, NULL, 4, lambda, phi);
    problem_free(&p);
    return status;
}

static void survives_lack_of_memory(void **state)
{
    (void)state;
    support_exhaust_memory(full_life);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(chain_has_its_closed_form, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(known_modes_are_left_out, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(too_many_modes, support_setup, support_teardown),
        cmocka_unit_test(survives_lack_of_memory),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
