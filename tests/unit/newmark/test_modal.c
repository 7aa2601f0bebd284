/* SPDX-License-Identifier: MIT */
/* The modal form of the step is the step: taken naively from its arrays, it equals full Newton. */
#include "full_newton.h"
#include "newmark/modal.h"
#include "support.h"
#include "vehicles.h"

#include <float.h>

enum { STEPS = 300, MAX = 32 };

typedef struct motion {
    double y[MAX], v[MAX], a[MAX], g[MAX];
} motion;

static double dot(int32_t n, const double *x, const double *y)
{
    double sum = 0;
    for (int32_t i = 0; i < n; i++)
        sum += x[i] * y[i];
    return sum;
}

/* y := y + factor A^T x, A rows x n. */
static void add_rows(int32_t rows, int32_t n, double factor, const double *a, const double *x,
                     double *y)
{
    for (int32_t j = 0; j < rows; j++)
        for (int32_t i = 0; i < n; i++)
            y[i] += factor * a[j * n + i] * x[j];
}

/* g = law(e, x) by plain fixed-point sweeps: kappa D dg/dx is small. */
static void solve_forces(const trk_modal_form *f, const double *x_free, const double *e_rest,
                         double *g)
{
    for (int sweep = 0; sweep < 200; sweep++) {
        double next[MAX];
        for (int32_t j = 0; j < f->tables; j++) {
            double x = x_free[j] - f->kappa * dot(f->tables, f->coupling + j * f->tables, g);
            trk_law_hint hint = {0, 0};
            trk_law_point point;
            trk_link_law_evaluate(f->table[j].law, e_rest[j] + f->r * x, x, &hint, &point);
            next[j] = point.force;
        }
        memcpy(g, next, (size_t)f->tables * sizeof *g);
    }
}

/* The formulas of modal.h, line by line. */
static void step(const trk_modal_form *f, motion *m, const double *u, const double *du,
                 const double *load)
{
    int32_t n = f->n;
    double force[MAX], y[MAX], v[MAX], v_free[MAX], back[MAX] = {0};
    double x_damper[MAX], f_damper[MAX], x_free[MAX], e_rest[MAX], z[MAX];
    memcpy(force, f->weight, (size_t)n * sizeof *force);
    add_rows(f->roads, n, 1, f->height_force, u, force);
    add_rows(f->ports, n, 1, f->port_force, load, force);
    for (int32_t i = 0; i < n; i++) {
        y[i] = m->y[i] + f->h * m->v[i] + f->h * f->h * (0.5 - f->beta) * m->a[i];
        v[i] = m->v[i] + f->h * (1 - f->gamma) * m->a[i];
        v_free[i] = v[i] + f->kappa * f->inverse[i] * (force[i] - f->lambda[i] * y[i]);
        z[i] = y[i] - f->r * v[i];
    }
    for (int32_t k = 0; k < f->dampers; k++)
        x_damper[k] = dot(n, f->damper_rows + k * n, v_free) -
                      dot(f->roads, f->damper_road + k * f->roads, du);
    for (int32_t k = 0; k < f->dampers; k++)
        f_damper[k] = dot(f->dampers, f->damping + k * f->dampers, x_damper);
    for (int32_t j = 0; j < f->tables; j++) {
        const double *road = f->table_road + j * f->roads;
        x_free[j] = dot(n, f->reduced_rows + j * n, v_free) -
                    dot(f->roads, f->reduced_road + j * f->roads, du);
        e_rest[j] = dot(n, f->table_rows + j * n, z) - dot(f->roads, road, u) +
                    f->r * dot(f->roads, road, du);
    }
    solve_forces(f, x_free, e_rest, m->g);
    add_rows(f->tables, n, 1, f->reduced_rows, m->g, back);
    add_rows(f->dampers, n, 1, f->damper_rows, f_damper, back);
    for (int32_t i = 0; i < n; i++) {
        m->v[i] = v_free[i] - f->kappa * f->inverse[i] * back[i];
        m->a[i] = (m->v[i] - v[i]) / f->kappa;
        m->y[i] = y[i] + f->r * (m->v[i] - v[i]);
    }
}

static void start(const trk_modal_form *f, full_newton *full, motion *m)
{
    double q[MAX], v[MAX], a[MAX];
    full_newton_get(full, q, v, a, NULL);
    memset(m, 0, sizeof *m);
    for (int32_t i = 0; i < f->n; i++) {
        m->y[i] = dot(f->n, f->phi_inverse + i * f->n, q);
        m->v[i] = dot(f->n, f->phi_inverse + i * f->n, v);
        m->a[i] = dot(f->n, f->phi_inverse + i * f->n, a);
    }
}

