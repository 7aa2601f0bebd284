/* SPDX-License-Identifier: MIT */
/*
 * Nanoseconds a step: the stepper beside a plain full-Newton loop, over the road-simulator
 * sweep of the thesis, evaluated beforehand. Both run in turns; the best of some runs counts.
 *
 *     bench_newmark [--json] [seconds]
 */
#include "plain_newton.h"

#include <truckride/simulate.h>
#include <truckride/vehicle.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { ROUNDS = 3, EVERY = 10 }; /* compare each EVERY-th step */

typedef struct bench {
    trk_context *context;
    int64_t steps;
    trk_model *model;
    trk_excitation *road;
    double *height, *velocity; /* steps x roads */
    double *q_stepper, *q_plain;
} bench;

typedef struct result {
    double stepper, plain, simulate; /* [ns] a step */
    double iterations, plain_iterations, difference;
} result;

static double now(void)
{
    struct timespec t;
    timespec_get(&t, TIME_UTC);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void must(const bench *b, trk_status status)
{
    if (status == TRK_OK)
        return;
    fprintf(stderr, "bench_newmark: %s\n", trk_context_message(b->context));
    exit(1);
}

static double *zeros(int64_t count)
{
    double *block = calloc((size_t)count, sizeof *block);
    if (!block) {
        fprintf(stderr, "bench_newmark: no memory\n");
        exit(1);
    }
    return block;
}

/* The sweep, ten times as high as the thesis's, on the left and 0.6 of it on the right. */
static void prepare(bench *b, trk_vehicle vehicle, trk_variant variant, const trk_signal *sweep)
{
    trk_spec *spec;
    must(b, trk_vehicle_create_builtin(b->context, vehicle, variant, &spec));
    must(b, trk_model_compile(b->context, spec, NULL, &b->model));
    trk_spec_destroy(spec);
    must(b, trk_excitation_create(b->context, b->model, &b->road));
    for (int32_t k = 1; k <= trk_model_count(b->model, TRK_PART_ROAD); k++) {
        double x, y;
        must(b, trk_model_get_road_place(b->model, k, &x, &y));
        must(b, trk_excitation_add_motion(b->road, k, sweep, y < 0 ? 6 : 10, -x / 20));
    }
    int64_t roads = trk_excitation_roads(b->road),
            n = trk_model_count(b->model, TRK_PART_COORDINATE);
    b->height = zeros(b->steps * roads);
    b->velocity = zeros(b->steps * roads);
    b->q_stepper = zeros((b->steps / EVERY + 1) * n);
    b->q_plain = zeros((b->steps / EVERY + 1) * n);
    trk_excitation_evaluate(b->road, b->steps, 1e-3, 1e-3, b->height, b->velocity, NULL);
}

static void finish(bench *b)
{
    trk_excitation_destroy(b->road);
    trk_model_destroy(b->model);
    free(b->height);
    free(b->velocity);
    free(b->q_stepper);
    free(b->q_plain);
}

static double run_stepper(bench *b, result *r)
{
    trk_newmark *stepper;
    trk_newmark_statistics statistics = {.struct_size = sizeof statistics};
    int32_t roads = trk_excitation_roads(b->road),
            n = trk_model_count(b->model, TRK_PART_COORDINATE);
    must(b, trk_newmark_create(b->context, b->model, NULL, &stepper));
    double start = now();
    for (int64_t k = 0; k < b->steps; k++) {
        must(b, trk_newmark_step(stepper, b->height + k * roads, b->velocity + k * roads, NULL));
        if (k % EVERY == 0)
            trk_newmark_get_state(stepper, b->q_stepper + k / EVERY * n, NULL, NULL);
    }
    double seconds = now() - start;
    must(b, trk_newmark_get_statistics(stepper, &statistics));
    r->iterations = (double)statistics.iterations / (double)b->steps;
    trk_newmark_destroy(stepper);
    return seconds;
}

static double run_plain(bench *b, result *r)
{
    trk_newmark_options options;
    trk_newmark_options_init(&options, sizeof options);
    int32_t roads = trk_excitation_roads(b->road),
            n = trk_model_count(b->model, TRK_PART_COORDINATE);
    plain_newton *plain = plain_newton_create(b->model, &options);
    if (!plain)
        return NAN;
    double start = now();
    for (int64_t k = 0; k < b->steps; k++) {
        if (!plain_newton_step(plain, b->height + k * roads, b->velocity + k * roads)) {
            fprintf(stderr, "bench_newmark: the plain loop does not converge in step %lld\n",
                    (long long)k);
            exit(1);
        }
        if (k % EVERY == 0)
            memcpy(b->q_plain + k / EVERY * n, plain_newton_q(plain), (size_t)n * sizeof(double));
    }
    double seconds = now() - start;
    r->plain_iterations = (double)plain_newton_iterations(plain) / (double)b->steps;
    plain_newton_destroy(plain);
    return seconds;
}

static double run_simulate(bench *b)
{
    trk_simulate_options options;
    trk_simulate_options_init(&options, sizeof options);
    options.duration = (double)b->steps * 1e-3;
    trk_series *series;
    double start = now();
    must(b, trk_simulate(b->context, b->model, b->road, NULL, &options, NULL, NULL, &series));
    double seconds = now() - start;
    trk_series_destroy(series);
    return seconds;
}

/* Largest difference of a coordinate over its peak. */
static double difference(const bench *b)
{
    int64_t n = trk_model_count(b->model, TRK_PART_COORDINATE), rows = (b->steps - 1) / EVERY + 1;
    double worst = 0;
    for (int64_t i = 0; i < n; i++) {
        double peak = 0, off = 0;
        for (int64_t k = i; k < rows * n; k += n) {
            peak = fmax(peak, fabs(b->q_plain[k]));
            off = fmax(off, fabs(b->q_plain[k] - b->q_stepper[k]));
        }
        worst = fmax(worst, off / peak);
    }
    return worst;
}

static result measure(bench *b, trk_vehicle vehicle, trk_variant variant, const trk_signal *sweep)
{
    result r = {INFINITY, INFINITY, INFINITY, 0, 0, 0};
    double to_nanoseconds = 1e9 / (double)b->steps;
    prepare(b, vehicle, variant, sweep);
    for (int round = 0; round < ROUNDS; round++) {
        r.stepper = fmin(r.stepper, to_nanoseconds * run_stepper(b, &r));
        r.plain = fmin(r.plain, to_nanoseconds * run_plain(b, &r));
        r.simulate = fmin(r.simulate, to_nanoseconds * run_simulate(b));
    }
    r.difference = difference(b);
    finish(b);
    return r;
}

int main(int argc, char **argv)
{
    static const struct {
        const char *name;
        trk_vehicle vehicle;
        trk_variant variant;
    } cases[] = {
        {"truck 13 DOF, 8 damper curves", TRK_VEHICLE_REFERENCE_TRUCK, TRK_VARIANT_THESIS_DAMPERS},
        {"truck 13 DOF, all curves", TRK_VEHICLE_REFERENCE_TRUCK, TRK_VARIANT_NONLINEAR},
        {"truck 13 DOF, linear", TRK_VEHICLE_REFERENCE_TRUCK, TRK_VARIANT_LINEAR},
        {"half truck 7 DOF, 4 damper curves", TRK_VEHICLE_REFERENCE_HALF,
         TRK_VARIANT_THESIS_DAMPERS},
        {"quarter car 2 DOF, 1 damper curve", TRK_VEHICLE_THESIS_QUARTER, TRK_VARIANT_LINEAR},
    };
    int json = argc > 1 && strcmp(argv[1], "--json") == 0;
    double seconds = argc > 1 + json ? strtod(argv[1 + json], NULL) : 480;
    bench b = {.steps = (int64_t)(1000 * seconds)};
    trk_signal *sweep;
    if (b.steps < 1 || trk_context_create(NULL, NULL, &b.context) != TRK_OK) {
        fprintf(stderr, "usage: bench_newmark [--json] [seconds]\n");
        return 1;
    }
    must(&b, trk_signal_create_sweep(b.context, NULL, &sweep));
    if (json)
        printf("{\"steps\": %lld, \"unit\": \"ns/step\", \"cases\": [", (long long)b.steps);
    else
        printf("%lld steps of 1 ms; ns a step, best of %d\n%-34s %9s %9s %7s %6s %6s %10s %9s\n",
               (long long)b.steps, ROUNDS, "vehicle", "condensed", "plain", "ratio", "iter",
               "plain", "difference", "simulate");
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        result r = measure(&b, cases[k].vehicle, cases[k].variant, sweep);
        printf(
            json ? "%s{\"vehicle\": \"%s\", \"condensed\": %.1f, \"plain\": %.1f, \"ratio\": %.4f, "
                   "\"iterations\": %.3f, \"plain_iterations\": %.3f, \"difference\": %.3g, "
                   "\"simulate\": %.1f}"
                 : "%s%-34s %9.1f %9.1f %7.4f %6.3f %6.3f %10.2g %9.1f\n",
            json && k ? ", " : "", cases[k].name, r.stepper, r.plain, r.stepper / r.plain,
            r.iterations, r.plain_iterations, r.difference, r.simulate);
        fflush(stdout);
    }
    if (json)
        printf("]}\n");
    trk_signal_destroy(sweep);
    trk_context_destroy(b.context);
    return 0;
}
