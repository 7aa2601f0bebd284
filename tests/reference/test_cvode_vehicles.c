/* SPDX-License-Identifier: MIT */
/*
 * The stepper against CVODE (Adams, relative tolerance 1e-12): an independent method,
 * integrating M q'' = -r(q, q', t) with rows and forces from the public API. Roads:
 * the step of the thesis (1 s to 1.5 s) and a sine of 1 Hz, on one side of the 3D truck
 * more than on the other so that all coordinates move.
 */
#include "support.h"
#include "vehicles.h"

#include <truckride/rungekutta.h>
#include <truckride/signal.h>

#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

enum { MAX = 64, SAMPLES = 600 };

static const double duration = 3, first_kink = 1, last_kink = 1.5;

typedef struct problem {
    const trk_model *model;
    const trk_signal *road;
    int32_t n, links, wheels;
    double inverse[MAX * MAX]; /* M^-1 */
    double b[MAX][MAX], g[MAX][MAX];
} problem;

/* Road under wheel k: odd wheels see half of it. */
static double gain(int32_t k)
{
    return k % 2 ? 0.5 : 1;
}

static void check(int flag)
{
    assert_true(flag >= 0);
}

/* inverse := mass^-1 by Gauss and Jordan; M is positive definite. */
static void invert(int32_t n, double *mass, double *inverse)
{
    for (int32_t i = 0; i < n; i++)
        for (int32_t j = 0; j < n; j++)
            inverse[i * n + j] = i == j;
    for (int32_t k = 0; k < n; k++) {
        double pivot = mass[k * n + k];
        for (int32_t j = 0; j < n; j++) {
            mass[k * n + j] /= pivot;
            inverse[k * n + j] /= pivot;
        }
        for (int32_t i = 0; i < n; i++) {
            double factor = mass[i * n + k];
            for (int32_t j = 0; i != k && j < n; j++) {
                mass[i * n + j] -= factor * mass[k * n + j];
                inverse[i * n + j] -= factor * inverse[k * n + j];
            }
        }
    }
}

static problem *describe(const trk_model *model, const trk_signal *road)
{
    double mass[MAX * MAX];
    problem *p = calloc(1, sizeof *p);
    assert_non_null(p);
    p->model = model;
    p->road = road;
    p->n = trk_model_count(model, TRK_PART_COORDINATE);
    p->links = trk_model_count(model, TRK_PART_LINK);
    p->wheels = trk_model_count(model, TRK_PART_ROAD);
    assert_true(p->n <= MAX && p->links <= MAX);
    trk_model_get_mass(model, mass);
    invert(p->n, mass, p->inverse);
    for (int32_t k = 0; k < p->links; k++)
        assert_int_equal(trk_model_get_link_row(model, k + 1, p->b[k], p->g[k]), TRK_OK);
    return p;
}

/* y = (q, v), y' = (v, -M^-1 B^T f). */
static int right_side(realtype t, N_Vector y, N_Vector rate_of_change, void *user)
{
    const problem *p = user;
    const double *q = NV_DATA_S(y), *v = q + p->n;
    double *out = NV_DATA_S(rate_of_change), e[MAX], rate[MAX], force[MAX], r[MAX] = {0};
    double height = trk_signal_value(p->road, t), velocity = trk_signal_rate(p->road, t);
    for (int32_t k = 0; k < p->links; k++) {
        e[k] = rate[k] = 0;
        for (int32_t i = 0; i < p->n; i++) {
            e[k] += p->b[k][i] * q[i];
            rate[k] += p->b[k][i] * v[i];
        }
        for (int32_t i = 0; i < p->wheels; i++) {
            e[k] -= p->g[k][i] * gain(i) * height;
            rate[k] -= p->g[k][i] * gain(i) * velocity;
        }
    }
    trk_model_get_link_force(p->model, e, rate, force);
    for (int32_t k = 0; k < p->links; k++)
        for (int32_t i = 0; i < p->n; i++)
            r[i] += p->b[k][i] * force[k];
    for (int32_t i = 0; i < p->n; i++) {
        out[i] = v[i];
        out[p->n + i] = 0;
        for (int32_t j = 0; j < p->n; j++)
            out[p->n + i] -= p->inverse[i * p->n + j] * r[j];
    }
    return 0;
}

