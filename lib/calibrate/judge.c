/* SPDX-License-Identifier: MIT */
/*
 * Judging an answer from the model itself, whatever the minimiser said.
 *
 * With P the pseudo-inverse of the weighted Jacobian J = w/s dy/du, the covariance of
 * u = ln p under independent errors of the targets is P diag(w^2) P^T, and the 95 %
 * interval of p is p exp(-+1.96 sigma) (CALIBRATE.4). A parameter is determined if
 * that interval is shorter than its bounds are apart.
 *
 * A point is a minimum if no step is left, or if what a step could still take from the
 * residuals, their projection on the range of J, is small against a standard uncertainty:
 * then the answer is off by as small a part of its own standard deviation. Where the mode of a
 * target changes abruptly the second is all that can be had.
 * Source: D. M. Bates, D. G. Watts, Technometrics 23 (1981) 179-183.
 */
#include "calibrate/calibrate.h"

#include "linalg/eigen.h"

#include <math.h>
#include <string.h>

static const double run_step = 0.02;     /* of u, for differences of simulated runs       */
static const double not_seen = 1e-8;     /* singular value over the largest one: no rank  */
static const double stationary = 1e-6;   /* of u */
static const double small_offset = 0.01; /* standard uncertainties                        */

typedef struct judge {
    trk_calibration *c;
    int32_t n, m;
    double *y, *r, *high, *low; /* m each            */
    double *j;                  /* m x n, row-major  */
    double *vt, *copy;          /* n x n, m x n      */
    double *sigma;              /* n                 */
    bool minimum;
} judge;

static double half_square(int32_t m, const double *r)
{
    double q = 0;
    for (int32_t i = 0; i < m; i++)
        q += r[i] * r[i] / 2;
    return q;
}

/* Jacobian of targets taken from runs, by central differences; looks for a lower Q and for jumps. */
static trk_status differences(judge *w, const double *u)
{
    double moved[TRK_MAX_PARAMETERS], q = half_square(w->m, w->r);
    memcpy(moved, u, (size_t)w->n * sizeof *moved);
    for (int32_t j = 0; j < w->n; j++) {
        for (int side = 0; side < 2; side++) {
            double *y = side ? w->high : w->low;
            moved[j] = u[j] + (side ? run_step : -run_step);
            trk_status status = trk_fit_evaluate(w->c, moved, y, NULL);
            w->c->evaluations++;
            if (status != TRK_OK)
                return status;
            trk_fit_residuals(w->c, y, y, NULL);
            bool inside = moved[j] >= log(w->c->parameters[j].options.lower) &&
                          moved[j] <= log(w->c->parameters[j].options.upper);
            if (inside && half_square(w->m, y) < q * (1 - 1e-3) - 1e-3)
                w->minimum = false;
        }
        moved[j] = u[j];
        for (int32_t i = 0; i < w->m; i++) {
            double change = w->high[i] - w->low[i], bend = w->high[i] + w->low[i] - 2 * w->r[i];
            w->j[(int64_t)i * w->n + j] = change / (2 * run_step);
            /* Another peak became the highest right here: no interval has a meaning then. */
            if (fabs(bend) > 1 && fabs(bend) > 0.5 * fabs(change))
                w->minimum = false;
        }
    }
    return TRK_OK;
}

/* Singular values and right vectors of J, without the columns of parameters held at a bound. */
static trk_status decompose(judge *w, const bool *held, double *out_singular)
{
    for (int32_t i = 0; i < w->m; i++)
        for (int32_t j = 0; j < w->n; j++)
            w->copy[(int64_t)j * w->m + i] = held && held[j] ? 0 : w->j[(int64_t)i * w->n + j];
    return trk_singular_values(w->c->context, w->m, w->n, w->copy, out_singular, w->vt);
}

/* Component i of J v_k. */
static double image(const judge *w, int32_t i, int32_t k)
{
    double sum = 0;
    for (int32_t l = 0; l < w->n; l++)
        sum += w->j[(int64_t)i * w->n + l] * w->vt[l * w->n + k];
    return sum;
}

static bool is_seen(const judge *w, const double *singular, int32_t k)
{
    return k < (w->n < w->m ? w->n : w->m) && singular[k] > not_seen * singular[0];
}

/* Is the Gauss-Newton step of least norm, within the bounds, or what it gains, small? */
static trk_status look_around(judge *w, const double *u)
{
    double step[TRK_MAX_PARAMETERS] = {0}, *s = w->c->singular, offset = 0, largest = 0;
    bool held[TRK_MAX_PARAMETERS];
    trk_fit_hold(w->c, u, w->r, w->j, held);
    trk_status status = decompose(w, held, s);
    if (status != TRK_OK)
        return status;
    for (int32_t k = 0; k < w->n && is_seen(w, s, k); k++) {
        double along = 0;
        for (int32_t i = 0; i < w->m; i++)
            along += image(w, i, k) * w->r[i] / s[k];
        for (int32_t j = 0; j < w->n; j++)
            step[j] -= w->vt[j * w->n + k] * along / s[k];
        offset += along * along;
    }
    for (int32_t j = 0; j < w->n; j++) {
        const trk_parameter_options *o = &w->c->parameters[j].options;
        double to = fmin(fmax(u[j] + step[j], log(o->lower)), log(o->upper));
        largest = fmax(largest, held[j] ? 0 : fabs(to - u[j]));
    }
    w->minimum = largest <= stationary || sqrt(offset) <= small_offset;
    return TRK_OK;
}

