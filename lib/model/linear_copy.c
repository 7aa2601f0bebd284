/* SPDX-License-Identifier: MIT */
/* Copy a model and make its links linear. */
#include "model/linear_copy.h"

#include <string.h>

/* A copy of `count` elements; NULL if *status is or becomes other than TRK_OK. */
static void *copy(trk_context *context, const void *from, int64_t count, size_t size,
                  trk_status *status)
{
    if (*status != TRK_OK)
        return NULL;
    void *to = trk_new(context, count, size);
    if (!to)
        *status = TRK_E_MEMORY;
    else if (count > 0)
        memcpy(to, from, (size_t)count * size);
    return to;
}

static trk_status copy_rows(trk_context *context, const trk_rows *from, trk_rows *to)
{
    if (!from->start) /* no row was ever appended */
        return TRK_OK;
    trk_status status = TRK_OK;
    to->start = copy(context, from->start, (int64_t)from->count + 1, sizeof *to->start, &status);
    to->column = copy(context, from->column, from->entries, sizeof *to->column, &status);
    to->value = copy(context, from->value, from->entries, sizeof *to->value, &status);
    if (status != TRK_OK)
        return status;
    to->count = from->count;
    to->entries = from->entries;
    to->row_capacity = (int64_t)from->count + 1;
    to->column_capacity = to->value_capacity = from->entries;
    return TRK_OK;
}

static trk_status copy_parts(const trk_model *from, trk_model *to)
{
    trk_context *context = to->context;
    trk_status status = TRK_OK;
    const int32_t bodies = from->names[TRK_PART_BODY].count,
                  roads = from->names[TRK_PART_ROAD].count;
    const int32_t named = trk_model_named_links(from);
    to->name = trk_copy_text(context, from->name);
    if (!to->name)
        return TRK_E_MEMORY;
    to->n = from->n;
    to->coordinate = copy(context, from->coordinate, bodies, sizeof *to->coordinate, &status);
    to->is_rotation = copy(context, from->is_rotation, from->n, sizeof *to->is_rotation, &status);
    to->mass = copy(context, from->mass, from->inertia.count, sizeof *to->mass, &status);
    to->mass_capacity = from->inertia.count;
    to->link_motion = copy(context, from->link_motion, named, sizeof *to->link_motion, &status);
    to->link_beam =
        copy(context, from->link_beam, from->links.count - named, sizeof *to->link_beam, &status);
    to->port_motion =
        copy(context, from->port_motion, from->ports.count, sizeof *to->port_motion, &status);
    to->sensor_quantity = copy(context, from->sensor_quantity, from->sensors.count,
                               sizeof *to->sensor_quantity, &status);
    to->sensor_motion =
        copy(context, from->sensor_motion, from->sensors.count, sizeof *to->sensor_motion, &status);
    to->sensor_link =
        copy(context, from->sensor_link, from->sensors.count, sizeof *to->sensor_link, &status);
    to->road_x = copy(context, from->road_x, roads, sizeof *to->road_x, &status);
    to->road_y = copy(context, from->road_y, roads, sizeof *to->road_y, &status);
    for (size_t part = 0; status == TRK_OK && part < sizeof to->names / sizeof *to->names; part++)
        status = trk_names_copy(context, &from->names[part], &to->names[part]);
    return status;
}

/* What is not that of the model: links, weight, static equilibrium. */
static trk_status add_links(trk_model *model, const double *stiffness, const double *damping)
{
    trk_context *context = model->context;
    const int32_t links = model->links.count;
    model->laws = trk_new(context, links, sizeof *model->laws);
    model->nonlinear = trk_new(context, links, sizeof *model->nonlinear);
    model->memory = trk_new(context, (int64_t)links + 1, sizeof *model->memory);
    model->static_force = trk_new(context, links, sizeof *model->static_force);
    model->static_q = trk_new(context, model->n, sizeof *model->static_q);
    model->weight = trk_new(context, model->n, sizeof *model->weight);
    if (!model->laws || !model->nonlinear || !model->memory || !model->static_force ||
        !model->static_q || !model->weight)
        return TRK_E_MEMORY;
    for (int32_t k = 0; k < links; k++)
        model->laws[k] = (trk_link_law){.stiffness = stiffness[k], .damping = damping[k]};
    return TRK_OK;
}

trk_status trk_model_copy_linear(trk_context *context, const trk_model *model,
                                 const double *stiffness, const double *damping,
                                 trk_model **out_model)
{
    trk_model *to = trk_new(context, 1, sizeof *to);
    *out_model = NULL;
    if (!to)
        return TRK_E_MEMORY;
    to->context = context;
    trk_status status = copy_parts(model, to);
    if (status == TRK_OK)
        status = copy_rows(context, &model->inertia, &to->inertia);
    if (status == TRK_OK)
        status = copy_rows(context, &model->links, &to->links);
    if (status == TRK_OK)
        status = copy_rows(context, &model->roads, &to->roads);
    if (status == TRK_OK)
        status = copy_rows(context, &model->ports, &to->ports);
    if (status == TRK_OK)
        status = copy_rows(context, &model->sensors, &to->sensors);
    if (status == TRK_OK)
        status = add_links(to, stiffness, damping);
    if (status != TRK_OK) {
        trk_model_destroy(to);
        return status;
    }
    *out_model = to;
    return TRK_OK;
}
