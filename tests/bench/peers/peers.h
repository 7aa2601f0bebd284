/* SPDX-License-Identifier: MIT */
/*
 * Integrators that compete at matched accuracy. Each solves the problem from rest and fills
 * out_q, (samples + 1) x n, and returns the seconds the integration took, NAN if it failed. The
 * setting is a step [s] or a relative tolerance.
 */
#ifndef TRK_TESTS_BENCH_PEERS_H
#define TRK_TESTS_BENCH_PEERS_H

#include "problem.h"

typedef double (*peer_solver)(problem *p, double setting, double *out_q);

/* Our steppers, and a plain Newton loop on all accelerations; a fixed step that divides a
 * sample, the road given. */
double peer_newmark(problem *p, double step, double *out_q);
double peer_rungekutta(problem *p, double step, double *out_q);
double peer_plain(problem *p, double step, double *out_q);

/* Velocity Verlet and classical Runge-Kutta, likewise. */
double peer_verlet(problem *p, double step, double *out_q);
double peer_rk4(problem *p, double step, double *out_q);

/* Dormand-Prince 5(4) with step control and dense output. */
double peer_dopri5(problem *p, double tolerance, double *out_q);

/* SUNDIALS: CVODE, ARKODE. */
double peer_cvode_adams(problem *p, double tolerance, double *out_q);
double peer_cvode_bdf(problem *p, double tolerance, double *out_q);
double peer_arkode_erk(problem *p, double tolerance, double *out_q);
double peer_arkode_dirk(problem *p, double tolerance, double *out_q);

/* GNU Scientific Library. */
double peer_gsl_rk8pd(problem *p, double tolerance, double *out_q);
double peer_gsl_msadams(problem *p, double tolerance, double *out_q);

/* Absolute tolerance of y [m, m/s] for a relative one: displacements are millimetres. */
static inline double peer_absolute(double tolerance)
{
    return 1e-3 * tolerance;
}

#endif
