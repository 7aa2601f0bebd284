/* SPDX-License-Identifier: MIT */
/*
 * Dormand-Prince 5(4), first same as last, PI step control and the continuous extension of
 * Hairer, Norsett and Wanner, Solving Ordinary Differential Equations I, 2nd ed., II.5-II.6.
 */
#include "peers.h"

#include <math.h>
#include <string.h>

enum { STAGES = 7, MAX_Y = 2 * PROBLEM_MAX };

static const double node[STAGES] = {0, 1. / 5, 3. / 10, 4. / 5, 8. / 9, 1, 1};
static const double weight[STAGES][STAGES - 1] = {
    {0},
    {1. / 5},
    {3. / 40, 9. / 40},
    {44. / 45, -56. / 15, 32. / 9},
    {19372. / 6561, -25360. / 2187, 64448. / 6561, -212. / 729},
    {9017. / 3168, -355. / 33, 46732. / 5247, 49. / 176, -5103. / 18656},
    {35. / 384, 0, 500. / 1113, 125. / 192, -2187. / 6784, 11. / 84},
};
static const double error_weight[STAGES] = {71. / 57600,      0,         -71. / 16695, 71. / 1920,
                                            -17253. / 339200, 22. / 525, -1. / 40};
static const double dense_weight[STAGES] = {
    -12715105075. / 11282082432,  0,
    87487479700. / 32700410799,   -10690763975. / 1880347072,
    701980252875. / 199316789632, -1453857185. / 822651844,
    69997945. / 29380423};

typedef struct attempt {
    int m; /* 2 n */
    double k[STAGES][MAX_Y], y[MAX_Y];
} attempt;

/* Stages and result of a step from y; k[0] is known. Returns the error over the tolerance. */
static double try_step(problem *p, attempt *s, double t, double h, const double *y,
                       double tolerance)
{
    double sum = 0;
    for (int stage = 1; stage < STAGES; stage++) {
        for (int i = 0; i < s->m; i++) {
            double slope = 0;
            for (int j = 0; j < stage; j++)
                slope += weight[stage][j] * s->k[j][i];
            s->y[i] = y[i] + h * slope;
        }
        problem_derivative(p, t + node[stage] * h, s->y, s->k[stage]);
    }
    for (int i = 0; i < s->m; i++) {
        double slope = 0;
        for (int j = 0; j < STAGES; j++)
            slope += error_weight[j] * s->k[j][i];
        double e =
            h * slope / (peer_absolute(tolerance) + tolerance * fmax(fabs(y[i]), fabs(s->y[i])));
        sum += e * e;
    }
    return sqrt(sum / s->m);
}

/* q at all samples within (t, t + h]. */
static void write_samples(const problem *p, const attempt *s, double t, double h, const double *y,
                          int64_t *next, double *out_q)
{
    for (; *next <= p->samples && (double)*next * PROBLEM_SAMPLE <= t + h * (1 + 1e-12); ++*next) {
        double x = ((double)*next * PROBLEM_SAMPLE - t) / h, x1 = 1 - x;
        for (int i = 0; i < p->n; i++) {
            double change = s->y[i] - y[i], bend = h * s->k[0][i] - change, dense = 0;
            double last = change - h * s->k[STAGES - 1][i] - bend;
            for (int j = 0; j < STAGES; j++)
                dense += h * dense_weight[j] * s->k[j][i];
            out_q[*next * p->n + i] = y[i] + x * (change + x1 * (bend + x * (last + x1 * dense)));
        }
    }
}

double peer_dopri5(problem *p, double tolerance, double *out_q)
{
    attempt s = {.m = 2 * p->n};
    double y[MAX_Y] = {0}, t = 0, h = 1e-4, last_error = 1e-4;
    int64_t next = 1;
    double start = bench_cpu();
    problem_derivative(p, 0, y, s.k[0]);
    while (next <= p->samples) {
        double error = fmax(try_step(p, &s, t, h, y, tolerance), 1e-10);
        if (!(h > 1e-12))
            return NAN;
        if (!(error <= 1)) {
            h *= fmax(0.2, 0.9 * pow(error, -0.2));
            continue;
        }
        write_samples(p, &s, t, h, y, &next, out_q);
        t += h;
        memcpy(y, s.y, sizeof y);
        memcpy(s.k[0], s.k[STAGES - 1], sizeof s.k[0]);
        h *= fmin(10, fmax(0.2, 0.9 * pow(error, -0.17) * pow(last_error, 0.04)));
        last_error = fmax(error, 1e-4);
    }
    return bench_cpu() - start;
}
