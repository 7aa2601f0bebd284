/* SPDX-License-Identifier: MIT */
/* Needs LAPACK. Damped modes (LINEAR.2, LINEAR.5). */
#include "models.h"

#include <complex.h>

/* (l^2 M + l C + K) phi = 0 to rounding of the largest l^2, phi^H M phi = 1, the phase. */
static void check_residual(const trk_model *model, const double *v, const trk_modes *modes,
                           int mode)
{
    int n = trk_model_count(model, TRK_PART_COORDINATE);
    double mass[MAXIMUM * MAXIMUM], damping[MAXIMUM * MAXIMUM], stiffness[MAXIMUM * MAXIMUM];
    double re[MAXIMUM], im[MAXIMUM];
    trk_model_get_mass(model, mass);
    trk_model_get_tangent(model, NULL, v, damping, stiffness);
    assert_int_equal(trk_modes_get_shape(modes, mode, re, im), TRK_OK);
    double size = two_pi * trk_modes_frequency(modes, mode);
    double largest = two_pi * trk_modes_frequency(modes, trk_modes_count(modes));
    double complex lambda = -trk_modes_damping_ratio(modes, mode) * size +
                            I * two_pi * trk_modes_damped_frequency(modes, mode);
    double complex norm = 0;
    for (int i = 0; i < n; i++) {
        double complex residual = 0;
        for (int j = 0; j < n; j++) {
            double complex phi = re[j] + I * im[j];
            double m = mass[i * n + j], c = damping[i * n + j], k = stiffness[i * n + j];
            residual += (lambda * lambda * m + lambda * c + k) * phi;
            norm += (re[i] - I * im[i]) * m * phi;
        }
        assert_near(cabs(residual), 0, 1e-12 * largest * largest * sqrt(mass[i * n + i]));
    }
    assert_near(creal(norm), 1, 1e-12);
    assert_near(im[trk_modes_dominant(modes, mode) - 1], 0, 0);
    assert_true(re[trk_modes_dominant(modes, mode) - 1] > 0);
}

static void modes_solve_their_equation(void **state)
{
    trk_context *context = *state;
    for (trk_vehicle vehicle = TRK_VEHICLE_THESIS_QUARTER; vehicle <= TRK_VEHICLE_REFERENCE_TRUCK;
         vehicle++)
        for (trk_variant variant = TRK_VARIANT_LINEAR; variant <= TRK_VARIANT_NONLINEAR;
             variant++) {
            trk_spec *spec;
            assert_ok(context, trk_vehicle_create_builtin(context, vehicle, variant, &spec));
            trk_model *model = compile(context, spec);
            double v[MAXIMUM] = {0.03, 0.07, -0.02}, share[MAXIMUM];
            trk_modes *modes;
            assert_ok(context, trk_modes_create_damped(context, model, NULL, v, &modes));
            int n = trk_model_count(model, TRK_PART_COORDINATE), roots = 0;
            for (int k = 1; k <= trk_modes_count(modes); k++) {
                check_residual(model, v, modes, k);
                roots += trk_modes_damped_frequency(modes, k) > 0 ? 2 : 1;
                assert_true(k == 1 ||
                            trk_modes_frequency(modes, k) >= trk_modes_frequency(modes, k - 1));
                assert_ok(context, trk_modes_get_energy(modes, k, share));
                double total = 0;
                for (int i = 0; i < n; i++)
                    total += share[i];
                assert_near(total, 1, 1e-13);
                assert_string_equal(
                    trk_modes_label(modes, k),
                    trk_model_part_name(model, TRK_PART_COORDINATE, trk_modes_dominant(modes, k)));
            }
            assert_int_equal(roots, 2 * n); /* none lost, none twice */
            trk_modes_destroy(modes);
            trk_model_destroy(model);
        }
}

/* C = a M + b K: ratio (a / w + b w) / 2, undamped frequencies and shapes. */
static void proportional_damping(void **state)
{
    trk_context *context = *state;
    enum { N = 6 };
    const double m = 250, k = 4e5, b = 2e-3;
    trk_spec *spec = chain(context, N, m, b * k, k);
    trk_link_options link;
    trk_link_options_init(&link, sizeof link);
    link.to_body = 1;
    link.stiffness = k;
    link.damping = b * k;
    assert_ok(context, trk_spec_add_link(spec, "ground", &link, NULL));
    trk_model *model = compile(context, spec);
    trk_modes *damped, *undamped;
    assert_ok(context, trk_modes_create_damped(context, model, NULL, NULL, &damped));
    assert_ok(context, trk_modes_create_undamped(context, model, NULL, &undamped));
    assert_int_equal(trk_modes_count(damped), N);
    for (int j = 1; j <= N; j++) {
        /* clamped-free chain */
        double omega = 2 * sqrt(k / m) * sin((2 * j - 1) * two_pi / (4 * (2 * N + 1)));
        double re[N], im[N], phi[N];
        assert_near(trk_modes_frequency(damped, j), omega / two_pi, 1e-11 * omega);
        assert_near(trk_modes_damping_ratio(damped, j), b * omega / 2, 1e-11);
        assert_ok(context, trk_modes_get_shape(damped, j, re, im));
        assert_ok(context, trk_modes_get_shape(undamped, j, phi, NULL));
        for (int i = 0; i < N; i++) {
            assert_near(re[i], phi[i], 1e-11);
            assert_near(im[i], 0, 1e-11);
        }
    }
    trk_modes_destroy(undamped);
    trk_modes_destroy(damped);
    trk_model_destroy(model);
}

