/* SPDX-License-Identifier: MIT */
/*
 * Static equilibrium B^T f(B q, 0) = w (MODEL.5) by Newton with an energy line search (MODEL.6).
 * Without gravity q = 0 is the answer by convention.
 */
#include "model/model.h"

#include "system/assembly.h"

#include <float.h>
#include <math.h>
#include <string.h>

enum { MAX_ITERATIONS = 200, MAX_DOUBLINGS = 40, MAX_TRIALS = 60 };

/* A step ends where the energy along it is this much less steep than at its start (MODEL.6). */
static const double FLATTER = 0.8;

/* Below this part of the largest force, a residual that does not fall any more is rounding. */
static const double SETTLED = 1e-9;

/* Arrays of the iteration, n or links long. */
typedef struct statics {
    double *q, *trial, *residual, *step, *tangent;
} statics;

/* r = w - B^T f(B q, 0); returns its largest entry, *out_scale the largest force. */
static double residual(const trk_model *model, const double *q, double *r, double *out_scale)
{
    memcpy(r, model->weight, (size_t)model->n * sizeof *r);
    *out_scale = 0;
    for (int32_t i = 0; i < model->n; i++)
        *out_scale = fmax(*out_scale, fabs(r[i]));
    for (int32_t k = 0; k < model->links.count; k++) {
        double f = trk_link_law_force(&model->laws[k], trk_rows_dot(&model->links, k, q), 0);
        *out_scale = fmax(*out_scale, fabs(f));
        trk_rows_add(&model->links, k, -f, r);
    }
    double largest = 0;
    for (int32_t i = 0; i < model->n; i++)
        largest = isnan(r[i]) ? INFINITY : fmax(largest, fabs(r[i]));
    return largest;
}

/* Largest tangents that the links have anywhere, in place of those at s->q. */
static void use_largest_tangents(const trk_model *model, statics *s)
{
    for (int32_t k = 0; k < model->links.count; k++) {
        const trk_link_law *law = &model->laws[k];
        double least, most = 0;
        if (law->spring)
            trk_curve_slope_range(law->spring, &least, &most);
        s->tangent[k] = law->stiffness + law->spring_scale * most;
        if (law->law) {
            double stiffness, ignored;
            law->law->ops->steepest(law->law, &stiffness, &ignored);
            s->tangent[k] += stiffness;
        }
    }
}

/* What rounding of q leaves out of balance where stiff links see small elongations (MODEL.7). */
static double rounding(const trk_model *model, const statics *s)
{
    double largest = 0;
    for (int32_t k = 0; k < model->links.count; k++) {
        double e = 0, most = 0;
        for (int64_t j = model->links.start[k]; j < model->links.start[k + 1]; j++) {
            e += fabs(model->links.value[j] * s->q[model->links.column[j]]);
            most = fmax(most, fabs(model->links.value[j]));
        }
        largest = fmax(largest, fabs(s->tangent[k]) * e * most);
    }
    return 64 * DBL_EPSILON * largest;
}

/* Newton direction at s->q into s->step. */
static trk_status direction(trk_model *model, trk_assembly *assembly, statics *s)
{
    for (int32_t k = 0; k < model->links.count; k++)
        s->tangent[k] =
            trk_link_law_static_stiffness(&model->laws[k], trk_rows_dot(&model->links, k, s->q));
    int32_t bad = 0;
    trk_status status = trk_assembly_factorize(assembly, 0, s->tangent, &bad);
    if (status == TRK_E_SINGULAR) { /* a curve may start flat: a tire that just touches */
        use_largest_tangents(model, s);
        status = trk_assembly_factorize(assembly, 0, s->tangent, &bad);
    }
    if (status == TRK_E_SINGULAR)
        return trk_model_fail_singular(model->context, model, "stiffness under gravity", s->tangent,
                                       bad);
    memcpy(s->step, s->residual, (size_t)model->n * sizeof *s->step);
    return status == TRK_OK ? trk_solver_solve(assembly->solver, s->step) : status;
}

/* Coordinate that is farthest off. */
static int32_t farthest(const trk_model *model, const statics *s)
{
    int32_t most = 0;
    for (int32_t i = 1; i < model->n; i++)
        if (fabs(s->q[i]) > fabs(s->q[most]))
            most = i;
    return most;
}

