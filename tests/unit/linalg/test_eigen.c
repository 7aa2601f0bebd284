/* SPDX-License-Identifier: MIT */
/* Eigenproblems and complex systems against closed forms. */
#include "linalg/eigen.h"
#include "support.h"

static const double pi = 3.14159265358979323846;

enum { CHAIN = 12 };

/* n masses between two walls, springs k: tridiagonal (-k, 2k, -k). */
static void fill_chain(int n, double stiffness, double mass, double *k, double *m)
{
    memset(k, 0, (size_t)(n * n) * sizeof *k);
    memset(m, 0, (size_t)(n * n) * sizeof *m);
    for (int i = 0; i < n; i++) {
        k[i * n + i] = 2.0 * stiffness;
        m[i * n + i] = mass;
        if (i > 0)
            k[i * n + i - 1] = k[(i - 1) * n + i] = -stiffness;
    }
}

/* w_j = 2 sqrt(k/m) sin(j pi / (2 (n + 1))), shapes sin(i j pi / (n + 1)). */
static void fixed_chain(void **state)
{
    trk_context *context = *state;
    double k[CHAIN * CHAIN], m[CHAIN * CHAIN], lambda[CHAIN];
    fill_chain(CHAIN, 4.0e5, 250.0, k, m);
    assert_ok(context, trk_eigen_symmetric(context, CHAIN, k, m, lambda));
    for (int j = 1; j <= CHAIN; j++) {
        double w = 2.0 * sqrt(4.0e5 / 250.0) * sin(j * pi / (2.0 * (CHAIN + 1)));
        const double *phi = k + (j - 1) * CHAIN;
        assert_near(sqrt(lambda[j - 1]), w, 1e-12 * w);
        double size = sqrt(2.0 / (250.0 * (CHAIN + 1)));
        int first = 1; /* of the components equally large by symmetry */
        double wave = j * pi / (CHAIN + 1);
        for (int i = 2; i <= CHAIN; i++)
            if (fabs(sin(i * wave)) > fabs(sin(first * wave)) + 1e-9)
                first = i;
        size = copysign(size, sin(first * wave));
        for (int i = 1; i <= CHAIN; i++)
            assert_near(phi[i - 1], size * sin(i * wave), 1e-13);
    }
}

static double quadratic(int n, const double *matrix, const double *a, const double *b)
{
    double sum = 0.0;
    for (int j = 0; j < n; j++)
        for (int i = 0; i < n; i++)
            sum += a[i] * matrix[j * n + i] * b[j];
    return sum;
}

/* Units a million apart do not hurt, and M is coupled. */
static void normalised_by_a_coupled_mass_matrix(void **state)
{
    trk_context *context = *state;
    enum { N = 5 };
    const double unit[N] = {1e-3, 1.0, 1e3, 10.0, 0.1};
    double k[N * N], m[N * N], phi[N * N], factor[N * N], lambda[N];
    for (int j = 0; j < N; j++)
        for (int i = 0; i < N; i++) {
            k[j * N + i] = (i == j ? 3.0 : -1.0 / (1 + abs(i - j))) * unit[i] * unit[j];
            m[j * N + i] = (i == j ? 2.0 : 0.25) * unit[i] * unit[j];
        }
    memcpy(phi, k, sizeof k);
    memcpy(factor, m, sizeof m);
    assert_ok(context, trk_eigen_symmetric(context, N, phi, factor, lambda));
    for (int a = 0; a < N; a++) {
        const double *mode = phi + a * N;
        double largest = 0.0;
        for (int i = 0; i < N; i++)
            if (fabs(mode[i]) > fabs(largest))
                largest = mode[i];
        assert_true(largest > 0.0);
        if (a > 0)
            assert_true(lambda[a] >= lambda[a - 1]);
        for (int b = 0; b < N; b++) {
            assert_near(quadratic(N, m, mode, phi + b * N), a == b, 1e-13);
            assert_near(quadratic(N, k, mode, phi + b * N), a == b ? lambda[a] : 0.0, 1e-13);
        }
    }
}

/* Two equal masses in and against phase: both components equally large, the first decides. */
static void sign_of_symmetric_pairs(void **state)
{
    trk_context *context = *state;
    double k[] = {3.0, -1.0, -1.0, 3.0}, m[] = {1.0, 0.0, 0.0, 1.0}, lambda[2];
    assert_ok(context, trk_eigen_symmetric(context, 2, k, m, lambda));
    assert_near(lambda[0], 2.0, 1e-15);
    assert_near(lambda[1], 4.0, 1e-14);
    const double wanted[] = {1.0, 1.0, 1.0, -1.0};
    for (int i = 0; i < 4; i++)
        assert_near(k[i], wanted[i] / sqrt(2.0), 1e-15);
}

