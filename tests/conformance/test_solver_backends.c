/* SPDX-License-Identifier: MIT */
/* One suite for every solver backend of this build. */
#include "linalg/solver.h"
#include "support.h"

/* The backend under test; set by main() before each run of the group. */
static trk_backend backend;

/* A chain of n unknowns with its own lists of entries: stiffness k to each of the
 * `reach` next unknowns, and a ground spring at every unknown. */
typedef struct chain {
    int32_t n, reach, links;
    int32_t *row, *column; /* per link: (i,i) (j,j) (i,j); then n ground springs */
    int64_t *slot;
    trk_solver *solver;
} chain;

static int64_t chain_count(const chain *c)
{
    return 3 * (int64_t)c->links + c->n;
}

static void chain_free(chain *c)
{
    trk_solver_destroy(c->solver);
    free(c->row);
    free(c->column);
    free(c->slot);
}

static trk_status chain_create(trk_context *context, trk_backend which, int32_t n, int32_t reach,
                               chain *c)
{
    *c = (chain){.n = n, .reach = reach};
    size_t room = (size_t)n * (size_t)(3 * reach + 1);
    c->row = malloc(room * sizeof *c->row);
    c->column = malloc(room * sizeof *c->column);
    c->slot = malloc(room * sizeof *c->slot);
    int64_t used = 0;
    for (int32_t i = 0; i < n; i++)
        for (int32_t j = i + 1; j <= i + reach && j < n; j++, c->links++) {
            /* Alternate the triangle in which the coupling is named. */
            const int32_t rows[] = {i, j, j % 2 ? i : j}, columns[] = {i, j, j % 2 ? j : i};
            memcpy(c->row + used, rows, sizeof rows);
            memcpy(c->column + used, columns, sizeof columns);
            used += 3;
        }
    for (int32_t i = 0; i < n; i++, used++)
        c->row[used] = c->column[used] = i;
    return trk_solver_create(context, which, n, chain_count(c), c->row, c->column, c->slot,
                             &c->solver);
}

static void chain_assemble(chain *c, double link, double ground)
{
    trk_solver_clear(c->solver);
    double *values = trk_solver_values(c->solver);
    for (int32_t k = 0; k < c->links; k++) {
        values[c->slot[3 * k]] += link;
        values[c->slot[3 * k + 1]] += link;
        values[c->slot[3 * k + 2]] -= link;
    }
    for (int32_t i = 0; i < c->n; i++)
        values[c->slot[3 * c->links + i]] += ground;
}

/* y := S x, formed spring by spring, so that it knows nothing about slots. */
static void chain_multiply(const chain *c, double link, double ground, const double *x, double *y)
{
    for (int32_t i = 0; i < c->n; i++)
        y[i] = ground * x[i];
    for (int32_t i = 0; i < c->n; i++)
        for (int32_t j = i + 1; j <= i + c->reach && j < c->n; j++) {
            double force = link * (x[i] - x[j]);
            y[i] += force;
            y[j] -= force;
        }
}

/* Numerical Recipes' 32-bit linear congruential generator, as a number in [-1, 1). */
static double draw(uint32_t *seed)
{
    *seed = 1664525u * *seed + 1013904223u;
    return (double)*seed / 2147483648.0 - 1.0;
}

static double largest_difference(int32_t n, const double *a, const double *b)
{
    double largest = 0.0;
    for (int32_t i = 0; i < n; i++)
        largest = fmax(largest, fabs(a[i] - b[i]));
    return largest;
}

static void one_unknown(void **state)
{
    trk_context *context = *state;
    trk_solver *solver = NULL;
    assert_ok(context, trk_solver_create(context, backend, 1, 0, NULL, NULL, NULL, &solver));
    assert_int_equal(trk_solver_backend(solver), backend);
    assert_int_equal(trk_solver_factor_entries(solver), 1);
    trk_solver_values(solver)[0] = 4.0;
    double x = 10.0;
    int32_t bad = 7;
    assert_ok(context, trk_solver_factorize(solver, &bad));
    assert_int_equal(bad, -1);
    assert_ok(context, trk_solver_solve(solver, &x));
    assert_near(x, 2.5, 1e-15);
    trk_solver_destroy(solver);
}

