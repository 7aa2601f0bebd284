/* SPDX-License-Identifier: MIT */
/*
 * The thesis's own run: its sweep of 480 s and 1 mm under all wheels in phase, road given, steps
 * alone; in one call for many steps by each kernel, in single calls, and in a plain Newton loop.
 */
#include "plain_newton.h"
#include "rig.h"

#include "newmark/newmark.h"

#include <math.h>
#include <stdlib.h>

enum { STEPS_A_SECOND = 1000, FULL = 480, SINGLE_CALLS = -1 };

typedef struct thesis_run {
    const rig *rig;
    const double *height, *velocity; /* (steps + 1) x roads, the first row at t = 0 */
    int64_t steps;
    int32_t kernel; /* TRK_KERNEL_..., or SINGLE_CALLS of the one that is chosen */
} thesis_run;

static double run(void *argument)
{
    const thesis_run *r = argument;
    const double *height = r->height + r->rig->roads, *velocity = r->velocity + r->rig->roads;
    const bench *b = r->rig->bench;
    trk_newmark *stepper;
    int64_t taken = r->steps;
    bench_must(b, trk_newmark_create(b->context, r->rig->model, NULL, &stepper));
    bool have = r->kernel == SINGLE_CALLS || trk_newmark_set_kernel(stepper, r->kernel);
    double start = bench_cpu();
    if (have && r->kernel != SINGLE_CALLS)
        bench_must(b, trk_newmark_record(stepper, r->steps, height, velocity, NULL, NULL, &taken));
    for (int64_t k = 0; r->kernel == SINGLE_CALLS && k < r->steps; k++)
        bench_must(b, trk_newmark_step(stepper, height + k * r->rig->roads,
                                       velocity + k * r->rig->roads, NULL));
    double seconds = bench_cpu() - start;
    trk_newmark_destroy(stepper);
    return have ? seconds : NAN;
}

static double run_plain(void *argument)
{
    const thesis_run *r = argument;
    plain_newton *plain = plain_newton_create(r->rig->model, NULL, r->height, r->velocity);
    if (!plain)
        return NAN;
    double start = bench_cpu();
    for (int64_t k = 1; k <= r->steps; k++)
        if (!plain_newton_step(plain, r->height + k * r->rig->roads,
                               r->velocity + k * r->rig->roads))
            return NAN;
    double seconds = bench_cpu() - start;
    plain_newton_destroy(plain);
    return seconds;
}

void bench_thesis(bench *b)
{
    static const struct {
        const char *name;
        int32_t kernel;
    } ways[] = {{"480 s, 1 mm: portable kernel, steps in a run", TRK_KERNEL_PORTABLE},
                {"480 s, 1 mm: AVX2 kernel, steps in a run", TRK_KERNEL_AVX2},
                {"480 s, 1 mm: AVX-512 kernel, steps in a run", TRK_KERNEL_AVX512},
                {"480 s, 1 mm: trk_newmark_step", SINGLE_CALLS}};
    enum { WAYS = sizeof ways / sizeof *ways };
    rig r;
    rig_create(b, TRK_VEHICLE_REFERENCE_TRUCK, TRK_VARIANT_THESIS_DAMPERS, RIG_ALL_SENSORS, 1, &r);
    int64_t steps = STEPS_A_SECOND * (b->tiny ? 2 : FULL), numbers = (steps + 1) * r.roads;
    double *height = bench_zeros(numbers), *velocity = bench_zeros(numbers);
    trk_signal *sweep;
    trk_excitation *road;
    bench_must(b, trk_signal_create_sweep(b->context, NULL, &sweep));
    bench_must(b, trk_excitation_create(b->context, r.model, &road));
    bench_must(b, trk_excitation_add_motion(road, TRK_ROAD_ALL, sweep, 1, 0));
    trk_excitation_evaluate(road, steps + 1, 0, 1.0 / STEPS_A_SECOND, height, velocity, NULL);
    thesis_run runs[WAYS + 1];
    bench_contender turns[WAYS + 1];
    for (int k = 0; k <= WAYS; k++) {
        runs[k] = (thesis_run){&r, height, velocity, steps, k < WAYS ? ways[k].kernel : 0};
        turns[k] = (bench_contender){k < WAYS ? run : run_plain, &runs[k], 0};
    }
    bench_race(b, turns, WAYS + 1);
    double to_ns = 1e9 / (double)steps, plain = turns[WAYS].best;
    bench_report(b, (bench_row){.name = "480 s, 1 mm: plain Newton",
                                .value = to_ns * plain,
                                .unit = "ns/step",
                                .ratio = 1,
                                .of = "itself"});
    for (int k = 0; k < WAYS; k++)
        if (isfinite(turns[k].best))
            bench_report(b, (bench_row){.name = ways[k].name,
                                        .value = to_ns * turns[k].best,
                                        .unit = "ns/step",
                                        .ratio = turns[k].best / plain,
                                        .of = "plain Newton"});
    trk_excitation_destroy(road);
    trk_signal_destroy(sweep);
    free(height);
    free(velocity);
    rig_destroy(&r);
}
