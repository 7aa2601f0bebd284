/* SPDX-License-Identifier: MIT */
/* Our own steppers as contenders, and a plain Newton loop. The road is given. */
#include "../plain_newton.h"
#include "peers.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Heights and rates under all wheels, `spacing` apart; rows of both for each time. */
static void sample_road(const problem *p, double spacing, int64_t count, double **out_height,
                        double **out_velocity)
{
    *out_height = bench_zeros((count + 1) * p->rig->roads);
    *out_velocity = bench_zeros((count + 1) * p->rig->roads);
    trk_excitation_evaluate(p->rig->road, count + 1, 0, spacing, *out_height, *out_velocity, NULL);
}

double peer_newmark(problem *p, double step, double *out_q)
{
    double *height, *velocity;
    int32_t roads = p->rig->roads, per_sample = (int32_t)lround(PROBLEM_SAMPLE / step);
    int64_t steps = p->samples * per_sample;
    sample_road(p, step, steps, &height, &velocity);
    trk_newmark *stepper = rig_stepper(p->rig, step);
    double start = bench_cpu();
    for (int64_t k = 1; k <= steps; k++) {
        bench_must(p->rig->bench,
                   trk_newmark_step(stepper, height + k * roads, velocity + k * roads, NULL));
        if (k % per_sample == 0)
            trk_newmark_get_state(stepper, out_q + k / per_sample * p->n, NULL, NULL);
    }
    double seconds = bench_cpu() - start;
    trk_newmark_destroy(stepper);
    free(height);
    free(velocity);
    return seconds;
}

double peer_plain(problem *p, double step, double *out_q)
{
    double *height, *velocity, seconds = NAN;
    int32_t roads = p->rig->roads, per_sample = (int32_t)lround(PROBLEM_SAMPLE / step);
    int64_t steps = p->samples * per_sample, k = 1;
    trk_newmark_options options;
    trk_newmark_options_init(&options, sizeof options);
    options.step = step;
    sample_road(p, step, steps, &height, &velocity);
    plain_newton *plain = plain_newton_create(p->rig->model, &options, height, velocity);
    double start = bench_cpu();
    for (; plain && k <= steps; k++) {
        if (!plain_newton_step(plain, height + k * roads, velocity + k * roads))
            break;
        if (k % per_sample == 0)
            memcpy(out_q + k / per_sample * p->n, plain_newton_q(plain),
                   (size_t)p->n * sizeof(double));
    }
    if (k > steps)
        seconds = bench_cpu() - start;
    plain_newton_destroy(plain);
    free(height);
    free(velocity);
    return seconds;
}

double peer_rungekutta(problem *p, double step, double *out_q)
{
    double *height, *velocity;
    int32_t roads = p->rig->roads, per_sample = (int32_t)lround(PROBLEM_SAMPLE / step);
    int64_t steps = p->samples * per_sample;
    trk_rungekutta_options options;
    trk_rungekutta *stepper;
    const bench *b = p->rig->bench;
    trk_rungekutta_options_init(&options, sizeof options);
    options.step = step;
    sample_road(p, step / 2, 2 * steps, &height, &velocity);
    if (trk_rungekutta_create(b->context, p->rig->model, &options, &stepper) != TRK_OK) {
        free(height);
        free(velocity);
        return NAN; /* the step is beyond its limit of stability */
    }
    bench_must(b, trk_rungekutta_set_state(stepper, 0, NULL, NULL, height, velocity, NULL));
    double start = bench_cpu();
    for (int64_t k = 1; k <= steps; k++) {
        const double *u = height + (2 * k - 1) * roads, *rate = velocity + (2 * k - 1) * roads;
        bench_must(b, trk_rungekutta_step(stepper, u, rate, NULL, u + roads, rate + roads, NULL));
        if (k % per_sample == 0)
            trk_rungekutta_get_state(stepper, out_q + k / per_sample * p->n, NULL, NULL);
    }
    double seconds = bench_cpu() - start;
    trk_rungekutta_destroy(stepper);
    free(height);
    free(velocity);
    return seconds;
}
