/* SPDX-License-Identifier: MIT */
/*
 * Newton on the forces g of the p non-linear links (NEWMARK.6):
 *
 *     e = e_free - w beta h^2 D g,  v = v_free - w gamma h D g,  w = 1 - alpha_f
 *     mismatch(g) = law(e, v) - g = 0
 *     (I + T D) d = mismatch,  T = diag(w (beta h^2 dg/de + gamma h dg/dv))  (NEWMARK.7)
 *     s(t) = d^T D mismatch(g + t d)                                         (NEWMARK.21)
 *
 * D is symmetric, and -D mismatch the gradient of a potential of g, convex if no law falls: s is
 * how steep it falls along d. A correction that runs past its valley is cut back to the valley, which
 * is how Newton's method finds its way over the corners of friction and contact.
 */
#include "newmark/newmark.h"

#include <float.h>
#include <math.h>
#include <string.h>

enum { MAX_TRIALS = 60, STRICT = 10 };

/*
 * Cut-back corrections end where s of (NEWMARK.21) is between these fractions of what it was. Short
 * of the valley the potential has fallen for certain; from the iteration STRICT on no more than that
 * will do, and an endless cycle is impossible.
 */
static const double OVERSHOOT = 0.1, FLATTER = 0.5;

/* Result of one evaluation of the laws. */
typedef struct check {
    double mismatch; /* largest |law - g| [N, N m]; infinite if not finite */
    double force;    /* largest |law| [N, N m]                             */
    int32_t worst;   /* its non-linear link                                */
} check;

/* The laws where `reach` = D g says. */
static check evaluate(trk_newmark *stepper)
{
    const trk_newmark_options *o = &stepper->options;
    const trk_model *model = stepper->model;
    const double *g = stepper->next.force;
    double w = 1 - o->alpha_f, q_factor = w * o->beta * o->step * o->step,
           v_factor = w * o->gamma * o->step;
    check result = {0, 0, 0};
    for (int32_t j = 0; j < stepper->p; j++) {
        double a = stepper->reach[j];
        int32_t link = model->nonlinear[j], memory = model->memory[link];
        trk_law_point point;
        trk_link_law_advance(&model->laws[link], stepper->now.memory + memory,
                             stepper->e_free[j] - q_factor * a, stepper->v_free[j] - v_factor * a,
                             o->step, &stepper->hints[j], &point, stepper->next.memory + memory);
        stepper->mismatch[j] = point.force - g[j];
        stepper->slope[j] = q_factor * point.stiffness + v_factor * point.damping;
        double force = fabs(point.force), size = fabs(stepper->mismatch[j]);
        result.force = force > result.force ? force : result.force;
        if (!(size <= result.mismatch)) {
            result.mismatch = isnan(size) ? INFINITY : size;
            result.worst = j;
        }
    }
    return result;
}

/* The same for a g from elsewhere than a correction. */
static check begin(trk_newmark *stepper)
{
    int32_t p = stepper->p;
    for (int32_t j = 0; j < p; j++) {
        const double *row = stepper->coupling + (int64_t)j * p;
        double sum = 0;
        for (int32_t k = 0; k < p; k++)
            sum += row[k] * stepper->next.force[k];
        stepper->reach[j] = sum;
    }
    return evaluate(stepper);
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
        const trk_link_law *law = &model->laws[link];
        trk_law_hint hint = stepper->hints[j];
        double ignored[TRK_LAW_STATES];
        trk_law_point point;
        trk_link_law_advance(law, stepper->now.memory + model->memory[link],
                             stepper->e_free[j] - q_factor * a, stepper->v_free[j] - v_factor * a,
                             o->step, &hint, &point, ignored);
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

/* Go on along the correction, evaluate there, and return s of (NEWMARK.21); NAN: not finite. */
static double go(trk_newmark *stepper, double by, check *result)
{
    double sum = 0;
    for (int32_t j = 0; j < stepper->p; j++) {
        stepper->next.force[j] += by * stepper->trial[j];
        stepper->reach[j] += by * stepper->pull[j];
    }
    *result = evaluate(stepper);
    for (int32_t j = 0; j < stepper->p; j++)
        sum += stepper->pull[j] * stepper->mismatch[j];
    return isfinite(result->mismatch) ? sum : NAN;
}

/*
 * Replace g by g + t d and evaluate there: t = 1 unless that runs past the valley, else a t near
 * the zero of s by regula falsi, Illinois variant (NEWMARK.21).
 */
static check search(trk_newmark *stepper, double start, double overshoot)
{
    check result;
    double t = 1, low = 0, high = 1, s_low = start, s_high = go(stepper, 1, &result), s = s_high;
    int side = 0;
    if (s >= -overshoot * start || result.mismatch <= rounding(stepper))
        return result;
    for (int k = 0; k < MAX_TRIALS && !(s >= -overshoot * start && s <= FLATTER * start); k++) {
        double next = low + (high - low) * (isfinite(s_high) ? s_low / (s_low - s_high) : 0.5);
        s = go(stepper, next - t, &result);
        t = next;
        if (s > 0) {
            low = t;
            s_low = s;
            s_high = side > 0 ? s_high / 2 : s_high;
            side = 1;
        } else {
            high = t;
            s_high = s;
            s_low = side < 0 ? s_low / 2 : s_low;
            side = -1;
        }
    }
    return result;
}

trk_status trk_newmark_solve_forces(trk_newmark *stepper)
{
    check result = begin(stepper);
    if (!isfinite(result.mismatch)) { /* the guess went too far: an air spring without air */
        memcpy(stepper->next.force, stepper->now.force, (size_t)stepper->p * sizeof(double));
        result = begin(stepper);
    }
    double tolerance = stepper->options.tolerance, least = stepper->force_floor;
    int32_t iterations = 0;
    while (
        !(result.mismatch <= fmax(least, tolerance * fmax(stepper->force_scale, result.force)))) {
        double before = result.mismatch, start;
        if (iterations == stepper->options.max_iterations || !isfinite(before) ||
            !isfinite(start = trk_newmark_find_direction(stepper)))
            return fail(stepper, iterations, result);
        result = search(stepper, start, iterations < STRICT ? OVERSHOOT : 0);
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