static void masses_that_are_not_definite(void **state)
{
    trk_context *context = *state;
    const double masses[][4] = {
        {1.0, 0.0, 0.0, 0.0},  /* massless          */
        {1.0, 0.0, 0.0, -2.0}, /* negative          */
        {1.0, 2.0, 2.0, 1.0},  /* indefinite        */
        {1.0, 1.0, 1.0, 1.0},  /* rank 1, exactly   */
        {0.1, 0.3, 0.3, 0.9},  /* rank 1, rounded   */
    };
    for (size_t c = 0; c < sizeof masses / sizeof *masses; c++) {
        double k[] = {2.0, -1.0, -1.0, 2.0}, m[4], lambda[2];
        memcpy(m, masses[c], sizeof m);
        assert_status(context, trk_eigen_symmetric(context, 2, k, m, lambda), TRK_E_SINGULAR);
        assert_message(context, "not positive definite at unknown 1");
    }
}

/* x" + 2 d w x' + w^2 x = 0 in state space: -d w +- i w sqrt(1 - d^2). */
static void damped_oscillator(void **state)
{
    trk_context *context = *state;
    const double w = 12.0, d = 0.2;
    double a[] = {0.0, -w * w, 1.0, -2.0 * d * w}, re[2], im[2], v[8];
    assert_ok(context, trk_eigen_general(context, 2, a, re, im, v));
    for (int j = 0; j < 2; j++) {
        assert_near(re[j], -d * w, 1e-13);
        assert_near(im[j], (j ? -w : w) * sqrt(1.0 - d * d), 1e-13);
        /* Second row of the state space: velocity = eigenvalue * displacement. */
        const double *q = v + 4 * j, *qdot = q + 2;
        assert_near(qdot[0], re[j] * q[0] - im[j] * q[1], 1e-14);
        assert_near(qdot[1], re[j] * q[1] + im[j] * q[0], 1e-14);
        assert_near(q[0] * q[0] + q[1] * q[1] + qdot[0] * qdot[0] + qdot[1] * qdot[1], 1.0, 1e-14);
    }
}

/* Overdamped, beside it a pair: real and complex columns in one matrix. */
static void real_and_complex_columns_mixed(void **state)
{
    trk_context *context = *state;
    enum { N = 3 };
    const double a[] = {-1.0, 0.5, 0.0, 0.0, -0.1, -2.0, 0.25, 2.0, -0.1}; /* column-major */
    double work[9], re[N], im[N], v[2 * N * N];
    memcpy(work, a, sizeof a);
    assert_ok(context, trk_eigen_general(context, N, work, re, im, v));
    int complex_ones = 0;
    for (int j = 0; j < N; j++) {
        const double *x = v + 2 * N * j;
        complex_ones += im[j] != 0.0;
        for (int i = 0; i < N; i++) {
            double real = 0.0, imaginary = 0.0;
            for (int l = 0; l < N; l++) {
                real += a[l * N + i] * x[2 * l];
                imaginary += a[l * N + i] * x[2 * l + 1];
            }
            assert_near(real, re[j] * x[2 * i] - im[j] * x[2 * i + 1], 1e-14);
            assert_near(imaginary, re[j] * x[2 * i + 1] + im[j] * x[2 * i], 1e-14);
        }
    }
    assert_int_equal(complex_ones, 2);
    double re_only[N], im_only[N];
    memcpy(work, a, sizeof a);
    assert_ok(context, trk_eigen_general(context, N, work, re_only, im_only, NULL));
    for (int j = 0; j < N; j++)
        assert_near(re_only[j] * re_only[j] + im_only[j] * im_only[j],
                    re[j] * re[j] + im[j] * im[j], 1e-13);
}

/* (1+i, 2; 3i, 4-i) has determinant 5 - 3i. */
static void complex_two_by_two(void **state)
{
    trk_context *context = *state;
    double a[] = {1, 1, 0, 3, 2, 0, 4, -1};
    /* Right-hand sides A (1, i) and A (0, 1). */
    double b[] = {1, 3, 1, 7, 2, 0, 4, -1};
    const double wanted[] = {1, 0, 0, 1, 0, 0, 1, 0};
    assert_ok(context, trk_complex_solve(context, 2, 2, a, b));
    for (int i = 0; i < 8; i++)
        assert_near(b[i], wanted[i], 1e-15);
}

/* Without scaling the rows, the first equation written in other units would be the pivot. */
static void complex_system_in_mixed_units(void **state)
{
    trk_context *context = *state;
    double a[] = {10, 0, 1, 0, 1e20, 0, 1, 0}, b[] = {0, 1e20, 0, 2};
    const double wanted[] = {0, 1, 0, 1};
    assert_ok(context, trk_complex_solve(context, 2, 1, a, b));
    for (int i = 0; i < 4; i++)
        assert_near(b[i], wanted[i], 1e-15);
}

static void singular_complex_systems(void **state)
{
    trk_context *context = *state;
    const double matrices[][8] = {
        {0, 0, 0, 0, 0, 0, 0, 0},
        {1, 1, 0, 0, 2, 0, 0, 0},                 /* a row of zeros  */
        {1, 1, 2, 2, 1, 1, 2, 2},                 /* equal columns   */
        {0.1, 0.1, 0.3, 0.3, 0.3, 0.3, 0.9, 0.9}, /* rank 1, rounded */
    };
    for (size_t c = 0; c < sizeof matrices / sizeof *matrices; c++) {
        double a[8], b[4] = {1, 0, 0, 0};
        memcpy(a, matrices[c], sizeof a);
        assert_status(context, trk_complex_solve(context, 2, 1, a, b), TRK_E_SINGULAR);
    }
}