static void slots_are_symmetric_and_repeat(void **state)
{
    trk_context *context = *state;
    const int32_t row[] = {2, 0, 2, 1, 0, 2}, column[] = {0, 2, 0, 1, 1, 2};
    int64_t slot[6];
    trk_solver *solver = NULL;
    assert_ok(context, trk_solver_create(context, backend, 3, 6, row, column, slot, &solver));
    assert_int_equal(slot[0], slot[1]);
    assert_int_equal(slot[0], slot[2]);
    for (int i = 2; i < 6; i++)
        for (int j = i + 1; j < 6; j++)
            assert_int_not_equal(slot[i], slot[j]);
    trk_solver_destroy(solver);
}

/* -x'' = 1 with fixed ends by differences: x_i = (i + 1)(n - i) / 2 exactly. */
static void tridiagonal_has_the_closed_form_solution(void **state)
{
    trk_context *context = *state;
    const int32_t sizes[] = {2, 3, 13, 40, 100};
    for (size_t s = 0; s < sizeof sizes / sizeof *sizes; s++) {
        int32_t n = sizes[s], bad;
        double x[100];
        chain c;
        assert_ok(context, chain_create(context, backend, n, 1, &c));
        chain_assemble(&c, 1.0, 0.0);
        trk_solver_values(c.solver)[c.slot[3 * c.links]] += 1.0; /* walls */
        trk_solver_values(c.solver)[c.slot[3 * c.links + n - 1]] += 1.0;
        assert_ok(context, trk_solver_factorize(c.solver, &bad));
        for (int32_t i = 0; i < n; i++)
            x[i] = 1.0;
        assert_ok(context, trk_solver_solve(c.solver, x));
        for (int32_t i = 0; i < n; i++)
            assert_near(x[i], 0.5 * (i + 1) * (n - i), 1e-13 * n * n);
        chain_free(&c);
    }
}

static void banded_chains_of_all_sizes(void **state)
{
    trk_context *context = *state;
    const int32_t sizes[] = {10, 100, 1000, 3000};
    double *wanted = malloc(3000 * sizeof *wanted), *x = malloc(3000 * sizeof *x);
    uint32_t seed = 1;
    for (size_t s = 0; s < sizeof sizes / sizeof *sizes; s++) {
        int32_t n = sizes[s], bad;
        if (backend == TRK_BACKEND_DENSE && n > 1000)
            continue; /* 9e9 operations */
        for (int32_t i = 0; i < n; i++)
            wanted[i] = draw(&seed);
        chain c;
        assert_ok(context, chain_create(context, backend, n, 4, &c));
        for (int pass = 1; pass <= 2; pass++) { /* new values, same pattern */
            chain_assemble(&c, 3.0e5 * pass, 2.0e3);
            assert_ok(context, trk_solver_factorize(c.solver, &bad));
            chain_multiply(&c, 3.0e5 * pass, 2.0e3, wanted, x);
            assert_ok(context, trk_solver_solve(c.solver, x));
            assert_near(largest_difference(n, x, wanted), 0.0, 1e-10);
        }
        assert_true(trk_solver_factor_entries(c.solver) >= 5 * (int64_t)n - 10);
        chain_free(&c);
    }
    free(wanted);
    free(x);
}

/* S = A^T A + I with random A and all entries named, row by row. */
static void random_matrices_full_pattern(void **state)
{
    trk_context *context = *state;
    enum { N = 24 };
    static int32_t row[N * (N + 1) / 2], column[N * (N + 1) / 2];
    static int64_t slot[N * (N + 1) / 2];
    double a[N][N], s[N][N], wanted[N], x[N];
    int64_t count = 0;
    for (int32_t i = 0; i < N; i++)
        for (int32_t j = 0; j <= i; j++, count++) {
            row[count] = i;
            column[count] = j;
        }
    trk_solver *solver = NULL;
    assert_ok(context, trk_solver_create(context, backend, N, count, row, column, slot, &solver));
    for (uint32_t seed = 1; seed <= 20; seed++) {
        uint32_t random = seed;
        for (int i = 0; i < N * N; i++)
            a[i / N][i % N] = draw(&random);
        memset(s, 0, sizeof s);
        for (int i = 0; i < N; i++) {
            wanted[i] = draw(&random);
            s[i][i] = 1.0;
            for (int j = 0; j < N; j++)
                for (int k = 0; k < N; k++)
                    s[i][j] += a[k][i] * a[k][j];
        }
        trk_solver_clear(solver);
        for (int64_t k = 0; k < count; k++)
            trk_solver_values(solver)[slot[k]] += s[row[k]][column[k]];
        int32_t bad;
        assert_ok(context, trk_solver_factorize(solver, &bad));
        for (int i = 0; i < N; i++) {
            x[i] = 0.0;
            for (int j = 0; j < N; j++)
                x[i] += s[i][j] * wanted[j];
        }
        assert_ok(context, trk_solver_solve(solver, x));
        assert_near(largest_difference(N, x, wanted), 0.0, 1e-12);
    }
    trk_solver_destroy(solver);
}