/* What the descent ended at: equilibrium, or `size` newtons out of balance. */
static trk_status conclude(const trk_model *model, const statics *s, double size, double scale)
{
    double noise = rounding(model, s);
    if (size <= fmax(1e-11 * scale, fmin(noise, 1e-4 * scale)))
        return TRK_OK;
    if (size <= noise) /* far off, by a pivot that was nothing but rounding */
        return trk_model_fail_singular(model->context, model, "stiffness under gravity", s->tangent,
                                       farthest(model, s));
    return trk_fail(model->context, TRK_E_CONVERGENCE,
                    "no static equilibrium found: %g N out of balance, largest force %g N", size,
                    scale);
}

/*
 * s->trial := s->q + t s->step and its residual; returns the fall of the energy along the step
 * there, step . residual.
 */
static double go(const trk_model *model, statics *s, double t, double *out_size, double *out_scale)
{
    double slope = 0;
    for (int32_t i = 0; i < model->n; i++)
        s->trial[i] = s->q[i] + t * s->step[i];
    *out_size = residual(model, s->trial, s->residual, out_scale);
    for (int32_t i = 0; i < model->n; i++)
        slope += s->step[i] * s->residual[i];
    return slope;
}

/*
 * Choose s->trial along the step: all of it if that halves the residual, else where the energy is
 * flatter, from beyond if need be (a tire in the air). false: the energy falls without end.
 */
static bool search(const trk_model *model, statics *s, double start, double *size, double *scale)
{
    double before = *size, t = 1, low = 0, s_low = start, now = go(model, s, 1, size, scale);
    int side = 0;
    if (*size < before / 2)
        return true;
    for (int k = 0; now > FLATTER * start; k++) {
        if (k == MAX_DOUBLINGS)
            return false;
        low = t;
        s_low = now;
        t *= 2;
        now = go(model, s, t, size, scale);
    }
    double high = t, s_high = now;
    for (int k = 0; k < MAX_TRIALS && !(fabs(now) <= FLATTER * start); k++) {
        t = low + (high - low) * (isfinite(s_high) ? s_low / (s_low - s_high) : 0.5);
        now = go(model, s, t, size, scale);
        if (now > 0) {
            low = t;
            s_low = now;
            s_high = side > 0 ? s_high / 2 : s_high;
            side = 1;
        } else {
            high = t;
            s_high = now;
            s_low = side < 0 ? s_low / 2 : s_low;
            side = -1;
        }
    }
    return true;
}

static trk_status iterate(trk_model *model, trk_assembly *assembly, statics *s)
{
    double scale, size = residual(model, s->q, s->residual, &scale), last = INFINITY;
    for (int32_t iteration = 0; iteration < MAX_ITERATIONS; iteration++) {
        double before = size, before_scale = scale, start = 0;
        trk_status status = direction(model, assembly, s);
        if (status != TRK_OK)
            return status;
        for (int32_t i = 0; i < model->n; i++)
            start += s->step[i] * s->residual[i];
        /* A residual of rounding still refines q, as long as the corrections get smaller. */
        bool settled = before <= fmax(SETTLED * before_scale, rounding(model, s));
        if ((settled && !(start < last / 2)) || !search(model, s, start, &size, &scale))
            return conclude(model, s, before, before_scale);
        last = settled ? start : INFINITY;
        memcpy(s->q, s->trial, (size_t)model->n * sizeof *s->q);
        if (size <= 4 * DBL_EPSILON * scale)
            return TRK_OK;
    }
    return conclude(model, s, size, scale);
}

static trk_status solve(trk_model *model, statics *s)
{
    trk_assembly assembly;
    trk_status status = trk_assembly_create(model->context, TRK_BACKEND_AUTO, model->n,
                                            &model->inertia, model->mass, &model->links, &assembly);
    if (status != TRK_OK)
        return status;
    status = iterate(model, &assembly, s);
    trk_assembly_clear(&assembly);
    return status;
}

trk_status trk_model_solve_static(trk_model *model)
{
    trk_context *context = model->context;
    trk_status status = TRK_OK;
    if (model->gravity > 0) {
        int64_t n = model->n;
        statics s = {model->static_q, NULL, NULL, NULL, NULL};
        s.trial = trk_new(context, n, sizeof(double));
        s.residual = trk_new(context, n, sizeof(double));
        s.step = trk_new(context, n, sizeof(double));
        s.tangent = trk_new(context, model->links.count, sizeof(double));
        status = s.trial && s.residual && s.step && s.tangent ? solve(model, &s) : TRK_E_MEMORY;
        trk_free(context, s.trial);
        trk_free(context, s.residual);
        trk_free(context, s.step);
        trk_free(context, s.tangent);
    }
    for (int32_t k = 0; k < model->links.count; k++)
        model->static_force[k] =
            trk_link_law_force(&model->laws[k], trk_rows_dot(&model->links, k, model->static_q), 0);
    return status;
}
