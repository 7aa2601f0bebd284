/* SPDX-License-Identifier: MIT */
/* The truck's step by each way the library has to take it, on this processor, and with friction
 * in its leaf springs, which only the general path takes. */
#include "rig.h"

#include "newmark/newmark.h"

#include <math.h>
#include <stdlib.h>

typedef struct kernel_run {
    const rig *rig;
    int32_t kernel;
    double *q;
} kernel_run;

static double run(void *argument)
{
    kernel_run *k = argument;
    const rig *r = k->rig;
    trk_newmark *stepper = rig_stepper(r, 1e-3);
    double seconds = NAN;
    if (trk_newmark_set_kernel(stepper, k->kernel))
        seconds = rig_drive(r, stepper, k->q);
    trk_newmark_destroy(stepper);
    return seconds;
}

void bench_kernels(bench *b)
{
    static const char *const name[] = {"truck: general path", "truck: portable kernel",
                                       "truck: AVX2 kernel", "truck: AVX-512 kernel"};
    enum { KERNELS = sizeof name / sizeof *name };
    rig r, leaves;
    kernel_run runs[KERNELS + 1];
    bench_contender turns[KERNELS + 1];
    rig_create(b, TRK_VEHICLE_REFERENCE_TRUCK, TRK_VARIANT_THESIS_DAMPERS, RIG_ALL_SENSORS,
               b->tiny ? b->seconds : b->seconds / 8, &r);
    int64_t rows = r.steps / RIG_EVERY + 1;
    for (int32_t k = 0; k < KERNELS; k++) {
        runs[k] = (kernel_run){&r, k, bench_zeros(rows * r.n)};
        turns[k] = (bench_contender){run, &runs[k], 0};
    }
    rig_create_on_leaves(b, TRK_VEHICLE_REFERENCE_TRUCK, TRK_VARIANT_THESIS_DAMPERS, r.seconds,
                         &leaves);
    runs[KERNELS] = (kernel_run){&leaves, TRK_KERNEL_GENERAL, NULL};
    turns[KERNELS] = (bench_contender){run, &runs[KERNELS], 0};
    bench_race(b, turns, KERNELS + 1);
    for (int k = 0; k < KERNELS; k++) {
        double ns = 1e9 * turns[k].best / (double)r.steps;
        if (isfinite(ns))
            bench_report(b, (bench_row){.name = name[k],
                                        .value = ns,
                                        .unit = "ns/step",
                                        .ratio = turns[k].best / turns[0].best,
                                        .of = "general path",
                                        .error = bench_error(rows, r.n, runs[k].q, runs[0].q),
                                        .bound = 1e-6});
        else
            bench_report(b, (bench_row){.name = name[k], .note = "not on this processor"});
    }
    bench_report(b, (bench_row){.name = "truck on leaf springs with friction: general path",
                                .value = 1e9 * turns[KERNELS].best / (double)r.steps,
                                .unit = "ns/step",
                                .ratio = turns[KERNELS].best / turns[0].best,
                                .of = "without friction"});
    for (int k = 0; k < KERNELS; k++)
        free(runs[k].q);
    rig_destroy(&leaves);
    rig_destroy(&r);
}
