/* SPDX-License-Identifier: MIT */
/* FFT against the direct sum, Parseval, linearity, equality of the kernels. */
#include "spectrum/fft.h"
#include "spectrum/roots.h"
#include "support.h"

static const long double two_pi = 6.283185307179586476925286766559L;

static double noise(uint64_t *seed)
{
    *seed = *seed * 6364136223846793005u + 1442695040888963407u;
    return (double)(*seed >> 11) / 9007199254740992.0 - 0.5;
}

static double *fill(trk_context *context, int64_t buffer, int64_t count)
{
    double *x = trk_new(context, buffer, sizeof *x);
    assert_non_null(x);
    uint64_t seed = 7;
    for (int64_t i = 0; i < count; i++)
        x[i] = noise(&seed);
    return x;
}

/* Largest error of lane 0 against the definition in long double, over the rms of Z. */
static double direct_error(int64_t n, int64_t lanes, const double *z, const double *Z)
{
    long double *c = malloc((size_t)n * sizeof *c), *s = malloc((size_t)n * sizeof *s);
    for (int64_t k = 0; k < n; k++) {
        c[k] = cosl(two_pi * (long double)k / (long double)n);
        s[k] = sinl(two_pi * (long double)k / (long double)n);
    }
    long double worst = 0, power = 0;
    for (int64_t k = 0; k < n; k++) {
        long double re = 0, im = 0;
        for (int64_t j = 0; j < n; j++) {
            const int64_t jk = j * k % n;
            const long double a = z[2 * lanes * j], b = z[2 * lanes * j + lanes];
            re += a * c[jk] + b * s[jk];
            im += b * c[jk] - a * s[jk];
        }
        worst = fmaxl(worst, hypotl(re - Z[2 * lanes * k], im - Z[2 * lanes * k + lanes]));
        power += re * re + im * im;
    }
    free(c);
    free(s);
    return (double)(worst / sqrtl(power / (long double)n));
}

static void check_length(trk_context *context, int64_t n, const trk_fft_kernel *kernel)
{
    trk_fft *fft = NULL;
    assert_ok(context, trk_fft_create(context, n, kernel, &fft));
    const int64_t size = trk_fft_buffer(fft), count = 2 * n * kernel->lanes;
    double *z = fill(context, size, count), *data = fill(context, size, count);
    double *work = trk_new(context, size, sizeof *work);
    assert_non_null(work);
    const double *Z = trk_fft_forward(fft, data, work);
    assert_near(direct_error(n, kernel->lanes, z, Z), 0, 4e-15);
    trk_free(context, work);
    trk_free(context, data);
    trk_free(context, z);
    trk_fft_destroy(fft);
}

static const int64_t long_lengths[] = {211, 243,  256,  331, 337,  511,  512, 625,
                                       674, 1009, 1024, 961, 2017, 2048, 2520};

static void matches_direct_sum(void **state)
{
    for (int64_t n = 1; n <= 200; n++) {
        check_length(*state, n, &trk_fft_kernel_scalar);
        check_length(*state, n, &trk_fft_kernel_lanes);
        check_length(*state, n, trk_fft_kernel_widest());
    }
    for (size_t i = 0; i < sizeof long_lengths / sizeof *long_lengths; i++)
        check_length(*state, long_lengths[i], trk_fft_kernel_widest());
}

static void real_equals_complex(void **state)
{
    const trk_fft_kernel *kernel = trk_fft_kernel_widest();
    const int64_t lanes = kernel->lanes;
    for (int64_t n = 1; n <= 700; n += n < 200 ? 1 : 37) {
        trk_fft *complex = NULL;
        trk_real_fft *real = NULL;
        assert_ok(*state, trk_fft_create(*state, n, kernel, &complex));
        assert_ok(*state, trk_real_fft_create(*state, n, kernel, &real));
        const int64_t size = trk_fft_buffer(complex), real_size = trk_real_fft_buffer(real);
        double *x = fill(*state, real_size, n * lanes), *work = fill(*state, real_size, 0);
        double *z = fill(*state, size, 0), *work2 = fill(*state, size, 0);
        for (int64_t i = 0; i < n * lanes; i++)
            z[2 * lanes * (i / lanes) + i % lanes] = x[i];
        const double *Z = trk_fft_forward(complex, z, work2);
        const double *X = trk_real_fft_forward(real, x, work);
        for (int64_t i = 0; i < 2 * lanes * (n / 2 + 1); i++)
            assert_near(X[i], Z[i], 4e-15 * sqrt((double)n));
        double *all[] = {x, work, z, work2};
        for (int i = 0; i < 4; i++)
            trk_free(*state, all[i]);
        trk_fft_destroy(complex);
        trk_real_fft_destroy(real);
    }
}

