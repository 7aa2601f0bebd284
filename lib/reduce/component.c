/* SPDX-License-Identifier: MIT */
/* Interface and interior of a component. */
#include "reduce/component.h"

#include "spec/vary.h"

#include <string.h>

/* Values of place while coordinates are sorted. */
enum { OUTSIDE = -1, INTERIOR = 0, INTERFACE = 1 };

void trk_component_clear(trk_component *component)
{
    trk_free(component->context, component->coordinate);
    trk_free(component->context, component->place);
    trk_free(component->context, component->stiffness);
    trk_free(component->context, component->damping);
    memset(component, 0, sizeof *component);
}

bool trk_component_touches(const trk_component *component, const trk_rows *rows, int32_t row)
{
    for (int64_t k = rows->start[row]; k < rows->start[row + 1]; k++)
        if (component->place[rows->column[k]] >= 0)
            return true;
    return false;
}

bool trk_component_leaves(const trk_component *component, const trk_rows *rows, int32_t row)
{
    for (int64_t k = rows->start[row]; k < rows->start[row + 1]; k++)
        if (component->place[rows->column[k]] < 0)
            return true;
    return false;
}

const char *trk_component_name(const trk_component *component, int32_t k)
{
    return trk_model_part_name(component->model, TRK_PART_COORDINATE, component->coordinate[k] + 1);
}

static trk_status allocate(trk_component *c)
{
    int64_t n = c->model->n, links = c->model->links.count;
    c->coordinate = trk_new(c->context, n, sizeof *c->coordinate);
    c->place = trk_new(c->context, n, sizeof *c->place);
    c->stiffness = trk_new(c->context, links, sizeof(double));
    c->damping = trk_new(c->context, links, sizeof(double));
    return c->coordinate && c->place && c->stiffness && c->damping ? TRK_OK : TRK_E_MEMORY;
}

/* All coordinates of matching bodies are interior, until a row says otherwise. */
static trk_status find_bodies(trk_component *c, const char *pattern)
{
    bool found = false;
    for (int32_t i = 0; i < c->model->n; i++)
        c->place[i] = OUTSIDE;
    for (int32_t b = 0; b < c->model->names[TRK_PART_BODY].count; b++) {
        if (!trk_spec_matches(pattern, c->model->names[TRK_PART_BODY].text[b]))
            continue;
        found = true;
        for (int k = 0; k < TRK_FREEDOMS; k++)
            if (c->model->coordinate[b][k] >= 0)
                c->place[c->model->coordinate[b][k]] = INTERIOR;
    }
    return found ? TRK_OK
                 : trk_fail(c->context, TRK_E_NAME, "%s: reduction: no body matches '%s'",
                            c->model->name, pattern);
}

static void mark(trk_component *c, const trk_rows *rows, int32_t row)
{
    for (int64_t k = rows->start[row]; k < rows->start[row + 1]; k++)
        if (c->place[rows->column[k]] == INTERIOR)
            c->place[rows->column[k]] = INTERFACE;
}

/* What reaches out of the component, or is not linear, attaches to the interface. */
static void find_interface(trk_component *c)
{
    const trk_model *model = c->model;
    for (int32_t k = 0; k < model->links.count; k++)
        if (!trk_link_law_is_linear(&model->laws[k]) ||
            model->roads.start[k + 1] > model->roads.start[k] ||
            trk_component_leaves(c, &model->links, k))
            mark(c, &model->links, k);
    for (int32_t r = 0; r < model->inertia.count; r++)
        if (trk_component_leaves(c, &model->inertia, r))
            mark(c, &model->inertia, r);
}

/* From marks to places: the interface first, each part in the order of the model. */
static void number(trk_component *c)
{
    for (int32_t kind = INTERFACE; kind >= INTERIOR; kind--) {
        for (int32_t i = 0; i < c->model->n; i++)
            if (c->place[i] == kind)
                c->coordinate[c->count++] = i;
        if (kind == INTERFACE)
            c->interface_count = c->count;
    }
    for (int32_t k = 0; k < c->count; k++)
        c->place[c->coordinate[k]] = k;
}

trk_status trk_component_find(trk_context *context, const trk_model *model, const char *pattern,
                              trk_component *out)
{
    *out = (trk_component){.context = context, .model = model};
    trk_status status = allocate(out);
    if (status == TRK_OK)
        status = find_bodies(out, pattern);
    if (status != TRK_OK)
        return status;
    find_interface(out);
    number(out);
    for (int32_t k = 0; k < model->links.count; k++)
        trk_model_link_tangent(model, k, NULL, NULL, &out->stiffness[k], &out->damping[k]);
    if (out->count == out->interface_count)
        return trk_fail(context, TRK_E_MODEL,
                        "%s: reduction: all %d coordinates of '%s' are interface: links to other "
                        "bodies or roads, curves or laws act on each",
                        model->name, (int)out->count, pattern);
    return TRK_OK;
}
