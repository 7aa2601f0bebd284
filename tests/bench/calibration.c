/* SPDX-License-Identifier: MIT */
/* Tire stiffnesses of the truck fitted to the frequencies of its axles, in units of modes. */
#include "bench.h"

#include <math.h>

enum { AXLES = 2 };

static const double wanted[AXLES] = {1.3, 0.8}; /* factors on the tire stiffness */

typedef struct calibration_run {
    const bench *bench;
    trk_spec *spec;
    trk_model *model;
    double frequency[AXLES]; /* of a truck whose tires have the wanted factors [Hz] */
    double error;
    int64_t evaluations;
} calibration_run;

static trk_calibration *create(const calibration_run *r)
{
    static const char *const pattern[AXLES] = {"front_*_tire", "rear_*_tire"};
    static const char *const coordinate[AXLES] = {"front_axle.z", "rear_axle.z"};
    trk_calibration *calibration;
    bench_must(r->bench, trk_calibration_create(r->bench->context, r->spec, NULL, &calibration));
    for (int32_t k = 0; k < AXLES; k++) {
        trk_target_options target;
        int32_t parameter;
        bench_must(r->bench,
                   trk_calibration_add_parameter(calibration, pattern[k], NULL, &parameter));
        bench_must(r->bench, trk_calibration_act_on(calibration, parameter, TRK_FIELD_STIFFNESS,
                                                    pattern[k], 1, NULL));
        trk_target_options_init(&target, sizeof target);
        target.value = r->frequency[k];
        target.coordinate = coordinate[k];
        bench_must(r->bench, trk_calibration_add_target(calibration, coordinate[k], &target, NULL));
    }
    return calibration;
}

static double run(void *argument)
{
    calibration_run *r = argument;
    double start = bench_cpu();
    trk_calibration *calibration = create(r);
    bench_must(r->bench, trk_calibration_solve(calibration, NULL, NULL, NULL));
    double seconds = bench_cpu() - start;
    r->evaluations = trk_calibration_evaluations(calibration);
    r->error = 0;
    for (int32_t k = 0; k < AXLES; k++) {
        trk_parameter_result result = {.struct_size = sizeof result};
        bench_must(r->bench, trk_calibration_get_parameter(calibration, k + 1, &result));
        r->error = fmax(r->error, fabs(result.fitted / wanted[k] - 1));
    }
    trk_calibration_destroy(calibration);
    return seconds;
}

static void modes(void *argument)
{
    calibration_run *r = argument;
    trk_modes *modes;
    bench_must(r->bench, trk_modes_create_undamped(r->bench->context, r->model, NULL, &modes));
    trk_modes_destroy(modes);
}

void bench_calibration(bench *b)
{
    calibration_run r = {.bench = b, .frequency = {1, 1}};
    char note[64];
    if (!trk_has_feature(TRK_FEATURE_NLOPT) || !trk_has_feature(TRK_FEATURE_LAPACK)) {
        bench_report(b, (bench_row){.name = "tires", .note = "this build has no NLopt or LAPACK"});
        return;
    }
    bench_must(b, trk_vehicle_create_builtin(b->context, TRK_VEHICLE_REFERENCE_TRUCK,
                                             TRK_VARIANT_LINEAR, &r.spec));
    bench_must(b, trk_model_compile(b->context, r.spec, NULL, &r.model));
    trk_calibration *calibration = create(&r);
    bench_must(b, trk_calibration_evaluate(calibration, wanted, r.frequency, NULL));
    trk_calibration_destroy(calibration);
    bench_contender turn = {run, &r, 0};
    bench_race(b, &turn, 1);
    double one = bench_repeat(modes, &r);
    snprintf(note, sizeof note, "%lld evaluations, compiling and modes each",
             (long long)r.evaluations);
    bench_report(b, (bench_row){.name = "tires of both axles to two frequencies",
                                .value = 1e3 * turn.best,
                                .unit = "ms",
                                .ratio = turn.best / one,
                                .of = "undamped modes",
                                .each = 1e9 * turn.best / (double)r.evaluations,
                                .element = "evaluation",
                                .error = r.error,
                                .bound = 1e-4,
                                .note = note});
    trk_model_destroy(r.model);
    trk_spec_destroy(r.spec);
}
