/* SPDX-License-Identifier: MIT */
/* Needs LAPACK. Eigenfrequencies against hand-made matrices, closed forms and symmetry. */
#include "hand.h"

#include <truckride/linear.h>

static const double two_pi = 6.283185307179586476925286766559;

static trk_model *compile(trk_context *context, trk_spec *spec)
{
    trk_model *model;
    assert_ok(context, trk_model_compile(context, spec, NULL, &model));
    trk_spec_destroy(spec);
    return model;
}

/* Undamped frequencies [Hz] of the model of a spec; both are destroyed. Returns their number. */
static int frequencies(trk_context *context, trk_spec *spec, double *out)
{
    trk_model *model = compile(context, spec);
    trk_modes *modes;
    assert_ok(context, trk_modes_create_undamped(context, model, NULL, &modes));
    int count = trk_modes_count(modes);
    for (int k = 0; k < count; k++)
        out[k] = trk_modes_frequency(modes, k + 1);
    trk_modes_destroy(modes);
    trk_model_destroy(model);
    return count;
}

static int by_value(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return x < y ? -1 : x > y;
}

/* One Jacobi rotation that zeroes a[p][q]. */
static void rotate(int n, hand_matrix a, int p, int q)
{
    double theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
    double t = copysign(1, theta) / (fabs(theta) + sqrt(theta * theta + 1));
    double c = 1 / sqrt(t * t + 1), s = t * c;
    for (int k = 0; k < n; k++) {
        double x = a[k][p], y = a[k][q];
        a[k][p] = c * x - s * y;
        a[k][q] = s * x + c * y;
    }
    for (int k = 0; k < n; k++) {
        double x = a[p][k], y = a[q][k];
        a[p][k] = c * x - s * y;
        a[q][k] = s * x + c * y;
    }
}

/* Frequencies of K phi = w^2 diag(m) phi by Jacobi's method, without LAPACK. K is destroyed. */
static void jacobi_frequencies(int n, hand_matrix k, const double *m, double *out)
{
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++)
            k[i][j] /= sqrt(m[i] * m[j]);
    for (int sweep = 0; sweep < 20; sweep++)
        for (int p = 0; p < n; p++)
            for (int q = p + 1; q < n; q++)
                if (k[p][q] != 0)
                    rotate(n, k, p, q);
    for (int i = 0; i < n; i++)
        out[i] = sqrt(k[i][i]) / two_pi;
    qsort(out, (size_t)n, sizeof *out, by_value);
}

/* Antisymmetric half of a symmetric truck's V: cab y, roll, yaw; frame roll; axles' roll. */
static void antisymmetric(const trk_truck_parameters *p, double *out)
{
    enum { Y, ROLL, YAW, FRAME, AXLE, COUNT = AXLE + 2 };
    hand_matrix k = {{0}};
    for (int e = 0; e < 2; e++) {
        double v = 2 * p->cab_vertical_stiffness[2 * e] * p->cab_mount_y[e] * p->cab_mount_y[e];
        double l = 2 * p->cab_longitudinal_stiffness[2 * e];
        double t = 2 * p->cab_lateral_stiffness[2 * e];
        double a = p->cab_lateral_x[e] - p->cab_cg[0], h = p->cab_lateral_z[e] - p->cab_cg[2];
        double H = p->cab_lateral_z[e] - p->frame_cg[2];
        double s = 2 * p->spring_stiffness[e] * p->spring_y[e] * p->spring_y[e] +
                   p->anti_roll_stiffness[e];
        hand_add(k, Y, Y, t);
        hand_add(k, Y, ROLL, -t * h);
        hand_add(k, Y, YAW, t * a);
        hand_add(k, Y, FRAME, t * H);
        hand_add(k, ROLL, ROLL, v + t * h * h);
        hand_add(k, ROLL, YAW, -t * h * a);
        hand_add(k, ROLL, FRAME, -v - t * h * H);
        hand_add(k, YAW, YAW, t * a * a + l * p->cab_longitudinal_y[e] * p->cab_longitudinal_y[e]);
        hand_add(k, YAW, FRAME, t * a * H);
        hand_add(k, FRAME, FRAME, v + t * H * H + s);
        hand_add(k, FRAME, AXLE + e, -s);
        hand_add(k, AXLE + e, AXLE + e, s + 2 * p->tire_stiffness[e] * p->tire_y[e] * p->tire_y[e]);
    }
    hand_add(k, ROLL, ROLL, p->cab_anti_roll_stiffness);
    hand_add(k, ROLL, FRAME, -p->cab_anti_roll_stiffness);
    hand_add(k, FRAME, FRAME, p->cab_anti_roll_stiffness);
    const double m[COUNT] = {p->cab_mass,         p->cab_inertia[0],       p->cab_inertia[2],
                             p->frame_inertia[0], p->axle_roll_inertia[0], p->axle_roll_inertia[1]};
    jacobi_frequencies(COUNT, k, m, out);
}

