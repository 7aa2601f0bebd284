/* SPDX-License-Identifier: MIT */
/*
 * Newton on the forces g of the p non-linear links (NEWMARK.6):
 *
 *     e = e_free - w beta h^2 D g,  v = v_free - w gamma h D g,  w = 1 - alpha_f
 *     mismatch(g) = law(e, v) - g = 0
 *     (I + T D) dg = mismatch,  T = diag(w (beta h^2 dg/de + gamma h dg/dv))  (NEWMARK.7)
 */
#include "newmark/newmark.h"

#include "linalg/small.h"

#include <float.h>
#include <math.h>
#include <string.h>

enum { MAX_HALVINGS = 12 };

/* Result of one evaluation of the laws. */
typedef struct check {
    double mismatch; /* largest |law - g| [N, N m]; infinite if not finite */
    double force;    /* largest |law| [N, N m]                             */
    int32_t worst;   /* its non-linear link                                */
} check;

static check evaluate(trk_newmark *stepper, const double *g)
{
    const trk_newmark_options *o = &stepper->options;
    int32_t p = stepper->p;
    double w = 1 - o->alpha_f, q_factor = w * o->beta * o->step * o->step,
           v_factor = w * o->gamma * o->step;
    check result = {0, 0, 0};
    for (int32_t j = 0; j < p; j++) {
        const double *d = stepper->coupling + (int64_t)j * p;
        double a = 0;
        for (int32_t k = 0; k < p; k++)
            a += d[k] * g[k];
        trk_law_point point;
        trk_law_evaluate(&stepper->model->laws[stepper->model->nonlinear[j]],
                         stepper->e_free[j] - q_factor * a, stepper->v_free[j] - v_factor * a,
                         &stepper->hints[j], &point);
        stepper->mismatch[j] = point.force - g[j];
        stepper->slope[j] = q_factor * point.stiffness + v_factor * point.damping;
        result.force = fmax(result.force, fabs(point.force));
        double size = fabs(stepper->mismatch[j]);
        if (!(size <= result.mismatch)) {
            result.mismatch = isnan(size) ? INFINITY : size;
            result.worst = j;
        }
    }
    return result;
}

/* Newton correction into stepper->mismatch. */
static bool newton_step(trk_newmark *stepper)
{
    int32_t p = stepper->p;
    for (int32_t j = 0; j < p; j++)
        for (int32_t k = 0; k < p; k++)
            stepper->jacobian[(int64_t)j * p + k] =
                stepper->slope[j] * stepper->coupling[(int64_t)j * p + k] + (j == k);
    return trk_small_solve(p, stepper->jacobian, stepper->mismatch);
}

/*
 * Smallest mismatch that rounding of the coordinates lets through (NEWMARK.12): it matters
 * when a stiff link sees a small elongation as the difference of large displacements.
 */
static double rounding(const trk_newmark *stepper)
{
    const trk_model *model = stepper->model;
    const trk_newmark_options *o = &stepper->options;
    const trk_state *next = &stepper->next;
    double q_factor = o->beta * o->step * o->step, v_factor = o->gamma * o->step, largest = 0;
    for (int32_t j = 0; j < stepper->p; j++) {
        int32_t link = model->nonlinear[j];
        double acceleration = 0, a = 0;
        double e = fabs(trk_rows_dot(&model->roads, link, next->height));
        double v = fabs(trk_rows_dot(&model->roads, link, next->velocity));
        for (int64_t k = model->links.start[link]; k < model->links.start[link + 1]; k++) {
            int32_t i = model->links.column[k];
            double coefficient = fabs(model->links.value[k]);
            e += coefficient * fabs(next->q[i]);
            v += coefficient * fabs(next->v[i]);
            acceleration += coefficient * fabs(next->a[i]);
        }
        for (int32_t k = 0; k < stepper->p; k++) {
            double term =
                (1 - o->alpha_f) * stepper->coupling[(int64_t)j * stepper->p + k] * next->force[k];
            a += term;
            acceleration += fabs(term);
        }
        const trk_law *law = &model->laws[link];
        trk_law_hint hint = stepper->hints[j];
        trk_law_point point;
        trk_law_evaluate(law, stepper->e_free[j] - q_factor * a, stepper->v_free[j] - v_factor * a,
                         &hint, &point);
        e += q_factor * acceleration + fabs(law->spring_offset);
        v += v_factor * acceleration;
        largest = fmax(largest, fabs(point.stiffness) * e + fabs(point.damping) * v);
    }
    return fmax(stepper->force_floor, 32 * DBL_EPSILON * largest);
}

static trk_status fail(trk_newmark *stepper, int32_t iterations, check result)
{
    int32_t link = stepper->model->nonlinear[result.worst] + 1;
    stepper->statistics.worst_link = link;
    return trk_fail(
        stepper->context, TRK_E_CONVERGENCE,
        "%s: no convergence in the step after t = %.9g s: after %d iterations link '%s' is "
        "%.3g N off, tolerance %g of the largest link force",
        trk_model_name(stepper->model), trk_newmark_time(stepper), iterations,
        trk_model_part_name(stepper->model, TRK_PART_LINK, link), result.mismatch,
        stepper->options.tolerance);
}

/* Replace g by the best of g + dg, g + dg / 2, ... and evaluate there. */
static check search(trk_newmark *stepper, double mismatch)
{
    int32_t p = stepper->p;
    double *g = stepper->next.force, *correction = stepper->trial;
    memcpy(correction, stepper->mismatch, (size_t)p * sizeof *correction);
    for (int32_t j = 0; j < p; j++)
        g[j] += correction[j];
    check result = evaluate(stepper, g);
    for (int halving = 0; halving < MAX_HALVINGS && !(result.mismatch < mismatch); halving++) {
        for (int32_t j = 0; j < p; j++) {
            correction[j] /= 2;
            g[j] -= correction[j];
        }
        result = evaluate(stepper, g);
    }
    return result;
}

trk_status trk_newmark_solve_forces(trk_newmark *stepper)
{
    check result = evaluate(stepper, stepper->next.force);
    double tolerance = stepper->options.tolerance, least = stepper->force_floor;
    int32_t iterations = 0;
    while (
        !(result.mismatch <= fmax(least, tolerance * fmax(stepper->force_scale, result.force)))) {
        double before = result.mismatch;
        if (iterations == stepper->options.max_iterations || !isfinite(before) ||
            !newton_step(stepper))
            return fail(stepper, iterations, result);
        result = search(stepper, before);
        iterations++;
        if (!(result.mismatch < before / 2) && result.mismatch <= rounding(stepper))
            break;
    }
    stepper->statistics.iterations += iterations;
    if (iterations > stepper->statistics.max_iterations) {
        stepper->statistics.max_iterations = iterations;
        stepper->statistics.worst_link = stepper->model->nonlinear[result.worst] + 1;
    }
    return TRK_OK;
}
