/* SPDX-License-Identifier: MIT */
/*
 * Energy over a run by average acceleration. From (NEWMARK.2), (NEWMARK.3) follows, for
 * any force law and with bars for the means over a step (NEWMARK.9),
 *
 *     dT + f^bar . de = p^bar . P^T dq - f^bar . G du
 *
 * exactly: kinetic energy and work of the links equal work of loads and road. For linear
 * links f^bar . de is the change of k e^2 / 2 and c e'^bar de.
 */
#include "support.h"
#include "vehicles.h"

enum { MAX = 64 };

typedef struct state {
    double q[MAX], v[MAX], e[MAX], rate[MAX], force[MAX];
    double height[MAX], velocity[MAX], load[MAX];
} state;

typedef struct run {
    const trk_model *model;
    trk_newmark *stepper;
    int32_t n, links, wheels, ports;
    double mass[MAX * MAX], g[MAX][MAX], p[MAX][MAX], damping[MAX];
    state now, before;
} run;

/* What was put in, and where it went [J]. */
typedef struct balance {
    double links;       /* f^bar . de                                      */
    double dissipation; /* c e'^bar de, linear links                       */
    double lost;        /* (f(e, e') - f(e, 0)) e' dt, trapezoidal         */
    double supplied;    /* road and load, mean force times way             */
    double power;       /* road and load, force times velocity, trapezoidal */
    double kinetic, potential;
} balance;

static double kinetic(const run *r)
{
    double sum = 0;
    for (int32_t i = 0; i < r->n; i++)
        for (int32_t j = 0; j < r->n; j++)
            sum += r->now.v[i] * r->mass[i * r->n + j] * r->now.v[j] / 2;
    return sum;
}

static double dot(int32_t n, const double *x, const double *y)
{
    double sum = 0;
    for (int32_t i = 0; i < n; i++)
        sum += x[i] * y[i];
    return sum;
}

/* Integral of f(e, 0) from 0 to the present elongations, Gauss with 2 points in 400 panels. */
static double potential(const run *r)
{
    enum { PANELS = 400 };
    const double none[MAX] = {0}, point[2] = {0.5 - 0.28867513459481287, 0.5 + 0.28867513459481287};
    double e[MAX], force[MAX], sum = 0;
    for (int panel = 0; panel < PANELS; panel++)
        for (int i = 0; i < 2; i++) {
            for (int32_t k = 0; k < r->links; k++)
                e[k] = r->now.e[k] * (panel + point[i]) / PANELS;
            trk_model_get_link_force(r->model, e, none, force);
            sum += dot(r->links, force, r->now.e) / (2 * PANELS);
        }
    return sum;
}

static void read_state(run *r, double t, state *s)
{
    support_road(t, r->wheels, s->height, s->velocity);
    support_load(t, r->ports, s->load);
    trk_newmark_get_state(r->stepper, s->q, s->v, NULL);
    trk_newmark_get_links(r->stepper, s->e, s->rate, s->force);
}

/* Road and load work of one link or port over the last step. */
static void add_step(run *r, double h, balance *b)
{
    const state *s = &r->now, *s0 = &r->before;
    const double none[MAX] = {0};
    double slow[MAX], slow0[MAX];
    trk_model_get_link_force(r->model, s->e, none, slow);
    trk_model_get_link_force(r->model, s0->e, none, slow0);
    for (int32_t k = 0; k < r->links; k++) {
        double mean = (s->force[k] + s0->force[k]) / 2, de = s->e[k] - s0->e[k];
        double du = dot(r->wheels, r->g[k], s->height) - dot(r->wheels, r->g[k], s0->height);
        b->links += mean * de;
        b->dissipation += r->damping[k] * (s->rate[k] + s0->rate[k]) / 2 * de;
        b->lost += h / 2 *
                   ((s->force[k] - slow[k]) * s->rate[k] + (s0->force[k] - slow0[k]) * s0->rate[k]);
        b->supplied -= mean * du;
        b->power -= h / 2 *
                    (s->force[k] * dot(r->wheels, r->g[k], s->velocity) +
                     s0->force[k] * dot(r->wheels, r->g[k], s0->velocity));
    }
    for (int32_t k = 0; k < r->ports; k++) {
        b->supplied +=
            (s->load[k] + s0->load[k]) / 2 * (dot(r->n, r->p[k], s->q) - dot(r->n, r->p[k], s0->q));
        b->power +=
            h / 2 *
            (s->load[k] * dot(r->n, r->p[k], s->v) + s0->load[k] * dot(r->n, r->p[k], s0->v));
    }
}

