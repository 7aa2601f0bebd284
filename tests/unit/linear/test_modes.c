/* SPDX-License-Identifier: MIT */
/* Needs LAPACK. Undamped modes (LINEAR.1, LINEAR.4): definition, closed forms, queries. */
#include "models.h"

/* Row i of A times y. */
static double dot(int n, const double *a, int i, const double *y)
{
    double sum = 0;
    for (int j = 0; j < n; j++)
        sum += a[i * n + j] * y[j];
    return sum;
}

/* K phi = w^2 M phi row by row; phi_j^T M phi_k = delta_jk. */
static void modes_solve_their_equation(void **state)
{
    trk_context *context = *state;
    trk_model *model = builtin(context, TRK_VEHICLE_REFERENCE_TRUCK);
    enum { N = 13 };
    double mass[N * N], stiffness[N * N], phi[N][N], none[N];
    trk_model_get_mass(model, mass);
    trk_model_get_tangent(model, NULL, NULL, NULL, stiffness);
    trk_modes *modes;
    assert_ok(context, trk_modes_create_undamped(context, model, NULL, &modes));
    assert_int_equal(trk_modes_count(modes), N);
    double largest = two_pi * trk_modes_frequency(modes, N);
    for (int k = 0; k < N; k++) {
        assert_ok(context, trk_modes_get_shape(modes, k + 1, phi[k], none));
        double omega = two_pi * trk_modes_frequency(modes, k + 1);
        for (int i = 0; i < N; i++) {
            double residual =
                dot(N, stiffness, i, phi[k]) - omega * omega * dot(N, mass, i, phi[k]);
            assert_near(residual, 0, 1e-13 * largest * largest * sqrt(mass[i * N + i]));
            assert_near(none[i], 0, 0);
        }
        for (int j = 0; j <= k; j++) {
            double sum = 0;
            for (int i = 0; i < N; i++)
                sum += phi[j][i] * dot(N, mass, i, phi[k]);
            assert_near(sum, j == k, 1e-12);
        }
        assert_near(trk_modes_damping_ratio(modes, k + 1), 0, 0);
        assert_near(trk_modes_damped_frequency(modes, k + 1), trk_modes_frequency(modes, k + 1), 0);
    }
    trk_modes_destroy(modes);
    trk_model_destroy(model);
}

/* M is diagonal: the share of a coordinate is m_i phi_i^2. The label names the largest. */
static void energy_and_labels(void **state)
{
    trk_context *context = *state;
    trk_model *model = builtin(context, TRK_VEHICLE_REFERENCE_TRUCK);
    enum { N = 13 };
    double mass[N * N], phi[N], share[N];
    trk_model_get_mass(model, mass);
    trk_modes *modes;
    assert_ok(context, trk_modes_create_undamped(context, model, NULL, &modes));
    for (int k = 1; k <= N; k++) {
        assert_ok(context, trk_modes_get_shape(modes, k, phi, NULL));
        assert_ok(context, trk_modes_get_energy(modes, k, share));
        double total = 0;
        int most = 0;
        for (int i = 0; i < N; i++) {
            assert_near(share[i], mass[i * N + i] * phi[i] * phi[i], 1e-13);
            total += share[i];
            most = share[i] > share[most] ? i : most;
        }
        assert_near(total, 1, 1e-14);
        assert_int_equal(trk_modes_dominant(modes, k), most + 1);
        assert_true(phi[most] > 0);
        assert_string_equal(trk_modes_label(modes, k),
                            trk_model_part_name(model, TRK_PART_COORDINATE, most + 1));
    }
    trk_model_destroy(model); /* the labels are the modes' own */
    assert_string_equal(trk_modes_label(modes, 13), "front_axle.roll");
    trk_modes_destroy(modes);
}

