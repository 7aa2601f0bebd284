/* SPDX-License-Identifier: MIT */
/* GNU Scientific Library, odeiv2. It has no dense output: steps end on the samples. */
#include "peers.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>
#include <math.h>
#include <string.h>

static int right_side(double t, const double *y, double *out, void *user)
{
    problem_derivative(user, t, y, out);
    return GSL_SUCCESS;
}

static double solve(problem *p, const gsl_odeiv2_step_type *method, double tolerance, double *out_q)
{
    gsl_odeiv2_system system = {right_side, NULL, (size_t)(2 * p->n), p};
    double y[2 * PROBLEM_MAX] = {0}, t = 0;
    gsl_set_error_handler_off();
    double start = bench_cpu();
    gsl_odeiv2_driver *driver =
        gsl_odeiv2_driver_alloc_y_new(&system, method, 1e-4, peer_absolute(tolerance), tolerance);
    bool good = driver != NULL;
    for (int64_t k = 1; good && k <= p->samples; k++) {
        good = gsl_odeiv2_driver_apply(driver, &t, (double)k * PROBLEM_SAMPLE, y) == GSL_SUCCESS;
        memcpy(out_q + k * p->n, y, (size_t)p->n * sizeof *y);
    }
    double seconds = bench_cpu() - start;
    if (driver)
        gsl_odeiv2_driver_free(driver);
    return good ? seconds : NAN;
}

double peer_gsl_rk8pd(problem *p, double tolerance, double *out_q)
{
    return solve(p, gsl_odeiv2_step_rk8pd, tolerance, out_q);
}

double peer_gsl_msadams(problem *p, double tolerance, double *out_q)
{
    return solve(p, gsl_odeiv2_step_msadams, tolerance, out_q);
}
