/* SPDX-License-Identifier: MIT */
/* The stepper on one mass: exact solutions of the difference equations, orders, spectral radii. */
#include "linalg/small.h"
#include "support.h"
#include "vehicles.h"

#include <complex.h>

static const double pi = 3.14159265358979323846;

/* Stepper on m q'' + c q' + k q = 0 with m = 1, from q = 1, v = 0. */
typedef struct oscillator {
    trk_model *model;
    trk_newmark *stepper;
} oscillator;

static oscillator start(trk_context *context, double w, double damping_ratio,
                        const trk_newmark_options *options)
{
    oscillator o;
    o.model = support_oscillator(context, 1, w * w, 2 * damping_ratio * w);
    assert_ok(context, trk_newmark_create(context, o.model, options, &o.stepper));
    const double q = 1, v = 0;
    assert_ok(context, trk_newmark_set_state(o.stepper, 0, &q, &v, NULL, NULL, NULL));
    return o;
}

static void step(trk_context *context, const oscillator *o, double *q, double *v)
{
    assert_ok(context, trk_newmark_step(o->stepper, NULL, NULL, NULL));
    trk_newmark_get_state(o->stepper, q, v, NULL);
}

static void stop(oscillator *o)
{
    trk_newmark_destroy(o->stepper);
    trk_model_destroy(o->model);
}

/* q_k = cos(w_n k h), w_n = (2 / h) atan(w h / 2), and constant energy (NEWMARK.8, NEWMARK.9). */
static void test_undamped(void **state)
{
    const double w = 2 * pi * 1.3, h = 0.01;
    trk_newmark_options options;
    support_method(0, h, &options);
    oscillator o = start(*state, w, 0, &options);
    double phase = 2 * atan(w * h / 2), off = 0, drift = 0, q, v;
    for (int k = 1; k <= 100000; k++) {
        step(*state, &o, &q, &v);
        off = fmax(off, fabs(q - cos(phase * k)));
        off = fmax(off, fabs(v / w + sin(phase * k)));
        drift = fmax(drift, fabs((v * v + w * w * q * q) / (w * w) - 1));
    }
    print_message("undamped, 1e5 steps: off cos(w_n t) %.2g, energy drift %.2g\n", off, drift);
    assert_true(off < 1e-11);
    assert_true(drift < 1e-12);
    stop(&o);
}

/* With damping a step multiplies mode lambda by (1 + h lambda/2) / (1 - h lambda/2). */
static void test_damped(void **state)
{
    const double w = 2 * pi * 1.3, ratio = 0.02, h = 0.01;
    trk_newmark_options options;
    support_method(0, h, &options);
    oscillator o = start(*state, w, ratio, &options);
    double wd = w * sqrt(1 - ratio * ratio), off = 0, q, v;
    double complex lambda = -ratio * w + I * wd, mode = 1 - I * ratio * w / wd;
    double complex mu = (1 + h * lambda / 2) / (1 - h * lambda / 2);
    for (int k = 1; k <= 10000; k++) {
        step(*state, &o, &q, &v);
        mode *= mu;
        off = fmax(off, fabs(q - creal(mode)));
        off = fmax(off, fabs(v - creal(lambda * mode)) / w);
    }
    print_message("damped: off the exact difference solution %.2g\n", off);
    assert_true(off < 1e-13);
    stop(&o);
}

/* Any beta, gamma: q_{k+1} - 2 tau q_k + delta q_{k-1} = 0 (NEWMARK.8). */
static void test_adams(void **state)
{
    const double w = 2 * pi * 1.3, h = 0.01, x = w * h;
    trk_newmark_options options;
    support_method(1, h, &options);
    assert_true(options.beta == 0.36 && options.gamma == 0.7 && options.alpha_f == 0);
    oscillator o = start(*state, w, 0, &options);
    double d = 1 + options.beta * x * x, tau = 1 - x * x / 2 * (options.gamma + 0.5) / d,
           delta = 1 - x * x * (options.gamma - 0.5) / d;
    double before = 1, now = (1 - x * x * (0.5 - options.beta)) / d, off = 0, q, v;
    for (int k = 1; k <= 2000; k++) {
        step(*state, &o, &q, &v);
        off = fmax(off, fabs(q - now));
        double next = 2 * tau * now - delta * before;
        before = now;
        now = next;
    }
    double damping = -log(delta) / 2 / atan2(sqrt(delta - tau * tau), tau);
    print_message(
        "Adams: off the exact difference solution %.2g; damping ratio %.5f, first order %.5f\n",
        off, damping, (options.gamma - 0.5) * x / 2);
    assert_true(off < 1e-13);
    assert_near(damping, (options.gamma - 0.5) * x / 2, 0.02 * damping);
    stop(&o);
}

/* Largest errors over the second of two periods: of q and v; of a; of a against an earlier time. */
enum { MOTION, ACCELERATION, SHIFTED, ERRORS };

