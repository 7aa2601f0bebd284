/* SPDX-License-Identifier: MIT */
/* Tangents (MODEL.4) against central differences of B^T f(B q, B v) at random states. */
#include "support.h"

#include <truckride/model.h>
#include <truckride/vehicle.h>

enum { MOST = 60, N = 13 };

static uint32_t seed = 3;

static double random_number(double size)
{
    seed = seed * 1664525u + 1013904223u;
    return size * ((double)(seed >> 8) / (1 << 24) * 2 - 1);
}

typedef struct rows {
    int32_t links;
    double b[MOST][N];
} rows;

static void generalized_force(const trk_model *model, const rows *r, const double *q,
                              const double *v, double *out)
{
    double e[MOST] = {0}, rate[MOST] = {0}, force[MOST];
    for (int32_t k = 0; k < r->links; k++)
        for (int i = 0; i < N; i++) {
            e[k] += r->b[k][i] * q[i];
            rate[k] += r->b[k][i] * v[i];
        }
    trk_model_get_link_force(model, e, rate, force);
    memset(out, 0, N * sizeof *out);
    for (int32_t k = 0; k < r->links; k++)
        for (int i = 0; i < N; i++)
            out[i] += r->b[k][i] * force[k];
}

/* Column j of the derivative with respect to x, which is q or v. */
static void difference(const trk_model *model, const rows *r, const double *q, const double *v,
                       double *x, int j, double *out)
{
    const double h = 1e-6;
    double less[N], keep = x[j];
    x[j] = keep + h;
    generalized_force(model, r, q, v, out);
    x[j] = keep - h;
    generalized_force(model, r, q, v, less);
    x[j] = keep;
    for (int i = 0; i < N; i++)
        out[i] = (out[i] - less[i]) / (2 * h);
}

static void check_state(const trk_model *model, const rows *r, double *q, double *v)
{
    double c[N * N], k[N * N], column[N], k_size = 0, c_size = 0;
    trk_model_get_tangent(model, q, v, c, k);
    for (int i = 0; i < N * N; i++) {
        k_size = fmax(k_size, fabs(k[i]));
        c_size = fmax(c_size, fabs(c[i]));
    }
    for (int j = 0; j < N; j++) {
        difference(model, r, q, v, q, j, column);
        for (int i = 0; i < N; i++)
            assert_near(k[N * i + j], column[i], 1e-5 * k_size);
        difference(model, r, q, v, v, j, column);
        for (int i = 0; i < N; i++)
            assert_near(c[N * i + j], column[i], 1e-5 * c_size);
        for (int i = 0; i < N; i++) {
            assert_near(k[N * i + j], k[N * j + i], 1e-15 * k_size);
            assert_near(c[N * i + j], c[N * j + i], 1e-15 * c_size);
        }
    }
}

static void tangents_are_derivatives(void **state)
{
    for (int gravity = 0; gravity < 2; gravity++) {
        trk_spec *spec;
        trk_model *model;
        trk_model_options options;
        trk_model_options_init(&options, sizeof options);
        options.gravity = gravity * TRK_STANDARD_GRAVITY;
        assert_ok(*state, trk_vehicle_create_builtin(*state, TRK_VEHICLE_REFERENCE_TRUCK,
                                                     TRK_VARIANT_NONLINEAR, &spec));
        assert_ok(*state, trk_model_compile(*state, spec, &options, &model));
        assert_int_equal(trk_model_count(model, TRK_PART_COORDINATE), N);
        rows r = {.links = trk_model_count(model, TRK_PART_LINK)};
        assert_in_range(r.links, 1, MOST);
        for (int32_t k = 0; k < r.links; k++)
            assert_ok(*state, trk_model_get_link_row(model, k + 1, r.b[k], NULL));
        for (int round = 0; round < 25; round++) {
            double q[N], v[N];
            trk_model_get_static(model, q, NULL);
            for (int i = 0; i < N; i++) {
                q[i] += random_number(0.02);
                v[i] = random_number(0.3);
            }
            check_state(model, &r, q, v);
        }
        trk_model_destroy(model);
        trk_spec_destroy(spec);
    }
}

static void null_means_static_equilibrium_at_rest(void **state)
{
    trk_spec *spec;
    trk_model *model;
    trk_model_options options;
    trk_model_options_init(&options, sizeof options);
    options.gravity = TRK_STANDARD_GRAVITY;
    assert_ok(*state, trk_vehicle_create_builtin(*state, TRK_VEHICLE_REFERENCE_TRUCK,
                                                 TRK_VARIANT_NONLINEAR, &spec));
    assert_ok(*state, trk_model_compile(*state, spec, &options, &model));
    double q[N], v[N] = {0}, c[2][N * N], k[2][N * N];
    trk_model_get_static(model, q, NULL);
    trk_model_get_tangent(model, q, v, c[0], k[0]);
    trk_model_get_tangent(model, NULL, NULL, c[1], k[1]);
    assert_memory_equal(c[0], c[1], sizeof c[0]);
    assert_memory_equal(k[0], k[1], sizeof k[0]);
    trk_model_get_tangent(model, NULL, NULL, NULL, k[1]);
    assert_memory_equal(k[0], k[1], sizeof k[0]);
    trk_model_get_tangent(model, NULL, NULL, NULL, NULL);
    trk_model_destroy(model);
    trk_spec_destroy(spec);
}

#define TEST(f) cmocka_unit_test_setup_teardown(f, support_setup, support_teardown)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(tangents_are_derivatives),
        TEST(null_means_static_equilibrium_at_rest),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
