/* SPDX-License-Identifier: MIT */
/* Motion of the links, their equivalents, the mean position (LINEAR.31, LINEAR.35). */
#include "linear/linearise.h"

#include "model/linear_copy.h"

#include <math.h>
#include <string.h>

static const double two_pi = 6.283185307179586476925286766559;

/* Most that a mean elongation goes at once, in standard deviations. */
static const double longest_step = 1;
enum { MOST_STEPS = 50 };

void trk_linearisation_clear(trk_linearisation *l)
{
    trk_model_destroy(l->linear);
    trk_assembly_clear(&l->assembly);
    void *blocks[] = {l->links, l->mean, l->excess, l->slope, l->h, l->e_form, l->v_form};
    for (size_t k = 0; k < sizeof blocks / sizeof *blocks; k++)
        trk_free(l->context, blocks[k]);
    memset(l, 0, sizeof *l);
}

static trk_status allocate(trk_linearisation *l)
{
    trk_context *context = l->context;
    const trk_model *model = l->model;
    const int64_t inputs = (int64_t)model->names[TRK_PART_ROAD].count + model->ports.count;
    l->links = trk_new(context, model->nonlinear_count, sizeof *l->links);
    l->mean = trk_new(context, model->n, sizeof *l->mean);
    l->excess = trk_new(context, model->n, sizeof *l->excess);
    l->slope = trk_new(context, model->links.count, sizeof *l->slope);
    l->h = trk_new(context, inputs, sizeof *l->h);
    l->e_form = trk_new(context, model->nonlinear_count, sizeof *l->e_form);
    l->v_form = trk_new(context, model->nonlinear_count, sizeof *l->v_form);
    return l->links && l->mean && l->excess && l->slope && l->h && l->e_form && l->v_form
               ? TRK_OK
               : TRK_E_MEMORY;
}

trk_status trk_linearisation_start(trk_context *context, const trk_model *model, int64_t count,
                                   const double *frequency, const double *input,
                                   trk_linearisation *out)
{
    *out = (trk_linearisation){
        .context = context, .model = model, .count = count, .frequency = frequency, .input = input};
    double *damping = trk_new(context, model->links.count, sizeof *damping);
    trk_status status = damping ? allocate(out) : TRK_E_MEMORY;
    if (status == TRK_OK) {
        memcpy(out->mean, model->static_q, (size_t)model->n * sizeof *out->mean);
        for (int32_t k = 0; k < model->links.count; k++)
            trk_model_link_tangent(model, k, NULL, NULL, &out->slope[k], &damping[k]);
        status = trk_model_copy_linear(context, model, out->slope, damping, &out->linear);
    }
    trk_free(context, damping);
    if (status == TRK_OK)
        status = trk_assembly_create(context, TRK_BACKEND_AUTO, model->n, &model->inertia,
                                     model->mass, &model->links, &out->assembly);
    return status;
}

/* Variances by the trapezoidal rule (LINEAR.10), of the rate from that of the elongation. */
static void add_frequency(trk_linearisation *l, const trk_superposition *s, int64_t f)
{
    const double omega = two_pi * l->frequency[f];
    const double width = f > 0 ? l->frequency[f] - l->frequency[f - 1] : 0;
    for (int32_t j = 0; j < l->model->nonlinear_count; j++) {
        trk_moved_link *link = &l->links[j];
        for (int32_t i = 0; i < s->inputs; i++)
            l->h[i] = trk_random_elongation(s, l->model->nonlinear[j], i);
        const double e =
            trk_random_form(s->inputs, l->h, l->input + 2 * f * (int64_t)s->inputs * s->inputs);
        link->e_deviation += 0.5 * width * (l->e_form[j] + e);
        link->v_deviation += 0.5 * width * (l->v_form[j] + omega * omega * e);
        l->e_form[j] = e;
        l->v_form[j] = omega * omega * e;
    }
}

trk_status trk_linearisation_respond(trk_linearisation *l)
{
    trk_superposition s;
    for (int32_t j = 0; j < l->model->nonlinear_count; j++)
        l->links[j].e_deviation = l->links[j].v_deviation = 0;
    trk_status status = trk_superposition_create(l->context, l->linear, NULL, NULL, &s);
    for (int64_t f = 0; status == TRK_OK && f < l->count; f++) {
        status = trk_superposition_solve(&s, two_pi * l->frequency[f]);
        if (status == TRK_OK)
            add_frequency(l, &s, f);
    }
    trk_superposition_clear(&s);
    for (int32_t j = 0; j < l->model->nonlinear_count; j++) {
        l->links[j].e_deviation = sqrt(l->links[j].e_deviation);
        l->links[j].v_deviation = sqrt(l->links[j].v_deviation);
    }
    return status;
}