/* sum |Z|^2 = n sum |z|^2, and F(a + 2 b) = F(a) + 2 F(b), at lengths too long for a direct sum. */
static void parseval_and_linearity(void **state)
{
    static const int64_t lengths[] = {65536, 100003, 131071, 120000};
    for (size_t i = 0; i < sizeof lengths / sizeof *lengths; i++) {
        const int64_t n = lengths[i];
        trk_fft *fft = NULL;
        assert_ok(*state, trk_fft_create(*state, n, &trk_fft_kernel_scalar, &fft));
        const int64_t size = trk_fft_buffer(fft);
        double *a = fill(*state, size, 2 * n), *b = fill(*state, size, 0);
        double *sum = fill(*state, size, 0), *work[3];
        double power = 0, transformed = 0;
        for (int64_t k = 0; k < 2 * n; k++) {
            b[k] = a[2 * n - 1 - k] * a[k];
            sum[k] = a[k] + 2 * b[k];
            power += a[k] * a[k];
        }
        for (int w = 0; w < 3; w++)
            work[w] = fill(*state, size, 0);
        const double *A = trk_fft_forward(fft, a, work[0]), *B = trk_fft_forward(fft, b, work[1]);
        const double *S = trk_fft_forward(fft, sum, work[2]);
        for (int64_t k = 0; k < 2 * n; k++) {
            transformed += A[k] * A[k];
            assert_near(S[k], A[k] + 2 * B[k], 1e-14 * sqrt((double)n));
        }
        assert_near(transformed / (power * (double)n), 1, 1e-12);
        double *all[] = {a, b, sum, work[0], work[1], work[2]};
        for (int w = 0; w < 6; w++)
            trk_free(*state, all[w]);
        trk_fft_destroy(fft);
    }
}

/* A plan for each kernel must give the same bits, whatever the processor. */
static void kernels_agree_bit_by_bit(void **state)
{
    const trk_fft_kernel *several = trk_fft_kernel_widest();
    const trk_fft_kernel *portable = &trk_fft_kernel_lanes;
    assert_int_equal(several->lanes, portable->lanes);
    for (int64_t n = 1; n <= 1400; n += n < 70 ? 1 : 133) {
        trk_real_fft *plan[3] = {0};
        const trk_fft_kernel *kernel[3] = {several, portable, &trk_fft_kernel_scalar};
        double *data[3], *work[3];
        const double *X[3];
        for (int i = 0; i < 3; i++) {
            assert_ok(*state, trk_real_fft_create(*state, n, kernel[i], &plan[i]));
            const int64_t size = trk_real_fft_buffer(plan[i]);
            data[i] = fill(*state, size, i < 2 ? n * several->lanes : 0);
            work[i] = fill(*state, size, 0);
            for (int64_t k = 0; i == 2 && k < n; k++)
                data[2][k] = work[0][k]; /* lane 0, saved below */
            if (i == 0)
                for (int64_t k = 0; k < n; k++)
                    work[0][k] = data[0][k * several->lanes];
        }
        for (int i = 0; i < 3; i++)
            X[i] = trk_real_fft_forward(plan[i], data[i], work[i]);
        const int64_t lanes = several->lanes, parts = 2 * (n / 2 + 1);
        assert_memory_equal(X[0], X[1], (size_t)(parts * lanes) * sizeof(double));
        for (int64_t k = 0; k < parts; k++)
            assert_true(X[0][k * lanes] == X[2][k]);
        for (int i = 0; i < 3; i++) {
            trk_free(*state, data[i]);
            trk_free(*state, work[i]);
            trk_real_fft_destroy(plan[i]);
        }
    }
}

static void roots_are_accurate(void **state)
{
    static const int64_t lengths[] = {1,  2,  3,  4,    5,    6,     7,     8,
                                      12, 16, 97, 1000, 4096, 99991, 100002};
    for (size_t i = 0; i < sizeof lengths / sizeof *lengths; i++) {
        const int64_t n = lengths[i];
        double *root = fill(*state, 2 * n, 0);
        trk_roots_fill(n, root);
        for (int64_t k = 0; k < n; k++) {
            const long double angle = two_pi * (long double)k / (long double)n;
            assert_near(root[2 * k], (double)cosl(angle), 1.2e-16);
            assert_near(root[2 * k + 1], (double)-sinl(angle), 1.2e-16);
        }
        trk_free(*state, root);
    }
}

static trk_status plan_once(trk_context *context)
{
    trk_real_fft *fft = NULL;
    trk_status status = trk_real_fft_create(context, 2 * 331, &trk_fft_kernel_scalar, &fft);
    assert_true((fft == NULL) == (status != TRK_OK));
    trk_real_fft_destroy(fft);
    return status;
}

static void survives_lack_of_memory(void **state)
{
    (void)state;
    support_exhaust_memory(plan_once);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(matches_direct_sum, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(real_equals_complex, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(parseval_and_linearity, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(kernels_agree_bit_by_bit, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(roots_are_accurate, support_setup, support_teardown),
        cmocka_unit_test(survives_lack_of_memory),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
