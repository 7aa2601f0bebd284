/* SPDX-License-Identifier: MIT */
/* Variants of a vehicle advanced together by trk_batch_run(), against single runs. */
#define _DEFAULT_SOURCE /* wait4 */
#include "fleet.h"

#include <math.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

enum { RARELY = 10 };

/* Peak resident memory [B] of a process that runs the batch, beyond one that does not. */
static double measure_memory(fleet *f)
{
    long peak[2] = {0, 0};
    for (int run = 0; run < 2; run++) {
        struct rusage usage;
        int status;
        fflush(NULL);
        pid_t child = fork();
        if (child == 0) {
            f->threads = 2;
            f->record_every = 1;
            if (run)
                fleet_run(f);
            _exit(0);
        }
        if (child < 0 || wait4(child, &status, 0, &usage) < 0 || status != 0)
            return NAN;
        peak[run] = usage.ru_maxrss;
    }
    return 1024.0 * (double)(peak[1] - peak[0]);
}

/* Least times of a variant and step [ns]. */
typedef struct times {
    double one, rare, single, stepper; /* processor time: one thread                  */
    double one_wall, two_wall;         /* wall clock, as threads need a processor each */
} times;

static double time_batch(fleet *f, int32_t threads, int64_t record_every, double (*clock)(void))
{
    f->threads = threads;
    f->record_every = record_every;
    double start = clock();
    fleet_run(f);
    return 1e9 * (clock() - start) / ((double)f->rig.steps * f->count);
}

static double time_single(const fleet *f, double *square)
{
    double start = bench_cpu();
    fleet_run_single(f, 0, square);
    return 1e9 * (bench_cpu() - start) / (double)f->rig.steps;
}

static times race(const bench *b, fleet *f)
{
    times t = {INFINITY, INFINITY, INFINITY, INFINITY, INFINITY, INFINITY};
    trk_newmark_statistics statistics;
    double *square = bench_zeros(f->rig.sensors);
    for (int round = 0; round < b->rounds; round++) {
        double step = 1e9 * rig_run_stepper(&f->rig, NULL, &statistics) / (double)f->rig.steps;
        t.stepper = fmin(t.stepper, step);
        t.single = fmin(t.single, time_single(f, square));
        t.rare = fmin(t.rare, time_batch(f, 1, RARELY, bench_cpu));
        t.one_wall = fmin(t.one_wall, time_batch(f, 1, 1, bench_now));
        t.two_wall = fmin(t.two_wall, time_batch(f, 2, 1, bench_now));
        t.one = fmin(t.one, time_batch(f, 1, 1, bench_cpu));
    }
    free(square);
    return t;
}

static void measure(bench *b, const char *vehicle, fleet *f)
{
    char what[64], name[96];
    const rig *r = &f->rig;
    times t = race(b, f);
    double elements = r->n + r->links + r->curves, error = fleet_error(f);
    snprintf(what, sizeof what, "%s, %d variants", vehicle, (int)f->count);
    snprintf(name, sizeof name, "%s: all %d sensors", what, (int)r->sensors);
    bench_report(b, (bench_row){name, t.one, "ns/step", t.one / t.single, "trk_simulate",
                                t.one / (elements + r->sensors), "element", error, 1e-8});
    snprintf(name, sizeof name, "%s: each 10th step recorded", what);
    bench_report(b, (bench_row){name, t.rare, "ns/step", t.rare / t.stepper, "trk_newmark_step",
                                t.rare / elements, "element"});
    snprintf(name, sizeof name, "%s: 2 threads", what);
    bench_report(b, (bench_row){name, t.two_wall, "ns/step", t.two_wall / t.one_wall,
                                "1 thread, wall clock"});
    double bytes = measure_memory(f);
    snprintf(name, sizeof name, "%s: peak memory", what);
    bench_report(b, (bench_row){.name = name,
                                .value = 1e-6 * bytes,
                                .unit = "MB",
                                .ratio = bytes / (8.0 * (double)r->steps * f->count * r->sensors),
                                .of = "all samples",
                                .note = "2 threads; beyond the models"});
}

void bench_batch(bench *b)
{
    fleet f;
    double seconds = b->tiny ? 0.5 : b->seconds / 16;
    fleet_create(b, TRK_VEHICLE_REFERENCE_TRUCK, b->tiny ? 9 : 64, seconds, &f);
    measure(b, "truck", &f);
    fleet_destroy(&f);
    fleet_create(b, TRK_VEHICLE_REFERENCE_HALF, b->tiny ? 9 : 256, seconds, &f);
    measure(b, "half truck", &f);
    fleet_destroy(&f);
    if (!b->full)
        return;
    int rounds = b->rounds;
    b->rounds = 1; /* minutes each */
    fleet_create(b, TRK_VEHICLE_REFERENCE_HALF, 10000, b->seconds, &f);
    measure(b, "half truck", &f);
    fleet_destroy(&f);
    b->rounds = rounds;
}