/* w - B^T E[f] into l->excess, slopes of E[f] into l->slope; returns the size of the forces. */
static double find_excess(trk_linearisation *l)
{
    const trk_model *model = l->model;
    double size = 0;
    memcpy(l->excess, model->weight, (size_t)model->n * sizeof *l->excess);
    for (int32_t i = 0; i < model->n; i++)
        size = fmax(size, fabs(l->excess[i]));
    for (int32_t k = 0, j = 0; k < model->links.count; k++) {
        const double e = trk_rows_dot(&model->links, k, l->mean);
        double force = model->laws[k].stiffness * e;
        l->slope[k] = model->laws[k].stiffness;
        if (j < model->nonlinear_count && model->nonlinear[j] == k) {
            force = l->links[j].equivalent.force;
            l->slope[k] = l->links[j].equivalent.slope;
            size = fmax(size, fabs(l->links[j].equivalent.stiffness) * l->links[j].e_deviation);
            j++;
        }
        size = fmax(size, fabs(force));
        trk_rows_add(&model->links, k, -force, l->excess);
    }
    return size;
}

/* One step of Newton's method on the balance of mean forces, or a part of it. */
static trk_status balance(trk_linearisation *l, double *out_moved)
{
    const trk_model *model = l->model;
    const double size = find_excess(l);
    double largest = 0;
    for (int32_t i = 0; i < model->n; i++)
        largest = fmax(largest, fabs(l->excess[i]));
    *out_moved = 0;
    if (largest <= 1e-13 * size) /* balanced, as where all is symmetric: nothing need hold it */
        return TRK_OK;
    int32_t bad = 0;
    trk_status status = trk_assembly_factorize(&l->assembly, 0, l->slope, &bad);
    if (status == TRK_E_SINGULAR)
        return trk_model_fail_singular(l->context, model, "stiffness against mean forces", l->slope,
                                       bad);
    if (status == TRK_OK)
        status = trk_solver_solve(l->assembly.solver, l->excess);
    if (status != TRK_OK)
        return status;
    for (int32_t j = 0; j < model->nonlinear_count; j++) {
        const double e = trk_rows_dot(&model->links, model->nonlinear[j], l->excess);
        if (l->links[j].e_deviation > 0)
            *out_moved = fmax(*out_moved, fabs(e) / l->links[j].e_deviation);
    }
    /* Slopes hold about as far as the motion goes. */
    const double share = *out_moved > longest_step ? longest_step / *out_moved : 1;
    for (int32_t i = 0; i < model->n; i++)
        l->mean[i] += share * l->excess[i];
    return TRK_OK;
}

static trk_status find_equivalents(trk_linearisation *l)
{
    for (int32_t j = 0; j < l->model->nonlinear_count; j++) {
        const int32_t k = l->model->nonlinear[j];
        trk_moved_link *link = &l->links[j];
        const double e = trk_rows_dot(&l->model->links, k, l->mean);
        const bool within = trk_link_equivalent(&l->model->laws[k], e, link->e_deviation,
                                                link->v_deviation, &link->equivalent);
        if (!within || !isfinite(link->equivalent.stiffness) || !isfinite(link->equivalent.damping))
            return trk_fail(
                l->context, TRK_E_RANGE,
                "%s: link '%s' leaves what its law can do, by a mean of %g and a standard "
                "deviation of %g",
                trk_model_name(l->model), trk_model_part_name(l->model, TRK_PART_LINK, k + 1), e,
                link->e_deviation);
    }
    return TRK_OK;
}

trk_status trk_linearisation_move(trk_linearisation *l, double tolerance)
{
    double moved = INFINITY;
    trk_status status = TRK_OK;
    for (int k = 0; k < MOST_STEPS && status == TRK_OK && moved > tolerance; k++) {
        status = find_equivalents(l);
        if (status == TRK_OK)
            status = balance(l, &moved);
    }
    return status == TRK_OK && moved > tolerance
               ? trk_fail(
                     l->context, TRK_E_CONVERGENCE,
                     "%s: statistical linearisation: no mean position in %d steps, the last of "
                     "%.2g standard deviations",
                     trk_model_name(l->model), MOST_STEPS, moved)
               : status;
}

trk_status trk_linearisation_check(trk_linearisation *l)
{
    trk_modes *modes;
    trk_status status = trk_modes_create_damped(l->context, l->linear, NULL, NULL, &modes);
    if (status != TRK_OK)
        return status;
    for (int32_t k = 1; status == TRK_OK && k <= trk_modes_count(modes); k++)
        if (trk_modes_damping_ratio(modes, k) < -1e-6)
            status = trk_fail(l->context, TRK_E_MODEL,
                              "%s: the linear vehicle is unstable: the mode of %s at %g Hz grows",
                              trk_model_name(l->model), trk_modes_label(modes, k),
                              trk_modes_frequency(modes, k));
    trk_modes_destroy(modes);
    return status;
}
