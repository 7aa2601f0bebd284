/* SPDX-License-Identifier: MIT */
/* CVODE: Adams with a fixed-point iteration, BDF with Newton and the exact Jacobian. */
#include "peers.h"
#include "sundials_common.h"

#include <cvode/cvode.h>
#include <math.h>

static double solve(problem *p, int method, double tolerance, double *out_q)
{
    sundials s;
    if (!sundials_open(&s, p))
        return NAN;
    double start = bench_cpu();
    void *cvode = CVodeCreate(method, s.context);
    bool good = cvode && CVodeInit(cvode, sundials_right_side, 0, s.y) == 0 &&
                CVodeSStolerances(cvode, tolerance, peer_absolute(tolerance)) == 0 &&
                CVodeSetUserData(cvode, p) == 0 && CVodeSetMaxNumSteps(cvode, 100000000) == 0;
    if (good && method == CV_ADAMS)
        good = CVodeSetNonlinearSolver(cvode, s.fixed_point) == 0;
    else if (good)
        good = CVodeSetLinearSolver(cvode, s.solver, s.matrix) == 0 &&
               CVodeSetJacFn(cvode, sundials_jacobian) == 0;
    for (int64_t k = 1; good && k <= p->samples; k++) {
        double reached;
        good = CVode(cvode, (double)k * PROBLEM_SAMPLE, s.y, &reached, CV_NORMAL) >= 0;
        sundials_read(&s, p, out_q + k * p->n);
    }
    double seconds = bench_cpu() - start;
    CVodeFree(&cvode);
    sundials_close(&s);
    return good ? seconds : NAN;
}

double peer_cvode_adams(problem *p, double tolerance, double *out_q)
{
    return solve(p, CV_ADAMS, tolerance, out_q);
}

double peer_cvode_bdf(problem *p, double tolerance, double *out_q)
{
    return solve(p, CV_BDF, tolerance, out_q);
}