static void find_errors(trk_context *context, int method, int64_t steps, double *out)
{
    const double w = 2 * pi, h = 2.0 / (double)steps;
    trk_newmark_options options;
    support_method(method, h, &options);
    oscillator o = start(context, w, 0, &options);
    double shift = (options.alpha_f - options.alpha_m) * h, q, v, a;
    memset(out, 0, ERRORS * sizeof *out);
    for (int64_t k = 1; k <= steps; k++) {
        step(context, &o, &q, &v);
        if (k < steps / 2)
            continue; /* until the run has forgotten that a_0 belongs to its own time */
        trk_newmark_get_state(o.stepper, NULL, NULL, &a);
        double t = (double)k * h;
        out[MOTION] = fmax(out[MOTION], fmax(fabs(q - cos(w * t)), fabs(v / w + sin(w * t))));
        out[ACCELERATION] = fmax(out[ACCELERATION], fabs(a / (w * w) + cos(w * t)));
        out[SHIFTED] = fmax(out[SHIFTED], fabs(a / (w * w) + cos(w * (t - shift))));
    }
    stop(&o);
}

/* Orders, those of the acceleration by (NEWMARK.11). */
static void test_orders(void **state)
{
    const double wanted[SUPPORT_METHODS][ERRORS] = {{2, 2, 2}, {1, 1, 1}, {2, 1, 2}, {2, 1, 2}};
    print_message("%-24s %10s %10s %6s %10s %6s %10s %6s\n", "method", "h [s]", "q, v", "order",
                  "a", "order", "a shifted", "order");
    for (int method = 0; method < SUPPORT_METHODS; method++) {
        double error[ERRORS], before[ERRORS] = {0}, order[ERRORS];
        for (int64_t steps = 2000; steps <= 32000; steps *= 2) {
            find_errors(*state, method, steps, error);
            print_message("%-24s %10.3g", support_method_name(method), 2.0 / (double)steps);
            for (int k = 0; k < ERRORS; k++) {
                order[k] = log2(before[k] / error[k]);
                print_message(" %10.3g %6.3f", error[k], steps > 2000 ? order[k] : NAN);
            }
            print_message("\n");
            memcpy(before, error, sizeof error);
        }
        for (int k = 0; k < ERRORS; k++)
            assert_near(order[k], wanted[method][k], 0.01);
    }
}

/* Coefficients of q_{k+3} = c2 q_{k+2} + c1 q_{k+1} + c0 q_k, from the run itself. */
static void recurrence(trk_context *context, const trk_newmark_options *options, double *out)
{
    oscillator o = start(context, 1e3 / options->step, 0, options);
    double q[6], v, matrix[9];
    q[0] = 1;
    for (int k = 1; k < 6; k++)
        step(context, &o, &q[k], &v);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            matrix[3 * i + j] = q[i + j];
    memcpy(out, q + 3, 3 * sizeof *out);
    assert_true(trk_small_solve(3, matrix, out));
    stop(&o);
}

/* At w h = 1e3 the characteristic polynomial is (NEWMARK.10) up to terms of 1e-6. */
static void test_spectral_radius(void **state)
{
    for (int k = 0; k < 6; k++) {
        trk_newmark_options options;
        support_method(0, 1e-3, &options);
        double rho, sigma, c[3];
        if (k < 3) {
            double alpha = -0.1 * (k + 1);
            trk_newmark_options_hht(&options, alpha);
            rho = (1 + alpha) / (1 - alpha);
            sigma = -alpha / (1 + alpha);
        } else {
            rho = sigma = 0.3 * (k - 2);
            trk_newmark_options_generalized_alpha(&options, rho);
        }
        recurrence(*state, &options, c);
        print_message(
            "alpha_f %.4f alpha_m %.4f: polynomial z^3 + %.6f z^2 + %.6f z + %.6f, rho %.4f\n",
            options.alpha_f, options.alpha_m, -c[2], -c[1], -c[0], rho);
        assert_near(-c[2], 2 * rho + sigma, 2e-5);
        assert_near(-c[1], rho * (rho + 2 * sigma), 2e-5);
        assert_near(-c[0], rho * rho * sigma, 2e-5);
    }
}

/* rho = 0: a mode that the step cannot resolve is gone after three steps. */
static void test_annihilation(void **state)
{
    trk_newmark_options options;
    support_method(0, 1e-3, &options);
    trk_newmark_options_generalized_alpha(&options, 0);
    oscillator o = start(*state, 1e6, 0, &options);
    double q = 1, v;
    for (int k = 0; k < 3; k++)
        step(*state, &o, &q, &v);
    assert_near(q, 0, 1e-5); /* w h = 1e3: terms of 1e-6 are left */
    stop(&o);
}

/* The named methods are those of the literature. */
static void test_named_methods(void **state)
{
    (void)state;
    trk_newmark_options a, b;
    support_method(0, 1e-3, &a);
    trk_newmark_options_hht(&a, 0);
    assert_true(a.beta == 0.25 && a.gamma == 0.5 && a.alpha_f == 0 && a.alpha_m == 0);
    support_method(0, 1e-3, &a);
    trk_newmark_options_generalized_alpha(&a, 0.5);
    assert_near(a.alpha_m, 0, 1e-15);
    support_method(0, 1e-3, &b);
    trk_newmark_options_hht(&b, -1.0 / 3); /* HHT is generalized alpha with rho = 1/2 there */
    assert_near(a.alpha_f, b.alpha_f, 1e-15);
    assert_near(a.beta, b.beta, 1e-15);
    assert_near(a.gamma, b.gamma, 1e-15);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_undamped, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(test_damped, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(test_adams, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(test_orders, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(test_spectral_radius, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(test_annihilation, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(test_named_methods, support_setup, support_teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
