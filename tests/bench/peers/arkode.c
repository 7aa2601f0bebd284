/* SPDX-License-Identifier: MIT */
/* ARKODE: explicit and diagonally implicit Runge-Kutta methods of order 5, adaptive. */
#include "peers.h"
#include "sundials_common.h"

#include <arkode/arkode_arkstep.h>
#include <arkode/arkode_erkstep.h>
#include <math.h>

enum { ORDER = 5, MOST_STEPS = 100000000 };

double peer_arkode_erk(problem *p, double tolerance, double *out_q)
{
    sundials s;
    if (!sundials_open(&s, p))
        return NAN;
    double start = bench_cpu(), reached;
    void *erk = ERKStepCreate(sundials_right_side, 0, s.y, s.context);
    bool good = erk && ERKStepSetOrder(erk, ORDER) == 0 &&
                ERKStepSStolerances(erk, tolerance, peer_absolute(tolerance)) == 0 &&
                ERKStepSetUserData(erk, p) == 0 && ERKStepSetMaxNumSteps(erk, MOST_STEPS) == 0;
    for (int64_t k = 1; good && k <= p->samples; k++) {
        good = ERKStepEvolve(erk, (double)k * PROBLEM_SAMPLE, s.y, &reached, ARK_NORMAL) >= 0;
        sundials_read(&s, p, out_q + k * p->n);
    }
    double seconds = bench_cpu() - start;
    ERKStepFree(&erk);
    sundials_close(&s);
    return good ? seconds : NAN;
}

double peer_arkode_dirk(problem *p, double tolerance, double *out_q)
{
    sundials s;
    if (!sundials_open(&s, p))
        return NAN;
    double start = bench_cpu(), reached;
    void *dirk = ARKStepCreate(NULL, sundials_right_side, 0, s.y, s.context);
    bool good = dirk && ARKStepSetOrder(dirk, ORDER) == 0 &&
                ARKStepSStolerances(dirk, tolerance, peer_absolute(tolerance)) == 0 &&
                ARKStepSetUserData(dirk, p) == 0 && ARKStepSetMaxNumSteps(dirk, MOST_STEPS) == 0 &&
                ARKStepSetLinearSolver(dirk, s.solver, s.matrix) == 0 &&
                ARKStepSetJacFn(dirk, sundials_jacobian) == 0;
    for (int64_t k = 1; good && k <= p->samples; k++) {
        good = ARKStepEvolve(dirk, (double)k * PROBLEM_SAMPLE, s.y, &reached, ARK_NORMAL) >= 0;
        sundials_read(&s, p, out_q + k * p->n);
    }
    double seconds = bench_cpu() - start;
    ARKStepFree(&dirk);
    sundials_close(&s);
    return good ? seconds : NAN;
}