static void compare(trk_context *context, trk_vehicle vehicle, trk_variant variant, int method,
                    double gravity)
{
    trk_model *model = support_model(context, vehicle, variant, gravity);
    trk_newmark_options options;
    trk_modal_form *f;
    motion m;
    double u[MAX], du[MAX], load[MAX], q[(STEPS + 1) * MAX], full_q[(STEPS + 1) * MAX];
    support_method(method, 1e-3, &options);
    options.tolerance = 1e-14;
    assert_ok(context, trk_modal_form_create(context, model, &options, &f));
    assert_non_null(f);
    full_newton *full = full_newton_create(model, &options);
    for (int k = 0; k <= STEPS; k++) {
        support_road(k * options.step, f->roads, u, du);
        support_load(k * options.step, f->ports, load);
        if (k == 0) {
            full_newton_start(full, u, du, load);
            start(f, full, &m);
        } else {
            full_newton_step(full, u, du, load);
            step(f, &m, u, du, load);
        }
        full_newton_get(full, full_q + k * f->n, NULL, NULL, NULL);
        for (int32_t i = 0; i < f->n; i++)
            q[k * f->n + i] = dot(f->n, f->phi + i * f->n, m.y);
    }
    double off = support_difference(STEPS + 1, f->n, full_q, q, 1e-6);
    print_message("%-16s %-15s %-22s g %-4.3g q %8.2g\n", support_vehicle_name(vehicle),
                  support_variant_name(variant), support_method_name(method), gravity, off);
    assert_true(off < 1e-12);
    full_newton_destroy(full);
    trk_modal_form_destroy(f);
    trk_model_destroy(model);
}

static void test_step(void **state)
{
    for (trk_vehicle vehicle = 1; vehicle <= SUPPORT_VEHICLES; vehicle++)
        for (trk_variant variant = 0; variant < SUPPORT_VARIANTS; variant++) {
            compare(*state, vehicle, variant, 0, 0);
            compare(*state, vehicle, variant, 1, TRK_STANDARD_GRAVITY);
        }
}

/* Phi^T M Phi = I, Phi^T K0 Phi = diag(lambda), Phi^T M = Phi^-1 (NEWMARK.14). */
static void test_basis(void **state)
{
    for (trk_vehicle vehicle = 1; vehicle <= SUPPORT_VEHICLES; vehicle++) {
        trk_model *model = support_model(*state, vehicle, TRK_VARIANT_LINEAR, 0);
        int32_t n = model->n;
        double phi[MAX * MAX], inverse[MAX * MAX], lambda[MAX], row[MAX];
        assert_ok(*state, trk_modal_basis(*state, model, phi, inverse, lambda));
        for (int32_t i = 0; i < n; i++)
            for (int32_t j = 0; j < n; j++) {
                double product = 0, stiffness = 0;
                for (int32_t k = 0; k < n; k++)
                    product += inverse[i * n + k] * phi[k * n + j];
                for (int32_t l = 0; l < model->links.count; l++) {
                    double wi = 0, wj = 0;
                    trk_rows_expand(&model->links, l, n, row);
                    for (int32_t k = 0; k < n; k++) {
                        wi += row[k] * phi[k * n + i];
                        wj += row[k] * phi[k * n + j];
                    }
                    stiffness += wi * model->laws[l].stiffness * wj;
                }
                double scale = sqrt(lambda[i] * lambda[j]);
                assert_near(product, i == j, 1e-13);
                assert_near(stiffness, i == j ? lambda[i] : 0, 1e-13 * scale + 1e-300);
            }
        trk_model_destroy(model);
    }
}

/* No such form: an alpha method, or a link that pulls the wrong way. */
static void test_none(void **state)
{
    trk_model *model = support_oscillator(*state, 1, 1, 0);
    trk_newmark_options options;
    trk_modal_form *form;
    trk_newmark_options_init(&options, sizeof options);
    options.alpha_f = 0.1;
    assert_ok(*state, trk_modal_form_create(*state, model, &options, &form));
    assert_null(form);
    options.alpha_f = 0;
    model->laws[0].stiffness = -1;
    assert_ok(*state, trk_modal_form_create(*state, model, &options, &form));
    assert_null(form);
    trk_model_destroy(model);
}

static trk_spec *spec_for_memory;

static trk_status create(trk_context *context)
{
    trk_model *model = NULL;
    trk_modal_form *form = NULL;
    trk_newmark_options options;
    trk_newmark_options_init(&options, sizeof options);
    trk_status status = trk_model_compile(context, spec_for_memory, NULL, &model);
    if (status == TRK_OK)
        status = trk_modal_form_create(context, model, &options, &form);
    trk_modal_form_destroy(form);
    trk_model_destroy(model);
    return status;
}

static void test_memory(void **state)
{
    spec_for_memory = support_spec(*state, TRK_VEHICLE_REFERENCE_HALF, TRK_VARIANT_NONLINEAR);
    support_exhaust_memory(create);
    trk_spec_destroy(spec_for_memory);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_step, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(test_basis, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(test_none, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(test_memory, support_setup, support_teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