/* A free chain: two zero eigenvalues (place and speed of the whole), the others as they are. */
static void free_chain(void **state)
{
    trk_context *context = *state;
    for (int n = 1; n <= 6; n++)
        for (int damped = 0; damped < 2; damped++) {
            const double m = 250, k = 4e5, b = damped * 1e-3;
            trk_model *model = compile(context, chain(context, n, m, b * k, k));
            trk_modes *modes;
            double re[MAXIMUM], im[MAXIMUM];
            assert_ok(context, trk_modes_create_damped(context, model, NULL, NULL, &modes));
            assert_int_equal(trk_modes_count(modes), n + 1);
            for (int j = 1; j <= n + 1; j++) {
                double omega = 2 * sqrt(k / m) * sin((j < 3 ? 0 : j - 2) * two_pi / (4 * n));
                assert_near(trk_modes_frequency(modes, j), omega / two_pi, 1e-11 * omega);
                assert_near(trk_modes_damping_ratio(modes, j), b * omega / 2, 1e-11);
                assert_ok(context, trk_modes_get_shape(modes, j, re, im));
                for (int i = 0; i < n; i++)
                    assert_true(isfinite(re[i]) && isfinite(im[i]));
            }
            trk_modes_destroy(modes);
            trk_model_destroy(model);
        }
}

/* An inverted spring and a damper: m l^2 + c l - k = 0, one growing and one decaying root. */
static void unstable(void **state)
{
    trk_context *context = *state;
    const double m = 100, c = 500, k = 2.25e4;
    trk_spec *spec = chain(context, 1, m, 0, 0);
    trk_link_options link;
    trk_link_options_init(&link, sizeof link);
    link.to_body = 1;
    link.stiffness = -k;
    link.damping = c;
    assert_ok(context, trk_spec_add_link(spec, "inverted", &link, NULL));
    trk_model *model = compile(context, spec);
    trk_modes *modes;
    assert_ok(context, trk_modes_create_damped(context, model, NULL, NULL, &modes));
    double root = sqrt(c * c + 4 * m * k);
    assert_int_equal(trk_modes_count(modes), 2);
    assert_near(trk_modes_frequency(modes, 1), (root - c) / (2 * m) / two_pi, 1e-12);
    assert_near(trk_modes_damping_ratio(modes, 1), -1, 0);
    assert_near(trk_modes_frequency(modes, 2), (root + c) / (2 * m) / two_pi, 1e-12);
    assert_near(trk_modes_damping_ratio(modes, 2), 1, 0);
    trk_modes_destroy(modes);
    trk_model_destroy(model);
}

static void creation_errors(void **state)
{
    trk_context *context = *state;
    trk_model *model = builtin(context, TRK_VEHICLE_THESIS_QUARTER);
    trk_modes *modes = (trk_modes *)state;
    const double bad[] = {INFINITY, 0};
    assert_status(context, trk_modes_create_damped(context, model, bad, NULL, &modes), TRK_E_RANGE);
    assert_null(modes);
    assert_message(context, "displacement of 'sprung.z' is inf");
    assert_status(context, trk_modes_create_damped(context, model, NULL, bad, &modes), TRK_E_RANGE);
    assert_message(context, "velocity of 'sprung.z' is inf");
    assert_status(context, trk_modes_create_damped(context, NULL, NULL, NULL, &modes),
                  TRK_E_ARGUMENT);
    assert_status(context, trk_modes_create_damped(context, model, NULL, NULL, NULL),
                  TRK_E_ARGUMENT);
    assert_int_equal(trk_modes_create_damped(NULL, model, NULL, NULL, &modes), TRK_E_ARGUMENT);
    trk_model_destroy(model);
}

static trk_status work(trk_context *context)
{
    trk_spec *spec;
    trk_model *model = NULL;
    trk_modes *modes = NULL;
    trk_status status =
        trk_vehicle_create_builtin(context, TRK_VEHICLE_THESIS_QUARTER, TRK_VARIANT_LINEAR, &spec);
    if (status == TRK_OK)
        status = trk_model_compile(context, spec, NULL, &model);
    if (status == TRK_OK)
        status = trk_modes_create_damped(context, model, NULL, NULL, &modes);
    assert_true((status == TRK_OK) == (modes != NULL));
    trk_modes_destroy(modes);
    trk_model_destroy(model);
    trk_spec_destroy(spec);
    return status;
}

static void out_of_memory(void **state)
{
    (void)state;
    support_exhaust_memory(work);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(modes_solve_their_equation, support_setup,
                                        support_teardown),
        cmocka_unit_test_setup_teardown(proportional_damping, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(free_chain, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(unstable, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(creation_errors, support_setup, support_teardown),
        cmocka_unit_test(out_of_memory),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
