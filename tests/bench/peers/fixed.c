/* SPDX-License-Identifier: MIT */
/* Explicit methods with a fixed step: velocity Verlet, classical Runge-Kutta. */
#include "peers.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Height and rate of the sweep at every `spacing`; the road is given, as to a fixed-step code. */
static double *sample_road(const problem *p, double spacing, int64_t count)
{
    double *road = bench_zeros(2 * (count + 1));
    for (int64_t k = 0; k <= count; k++)
        problem_road(p, (double)k * spacing, &road[2 * k], &road[2 * k + 1]);
    return road;
}

/*
 * Velocity Verlet for forces that depend on velocity: the new acceleration sees a velocity
 * extrapolated by the second-order Adams-Bashforth formula, so that one evaluation a step
 * suffices and the order stays two.
 */
static void verlet(problem *p, double h, int per_sample, const double *road, double *out_q)
{
    int n = p->n;
    double y[2 * PROBLEM_MAX] = {0}, a[PROBLEM_MAX], before[PROBLEM_MAX], v[PROBLEM_MAX] = {0};
    problem_acceleration(p, y, road[0], road[1], a);
    memcpy(before, a, sizeof a);
    for (int64_t k = 1; k <= p->samples * per_sample; k++) {
        for (int i = 0; i < n; i++) {
            y[i] += h * (v[i] + 0.5 * h * a[i]);
            y[n + i] = v[i] + h * (1.5 * a[i] - 0.5 * before[i]);
            v[i] += 0.5 * h * a[i];
            before[i] = a[i];
        }
        problem_acceleration(p, y, road[2 * k], road[2 * k + 1], a);
        for (int i = 0; i < n; i++)
            v[i] += 0.5 * h * a[i];
        if (k % per_sample == 0)
            memcpy(out_q + k / per_sample * n, y, (size_t)n * sizeof *y);
    }
}

static void rk4(problem *p, double h, int per_sample, const double *road, double *out_q)
{
    int n = p->n;
    double y[2 * PROBLEM_MAX] = {0}, z[2 * PROBLEM_MAX], k1[PROBLEM_MAX], k2[PROBLEM_MAX],
                 k3[PROBLEM_MAX], k4[PROBLEM_MAX];
    const double *q = y, *v = y + n;
    for (int64_t k = 0; k < p->samples * per_sample; k++, road += 4) {
        problem_acceleration(p, y, road[0], road[1], k1);
        for (int i = 0; i < n; i++) {
            z[i] = q[i] + 0.5 * h * v[i];
            z[n + i] = v[i] + 0.5 * h * k1[i];
        }
        problem_acceleration(p, z, road[2], road[3], k2);
        for (int i = 0; i < n; i++) {
            z[i] = q[i] + 0.5 * h * (v[i] + 0.5 * h * k1[i]);
            z[n + i] = v[i] + 0.5 * h * k2[i];
        }
        problem_acceleration(p, z, road[2], road[3], k3);
        for (int i = 0; i < n; i++) {
            z[i] = q[i] + h * (v[i] + 0.5 * h * k2[i]);
            z[n + i] = v[i] + h * k3[i];
        }
        problem_acceleration(p, z, road[4], road[5], k4);
        for (int i = 0; i < n; i++) {
            y[i] += h * (v[i] + h / 6 * (k1[i] + k2[i] + k3[i]));
            y[n + i] += h / 6 * (k1[i] + 2 * (k2[i] + k3[i]) + k4[i]);
        }
        if ((k + 1) % per_sample == 0)
            memcpy(out_q + (k + 1) / per_sample * n, y, (size_t)n * sizeof *y);
    }
}

typedef void (*fixed_method)(problem *p, double h, int per_sample, const double *road,
                             double *out_q);

static double run(problem *p, fixed_method method, double step, int roads_a_step, double *out_q)
{
    int per_sample = (int)lround(PROBLEM_SAMPLE / step);
    step = PROBLEM_SAMPLE / per_sample;
    double *road = sample_road(p, step / roads_a_step, p->samples * per_sample * roads_a_step);
    double start = bench_cpu();
    method(p, step, per_sample, road, out_q);
    double seconds = bench_cpu() - start;
    free(road);
    return seconds;
}

double peer_verlet(problem *p, double step, double *out_q)
{
    return run(p, verlet, step, 1, out_q);
}

double peer_rk4(problem *p, double step, double *out_q)
{
    return run(p, rk4, step, 2, out_q);
}
