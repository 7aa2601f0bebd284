/* SPDX-License-Identifier: MIT */
/* Time a step of every vehicle: the stepper, the whole of trk_simulate(), a plain Newton loop. */
#include "plain_newton.h"
#include "rig.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { FEW_SENSORS = 20 };

typedef struct vehicle_run {
    rig all, few; /* all sensors, few sensors; the same otherwise */
    double *q, *q_plain;
    trk_newmark_statistics statistics;
} vehicle_run;

static double run_stepper(void *argument)
{
    vehicle_run *r = argument;
    return rig_run_stepper(&r->all, NULL, &r->statistics);
}

static double run_simulate(void *argument)
{
    return rig_run_simulate(&((vehicle_run *)argument)->all);
}

static double run_simulate_few(void *argument)
{
    return rig_run_simulate(&((vehicle_run *)argument)->few);
}

static double run_plain(void *argument)
{
    vehicle_run *r = argument;
    const rig *g = &r->all;
    plain_newton *plain = plain_newton_create(g->model, NULL, g->height, g->velocity);
    if (!plain)
        return NAN;
    double start = bench_cpu();
    for (int64_t k = 1; k <= g->steps; k++) {
        if (!plain_newton_step(plain, g->height + k * g->roads, g->velocity + k * g->roads))
            return NAN;
        if (k % RIG_EVERY == 0)
            memcpy(r->q_plain + k / RIG_EVERY * g->n, plain_newton_q(plain),
                   (size_t)g->n * sizeof(double));
    }
    double seconds = bench_cpu() - start;
    plain_newton_destroy(plain);
    return seconds;
}

/*
 * Operations of a step in modal form: two recurrences of three terms a mode, drives of height
 * and rate, tables from and to modes, and in each sweep the coupling of the tables and a cubic
 * with its slope. An estimate of the least, not a count of what the kernel does.
 */
static double operations(const vehicle_run *r)
{
    double n = r->all.n, p = r->all.curves, roads = r->all.roads;
    double sweeps = 1 + (double)r->statistics.iterations / (double)r->statistics.steps;
    return 12 * n + 4 * n * roads + 4 * n * p + sweeps * p * (2 * p + 10);
}

static void report(bench *b, const char *name, vehicle_run *r, const double *ns)
{
    char text[96], note[96];
    const rig *g = &r->all;
    int elements = g->n + g->links + g->curves;
    double plain = ns[3];
    double error = bench_error(g->steps / RIG_EVERY + 1, g->n, r->q, r->q_plain);
    snprintf(note, sizeof note, "%d coordinates, %d links, %d curves; %.2f corrections a step",
             (int)g->n, (int)g->links, (int)g->curves,
             (double)r->statistics.iterations / (double)r->statistics.steps);
    snprintf(text, sizeof text, "%s: trk_newmark_step", name);
    bench_report(b, (bench_row){text, ns[0], "ns/step", ns[0] / plain, "plain Newton",
                                ns[0] / elements, "element", error, 1e-6, note});
    snprintf(text, sizeof text, "%s: operations at FMA peak", name);
    bench_report(b, (bench_row){text, operations(r), "flop", 1e9 * operations(r) / b->peak / ns[0],
                                "trk_newmark_step"});
    snprintf(text, sizeof text, "%s: trk_simulate, %d sensors", name, (int)g->sensors);
    bench_report(b, (bench_row){text, ns[1], "ns/step", ns[1] / plain, "plain Newton",
                                ns[1] / (elements + g->sensors), "element"});
    if (r->few.model) {
        snprintf(text, sizeof text, "%s: trk_simulate, %d sensors", name, (int)r->few.sensors);
        bench_report(b, (bench_row){text, ns[2], "ns/step", ns[2] / plain, "plain Newton",
                                    ns[2] / (elements + r->few.sensors), "element"});
    }
    snprintf(text, sizeof text, "%s: plain Newton", name);
    bench_report(b, (bench_row){text, plain, "ns/step", plain / ns[0], "trk_newmark_step",
                                plain / elements, "element"});
}

static void measure(bench *b, const char *name, trk_vehicle vehicle, trk_variant variant)
{
    vehicle_run r = {0};
    rig_create(b, vehicle, variant, RIG_ALL_SENSORS, b->seconds, &r.all);
    bool few = r.all.sensors > FEW_SENSORS;
    if (few)
        rig_create(b, vehicle, variant, FEW_SENSORS, b->seconds, &r.few);
    int64_t rows = r.all.steps / RIG_EVERY + 1;
    r.q = bench_zeros(rows * r.all.n);
    r.q_plain = bench_zeros(rows * r.all.n);
    bench_contender contenders[] = {
        {run_stepper, &r, 0},
        {run_simulate, &r, 0},
        {few ? run_simulate_few : run_simulate, &r, 0},
        {run_plain, &r, 0},
    };
    double ns[4];
    rig_run_stepper(&r.all, r.q, &r.statistics); /* to compare; reading the state takes time */
    bench_race(b, contenders, 4);
    for (int k = 0; k < 4; k++)
        ns[k] = 1e9 * contenders[k].best / (double)r.all.steps;
    report(b, name, &r, ns);
    free(r.q);
    free(r.q_plain);
    rig_destroy(&r.all);
    if (few)
        rig_destroy(&r.few);
}

void bench_truck(bench *b)
{
    measure(b, "truck", TRK_VEHICLE_REFERENCE_TRUCK, TRK_VARIANT_THESIS_DAMPERS);
    measure(b, "truck, linear", TRK_VEHICLE_REFERENCE_TRUCK, TRK_VARIANT_LINEAR);
    measure(b, "truck, all curves", TRK_VEHICLE_REFERENCE_TRUCK, TRK_VARIANT_NONLINEAR);
    measure(b, "half truck", TRK_VEHICLE_REFERENCE_HALF, TRK_VARIANT_THESIS_DAMPERS);
    measure(b, "quarter car", TRK_VEHICLE_THESIS_QUARTER, TRK_VARIANT_THESIS_DAMPERS);
}
