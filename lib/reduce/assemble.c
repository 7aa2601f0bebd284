/* SPDX-License-Identifier: MIT */
/* A model over the new coordinates. */
#include "reduce/assemble.h"

#include "reduce/compress.h"
#include "reduce/links.h"

#include <stdio.h>
#include <string.h>

static trk_status add_inertia(trk_model *out, double mass)
{
    trk_status status = trk_grow(out->context, (void **)&out->mass, &out->mass_capacity,
                                 out->inertia.count, sizeof *out->mass);
    if (status == TRK_OK)
        out->mass[out->inertia.count - 1] = mass;
    return status;
}

/* Inertia inside of the component is merged, the rest stays. */
static trk_status transform_inertia(trk_transform *t, trk_compressor *sum, trk_model *out)
{
    const trk_component *c = t->component;
    const trk_model *model = c->model;
    trk_status status = TRK_OK;
    for (int32_t r = 0; status == TRK_OK && r < model->inertia.count; r++) {
        if (!trk_component_leaves(c, &model->inertia, r)) {
            trk_basis_project(t->basis, c, &model->inertia, r, t->w);
            trk_compressor_add(sum, model->mass[r], t->w);
            continue;
        }
        status = trk_transform_row(t, &model->inertia, r, &out->inertia);
        if (status == TRK_OK)
            status = add_inertia(out, model->mass[r]);
    }
    trk_compressor_finish(sum);
    for (int32_t j = 0; status == TRK_OK && j < sum->width; j++) {
        double factor = trk_compressor_row(sum, j, t->w);
        if (factor == 0)
            continue;
        status = trk_transform_append(t, t->w, &out->inertia);
        if (status == TRK_OK)
            status = add_inertia(out, factor);
    }
    return status;
}

/* w of (MODEL.2): T^T w. */
static void build_weight(const trk_transform *t, trk_model *out)
{
    const trk_component *c = t->component;
    for (int32_t i = 0; i < c->model->n; i++)
        if (c->place[i] < 0)
            out->weight[t->kept[i]] = c->model->weight[i];
        else
            for (int32_t j = 0; j < t->basis->count; j++)
                out->weight[t->of_basis[j]] +=
                    t->basis->t[(int64_t)c->place[i] * t->basis->count + j] * c->model->weight[i];
}

static trk_status build_inertia(trk_transform *t, trk_model *out)
{
    trk_compressor sum;
    trk_status status = trk_compressor_create(out->context, t->basis->count, &sum);
    if (status == TRK_OK)
        status = transform_inertia(t, &sum, out);
    trk_compressor_clear(out->context, &sum);
    return status;
}

/* "modes.1", "modes.2", ..., on from those of an earlier reduction. */
static trk_status name_modes(trk_model *out, int32_t count)
{
    trk_names *names = &out->names[TRK_PART_COORDINATE];
    trk_status status = TRK_OK;
    for (int32_t number = 1; status == TRK_OK && count > 0; number++) {
        char name[24];
        snprintf(name, sizeof name, "modes.%d", (int)number);
        if (trk_names_find(names, name))
            continue;
        status = trk_names_add(out->context, names, "coordinate", name);
        count--;
    }
    return status;
}

static trk_status build_coordinates(const trk_transform *t, trk_model *out)
{
    const trk_model *model = t->component->model;
    int32_t bodies = model->names[TRK_PART_BODY].count;
    out->n = t->n;
    out->coordinate = trk_new(out->context, bodies, sizeof *out->coordinate);
    out->is_rotation = trk_new(out->context, t->n, sizeof *out->is_rotation);
    out->weight = trk_new(out->context, t->n, sizeof *out->weight);
    out->static_q = trk_new(out->context, t->n, sizeof *out->static_q);
    if (!out->coordinate || !out->is_rotation || !out->weight || !out->static_q)
        return TRK_E_MEMORY;
    for (int32_t b = 0; b < bodies; b++)
        for (int k = 0; k < TRK_FREEDOMS; k++) {
            int32_t old = model->coordinate[b][k];
            out->coordinate[b][k] = old < 0 ? -1 : t->kept[old];
        }
    trk_status status = TRK_OK;
    for (int32_t i = 0; status == TRK_OK && i < model->n; i++)
        if (t->kept[i] >= 0) {
            out->is_rotation[t->kept[i]] = model->is_rotation[i];
            status = trk_names_add(out->context, &out->names[TRK_PART_COORDINATE], "coordinate",
                                   trk_model_part_name(model, TRK_PART_COORDINATE, i + 1));
        }
    return status == TRK_OK ? name_modes(out, t->basis->count - t->basis->kept) : status;
}

/* Copy of an array of `count` elements, also of none. */
static trk_status copy(trk_context *context, int64_t count, size_t size, const void *from, void *to)
{
    void *block = trk_new(context, count, size);
    if (!block)
        return TRK_E_MEMORY;
    if (count > 0)
        memcpy(block, from, (size_t)count * size);
    *(void **)to = block;
    return TRK_OK;
}

static trk_status build_names(const trk_model *model, trk_model *out)
{
    int32_t roads = model->names[TRK_PART_ROAD].count;
    out->name = trk_copy_text(out->context, model->name);
    trk_status status = out->name ? TRK_OK : TRK_E_MEMORY;
    for (trk_part part = 1; status == TRK_OK && part <= TRK_MODEL_PARTS; part++)
        if (part != TRK_PART_COORDINATE)
            status = trk_names_copy(out->context, &model->names[part], &out->names[part]);
    if (status == TRK_OK)
        status = copy(out->context, roads, sizeof(double), model->road_x, &out->road_x);
    if (status == TRK_OK)
        status = copy(out->context, roads, sizeof(double), model->road_y, &out->road_y);
    return status;
}

/* Ports and sensors: their rows, and what they are. */
static trk_status build_parts(trk_transform *t, trk_model *out)
{
    const trk_model *model = t->component->model;
    trk_context *context = out->context;
    int32_t ports = model->ports.count, sensors = model->sensors.count;
    trk_status status = TRK_OK;
    for (int32_t k = 0; status == TRK_OK && k < ports; k++)
        status = trk_transform_row(t, &model->ports, k, &out->ports);
    for (int32_t k = 0; status == TRK_OK && k < sensors; k++)
        status = trk_transform_row(t, &model->sensors, k, &out->sensors);
    if (status == TRK_OK)
        status =
            copy(context, ports, sizeof *out->port_motion, model->port_motion, &out->port_motion);
    if (status == TRK_OK)
        status = copy(context, sensors, sizeof *out->sensor_motion, model->sensor_motion,
                      &out->sensor_motion);
    if (status == TRK_OK)
        status = copy(context, sensors, sizeof *out->sensor_quantity, model->sensor_quantity,
                      &out->sensor_quantity);
    if (status == TRK_OK)
        status =
            copy(context, sensors, sizeof *out->sensor_link, model->sensor_link, &out->sensor_link);
    return status;
}

trk_status trk_reduce_assemble(const trk_component *component, const trk_basis *basis,
                               double modal_damping, trk_model *out)
{
    trk_transform t;
    trk_status status = trk_transform_create(component, basis, &t);
    if (status == TRK_OK)
        status = build_names(component->model, out);
    if (status == TRK_OK)
        status = build_coordinates(&t, out);
    if (status == TRK_OK)
        status = build_inertia(&t, out);
    if (status == TRK_OK)
        status = trk_reduce_build_links(&t, modal_damping, out);
    if (status == TRK_OK)
        status = build_parts(&t, out);
    if (status == TRK_OK)
        build_weight(&t, out);
    trk_transform_clear(&t);
    return status;
}