/* q at SAMPLES + 1 times; CVODE starts anew where the road's second derivative jumps. */
static double *reference(problem *p)
{
    SUNContext sun;
    int32_t n = p->n;
    double *q = calloc((size_t)((SAMPLES + 1) * n), sizeof *q);
    assert_non_null(q);
    check(SUNContext_Create(NULL, &sun));
    N_Vector y = N_VNew_Serial(2 * n, sun), tolerance = N_VNew_Serial(2 * n, sun);
    N_VConst(0, y);
    for (int32_t i = 0; i < n; i++) { /* of displacements of some mm and velocities of some cm/s */
        NV_Ith_S(tolerance, i) = 1e-14;
        NV_Ith_S(tolerance, n + i) = 1e-13;
    }
    void *cvode = CVodeCreate(CV_ADAMS, sun);
    check(CVodeInit(cvode, right_side, 0, y));
    check(CVodeSVtolerances(cvode, 1e-12, tolerance));
    check(CVodeSetUserData(cvode, p));
    check(CVodeSetMaxNumSteps(cvode, 1000000));
    SUNMatrix matrix = SUNDenseMatrix(2 * n, 2 * n, sun);
    SUNLinearSolver solver = SUNLinSol_Dense(y, matrix, sun);
    check(CVodeSetLinearSolver(cvode, solver, matrix));
    for (int k = 1; k <= SAMPLES; k++) {
        double t = duration * k / SAMPLES, reached;
        check(CVodeSetStopTime(cvode, t <= first_kink  ? first_kink
                                      : t <= last_kink ? last_kink
                                                       : duration));
        check(CVode(cvode, t, y, &reached, CV_NORMAL));
        memcpy(q + k * n, NV_DATA_S(y), (size_t)n * sizeof *q);
        if (t == first_kink || t == last_kink)
            check(CVodeReInit(cvode, t, y));
    }
    CVodeFree(&cvode);
    check(SUNLinSolFree(solver));
    SUNMatDestroy(matrix);
    N_VDestroy(y);
    N_VDestroy(tolerance);
    check(SUNContext_Free(&sun));
    return q;
}

/* q at the same times by average acceleration in `steps` steps a sample. */
static double *step(trk_context *context, const problem *p, int steps)
{
    trk_newmark_options options;
    support_method(0, duration / SAMPLES / steps, &options);
    double *q = calloc((size_t)((SAMPLES + 1) * p->n), sizeof *q), height[MAX], velocity[MAX];
    assert_non_null(q);
    trk_newmark *stepper;
    assert_ok(context, trk_newmark_create(context, p->model, &options, &stepper));
    for (int64_t k = 0; k <= (int64_t)SAMPLES * steps; k++) {
        double t = duration * (double)k / (SAMPLES * steps);
        for (int32_t i = 0; i < p->wheels; i++) {
            height[i] = gain(i) * trk_signal_value(p->road, t);
            velocity[i] = gain(i) * trk_signal_rate(p->road, t);
        }
        if (k == 0)
            assert_ok(context,
                      trk_newmark_set_state(stepper, 0, NULL, NULL, height, velocity, NULL));
        else
            assert_ok(context, trk_newmark_step(stepper, height, velocity, NULL));
        if (k % steps == 0)
            trk_newmark_get_state(stepper, q + k / steps * p->n, NULL, NULL);
    }
    trk_newmark_destroy(stepper);
    return q;
}

static void put_road(const problem *p, double t, double *height, double *velocity)
{
    for (int32_t i = 0; i < p->wheels; i++) {
        height[i] = gain(i) * trk_signal_value(p->road, t);
        velocity[i] = gain(i) * trk_signal_rate(p->road, t);
    }
}

/* q at the same times by the Runge-Kutta method. */
static double *step_explicitly(trk_context *context, const problem *p, int steps)
{
    trk_rungekutta_options options;
    trk_rungekutta_options_init(&options, sizeof options);
    double h = options.step = duration / SAMPLES / steps;
    double *q = calloc((size_t)((SAMPLES + 1) * p->n), sizeof *q);
    double height[2][MAX], velocity[2][MAX];
    assert_non_null(q);
    trk_rungekutta *stepper;
    assert_ok(context, trk_rungekutta_create(context, p->model, &options, &stepper));
    put_road(p, 0, height[1], velocity[1]);
    assert_ok(context,
              trk_rungekutta_set_state(stepper, 0, NULL, NULL, height[1], velocity[1], NULL));
    for (int64_t k = 1; k <= (int64_t)SAMPLES * steps; k++) {
        put_road(p, ((double)k - 0.5) * h, height[0], velocity[0]);
        put_road(p, duration * (double)k / (SAMPLES * steps), height[1], velocity[1]);
        assert_ok(context, trk_rungekutta_step(stepper, height[0], velocity[0], NULL, height[1],
                                               velocity[1], NULL));
        if (k % steps == 0)
            trk_rungekutta_get_state(stepper, q + k / steps * p->n, NULL, NULL);
    }
    trk_rungekutta_destroy(stepper);
    return q;
}

