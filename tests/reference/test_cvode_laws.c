/* SPDX-License-Identifier: MIT */
/*
 * Laws against CVODE (BDF, relative tolerance 1e-11): a cab on an air spring with auxiliary volume
 * and on the seal of its damper, over a moving frame. Air, throttle and seal are written out anew
 * from (LAW.14) and (LAW.15); the mass of the air is a third state of the reference.
 */
#include "laws.h"
#include "support.h"
#include "vehicles.h"

#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

enum { SAMPLES = 300 };

static const double pi = 3.14159265358979323846, duration = 3, mass = 407.2, damping = 700;

typedef struct problem {
    trk_air_spring_options air;
    trk_seal_options seal;
    double rest; /* force at e = 0 */
} problem;

static void frame(double t, double *height, double *velocity)
{
    double ramp = 1 - cos(pi * t / 3), rise = pi / 3 * sin(pi * t / 3), a = 2 * pi * 1.7;
    *height = 0.012 * ramp * sin(a * t);
    *velocity = 0.012 * (rise * sin(a * t) + ramp * a * cos(a * t));
}

static void check(int flag)
{
    assert_true(flag >= 0);
}

/* y = (q, v, share of the air that is in the bellows, 1 at rest). */
static int right_side(realtype t, N_Vector y, N_Vector change, void *user)
{
    const problem *p = user;
    const trk_air_spring_options *o = &p->air;
    const double gas = 287.05;
    double height, velocity, *out = NV_DATA_S(change);
    frame(t, &height, &velocity);
    double e = NV_Ith_S(y, 0) - height, v = NV_Ith_S(y, 1) - velocity, share = NV_Ith_S(y, 2);
    double start = o->pressure * o->volume / (gas * o->temperature);
    double volume = o->volume + o->area * e + o->area_slope * e * e / 2;
    double inside = o->pressure * pow(share * o->volume / volume, o->exponent);
    double left = start * (1 + o->auxiliary_volume / o->volume) - share * start;
    double full = start * o->auxiliary_volume / o->volume;
    double behind = o->pressure * pow(left / full, o->exponent);
    double slow = v / p->seal.stribeck;
    double seal = (p->seal.sliding + (p->seal.breakaway - p->seal.sliding) * exp(-slow * slow)) *
                  tanh(v / p->seal.creep);
    double force = -(inside - o->ambient) * (o->area + o->area_slope * e) + seal + damping * v;
    out[0] = NV_Ith_S(y, 1);
    out[1] = -(force - p->rest) / mass;
    out[2] = o->conductance * (behind - inside) / start;
    return 0;
}

static void reference(problem *p, double *q)
{
    SUNContext sun;
    check(SUNContext_Create(NULL, &sun));
    N_Vector y = N_VNew_Serial(3, sun), tolerance = N_VNew_Serial(3, sun);
    N_VConst(0, y);
    NV_Ith_S(y, 2) = 1;
    NV_Ith_S(tolerance, 0) = 1e-13;
    NV_Ith_S(tolerance, 1) = 1e-12;
    NV_Ith_S(tolerance, 2) = 1e-12;
    void *cvode = CVodeCreate(CV_BDF, sun);
    check(CVodeInit(cvode, right_side, 0, y));
    check(CVodeSVtolerances(cvode, 1e-11, tolerance));
    check(CVodeSetUserData(cvode, p));
    check(CVodeSetMaxNumSteps(cvode, 1000000));
    SUNMatrix matrix = SUNDenseMatrix(3, 3, sun);
    SUNLinearSolver solver = SUNLinSol_Dense(y, matrix, sun);
    check(CVodeSetLinearSolver(cvode, solver, matrix));
    for (int k = 1; k <= SAMPLES; k++) {
        double reached;
        check(CVodeSetStopTime(cvode, duration * k / SAMPLES));
        check(CVode(cvode, duration * k / SAMPLES, y, &reached, CV_NORMAL));
        q[k] = NV_Ith_S(y, 0);
    }
    CVodeFree(&cvode);
    check(SUNLinSolFree(solver));
    SUNMatDestroy(matrix);
    N_VDestroy(y);
    N_VDestroy(tolerance);
    check(SUNContext_Free(&sun));
}

static trk_model *cab(trk_context *context, problem *p)
{
    trk_law *air = support_law(context, TRK_LAW_AIR_SPRING),
            *seal = support_law(context, TRK_LAW_SEAL);
    trk_spec *spec;
    trk_body_options body;
    trk_link_options link;
    trk_model *model;
    trk_body_options_init(&body, sizeof body);
    trk_link_options_init(&link, sizeof link);
    trk_air_spring_options_init(&p->air, sizeof p->air);
    trk_seal_options_init(&p->seal, sizeof p->seal);
    assert_int_equal(trk_law_get_air_spring(air, &p->air), TRK_OK);
    assert_int_equal(trk_law_get_seal(seal, &p->seal), TRK_OK);
    p->rest = -(p->air.pressure - p->air.ambient) * p->air.area;
    body.mass = mass;
    assert_ok(context, trk_spec_create(context, "cab", &spec));
    assert_ok(context, trk_spec_add_road(spec, "frame", 0, 0, &link.from_road));
    assert_ok(context, trk_spec_add_body(spec, "cab", &body, &link.to_body));
    link.law = air;
    assert_ok(context, trk_spec_add_link(spec, "air", &link, NULL));
    link.law = seal;
    link.damping = damping;
    assert_ok(context, trk_spec_add_link(spec, "damper", &link, NULL));
    assert_ok(context, trk_model_compile(context, spec, NULL, &model));
    trk_spec_destroy(spec);
    trk_law_destroy(air);
    trk_law_destroy(seal);
    return model;
}

/* Largest error over the peak with `steps` steps a sample. */
static double error_of(trk_context *context, const trk_model *model, const double *wanted,
                       int steps)
{
    trk_newmark_options options;
    trk_newmark *stepper;
    double q, worst = 0, peak = 0, h = duration / SAMPLES / steps;
    support_method(0, h, &options);
    assert_ok(context, trk_newmark_create(context, model, &options, &stepper));
    for (int64_t k = 1; k <= (int64_t)SAMPLES * steps; k++) {
        double height, velocity;
        frame((double)k * h, &height, &velocity);
        assert_ok(context, trk_newmark_step(stepper, &height, &velocity, NULL));
        trk_newmark_get_state(stepper, &q, NULL, NULL);
        if (k % steps == 0) {
            worst = fmax(worst, fabs(q - wanted[k / steps]));
            peak = fmax(peak, fabs(wanted[k / steps]));
        }
    }
    trk_newmark_destroy(stepper);
    return worst / peak;
}

static void air_spring_and_seal(void **state)
{
    problem p;
    double wanted[SAMPLES + 1] = {0};
    trk_model *model = cab(*state, &p);
    reference(&p, wanted);
    double coarse = error_of(*state, model, wanted, 10), fine = error_of(*state, model, wanted, 40),
           finest = error_of(*state, model, wanted, 400);
    print_message("error over the peak: %.2g at 1 ms, %.2g at 0.25 ms, %.2g at 0.025 ms\n", coarse,
                  fine, finest);
    assert_true(coarse < 2e-4);
    assert_near(log2(coarse / fine) / 2, 2, 0.1);
    assert_true(finest < 2e-8);
    trk_model_destroy(model);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(air_spring_and_seal, support_setup, support_teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
