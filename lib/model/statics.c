/* SPDX-License-Identifier: MIT */
/*
 * Static equilibrium B^T f(B q, 0) = w (MODEL.5) by Newton with backtracking.
 * Without gravity q = 0 is the answer by convention.
 */
#include "model/model.h"

#include "system/assembly.h"

#include <float.h>
#include <math.h>
#include <string.h>

enum { MAX_ITERATIONS = 200, MAX_HALVINGS = 30 };

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
        double f = trk_law_force(&model->laws[k], trk_rows_dot(&model->links, k, q), 0);
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
        const trk_law *law = &model->laws[k];
        double least, most = 0;
        if (law->spring)
            trk_curve_slope_range(law->spring, &least, &most);
        s->tangent[k] = law->stiffness + law->spring_scale * most;
    }
}

/* What rounding of q leaves out of balance where stiff links see small elongations. */
static double rounding(const trk_model *model, const statics *s)
{
    double largest = 0;
    for (int32_t k = 0; k < model->links.count; k++) {
        double e = 0;
        for (int64_t j = model->links.start[k]; j < model->links.start[k + 1]; j++)
            e += fabs(model->links.value[j] * s->q[model->links.column[j]]);
        largest = fmax(largest, fabs(s->tangent[k]) * e);
    }
    return 64 * DBL_EPSILON * largest;
}

/* Newton direction at s->q into s->step. */
static trk_status direction(trk_model *model, trk_assembly *assembly, statics *s)
{
    double ignored;
    for (int32_t k = 0; k < model->links.count; k++)
        trk_model_link_tangent(model, k, s->q, NULL, &s->tangent[k], &ignored);
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

static trk_status iterate(trk_model *model, trk_assembly *assembly, statics *s)
{
    double scale, size = residual(model, s->q, s->residual, &scale);
    for (int32_t iteration = 0; iteration < MAX_ITERATIONS; iteration++) {
        trk_status status = direction(model, assembly, s);
        if (status != TRK_OK)
            return status;
        double factor = 1, smaller = INFINITY;
        for (int halving = 0; halving < MAX_HALVINGS; halving++, factor /= 2) {
            for (int32_t i = 0; i < model->n; i++)
                s->trial[i] = s->q[i] + factor * s->step[i];
            smaller = residual(model, s->trial, s->residual, &scale);
            if (smaller < size)
                break;
        }
        /* Go on until rounding stops the descent, then ask whether that is equilibrium. */
        if (!(smaller < size))
            return conclude(model, s, size, scale);
        size = smaller;
        memcpy(s->q, s->trial, (size_t)model->n * sizeof *s->q);
        if (size <= 4 * DBL_EPSILON * scale)
            return TRK_OK;
    }
    return trk_fail(model->context, TRK_E_CONVERGENCE,
                    "no static equilibrium found in %d iterations: %g N out of balance",
                    MAX_ITERATIONS, size);
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
            trk_law_force(&model->laws[k], trk_rows_dot(&model->links, k, model->static_q), 0);
    return status;
}
