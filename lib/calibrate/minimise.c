/* SPDX-License-Identifier: MIT */
/*
 * The minimiser: the only user of NLopt.
 *
 * With gradients: SLSQP on the unknowns (u, r), minimise r^T r / 2 subject to
 * r = residuals(u) (CALIBRATE.5). Its quadratic model is then exact in r and linear in u, so
 * that it converges like Gauss-Newton from the first step on. Without: BOBYQA on Q(u).
 *
 * NLopt takes a NaN from its callback for an answer and calls it success. So no callback
 * returns one: a failed evaluation is a large finite value, it is counted, and what
 * NLopt thinks it found is never used, only the best point that was evaluated.
 */
#define _POSIX_C_SOURCE 200809L
#include "calibrate/calibrate.h"

#include <math.h>
#include <string.h>
#include <time.h>

double trk_fit_clock(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

trk_status trk_fit_count(trk_calibration *calibration, trk_fit_watch *watch)
{
    if (watch->used >= watch->allowed || trk_fit_clock() > watch->deadline)
        return TRK_E_LIMIT;
    if (watch->progress &&
        watch->progress(watch->user,
                        watch->done + watch->share * (double)watch->used / (double)watch->allowed))
        return TRK_E_CANCELLED;
    watch->used++;
    calibration->evaluations++;
    return TRK_OK;
}

#ifdef TRUCKRIDE_WITH_NLOPT

#include <nlopt.h>

static const double failed_residual = 1e4; /* far outside of any measurement, but finite */
static const double small_residual = 1e-9; /* standard uncertainties: exact for this purpose */
static const double small_step = 1e-4;     /* of u: all the rest is rounding and curvature   */
static const double smallest_step = 1e-10;
static const double close_by = 0.02; /* of u: it would end at the answer known          */
static const int64_t patience = 20;  /* evaluations without a lower Q: it is stuck     */

typedef struct work {
    trk_calibration *c;
    trk_fit_watch *watch;
    nlopt_opt optimiser;
    int32_t parameters, values;
    bool evaluated, gradient;
    trk_status stop;              /* why the callbacks stopped NLopt; TRK_OK: they did not */
    bool done;                    /* they stopped it because nothing is left to gain       */
    int64_t idle;                 /* evaluations since Q fell last                         */
    double *u, *y, *r, *jacobian; /* at the point evaluated last                       */
    double *best_u, best_q;
} work;

static void stop_optimiser(work *w)
{
    if (w->optimiser) /* not outside of nlopt_optimize() */
        (void)nlopt_force_stop(w->optimiser);
}

static bool is_known(const work *w, const double *u)
{
    double distance = w->watch->known ? 0 : INFINITY;
    for (int32_t j = 0; j < w->parameters && w->watch->known; j++)
        distance = fmax(distance, fabs(u[j] - w->watch->known[j]));
    return distance < close_by;
}

/* Residuals and, with gradients, Jacobian at u, from memory if they are known. */
static void evaluate(work *w, const double *u)
{
    size_t size = (size_t)w->parameters * sizeof *u;
    if (w->stop != TRK_OK || (w->evaluated && memcmp(u, w->u, size) == 0))
        return;
    w->stop = trk_fit_count(w->c, w->watch);
    trk_status status = w->stop;
    if (status == TRK_OK) {
        memcpy(w->u, u, size);
        w->evaluated = true;
        status = trk_fit_evaluate(w->c, u, w->y, w->gradient ? w->jacobian : NULL);
    }
    if (w->stop != TRK_OK || status == TRK_E_MEMORY) {
        w->stop = status;
        stop_optimiser(w);
        return;
    }
    w->idle++;
    if (w->gradient && w->idle > patience)
        stop_optimiser(w);
    if (is_known(w, u)) {
        w->stop = TRK_E_CONVERGENCE;
        stop_optimiser(w);
    }
    if (status != TRK_OK) { /* the Jacobian of the last good point stays */
        w->c->failures++;
        for (int32_t i = 0; i < w->values; i++)
            w->r[i] = failed_residual;
        return;
    }
    trk_fit_residuals(w->c, w->y, w->r, w->gradient ? w->jacobian : NULL);
    double q = 0, largest = 0;
    for (int32_t i = 0; i < w->values; i++) {
        q += w->r[i] * w->r[i] / 2;
        largest = fmax(largest, fabs(w->r[i]));
    }
    if (q < w->best_q) {
        if (q < 0.999 * w->best_q)
            w->idle = 0;
        w->best_q = q;
        memcpy(w->best_u, u, size);
    }
    if (largest <= small_residual) {
        w->done = true;
        stop_optimiser(w);
    }
}

/* r^T r / 2 over the unknowns (u, r). */
static double slack_objective(unsigned count, const double *x, double *gradient, void *data)
{
    const work *w = data;
    double q = 0;
    for (unsigned k = 0; k < count; k++) {
        double r = k < (unsigned)w->parameters ? 0 : x[k];
        q += r * r / 2;
        if (gradient)
            gradient[k] = r;
    }
    return q;
}

/* residuals(u) - r = 0 */
static void slack_constraint(unsigned values, double *out, unsigned count, const double *x,
                             double *gradient, void *data)
{
    work *w = data;
    evaluate(w, x);
    for (unsigned i = 0; i < values; i++) {
        out[i] = w->r[i] - x[(unsigned)w->parameters + i];
        for (unsigned k = 0; gradient && k < count; k++)
            gradient[(size_t)i * count + k] =
                k < (unsigned)w->parameters ? w->jacobian[(size_t)i * (unsigned)w->parameters + k]
                                            : -(double)(k - (unsigned)w->parameters == i);
    }
}

static double plain_objective(unsigned count, const double *u, double *gradient, void *data)
{
    work *w = data;
    (void)count, (void)gradient;
    evaluate(w, u);
    double q = 0;
    for (int32_t i = 0; i < w->values; i++)
        q += w->r[i] * w->r[i] / 2;
    return q;
}

/* NLopt with its unknowns x, whose first ones are u. */
static trk_status optimise(work *w, const double *u, double *x)
{
    unsigned n = (unsigned)w->parameters, m = (unsigned)w->values;
    unsigned count = w->gradient ? n + m : n;
    w->optimiser = nlopt_create(w->gradient ? NLOPT_LD_SLSQP : NLOPT_LN_BOBYQA, count);
    if (!w->optimiser)
        return trk_fail(w->c->context, TRK_E_MEMORY, "out of memory in NLopt");
    nlopt_result result = NLOPT_SUCCESS;
    for (unsigned k = 0; result >= 0 && k < count; k++) {
        double low = k < n ? log(w->c->parameters[k].options.lower) : -HUGE_VAL;
        double high = k < n ? log(w->c->parameters[k].options.upper) : HUGE_VAL;
        result = nlopt_set_lower_bound(w->optimiser, (int)k, low);
        if (result >= 0)
            result = nlopt_set_upper_bound(w->optimiser, (int)k, high);
        x[k] = k < n ? fmin(fmax(u[k], low), high) : w->r[k - n];
    }
    if (result >= 0 && w->gradient) {
        result = nlopt_set_min_objective(w->optimiser, slack_objective, w);
        if (result >= 0)
            result = nlopt_add_equality_mconstraint(w->optimiser, m, slack_constraint, w, NULL);
        if (result >= 0)
            result = nlopt_set_xtol_rel(w->optimiser, 1e-10);
        /* SLSQP can call for one point for ever, which counts as one evaluation only. */
        if (result >= 0)
            result = nlopt_set_maxeval(w->optimiser,
                                       (int)fmin(2000 + 2.0 * (double)w->watch->allowed, 1e9));
    } else if (result >= 0) {
        result = nlopt_set_min_objective(w->optimiser, plain_objective, w);
        if (result >= 0)
            result = nlopt_set_initial_step1(w->optimiser, 0.2);
        if (result >= 0)
            result = nlopt_set_xtol_abs1(w->optimiser, 1e-5);
    }
    double ignored;
    if (result >= 0)
        result = nlopt_optimize(w->optimiser, x, &ignored);
    nlopt_destroy(w->optimiser);
    w->optimiser = NULL;
    if (result == NLOPT_OUT_OF_MEMORY)
        return trk_fail(w->c->context, TRK_E_MEMORY, "out of memory in NLopt");
    /* Whether the point is a minimum is for trk_fit_judge() to say, not for NLopt. */
    return w->stop;
}

/* One Gauss-Newton step from the best point, halved until it helps; false: none helps.
 * *out_size is its largest component. */
static bool improve(work *w, double *out_size)
{
    double step[TRK_MAX_PARAMETERS], trial[TRK_MAX_PARAMETERS], before = w->best_q, size = 0;
    evaluate(w, w->best_u);
    if (w->stop != TRK_OK || !trk_fit_gauss_newton(w->c, w->best_u, w->r, w->jacobian, step))
        return false;
    for (int32_t j = 0; j < w->parameters; j++)
        size = fmax(size, fabs(step[j]));
    *out_size = size;
    double origin[TRK_MAX_PARAMETERS];
    memcpy(origin, w->best_u, sizeof *origin * (size_t)w->parameters);
    for (double part = 1; w->stop == TRK_OK && part * size > smallest_step; part /= 2) {
        for (int32_t j = 0; j < w->parameters; j++)
            trial[j] = origin[j] + part * step[j];
        evaluate(w, trial);
        if (w->best_q < before)
            return true;
        if (size <= small_step || part < 0.01)
            break;
    }
    return false;
}

/* Gauss-Newton steps as long as they help: NLopt stops a little early, or is stuck.
 * TRK_E_CONVERGENCE: the last of them was not small. */
static trk_status polish(work *w)
{
    double size = INFINITY;
    for (int round = 0; round < 20 && !w->done; round++)
        if (!improve(w, &size))
            break;
    if (w->stop != TRK_OK)
        return w->stop;
    return w->done || size <= small_step ? TRK_OK : TRK_E_CONVERGENCE;
}

static trk_status run(work *w, double *u, double *x)
{
    evaluate(w, u);
    if (w->stop != TRK_OK)
        return w->stop;
    if (!isfinite(w->best_q)) /* the message of the evaluation says why */
        return TRK_E_CONVERGENCE;
    trk_status status = w->done ? TRK_OK : optimise(w, u, x);
    if (status == TRK_OK && w->gradient)
        status = polish(w);
    memcpy(u, w->best_u, (size_t)w->parameters * sizeof *u);
    return status;
}

trk_status trk_fit_minimise(trk_calibration *calibration, trk_fit_watch *watch, double *u,
                            double *out_q)
{
    trk_context *context = calibration->context;
    int32_t n = trk_fit_parameter_count(calibration), m = calibration->value_count;
    int64_t doubles = 3 * (int64_t)n + 3 * (int64_t)m + (int64_t)n * m;
    double *block = trk_new(context, doubles, sizeof *block);
    if (!block)
        return TRK_E_MEMORY;
    work w = {.c = calibration,
              .watch = watch,
              .parameters = n,
              .values = m,
              .gradient = trk_fit_has_gradient(calibration),
              .best_q = INFINITY};
    w.u = block;
    w.best_u = w.u + n;
    w.y = w.best_u + n;
    w.r = w.y + m;
    w.jacobian = w.r + m;
    trk_status status = run(&w, u, w.jacobian + (int64_t)n * m);
    *out_q = w.best_q;
    trk_free(context, block);
    return status;
}

#else

trk_status trk_fit_minimise(trk_calibration *calibration, trk_fit_watch *watch, double *u,
                            double *out_q)
{
    (void)watch, (void)u, (void)out_q;
    return trk_fail(calibration->context, TRK_E_UNSUPPORTED, "this build has no NLopt");
}

#endif