static void agrees_with_the_dense_backend(void **state)
{
    trk_context *context = *state;
    enum { N = 60 };
    double x[N], y[N];
    chain c, dense;
    uint32_t seed = 5;
    int32_t bad;
    assert_ok(context, chain_create(context, backend, N, 3, &c));
    assert_ok(context, chain_create(context, TRK_BACKEND_DENSE, N, 3, &dense));
    chain_assemble(&c, 2.0e5, 4.0e4);
    chain_assemble(&dense, 2.0e5, 4.0e4);
    assert_ok(context, trk_solver_factorize(c.solver, &bad));
    assert_ok(context, trk_solver_factorize(dense.solver, &bad));
    double largest = 0.0;
    for (int i = 0; i < N; i++)
        x[i] = y[i] = draw(&seed);
    assert_ok(context, trk_solver_solve(c.solver, x));
    assert_ok(context, trk_solver_solve(dense.solver, y));
    for (int i = 0; i < N; i++)
        largest = fmax(largest, fabs(y[i]));
    assert_near(largest_difference(N, x, y) / largest, 0.0, 1e-12);
    chain_free(&c);
    chain_free(&dense);
}

/* The values stay, and a solver recovers from a failed factorization. */
static void names_the_bad_unknown_and_recovers(void **state)
{
    trk_context *context = *state;
    enum { N = 30 };
    const double broken[] = {-1.0, 0.0, (double)NAN, (double)INFINITY};
    double x[N], wanted[N];
    chain c;
    assert_ok(context, chain_create(context, backend, N, 1, &c));
    for (size_t b = 0; b < sizeof broken / sizeof *broken; b++)
        for (int32_t k = 0; k < N; k += 7) {
            int32_t bad = -1;
            chain_assemble(&c, 0.0, 2.0); /* diagonal: any order finds the same unknown */
            double *entry = trk_solver_values(c.solver) + c.slot[3 * c.links + k];
            *entry = broken[b];
            assert_int_equal(trk_solver_factorize(c.solver, &bad), TRK_E_SINGULAR);
            assert_int_equal(bad, k);
            assert_memory_equal(entry, &broken[b], sizeof *entry);
            assert_status(context, trk_solver_solve(c.solver, x), TRK_E_ARGUMENT);
            assert_message(context, "factorization");

            chain_assemble(&c, 5.0, 1.0);
            assert_ok(context, trk_solver_factorize(c.solver, &bad));
            for (int i = 0; i < N; i++)
                wanted[i] = i - 3.0;
            chain_multiply(&c, 5.0, 1.0, wanted, x);
            assert_ok(context, trk_solver_solve(c.solver, x));
            assert_near(largest_difference(N, x, wanted), 0.0, 1e-12);
        }
    chain_free(&c);
}

/* A chain that hangs on nothing can move as a whole; rounding must not hide it. */
static void free_chain_is_singular(void **state)
{
    trk_context *context = *state;
    const int32_t sizes[] = {2, 3, 13, 100, 500};
    const double stiffness[] = {1.0, 0.1, 1.0 / 3.0, 2.7e7};
    for (size_t s = 0; s < sizeof sizes / sizeof *sizes; s++)
        for (size_t k = 0; k < sizeof stiffness / sizeof *stiffness; k++) {
            int32_t bad = -1;
            chain c;
            assert_ok(context, chain_create(context, backend, sizes[s], 2, &c));
            chain_assemble(&c, stiffness[k], 0.0);
            assert_int_equal(trk_solver_factorize(c.solver, &bad), TRK_E_SINGULAR);
            assert_in_range(bad, 0, sizes[s] - 1);
            /* A weak spring to ground, well above rounding, makes it definite. */
            chain_assemble(&c, stiffness[k], 1e-6 * stiffness[k]);
            assert_ok(context, trk_solver_factorize(c.solver, &bad));
            chain_free(&c);
        }
}