/* w_j = 2 sqrt(k/m) sin(j pi / 2n), j = 0 .. n - 1; the chain as a whole does not swing. */
static void free_chain(void **state)
{
    trk_context *context = *state;
    for (int n = 1; n <= 8; n++) {
        trk_model *model = compile(context, chain(context, n, 250, 0, 4e5));
        trk_modes *modes;
        double phi[MAXIMUM], share[MAXIMUM];
        assert_ok(context, trk_modes_create_undamped(context, model, NULL, &modes));
        assert_near(trk_modes_frequency(modes, 1), 0, 0);
        assert_near(trk_modes_damping_ratio(modes, 1), 0, 0);
        for (int j = 0; j < n; j++) {
            double f = 2 * sqrt(4e5 / 250) * sin(j * two_pi / (4 * n)) / two_pi;
            assert_near(trk_modes_frequency(modes, j + 1), f, 1e-12 * f);
            assert_ok(context, trk_modes_get_shape(modes, j + 1, phi, NULL));
            assert_ok(context, trk_modes_get_energy(modes, j + 1, share));
            for (int i = 0; i < n; i++) {
                assert_true(isfinite(phi[i]) && isfinite(share[i]));
                if (j == 0)
                    assert_near(phi[i], 1 / sqrt(250.0 * n), 1e-14);
            }
        }
        trk_modes_destroy(modes);
        trk_model_destroy(model);
    }
}

/* Three equal oscillators: one frequency three times, shapes still orthonormal. */
static void repeated_eigenvalues(void **state)
{
    trk_context *context = *state;
    enum { N = 3 };
    trk_spec *spec = chain(context, N, 100, 0, 0);
    trk_link_options link;
    trk_link_options_init(&link, sizeof link);
    link.stiffness = 9e4;
    for (link.to_body = 1; link.to_body <= N; link.to_body++) {
        char name[] = {(char)('0' + link.to_body), '\0'};
        assert_ok(context, trk_spec_add_link(spec, name, &link, NULL));
    }
    trk_model *model = compile(context, spec);
    trk_modes *modes;
    double phi[N][N];
    assert_ok(context, trk_modes_create_undamped(context, model, NULL, &modes));
    for (int k = 0; k < N; k++) {
        assert_near(trk_modes_frequency(modes, k + 1), 30 / two_pi, 1e-13);
        assert_ok(context, trk_modes_get_shape(modes, k + 1, phi[k], NULL));
        for (int j = 0; j <= k; j++) {
            double sum = 0;
            for (int i = 0; i < N; i++)
                sum += 100 * phi[j][i] * phi[k][i];
            assert_near(sum, j == k, 1e-13);
        }
    }
    trk_modes_destroy(modes);
    trk_model_destroy(model);
}

/* A spring of negative stiffness: omega^2 = -k/m. */
static void falling_over(void **state)
{
    trk_context *context = *state;
    trk_spec *spec = chain(context, 2, 100, 0, 1);
    trk_link_options link;
    trk_link_options_init(&link, sizeof link);
    link.to_body = 1;
    link.stiffness = -2.25e4;
    assert_ok(context, trk_spec_add_link(spec, "inverted", &link, NULL));
    link.to_body = 2;
    link.stiffness = 4e6;
    assert_ok(context, trk_spec_add_link(spec, "held", &link, NULL));
    trk_model *model = compile(context, spec);
    trk_modes *modes;
    assert_ok(context, trk_modes_create_undamped(context, model, NULL, &modes));
    assert_near(trk_modes_frequency(modes, 1), -15 / two_pi, 1e-3);
    assert_near(trk_modes_frequency(modes, 2), 200 / two_pi, 1e-3);
    trk_modes_destroy(modes);
    trk_model_destroy(model);
}

