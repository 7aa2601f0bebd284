/* SPDX-License-Identifier: MIT */
/*
 * A link a million times stiffer than the others must not loosen the tolerance of the dampers:
 * its force in the predicted state, which no time ever sees, is no measure of anything.
 */
#include "support.h"

#include <truckride/truckride.h>

/* Largest |z| of the sprung mass over 5 s on a sine. */
static double run(trk_context *context, trk_backend backend, double tire, double unsprung,
                  double step, double tolerance)
{
    const double v[] = {-1, -0.1, 0, 0.1, 1}, f[] = {-1500, -500, 0, 900, 3000};
    trk_quarter_car_parameters p;
    trk_quarter_car_parameters_init(&p, sizeof p);
    trk_curve *damper;
    trk_spec *spec;
    trk_model *model;
    assert_ok(context, trk_curve_create(context, "damper", 5, v, f, NULL, &damper));
    p.sprung_mass = 500;
    p.unsprung_mass = unsprung;
    p.spring_stiffness = 2e4;
    p.damping = 1500;
    p.tire_stiffness = tire;
    p.damper_curve = damper;
    assert_ok(context, trk_vehicle_create_quarter_car(context, &p, &spec));
    assert_ok(context, trk_model_compile(context, spec, NULL, &model));
    trk_newmark_options options;
    trk_newmark_options_init(&options, sizeof options);
    options.step = step;
    options.tolerance = tolerance;
    options.backend = backend;
    trk_newmark *stepper;
    assert_ok(context, trk_newmark_create(context, model, &options, &stepper));
    double largest = 0, q[2];
    for (int64_t k = 1; (double)k * step <= 5; k++) {
        double w = 2 * 3.14159265358979 * 2.3, t = (double)k * step;
        double height = 0.05 * sin(w * t), velocity = 0.05 * w * cos(w * t);
        assert_ok(context, trk_newmark_step(stepper, &height, &velocity, NULL));
        trk_newmark_get_state(stepper, q, NULL, NULL);
        largest = fmax(largest, fabs(q[0]));
    }
    trk_newmark_destroy(stepper);
    trk_model_destroy(model);
    trk_spec_destroy(spec);
    trk_curve_destroy(damper);
    return largest;
}

static void tolerance_holds_beside_stiff_links(void **state)
{
    const struct {
        double tire, unsprung, step, tolerance;
    } cases[] = {{1e12, 50, 1e-2, 1e-10}, {1e15, 1e-3, 1e-3, 1e-10}, {1e12, 50, 1e-3, 1e-8}};
    /* The dense backend steps by its kernels, the sparse one in general. */
    const trk_backend last =
        trk_has_feature(TRK_FEATURE_CHOLMOD) ? TRK_BACKEND_SPARSE : TRK_BACKEND_DENSE;
    for (trk_backend backend = TRK_BACKEND_DENSE; backend <= last; backend++)
        for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
            double tire = cases[k].tire, unsprung = cases[k].unsprung, step = cases[k].step;
            double loose = run(*state, backend, tire, unsprung, step, cases[k].tolerance);
            double tight = run(*state, backend, tire, unsprung, step, 1e-13);
            print_message("backend %d, tire %g N/m, step %g s: peak %.9g m, tight %.9g m\n",
                          backend, tire, step, loose, tight);
            assert_near(loose, tight, 1e-3 * tight);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test_setup_teardown(
        tolerance_holds_beside_stiff_links, support_setup, support_teardown)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
