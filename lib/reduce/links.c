/* SPDX-License-Identifier: MIT */
/* Links of a reduced model. */
#include "reduce/links.h"

#include "reduce/compress.h"

#include <math.h>
#include <string.h>

/* Rows of the component alone that have no name: only their sum counts. */
static bool is_merged(const trk_component *c, int32_t link)
{
    return link >= trk_model_named_links(c->model) &&
           !trk_component_leaves(c, &c->model->links, link);
}

/* A link without a name behind the others. */
static trk_status add_link(trk_model *out, int32_t beam, double stiffness, double damping)
{
    int32_t link = out->links.count - 1;
    out->laws[link] = (trk_link_law){.stiffness = stiffness, .damping = damping};
    out->link_beam[link - trk_model_named_links(out)] = beam;
    out->memory[link + 1] = out->memory[link];
    return trk_rows_append(out->context, &out->roads, 0, NULL, NULL);
}

static trk_status copy_law(trk_context *context, const trk_link_law *from, trk_link_law *to)
{
    *to = *from;
    to->spring = to->damper = NULL;
    to->law = NULL;
    trk_status status = TRK_OK;
    if (from->spring)
        status = trk_curve_copy(context, from->spring, &to->spring);
    if (status == TRK_OK && from->damper)
        status = trk_curve_copy(context, from->damper, &to->damper);
    if (status == TRK_OK && from->law)
        status = trk_law_copy(context, from->law, &to->law);
    return status;
}

/* Links with names, and rows of beams that lead out of the component. */
static trk_status build_others(trk_transform *t, trk_model *out)
{
    const trk_model *model = t->component->model;
    trk_status status = TRK_OK;
    for (int32_t k = 0; status == TRK_OK && k < model->links.count; k++) {
        if (is_merged(t->component, k))
            continue;
        status = trk_transform_row(t, &model->links, k, &out->links);
        if (status != TRK_OK)
            return status;
        int32_t link = out->links.count - 1, named = trk_model_named_links(model);
        if (k >= named) {
            status = add_link(out, model->link_beam[k - named], model->laws[k].stiffness,
                              model->laws[k].damping);
            continue;
        }
        int64_t first = model->roads.start[k];
        status =
            trk_rows_append(out->context, &out->roads, (int32_t)(model->roads.start[k + 1] - first),
                            model->roads.column + first, model->roads.value + first);
        if (status == TRK_OK)
            status = copy_law(out->context, &model->laws[k], &out->laws[link]);
        out->link_motion[link] = model->link_motion[k];
        out->memory[link + 1] = out->memory[link] + trk_link_law_states(&out->laws[link]);
        if (!trk_link_law_is_linear(&out->laws[link]))
            out->nonlinear[out->nonlinear_count++] = link;
    }
    return status;
}

/* What merged links do, by one of their factors; columns of modes only if asked for. */
static void merge_links(trk_transform *t, bool of_damping, bool with_modes, trk_compressor *sum)
{
    const trk_component *c = t->component;
    for (int32_t k = 0; k < c->model->links.count; k++) {
        double factor = of_damping ? c->damping[k] : c->stiffness[k];
        if (!is_merged(c, k) || factor == 0)
            continue;
        trk_basis_project(t->basis, c, &c->model->links, k, t->w);
        for (int32_t j = t->basis->kept; !with_modes && j < t->basis->count; j++)
            t->w[j] = 0;
        trk_compressor_add(sum, factor, t->w);
    }
    trk_compressor_finish(sum);
}

static trk_status append_links(trk_transform *t, const trk_compressor *sum, bool of_damping,
                               int32_t beam, trk_model *out)
{
    trk_status status = TRK_OK;
    for (int32_t j = 0; status == TRK_OK && j < sum->width; j++) {
        double factor = trk_compressor_row(sum, j, t->w);
        if (factor == 0)
            continue;
        status = trk_transform_append(t, t->w, &out->links);
        if (status == TRK_OK)
            status = add_link(out, beam, of_damping ? 0 : factor, of_damping ? factor : 0);
    }
    return status;
}

static trk_status build_merged(trk_transform *t, bool of_damping, bool with_modes, int32_t beam,
                               trk_model *out)
{
    trk_compressor sum;
    trk_status status = trk_compressor_create(out->context, t->basis->count, &sum);
    if (status == TRK_OK) {
        merge_links(t, of_damping, with_modes, &sum);
        status = append_links(t, &sum, of_damping, beam, out);
    }
    trk_compressor_clear(out->context, &sum);
    return status;
}

/* Damping ratio of the modes: c = 2 ratio sqrt(k m) on each coordinate. */
static trk_status build_modal_damping(trk_transform *t, double ratio, int32_t beam, trk_model *out)
{
    const trk_basis *basis = t->basis;
    trk_status status = TRK_OK;
    for (int32_t j = basis->kept; status == TRK_OK && j < basis->count; j++) {
        double damping = 2 * ratio * sqrt(fmax(basis->stiffness[j], 0) * basis->mass[j]);
        if (damping == 0)
            continue;
        memset(t->w, 0, (size_t)basis->count * sizeof *t->w);
        t->w[j] = 1;
        status = trk_transform_append(t, t->w, &out->links);
        if (status == TRK_OK)
            status = add_link(out, beam, 0, damping);
    }
    return status;
}

static int32_t first_merged_beam(const trk_component *c)
{
    int32_t named = trk_model_named_links(c->model);
    for (int32_t k = named; k < c->model->links.count; k++)
        if (is_merged(c, k))
            return c->model->link_beam[k - named];
    return 0;
}

trk_status trk_reduce_build_links(trk_transform *transform, double modal_damping, trk_model *out)
{
    const trk_model *model = transform->component->model;
    int64_t named = trk_model_named_links(model),
            most = model->links.count + 3 * (int64_t)transform->basis->count;
    int32_t beam = first_merged_beam(transform->component);
    out->laws = trk_new(out->context, most, sizeof *out->laws);
    out->link_motion = trk_new(out->context, named, sizeof *out->link_motion);
    out->link_beam = trk_new(out->context, most, sizeof *out->link_beam);
    out->nonlinear = trk_new(out->context, named, sizeof *out->nonlinear);
    out->memory = trk_new(out->context, most + 1, sizeof *out->memory);
    out->static_force = trk_new(out->context, most, sizeof *out->static_force);
    if (!out->laws || !out->link_motion || !out->link_beam || !out->nonlinear || !out->memory ||
        !out->static_force)
        return TRK_E_MEMORY;
    bool of_modes = modal_damping < 0;
    trk_status status = build_others(transform, out);
    if (status == TRK_OK)
        status = build_merged(transform, false, true, beam, out);
    if (status == TRK_OK)
        status = build_merged(transform, true, of_modes, beam, out);
    if (status == TRK_OK && !of_modes)
        status = build_modal_damping(transform, modal_damping, beam, out);
    return status;
}
