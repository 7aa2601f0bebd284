/* SPDX-License-Identifier: MIT */
/* Statistical linearisation: response and equivalent links in turn (LINEAR.31, LINEAR.35). */
#include "linear/linearise.h"

#include <float.h>
#include <math.h>
#include <string.h>

/* Limits of a share of the corrections. */
static const double least_share = 0.1, most_share = 4;

static const trk_linearise_options defaults = {
    .struct_size = sizeof defaults, .tolerance = 1e-6, .relaxation = 1, .max_iterations = 100};

void trk_linearise_options_init(trk_linearise_options *options, size_t struct_size)
{
    trk_write_defaults(options, struct_size, &defaults, sizeof defaults);
}

static trk_status read_options(trk_context *context, const trk_linearise_options *options,
                               trk_linearise_options *out)
{
    *out = defaults;
    trk_status status =
        trk_read_options(context, "trk_linearise_options", options, out, sizeof *out);
    if (status != TRK_OK)
        return status;
    if (!(out->tolerance > 0 && out->tolerance <= 1))
        return trk_fail(
            context, TRK_E_RANGE,
            "trk_linearise_options: tolerance is %g; a number > 0, at most 1, is needed",
            out->tolerance);
    if (!(out->relaxation > 0 && out->relaxation <= 1))
        return trk_fail(
            context, TRK_E_RANGE,
            "trk_linearise_options: relaxation is %g; a number > 0, at most 1, is needed",
            out->relaxation);
    if (out->max_iterations < 1)
        return trk_fail(context, TRK_E_RANGE,
                        "trk_linearise_options: max_iterations is %d; at least 1 is needed",
                        out->max_iterations);
    if (out->reserved)
        return trk_fail(context, TRK_E_OPTIONS,
                        "trk_linearise_options: reserved is %d; 0 is needed", out->reserved);
    return TRK_OK;
}

/*
 * Corrections of stiffness and damping, over the size of both as they act at the link's own
 * frequency. Returns the largest.
 */
static double find_corrections(trk_linearisation *l, int32_t *out_link)
{
    double largest = 0;
    for (int32_t j = 0; j < l->model->nonlinear_count; j++) {
        const trk_link_law *now = &l->linear->laws[l->model->nonlinear[j]];
        trk_moved_link *link = &l->links[j];
        const double omega = link->e_deviation > 0 ? link->v_deviation / link->e_deviation : 1;
        const double size = hypot(link->equivalent.stiffness, omega * link->equivalent.damping);
        const double unit = 1 / fmax(size, DBL_MIN);
        memcpy(link->before, link->correction, sizeof link->before);
        link->correction[0] = (link->equivalent.stiffness - now->stiffness) * unit;
        link->correction[1] = (link->equivalent.damping - now->damping) * omega * unit;
        const double change = hypot(link->correction[0], link->correction[1]);
        if (change > largest) {
            largest = change;
            *out_link = l->model->nonlinear[j];
        }
    }
    return largest;
}

/* The share of the corrections that would have ended them, had all fallen alike (LINEAR.31). */
static double next_share(const trk_linearisation *l, double share)
{
    double product = 0, square = 0;
    for (int32_t j = 0; j < l->model->nonlinear_count; j++)
        for (int i = 0; i < 2; i++) {
            const double fall = l->links[j].before[i] - l->links[j].correction[i];
            product += fall * l->links[j].before[i];
            square += fall * fall;
        }
    const double next = square > 0 ? share * product / square : share;
    return fmin(fmax(next, least_share), most_share);
}

static void correct(trk_linearisation *l, double share)
{
    for (int32_t j = 0; j < l->model->nonlinear_count; j++) {
        trk_link_law *law = &l->linear->laws[l->model->nonlinear[j]];
        const trk_equivalent *equivalent = &l->links[j].equivalent;
        law->stiffness += share * (equivalent->stiffness - law->stiffness);
        law->damping += share * (equivalent->damping - law->damping);
    }
}

static trk_status iterate(trk_linearisation *l, const trk_linearise_options *o)
{
    double share = o->relaxation, change = 0;
    int32_t worst = l->model->nonlinear[0];
    for (int32_t k = 0; k < o->max_iterations; k++) {
        trk_status status = trk_linearisation_respond(l);
        if (status == TRK_OK)
            status = trk_linearisation_move(l, o->tolerance);
        if (status != TRK_OK)
            return status;
        change = find_corrections(l, &worst);
        if (change <= o->tolerance) {
            correct(l, 1);
            return TRK_OK;
        }
        share = k > 0 ? next_share(l, share) : share;
        correct(l, share);
    }
    return trk_fail(l->context, TRK_E_CONVERGENCE,
                    "%s: statistical linearisation: link '%s' still changes by %.2g of its "
                    "stiffness and damping after %d iterations",
                    trk_model_name(l->model),
                    trk_model_part_name(l->model, TRK_PART_LINK, worst + 1), change,
                    o->max_iterations);
}

static void hand_over(trk_linearisation *l, double *out_stiffness, double *out_damping,
                      double *out_mean, trk_model **out_model)
{
    for (int32_t k = 0; k < trk_model_named_links(l->model); k++) {
        if (out_stiffness)
            out_stiffness[k] = l->linear->laws[k].stiffness;
        if (out_damping)
            out_damping[k] = l->linear->laws[k].damping;
    }
    for (int32_t i = 0; out_mean && i < l->model->n; i++)
        out_mean[i] = l->mean[i];
    if (out_model) {
        *out_model = l->linear;
        l->linear = NULL;
    }
}

trk_status trk_model_linearise(trk_context *context, const trk_model *model, int64_t count,
                               const double *frequency, const double *input,
                               const trk_linearise_options *options, double *out_stiffness,
                               double *out_damping, double *out_mean, trk_model **out_model)
{
    if (out_model)
        *out_model = NULL;
    TRK_REQUIRE(context, context, "trk_model_linearise");
    TRK_REQUIRE(context, model, "trk_model_linearise");
    TRK_REQUIRE(context, frequency, "trk_model_linearise");
    TRK_REQUIRE(context, input, "trk_model_linearise");
    trk_linearise_options o;
    trk_status status = read_options(context, options, &o);
    if (status == TRK_OK)
        status = trk_random_check(context, "trk_model_linearise", model, count, frequency, input);
    if (status != TRK_OK)
        return status;
    trk_linearisation l;
    status = trk_linearisation_start(context, model, count, frequency, input, &l);
    if (status == TRK_OK && model->nonlinear_count > 0)
        status = iterate(&l, &o);
    if (status == TRK_OK)
        status = trk_linearisation_check(&l);
    if (status == TRK_OK)
        hand_over(&l, out_stiffness, out_damping, out_mean, out_model);
    trk_linearisation_clear(&l);
    return status;
}