typedef void (*judge)(trk_context *context, const problem *p, const double *wanted);

static void for_all(trk_context *context, const trk_signal *road, judge judge_one)
{
    for (trk_vehicle vehicle = 1; vehicle <= SUPPORT_VEHICLES; vehicle++)
        for (trk_variant variant = 0; variant <= TRK_VARIANT_THESIS_DAMPERS; variant++) {
            if (vehicle == TRK_VEHICLE_THESIS_QUARTER && variant == TRK_VARIANT_LINEAR)
                continue; /* it has its damper curve anyway */
            trk_model *model = support_model(context, vehicle, variant, 0);
            problem *p = describe(model, road);
            double *wanted = reference(p);
            print_message("%-16s %-15s", support_vehicle_name(vehicle),
                          support_variant_name(variant));
            judge_one(context, p, wanted);
            free(wanted);
            free(p);
            trk_model_destroy(model);
        }
}

static void judge_order(trk_context *context, const problem *p, const double *wanted)
{
    double before = 0, order = 0;
    for (int steps = 5; steps <= 40; steps *= 2) {
        double *q = step(context, p, steps);
        double error = support_difference(SAMPLES + 1, p->n, wanted, q, 1e-3);
        order = log2(before / error);
        print_message("  h %.3g: %.3g", duration / SAMPLES / steps, error);
        if (before > 0)
            print_message(" (%.3f)", order);
        before = error;
        free(q);
    }
    print_message("\n");
    assert_near(order, 2, 0.02);
}

static void judge_accuracy(trk_context *context, const problem *p, const double *wanted)
{
    double *q = step(context, p, 5), worst = 0;
    int32_t worst_at = 0;
    for (int32_t i = 0; i < p->n; i++) {
        double peak = 0, error = 0;
        for (int k = i; k < (SAMPLES + 1) * p->n; k += p->n) {
            peak = fmax(peak, fabs(wanted[k]));
            error = fmax(error, fabs(q[k] - wanted[k]));
        }
        if (error / peak > worst) {
            worst = error / peak;
            worst_at = i;
        }
    }
    print_message("  h = 1 ms: %.3g of the peak of %s\n", worst,
                  trk_model_part_name(p->model, TRK_PART_COORDINATE, worst_at + 1));
    assert_true(worst < 1e-4);
    free(q);
}

static void judge_rungekutta(trk_context *context, const problem *p, const double *wanted)
{
    static const int steps[] = {1, 2, 5};
    double error[3];
    for (int k = 0; k < 3; k++) {
        double *q = step_explicitly(context, p, steps[k]);
        error[k] = support_difference(SAMPLES + 1, p->n, wanted, q, 1e-3);
        free(q);
    }
    print_message("  Runge-Kutta: h = 5 ms: %.3g, 2.5 ms: %.3g, 1 ms: %.3g\n", error[0], error[1],
                  error[2]);
    assert_true(error[2] < 1e-7);
}

static trk_signal *thesis_step(trk_context *context)
{
    trk_signal *road;
    assert_ok(context,
              trk_signal_create_step(context, first_kink, last_kink - first_kink, 0.01, &road));
    return road;
}

static void test_order_step(void **state)
{
    trk_signal *road = thesis_step(*state);
    for_all(*state, road, judge_order);
    trk_signal_destroy(road);
}

static void test_order_sine(void **state)
{
    trk_signal *road;
    assert_ok(*state, trk_signal_create_sine(*state, 0.01, 1, 0, 0, &road));
    for_all(*state, road, judge_order);
    trk_signal_destroy(road);
}

static void test_accuracy(void **state)
{
    trk_signal *road = thesis_step(*state);
    for_all(*state, road, judge_accuracy);
    trk_signal_destroy(road);
}

static void test_rungekutta_step(void **state)
{
    if (!trk_has_feature(TRK_FEATURE_LAPACK))
        skip();
    trk_signal *road = thesis_step(*state);
    for_all(*state, road, judge_rungekutta);
    trk_signal_destroy(road);
}

static void test_rungekutta_sine(void **state)
{
    if (!trk_has_feature(TRK_FEATURE_LAPACK))
        skip();
    trk_signal *road;
    assert_ok(*state, trk_signal_create_sine(*state, 0.01, 1, 0, 0, &road));
    for_all(*state, road, judge_rungekutta);
    trk_signal_destroy(road);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_order_step, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(test_order_sine, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(test_accuracy, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(test_rungekutta_step, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(test_rungekutta_sine, support_setup, support_teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
