/* SPDX-License-Identifier: MIT */
/* Targets on runs and curves return a known factor. Needs NLOPT, Needs LAPACK */
#include "fit.h"

enum { SAMPLES = 15001, POINTS = 12 };

/* A quarter car with a spring to fit, over 30 s of a seeded rough road. */
typedef struct fixture {
    trk_signal *signal;
    trk_excitation *excitation;
    trk_model *model;
} fixture;

static fixture setup(trk_context *context)
{
    static double height[SAMPLES];
    int64_t seed = 99;
    for (int k = 1; k < SAMPLES; k++) /* brownian, bounded: PSD as 1/f^2 */
        height[k] = 0.999 * height[k - 1] + 1e-3 * fit_normal(&seed);
    fixture f;
    f.model = support_model(context, TRK_VEHICLE_REFERENCE_FRONT, TRK_VARIANT_LINEAR, 0);
    assert_ok(context,
              trk_signal_create_samples(context, SAMPLES, 0, 0.002, height, NULL, &f.signal));
    assert_ok(context, trk_excitation_create(context, f.model, &f.excitation));
    assert_ok(context, trk_excitation_add_motion(f.excitation, TRK_ROAD_ALL, f.signal, 1, 0));
    return f;
}

static void clear(fixture *f)
{
    trk_excitation_destroy(f->excitation);
    trk_signal_destroy(f->signal);
    trk_model_destroy(f->model);
}

static void returns(trk_context *context, const fixture *f, const trk_target_options *target,
                    double factor, double accuracy, const char *what)
{
    trk_target_options twin = *target;
    double y[POINTS], magnitude[POINTS], error = 1;
    for (int round = 0; round < 2; round++) {
        trk_calibration *c = fit_create(context, TRK_VEHICLE_REFERENCE_FRONT);
        trk_run_options run;
        trk_run_options_init(&run, sizeof run);
        run.duration = 30;
        run.step = 0.002;
        run.segment_length = 2048;
        fit_stiffness(context, c, "tire");
        assert_ok(context, trk_calibration_add_target(c, "measured", &twin, NULL));
        assert_ok(context, trk_calibration_set_run(c, f->excitation, &run));
        if (round == 0) {
            assert_ok(context, trk_calibration_evaluate(c, &factor, y, NULL));
            twin.value = y[0];
            for (int k = 0; k < target->count; k++)
                magnitude[k] = target->magnitude[k] * exp(y[k]);
            twin.magnitude = magnitude;
        } else {
            assert_ok(context, trk_calibration_solve(c, NULL, NULL, NULL));
            error = fabs(fit_fitted(c, 1) / factor - 1);
            printf("%-24s factor %g returned with error %.1e in %lld evaluations\n", what, factor,
                   error, (long long)trk_calibration_evaluations(c));
        }
        trk_calibration_destroy(c);
    }
    assert_true(error < accuracy);
}

static void known_factors(void **state)
{
    fixture f = setup(*state);
    double frequency[POINTS], ones[POINTS];
    for (int k = 0; k < POINTS; k++) {
        frequency[k] = 1 + k;
        ones[k] = 1;
    }
    trk_target_options o;
    trk_target_options_init(&o, sizeof o);
    o.kind = TRK_TARGET_PSD_PEAK;
    o.sensor = "unsprung_z";
    o.value = 1;
    o.low = 3;
    o.high = 20;
    returns(*state, &f, &o, 1.4, 1e-3, "PSD peak");
    trk_target_options_init(&o, sizeof o);
    o.kind = TRK_TARGET_PSD_CURVE;
    o.sensor = "unsprung_z";
    o.count = POINTS;
    o.frequency = frequency;
    o.magnitude = ones;
    returns(*state, &f, &o, 1.4, 1e-3, "PSD curve");
    o.kind = TRK_TARGET_RESPONSE_CURVE;
    returns(*state, &f, &o, 1.4, 1e-6, "response curve");
    clear(&f);
}

static void refusals(void **state)
{
    trk_context *context = *state;
    fixture f = setup(context);
    trk_calibration *c = fit_create(context, TRK_VEHICLE_REFERENCE_FRONT);
    fit_stiffness(context, c, "tire");
    trk_target_options o;
    trk_target_options_init(&o, sizeof o);
    o.kind = TRK_TARGET_PSD_PEAK;
    o.sensor = "unsprung_z";
    o.value = 200;
    o.low = 200;
    o.high = 200.1;
    assert_ok(context, trk_calibration_add_target(c, "peak", &o, NULL));
    double p = 1, y, j;
    assert_status(context, trk_calibration_solve(c, NULL, NULL, NULL), TRK_E_ARGUMENT);
    assert_message(context, "trk_calibration_set_run");
    assert_status(context, trk_calibration_evaluate(c, &p, &y, &j), TRK_E_UNSUPPORTED);
    trk_run_options run;
    trk_run_options_init(&run, sizeof run);
    run.duration = 1;
    assert_status(context, trk_calibration_set_run(c, f.excitation, &run), TRK_E_RANGE);
    run.duration = 5;
    run.segment_length = 1024;
    assert_ok(context, trk_calibration_set_run(c, f.excitation, &run));
    assert_status(context, trk_calibration_evaluate(c, &p, &y, NULL), TRK_E_TARGET);
    assert_message(context, "target 'peak'");
    assert_status(context, trk_calibration_solve(c, NULL, NULL, NULL), TRK_E_CONVERGENCE);
    assert_message(context, "target 'peak'");
    trk_calibration_destroy(c);
    c = fit_create(context, TRK_VEHICLE_REFERENCE_HALF);
    assert_status(context, trk_calibration_set_run(c, f.excitation, NULL), TRK_E_ARGUMENT);
    assert_message(context, "another vehicle");
    trk_calibration_destroy(c);
    clear(&f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(known_factors), cmocka_unit_test(refusals)};
    return cmocka_run_group_tests(tests, support_setup, support_teardown);
}