/* The 13 modes of a symmetric truck: the half truck's seven and six antisymmetric ones. */
static void truck_is_half_truck_and_antisymmetric_part(void **state)
{
    trk_context *context = *state;
    for (int bar = 0; bar < 2; bar++) {
        trk_truck_parameters p;
        trk_truck_parameters_init(&p, sizeof p);
        p.cab_anti_roll_stiffness = bar * 30e3;
        trk_spec *half, *full;
        double parts[13], whole[13];
        assert_ok(context, trk_vehicle_create_half_truck(context, &p, &half));
        assert_ok(context, trk_vehicle_create_truck(context, &p, &full));
        assert_int_equal(frequencies(context, half, parts), 7);
        assert_int_equal(frequencies(context, full, whole), 13);
        antisymmetric(&p, parts + 7);
        qsort(parts, 13, sizeof *parts, by_value);
        for (int k = 0; k < 13; k++)
            assert_near(whole[k], parts[k], 1e-10 * parts[k]);
    }
}

/* The thesis's untrimmed models hop at 6.8 to 7 Hz; so does the reference tractor. */
static void axle_hop(void **state)
{
    trk_context *context = *state;
    trk_spec *spec;
    assert_ok(context, trk_vehicle_create_builtin(context, TRK_VEHICLE_REFERENCE_HALF,
                                                  TRK_VARIANT_LINEAR, &spec));
    trk_model *model = compile(context, spec);
    trk_modes *modes;
    assert_ok(context, trk_modes_create_undamped(context, model, NULL, &modes));
    assert_string_equal(trk_modes_label(modes, 6), "front_axle.z");
    assert_string_equal(trk_modes_label(modes, 7), "rear_axle.z");
    assert_near(trk_modes_frequency(modes, 6), 7.05, 0.005);
    assert_near(trk_modes_frequency(modes, 7), 7.15, 0.005);
    trk_modes_destroy(modes);
    trk_model_destroy(model);
}

/* m_s m_u w^4 - (m_s (k_s + k_t) + m_u k_s) w^2 + k_s k_t = 0 */
static void quarter_car_closed_form(void **state)
{
    trk_context *context = *state;
    trk_quarter_car_parameters p;
    trk_quarter_car_parameters_init(&p, sizeof p);
    for (double factor = 0.01; factor < 200; factor *= 10) {
        p.spring_stiffness = 500e3 * factor;
        double a = p.sprung_mass * p.unsprung_mass, c = p.spring_stiffness * p.tire_stiffness;
        double b = p.sprung_mass * (p.spring_stiffness + p.tire_stiffness) +
                   p.unsprung_mass * p.spring_stiffness;
        double high = (b + sqrt(b * b - 4 * a * c)) / (2 * a), low = c / (a * high), f[2];
        trk_spec *spec;
        assert_ok(context, trk_vehicle_create_quarter_car(context, &p, &spec));
        assert_int_equal(frequencies(context, spec, f), 2);
        assert_near(f[0], sqrt(low) / two_pi, 1e-12 * f[1]);
        assert_near(f[1], sqrt(high) / two_pi, 1e-12 * f[1]);
    }
}