/* Pivots just above and just below n * epsilon of their diagonal (LINALG.2). */
static void pivot_rule(void **state)
{
    trk_context *context = *state;
    const int32_t row[] = {0, 1, 1}, column[] = {0, 0, 1};
    int64_t slot[3];
    trk_solver *solver = NULL;
    assert_ok(context, trk_solver_create(context, backend, 2, 3, row, column, slot, &solver));
    double *values = trk_solver_values(solver);
    const double epsilon = 2.220446049250313e-16;
    for (int ulps = 0; ulps <= 12; ulps++) {
        int32_t bad = -1;
        trk_solver_clear(solver);
        values[slot[0]] = 1.0;
        values[slot[1]] = 1.0;
        values[slot[2]] = 1.0 + ulps * epsilon; /* both pivots: 1, then ulps * epsilon */
        trk_status status = trk_solver_factorize(solver, &bad);
        if (ulps <= 2)
            assert_int_equal(status, TRK_E_SINGULAR);
        if (ulps > 3)
            assert_int_equal(status, TRK_OK);
    }
    trk_solver_destroy(solver);
}

/* Free chain: 4 k sin^2(j pi / 2n), j = 0 .. n - 1. Below each gap there are j of them (LINALG.6). */
static void counts_negative_eigenvalues(void **state)
{
    trk_context *context = *state;
    enum { N = 50 };
    const double pi = 3.14159265358979323846;
    double scale[N], x[N] = {1}, growth;
    int32_t count, bad;
    chain c;
    assert_ok(context, chain_create(context, backend, N, 1, &c));
    for (int i = 0; i < N; i++)
        scale[i] = 20;
    for (int j = 0; j <= N; j++) {
        double middle = j == 0 ? -0.1 : j == N ? 40.1 : 40 * pow(sin((j - 0.5) * pi / (2 * N)), 2);
        chain_assemble(&c, 10, -middle);
        assert_ok(context, trk_solver_count_negative(c.solver, scale, &count, &growth));
        assert_int_equal(count, j);
        assert_true(growth > 0.1 && growth < 1e4);
    }
    assert_status(context, trk_solver_solve(c.solver, x), TRK_E_ARGUMENT);
    chain_assemble(&c, 10, 1);
    assert_ok(context, trk_solver_factorize(c.solver, &bad));
    assert_ok(context, trk_solver_solve(c.solver, x));
    double sum = 0; /* S 1 = 1, so that 1 . S^-1 e_0 = 1 */
    for (int i = 0; i < N; i++)
        sum += x[i];
    assert_near(sum, 1, 1e-13);
    chain_free(&c);
}

/* [0 1; 1 0] has a zero pivot and an eigenvalue of each sign; [1e-9 1; 1 0] grows. */
static void tells_when_not_to_trust_a_count(void **state)
{
    trk_context *context = *state;
    const int32_t row[] = {0, 1, 1}, column[] = {0, 0, 1};
    const double scale[] = {1, 1};
    int64_t slot[3];
    int32_t count;
    double growth;
    trk_solver *solver = NULL;
    assert_ok(context, trk_solver_create(context, backend, 2, 3, row, column, slot, &solver));
    trk_solver_values(solver)[slot[1]] = 1;
    assert_int_equal(trk_solver_count_negative(solver, scale, &count, &growth), TRK_E_SINGULAR);
    trk_solver_values(solver)[slot[0]] = trk_solver_values(solver)[slot[2]] = 1e-9;
    assert_ok(context, trk_solver_count_negative(solver, scale, &count, &growth));
    assert_int_equal(count, 1);
    assert_near(growth, 1e9, 1e2);
    trk_solver_destroy(solver);
}