/* Rows and linear dampings of the links through the public API. */
static void describe(run *r, const trk_model *model)
{
    double row[MAX], zero[MAX] = {0}, one[MAX];
    r->model = model;
    r->n = trk_model_count(model, TRK_PART_COORDINATE);
    r->links = trk_model_count(model, TRK_PART_LINK);
    r->wheels = trk_model_count(model, TRK_PART_ROAD);
    r->ports = trk_model_count(model, TRK_PART_PORT);
    assert_true(r->n <= MAX && r->links <= MAX);
    trk_model_get_mass(model, r->mass);
    for (int32_t k = 0; k < r->links; k++) {
        assert_int_equal(trk_model_get_link_row(model, k + 1, row, r->g[k]), TRK_OK);
        one[k] = 1;
    }
    for (int32_t k = 0; k < r->ports; k++)
        assert_int_equal(trk_model_get_row(model, TRK_PART_PORT, k + 1, r->p[k]), TRK_OK);
    trk_model_get_link_force(model, zero, one, r->damping);
}

static balance drive(trk_context *context, trk_vehicle vehicle, trk_variant variant, double h,
                     int64_t steps)
{
    trk_model *model = support_model(context, vehicle, variant, 0);
    run *r = calloc(1, sizeof *r);
    assert_non_null(r);
    describe(r, model);
    trk_newmark_options options;
    support_method(0, h, &options);
    options.tolerance = 1e-13;
    assert_ok(context, trk_newmark_create(context, model, &options, &r->stepper));
    read_state(r, 0, &r->before);
    balance b = {0};
    for (int64_t k = 1; k <= steps; k++) {
        support_road((double)k * h, r->wheels, r->now.height, r->now.velocity);
        support_load((double)k * h, r->ports, r->now.load);
        assert_ok(context,
                  trk_newmark_step(r->stepper, r->now.height, r->now.velocity, r->now.load));
        read_state(r, (double)k * h, &r->now);
        add_step(r, h, &b);
        r->before = r->now;
    }
    b.kinetic = kinetic(r);
    b.potential = potential(r);
    trk_newmark_destroy(r->stepper);
    trk_model_destroy(model);
    free(r);
    return b;
}

/* The identity holds for every vehicle and law up to rounding; for linear ones with c e'^bar de. */
static void test_discrete_balance(void **unused)
{
    for (trk_vehicle vehicle = 1; vehicle <= SUPPORT_VEHICLES; vehicle++)
        for (trk_variant variant = 0; variant < SUPPORT_VARIANTS; variant++) {
            balance b = drive(*unused, vehicle, variant, 1e-3, 2000);
            double gap = (b.kinetic + b.links - b.supplied) / b.supplied;
            print_message("%-16s %-15s supplied %9.3f J  kinetic %8.3f J  gap %8.2g",
                          support_vehicle_name(vehicle), support_variant_name(variant), b.supplied,
                          b.kinetic, gap);
            assert_true(fabs(gap) < 1e-11);
            if (variant == TRK_VARIANT_LINEAR && vehicle != TRK_VEHICLE_THESIS_QUARTER) {
                double linear = (b.kinetic + b.potential + b.dissipation - b.supplied) / b.supplied;
                print_message("  with k e^2/2 and c e'^2: %8.2g", linear);
                assert_true(fabs(linear) < 1e-11);
            }
            assert_true(b.lost > 0);
            print_message("\n");
        }
}

/* Power of road, load and dampers over time closes the balance with an error of O(h^2). */
static void test_balance_of_power(void **unused)
{
    for (trk_vehicle vehicle = 1; vehicle <= SUPPORT_VEHICLES; vehicle++) {
        double before = 0, gap = 0;
        for (int k = 0; k < 4; k++) {
            balance b =
                drive(*unused, vehicle, TRK_VARIANT_NONLINEAR, 2e-3 / (1 << k), (int64_t)500 << k);
            before = gap;
            gap = fabs(b.kinetic + b.potential + b.lost - b.power) / b.power;
            print_message("%-16s h %.3g: gap %.3g order %.3f\n", support_vehicle_name(vehicle),
                          2e-3 / (1 << k), gap, k > 0 ? log2(before / gap) : NAN);
        }
        assert_true(log2(before / gap) > 1.9);
        assert_true(gap < 1e-5);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_discrete_balance, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(test_balance_of_power, support_setup, support_teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