static trk_status linearise(judge *w, const double *u)
{
    bool gradient = trk_fit_has_gradient(w->c);
    trk_status status = trk_fit_evaluate(w->c, u, w->y, gradient ? w->j : NULL);
    w->c->evaluations++;
    if (status != TRK_OK)
        return status;
    trk_fit_residuals(w->c, w->y, w->r, gradient ? w->j : NULL);
    w->minimum = true;
    return gradient ? look_around(w, u) : differences(w, u);
}

/* Standard deviations of u from the singular values. */
static trk_status spread(judge *w)
{
    int32_t n = w->n;
    double *s = w->c->singular;
    trk_status status = decompose(w, NULL, s);
    if (status != TRK_OK)
        return status;
    for (int32_t j = 0; j < n; j++) {
        double variance = 0;
        for (int32_t k = 0; k < n; k++) /* directions that the targets do not see */
            if (!is_seen(w, s, k) && fabs(w->vt[j * n + k]) > 1e-6)
                variance = INFINITY;
        for (int32_t t = 0; t < trk_fit_target_count(w->c) && isfinite(variance); t++) {
            const trk_fit_target *target = &w->c->targets[t];
            for (int32_t i = target->first; i < target->first + target->count; i++) {
                double p = 0; /* entry (j, i) of P = V S^-2 (J V)^T */
                for (int32_t k = 0; k < n && is_seen(w, s, k); k++)
                    p += w->vt[j * n + k] * image(w, i, k) / (s[k] * s[k]);
                variance += p * p * target->options.weight * target->options.weight;
            }
        }
        w->sigma[j] = sqrt(variance);
        w->c->weakest[j] = w->vt[j * n + n - 1];
    }
    return TRK_OK;
}

static void fill_parameters(judge *w, const double *u)
{
    for (int32_t j = 0; j < w->n; j++) {
        trk_fit_parameter *p = &w->c->parameters[j];
        const trk_parameter_options *o = &p->options;
        double range = log(o->upper / o->lower);
        bool determined = TRK_NORMAL95 * w->sigma[j] <= range / 2;
        p->result = (trk_parameter_result){
            .struct_size = sizeof p->result,
            .start = o->start,
            .fitted = fmin(fmax(exp(u[j]), o->lower), o->upper),
            .low95 = determined ? exp(u[j] - TRK_NORMAL95 * w->sigma[j]) : 0,
            .high95 = determined ? exp(u[j] + TRK_NORMAL95 * w->sigma[j]) : INFINITY,
            .at_bound = u[j] <= log(o->lower) + TRK_AT_BOUND   ? -1
                        : u[j] >= log(o->upper) - TRK_AT_BOUND ? 1
                                                               : 0,
            .determined = determined};
    }
}

static void fill_targets(judge *w)
{
    for (int32_t t = 0; t < trk_fit_target_count(w->c); t++) {
        trk_fit_target *target = &w->c->targets[t];
        trk_target_result *result = &target->result;
        bool curve = target->options.frequency != NULL;
        double square = 0;
        for (int32_t i = target->first; i < target->first + target->count; i++)
            square += w->y[i] * w->y[i];
        result->struct_size = sizeof *result;
        result->measured = curve ? 0 : target->options.value;
        result->after = curve ? sqrt(square / target->count) : w->y[target->first];
        result->residual = (result->after - result->measured) / target->options.uncertainty;
        result->met = fabs(result->residual) <= w->c->solve_options.met;
    }
}

static trk_status run(judge *w, const double *u, trk_status stopped)
{
    trk_status status = linearise(w, u);
    if (status == TRK_E_MEMORY)
        return status;
    if (status != TRK_OK)
        return trk_fail_within(w->c->context, TRK_E_CONVERGENCE,
                               "the answer cannot be evaluated again");
    status = spread(w);
    if (status != TRK_OK)
        return status;
    memcpy(w->c->jacobian, w->j, (size_t)w->m * (size_t)w->n * sizeof *w->j);
    fill_parameters(w, u);
    fill_targets(w);
    trk_fit_conclude(w->c, stopped, w->minimum, w->sigma);
    return TRK_OK;
}

trk_status trk_fit_judge(trk_calibration *calibration, const double *u, trk_status stopped)
{
    trk_context *context = calibration->context;
    int64_t n = trk_fit_parameter_count(calibration), m = calibration->value_count;
    trk_free(context, calibration->jacobian);
    trk_free(context, calibration->singular);
    calibration->jacobian = trk_new(context, m * n, sizeof(double));
    calibration->singular = trk_new(context, n < m ? n : m, sizeof(double));
    double *block = trk_new(context, 4 * m + 2 * m * n + n * n + n, sizeof *block);
    trk_status status = TRK_E_MEMORY;
    if (calibration->jacobian && calibration->singular && block) {
        judge w = {.c = calibration, .n = (int32_t)n, .m = (int32_t)m};
        w.y = block;
        w.r = w.y + m;
        w.high = w.r + m;
        w.low = w.high + m;
        w.j = w.low + m;
        w.copy = w.j + m * n;
        w.vt = w.copy + m * n;
        w.sigma = w.vt + n * n;
        status = run(&w, u, stopped);
    }
    trk_free(context, block);
    return status;
}
