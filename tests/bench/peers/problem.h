/* SPDX-License-Identifier: MIT */
/*
 * The truck on the rig as a first-order system for other people's integrators: y = (q, v),
 * y' = (v, a(q, v, t)). The linear part is one dense product, premultiplied by M^-1 and laid
 * across the registers; dampers are cubic pieces, the current one kept; the road is evaluated in
 * closed form. All peers use this right-hand side.
 */
#ifndef TRK_TESTS_BENCH_PROBLEM_H
#define TRK_TESTS_BENCH_PROBLEM_H

#include "../rig.h"

enum { PROBLEM_MAX = 16, PROBLEM_TABLES = 8, PROBLEM_POINTS = 32 };

typedef double problem_lanes __attribute__((vector_size(64)));

/* A vector over the coordinates, padded. */
typedef struct problem_vector {
    problem_lanes part[2];
} problem_vector;

typedef struct problem_table {
    int points, at; /* piece in use: `at` is after point at - 1 */
    double x[PROBLEM_POINTS];
    double c[PROBLEM_POINTS + 1][4]; /* a piece before, between and after the points */
} problem_table;

typedef struct problem {
    problem_vector linear[2 * PROBLEM_MAX];  /* columns of -M^-1 [K C]                       */
    problem_vector of_height, of_rate;       /* a of a unit of the sweep and of its rate     */
    problem_vector of_force[PROBLEM_TABLES]; /* columns of -M^-1 B^T                         */
    problem_lanes rate_of[PROBLEM_MAX];      /* columns of B: damper velocities of v         */
    problem_table table[PROBLEM_TABLES];
    int n, tables;
    double seconds, frequency, growth, amplitude; /* of the sweep                             */
    int64_t samples;                              /* of q asked for, beside t = 0             */
    const rig *rig;
    long long evaluations;
} problem;

/* q is asked for every so many steps of 1 ms, in seconds: many steps divide it. */
enum { PROBLEM_EVERY = 30 };
#define PROBLEM_SAMPLE (1e-3 * PROBLEM_EVERY)

/* From a vehicle with linear springs. Ends the program if it is of another kind. */
problem *problem_create(const rig *r);
void problem_destroy(problem *p);

/* Height and rate of the sweep. */
void problem_road(const problem *p, double t, double *height, double *rate);

/* a for y = (q, v), length 2 n, with the road given; or at a time. */
void problem_acceleration(problem *p, const double *y, double height, double rate, double *a);
void problem_derivative(problem *p, double t, const double *y, double *out);

/* d(y')/dy, 2 n x 2 n, column-major. */
void problem_jacobian(problem *p, const double *y, double *out);

#endif