/* A curve's slope at the working point is the stiffness. */
static void working_point(void **state)
{
    trk_context *context = *state;
    const double x[] = {-1, 0, 1, 2}, y[] = {1e4, 0, 1e4, 4e4}; /* 1e4 x^2 */
    trk_curve_options exact;
    trk_curve_options_init(&exact, sizeof exact);
    exact.interpolation = TRK_INTERPOLATION_NOT_A_KNOT;
    trk_curve *curve;
    assert_ok(context, trk_curve_create(context, "parabola", 4, x, y, &exact, &curve));
    trk_spec *spec = chain(context, 1, 100, 0, 0);
    trk_link_options link;
    trk_link_options_init(&link, sizeof link);
    link.to_body = 1;
    link.spring_curve = curve;
    assert_ok(context, trk_spec_add_link(spec, "spring", &link, NULL));
    trk_curve_destroy(curve);
    trk_model *model = compile(context, spec);
    for (double q = 0.25; q < 2; q += 0.25) {
        trk_modes *modes;
        assert_ok(context, trk_modes_create_undamped(context, model, &q, &modes));
        assert_near(trk_modes_frequency(modes, 1), sqrt(2e4 * q / 100) / two_pi, 1e-12);
        trk_modes_destroy(modes);
    }
    trk_model_destroy(model);
}

static void no_such_mode(void **state)
{
    trk_context *context = *state;
    trk_model *model = builtin(context, TRK_VEHICLE_THESIS_QUARTER);
    trk_modes *modes;
    double values[2];
    assert_ok(context, trk_modes_create_undamped(context, model, NULL, &modes));
    const struct {
        trk_modes *modes;
        int32_t mode;
    } wrong[] = {{modes, 0}, {modes, 3}, {modes, -1}, {NULL, 1}};
    for (size_t k = 0; k < sizeof wrong / sizeof *wrong; k++) {
        assert_true(isnan(trk_modes_frequency(wrong[k].modes, wrong[k].mode)));
        assert_true(isnan(trk_modes_damped_frequency(wrong[k].modes, wrong[k].mode)));
        assert_true(isnan(trk_modes_damping_ratio(wrong[k].modes, wrong[k].mode)));
        assert_int_equal(trk_modes_get_shape(wrong[k].modes, wrong[k].mode, values, values),
                         TRK_E_ARGUMENT);
        assert_int_equal(trk_modes_get_energy(wrong[k].modes, wrong[k].mode, values),
                         TRK_E_ARGUMENT);
        assert_int_equal(trk_modes_dominant(wrong[k].modes, wrong[k].mode), 0);
        assert_null(trk_modes_label(wrong[k].modes, wrong[k].mode));
    }
    assert_int_equal(trk_modes_get_energy(modes, 1, NULL), TRK_E_ARGUMENT);
    assert_int_equal(trk_modes_count(NULL), 0);
    assert_int_equal(trk_modes_get_shape(modes, 1, NULL, NULL), TRK_OK);
    trk_modes_destroy(NULL);
    trk_modes_destroy(modes);
    trk_model_destroy(model);
}

static void creation_errors(void **state)
{
    trk_context *context = *state;
    trk_model *model = builtin(context, TRK_VEHICLE_THESIS_QUARTER);
    trk_modes *modes = (trk_modes *)state;
    const double bad[] = {0, NAN};
    assert_status(context, trk_modes_create_undamped(context, model, bad, &modes), TRK_E_RANGE);
    assert_null(modes);
    assert_message(context, "displacement of 'unsprung.z' is nan");
    assert_status(context, trk_modes_create_undamped(context, NULL, NULL, &modes), TRK_E_ARGUMENT);
    assert_status(context, trk_modes_create_undamped(context, model, NULL, NULL), TRK_E_ARGUMENT);
    assert_int_equal(trk_modes_create_undamped(NULL, model, NULL, &modes), TRK_E_ARGUMENT);
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
        status = trk_modes_create_undamped(context, model, NULL, &modes);
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
        cmocka_unit_test_setup_teardown(energy_and_labels, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(free_chain, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(repeated_eigenvalues, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(falling_over, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(working_point, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(no_such_mode, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(creation_errors, support_setup, support_teardown),
        cmocka_unit_test(out_of_memory),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