/* A mass on one spring and damper. */
static trk_model *oscillator(trk_context *context, double mass, double damping, double stiffness)
{
    trk_spec *spec;
    assert_ok(context, trk_spec_create(context, "oscillator", &spec));
    trk_body_options body;
    trk_link_options link;
    trk_body_options_init(&body, sizeof body);
    trk_link_options_init(&link, sizeof link);
    body.mass = mass;
    link.stiffness = stiffness;
    link.damping = damping;
    assert_ok(context, trk_spec_add_body(spec, "mass", &body, &link.to_body));
    assert_ok(context, trk_spec_add_link(spec, "spring", &link, NULL));
    return compile(context, spec);
}

/* lambda = -D w0 +- i w0 sqrt(1 - D^2), and two real values for D > 1. */
static void damped_oscillator(void **state)
{
    trk_context *context = *state;
    const double m = 250, k = 4e5, w0 = sqrt(k / m);
    const double ratio[] = {0, 1e-3, 0.2, 0.9, 1.5, 40};
    for (size_t i = 0; i < sizeof ratio / sizeof *ratio; i++) {
        double D = ratio[i];
        trk_model *model = oscillator(context, m, 2 * D * m * w0, k);
        trk_modes *modes;
        assert_ok(context, trk_modes_create_damped(context, model, NULL, NULL, &modes));
        if (D < 1) {
            assert_int_equal(trk_modes_count(modes), 1);
            assert_near(trk_modes_frequency(modes, 1), w0 / two_pi, 1e-12 * w0);
            assert_near(trk_modes_damped_frequency(modes, 1), w0 * sqrt(1 - D * D) / two_pi,
                        1e-12 * w0);
            assert_near(trk_modes_damping_ratio(modes, 1), D, 1e-13);
        } else {
            double fast = w0 * (D + sqrt(D * D - 1)), slow = w0 * w0 / fast;
            assert_int_equal(trk_modes_count(modes), 2);
            assert_near(trk_modes_frequency(modes, 1), slow / two_pi, 1e-13 * fast);
            assert_near(trk_modes_frequency(modes, 2), fast / two_pi, 1e-13 * fast);
            for (int mode = 1; mode <= 2; mode++) {
                assert_near(trk_modes_damped_frequency(modes, mode), 0, 0);
                assert_near(trk_modes_damping_ratio(modes, mode), 1, 0);
            }
        }
        trk_modes_destroy(modes);
        trk_model_destroy(model);
    }
}

static void scale(double *values, int count, double factor)
{
    for (int k = 0; k < count; k++)
        values[k] *= factor;
}

/* Tonnes and kN instead of kg and N, or a truck a thousand times heavier and stiffer. */
static void mass_and_stiffness_scale_out(void **state)
{
    trk_context *context = *state;
    double before[13], after[13];
    for (int step = 0; step < 2; step++) {
        double factor = step == 0 ? 1e3 : 1e-3;
        trk_truck_parameters p;
        trk_truck_parameters_init(&p, sizeof p);
        trk_spec *spec;
        assert_ok(context, trk_vehicle_create_truck(context, &p, &spec));
        frequencies(context, spec, before);
        p.cab_mass *= factor;
        p.frame_mass *= factor;
        scale(p.cab_inertia, 3, factor);
        scale(p.frame_inertia, 3, factor);
        double *pairs[] = {p.axle_mass, p.axle_roll_inertia, p.tire_stiffness, p.spring_stiffness,
                           p.anti_roll_stiffness};
        for (size_t k = 0; k < sizeof pairs / sizeof *pairs; k++)
            scale(pairs[k], 2, factor);
        scale(p.cab_vertical_stiffness, 4, factor);
        scale(p.cab_longitudinal_stiffness, 4, factor);
        scale(p.cab_lateral_stiffness, 4, factor);
        assert_ok(context, trk_vehicle_create_truck(context, &p, &spec));
        frequencies(context, spec, after);
        for (int k = 0; k < 13; k++)
            assert_near(after[k], before[k], 1e-11 * before[k]);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(truck_is_half_truck_and_antisymmetric_part, support_setup,
                                        support_teardown),
        cmocka_unit_test_setup_teardown(axle_hop, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(quarter_car_closed_form, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(damped_oscillator, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(mass_and_stiffness_scale_out, support_setup,
                                        support_teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