static void bad_arguments(void **state)
{
    trk_context *context = *state;
    double a[] = {1, 0, 0, 1, 0, 0, 0, 0}, b[] = {1, 0, 0, 1, 0, 0, 0, 0}, x[4];
    assert_status(context, trk_eigen_symmetric(context, 2, NULL, b, x), TRK_E_ARGUMENT);
    assert_status(context, trk_eigen_symmetric(context, 2, a, NULL, x), TRK_E_ARGUMENT);
    assert_status(context, trk_eigen_symmetric(context, 2, a, b, NULL), TRK_E_ARGUMENT);
    assert_status(context, trk_eigen_symmetric(context, 0, a, b, x), TRK_E_RANGE);
    assert_status(context, trk_eigen_symmetric(context, 32001, a, b, x), TRK_E_RANGE);
    assert_status(context, trk_eigen_general(context, 2, NULL, x, x + 2, NULL), TRK_E_ARGUMENT);
    assert_status(context, trk_eigen_general(context, 2, a, NULL, x, NULL), TRK_E_ARGUMENT);
    assert_status(context, trk_eigen_general(context, 2, a, x, NULL, NULL), TRK_E_ARGUMENT);
    assert_status(context, trk_eigen_general(context, 0, a, x, x + 2, NULL), TRK_E_RANGE);
    assert_status(context, trk_complex_solve(context, 2, 1, NULL, b), TRK_E_ARGUMENT);
    assert_status(context, trk_complex_solve(context, 2, 1, a, NULL), TRK_E_ARGUMENT);
    assert_status(context, trk_complex_solve(context, 0, 1, a, b), TRK_E_RANGE);
    assert_status(context, trk_complex_solve(context, 2, 0, a, b), TRK_E_RANGE);
}

static void not_finite(void **state)
{
    trk_context *context = *state;
    double good[] = {1, 0, 0, 1, 1, 0, 0, 1}, x[4];
    double wrong[] = {1, 0, (double)NAN, 1, 0, 0, 0, 0};
    assert_status(context, trk_eigen_symmetric(context, 2, wrong, good, x), TRK_E_RANGE);
    assert_message(context, "stiffness matrix: entry (0, 1)");
    assert_status(context, trk_eigen_symmetric(context, 2, good, wrong, x), TRK_E_RANGE);
    assert_message(context, "mass matrix: entry (0, 1)");
    assert_status(context, trk_eigen_general(context, 2, wrong, x, x + 2, NULL), TRK_E_RANGE);
    assert_status(context, trk_complex_solve(context, 2, 1, wrong, good), TRK_E_RANGE);
    assert_message(context, "entry (1, 0)");
    assert_status(context, trk_complex_solve(context, 2, 1, good, wrong), TRK_E_RANGE);
}

static trk_status all_three(trk_context *context)
{
    double k[] = {2, -1, -1, 2}, m[] = {1, 0, 0, 1}, a[] = {0, -4, 1, -1};
    double z[] = {1, 1, 0, 3, 2, 0, 4, -1}, b[] = {1, 3, 1, 7}, re[2], im[2], v[8];
    trk_status status = trk_eigen_symmetric(context, 2, k, m, re);
    if (status == TRK_OK)
        status = trk_eigen_general(context, 2, a, re, im, v);
    if (status == TRK_OK)
        status = trk_complex_solve(context, 2, 1, z, b);
    return status;
}

static void lack_of_memory(void **state)
{
    (void)state;
    support_exhaust_memory(all_three);
}

static void unsupported_without_lapack(void **state)
{
    trk_context *context = *state;
    double a[8] = {1}, b[8] = {1}, x[2];
    assert_status(context, trk_eigen_symmetric(context, 1, a, b, x), TRK_E_UNSUPPORTED);
    assert_message(context, "LAPACK");
    assert_status(context, trk_eigen_general(context, 1, a, x, x + 1, NULL), TRK_E_UNSUPPORTED);
    assert_status(context, trk_complex_solve(context, 1, 1, a, b), TRK_E_UNSUPPORTED);
}

#define TEST(function) cmocka_unit_test_setup_teardown(function, support_setup, support_teardown)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(fixed_chain),
        TEST(normalised_by_a_coupled_mass_matrix),
        TEST(sign_of_symmetric_pairs),
        TEST(masses_that_are_not_definite),
        TEST(damped_oscillator),
        TEST(real_and_complex_columns_mixed),
        TEST(complex_two_by_two),
        TEST(complex_system_in_mixed_units),
        TEST(singular_complex_systems),
        TEST(bad_arguments),
        TEST(not_finite),
        TEST(lack_of_memory),
    };
    const struct CMUnitTest without[] = {TEST(unsupported_without_lapack)};
    return trk_has_feature(TRK_FEATURE_LAPACK) ? cmocka_run_group_tests(tests, NULL, NULL)
                                               : cmocka_run_group_tests(without, NULL, NULL);
}