static void multiplies(void **state)
{
    trk_context *context = *state;
    enum { N = 40 };
    double x[N], y[N], wanted[N];
    uint32_t seed = 3;
    chain c;
    assert_ok(context, chain_create(context, backend, N, 3, &c));
    chain_assemble(&c, 7, 2);
    for (int i = 0; i < N; i++)
        x[i] = draw(&seed);
    chain_multiply(&c, 7, 2, x, wanted);
    trk_pattern_multiply(trk_solver_pattern(c.solver), trk_solver_values(c.solver), x, y);
    assert_near(largest_difference(N, y, wanted), 0, 1e-13);
    chain_free(&c);
}

static void rejects_bad_arguments(void **state)
{
    trk_context *context = *state;
    const int32_t row[] = {0, 3}, column[] = {0, 0};
    int64_t slot[2];
    trk_solver *solver = (trk_solver *)row;
    assert_status(context, trk_solver_create(context, backend, 3, 2, row, column, slot, &solver),
                  TRK_E_RANGE);
    assert_message(context, "entry 1 is at (3, 0), expected 0 to 2");
    assert_null(solver);
    assert_status(context, trk_solver_create(context, backend, 3, 2, column, row, slot, &solver),
                  TRK_E_RANGE);
    assert_status(context, trk_solver_create(context, backend, 0, 0, NULL, NULL, NULL, &solver),
                  TRK_E_RANGE);
    assert_status(context, trk_solver_create(context, backend, 3, -1, row, column, slot, &solver),
                  TRK_E_RANGE);
    assert_status(context,
                  trk_solver_create(context, backend, 3, INT32_MAX, row, column, slot, &solver),
                  TRK_E_RANGE);
    assert_status(context, trk_solver_create(context, backend, 3, 2, NULL, column, slot, &solver),
                  TRK_E_ARGUMENT);
    assert_status(context, trk_solver_create(context, backend, 3, 2, row, NULL, slot, &solver),
                  TRK_E_ARGUMENT);
    assert_status(context, trk_solver_create(context, backend, 3, 2, row, column, NULL, &solver),
                  TRK_E_ARGUMENT);
    assert_status(context, trk_solver_create(context, backend, 3, 0, NULL, NULL, NULL, NULL),
                  TRK_E_ARGUMENT);
    assert_int_equal(trk_solver_create(NULL, backend, 3, 0, NULL, NULL, NULL, &solver),
                     TRK_E_ARGUMENT);
    trk_solver_destroy(NULL);
}

static trk_status full_life(trk_context *context)
{
    chain c;
    double x[13] = {1.0};
    int32_t bad;
    trk_status status = chain_create(context, backend, 13, 2, &c);
    if (status == TRK_OK) {
        chain_assemble(&c, 2.0, 1.0);
        status = trk_solver_factorize(c.solver, &bad);
    }
    if (status == TRK_OK)
        status = trk_solver_solve(c.solver, x);
    chain_free(&c);
    return status;
}

static void survives_lack_of_memory(void **state)
{
    (void)state;
    support_exhaust_memory(full_life);
}

static int run(trk_backend which, const char *name)
{
#define TEST(function) cmocka_unit_test_setup_teardown(function, support_setup, support_teardown)
    const struct CMUnitTest tests[] = {
        TEST(one_unknown),
        TEST(slots_are_symmetric_and_repeat),
        TEST(tridiagonal_has_the_closed_form_solution),
        TEST(banded_chains_of_all_sizes),
        TEST(random_matrices_full_pattern),
        TEST(agrees_with_the_dense_backend),
        TEST(names_the_bad_unknown_and_recovers),
        TEST(free_chain_is_singular),
        TEST(pivot_rule),
        TEST(counts_negative_eigenvalues),
        TEST(tells_when_not_to_trust_a_count),
        TEST(multiplies),
        TEST(rejects_bad_arguments),
        TEST(survives_lack_of_memory),
    };
#undef TEST
    backend = which;
    return cmocka_run_group_tests_name(name, tests, NULL, NULL);
}

int main(void)
{
    int failed = run(TRK_BACKEND_DENSE, "dense");
    if (trk_has_feature(TRK_FEATURE_CHOLMOD))
        failed += run(TRK_BACKEND_SPARSE, "sparse");
    return failed;
}
