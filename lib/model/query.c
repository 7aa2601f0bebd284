/* SPDX-License-Identifier: MIT */
/* What a model tells about itself. */
#include "model/model.h"

#include <string.h>

const char *trk_model_name(const trk_model *model)
{
    return model ? model->name : NULL;
}

static const trk_names *names_of(const trk_model *model, trk_part part)
{
    static const trk_names none;
    return model && part >= 1 && part <= TRK_MODEL_PARTS ? &model->names[part] : &none;
}

int32_t trk_model_count(const trk_model *model, trk_part part)
{
    return names_of(model, part)->count;
}

int32_t trk_model_find(const trk_model *model, trk_part part, const char *name)
{
    return trk_names_find(names_of(model, part), name);
}

const char *trk_model_part_name(const trk_model *model, trk_part part, int32_t id)
{
    return trk_names_text(names_of(model, part), id);
}

const char *trk_model_link_name(const trk_model *model, int32_t link, const char **out_word)
{
    int32_t named = trk_model_named_links(model);
    *out_word = link < named ? "link" : "beam";
    return link < named
               ? trk_names_text(&model->names[TRK_PART_LINK], link + 1)
               : trk_names_text(&model->names[TRK_PART_BEAM], model->link_beam[link - named]);
}

static const char *sensor_unit(trk_quantity quantity, bool rotation)
{
    static const char *const units[][2] = {{"m", "rad"}, {"m/s", "rad/s"}, {"m/s^2", "rad/s^2"},
                                           {"m", "rad"}, {"m/s", "rad/s"}, {"N", "N m"}};
    return units[quantity][rotation];
}

const char *trk_model_unit(const trk_model *model, trk_part part, int32_t id)
{
    if (id < 1 || id > trk_model_count(model, part))
        return NULL;
    switch (part) {
    case TRK_PART_COORDINATE: return model->is_rotation[id - 1] ? "rad" : "m";
    case TRK_PART_LINK: return model->link_motion[id - 1] == TRK_MOTION_ROTATION ? "N m" : "N";
    case TRK_PART_PORT: return model->port_motion[id - 1] == TRK_MOTION_ROTATION ? "N m" : "N";
    case TRK_PART_ROAD: return "m";
    case TRK_PART_SENSOR:
        return sensor_unit(model->sensor_quantity[id - 1],
                           model->sensor_motion[id - 1] == TRK_MOTION_ROTATION);
    default: return NULL;
    }
}

double trk_model_gravity(const trk_model *model)
{
    return model ? model->gravity : 0;
}

trk_status trk_model_get_road_place(const trk_model *model, int32_t road, double *out_x,
                                    double *out_y)
{
    if (road < 1 || road > trk_model_count(model, TRK_PART_ROAD))
        return TRK_E_ARGUMENT;
    if (out_x)
        *out_x = model->road_x[road - 1];
    if (out_y)
        *out_y = model->road_y[road - 1];
    return TRK_OK;
}

void trk_model_get_static(const trk_model *model, double *out_q, double *out_force)
{
    if (!model)
        return;
    if (out_q)
        memcpy(out_q, model->static_q, (size_t)model->n * sizeof *out_q);
    if (out_force)
        memcpy(out_force, model->static_force,
               (size_t)trk_model_named_links(model) * sizeof *out_force);
}

void trk_model_get_mass(const trk_model *model, double *out_mass)
{
    if (!model || !out_mass)
        return;
    memset(out_mass, 0, (size_t)model->n * (size_t)model->n * sizeof *out_mass);
    for (int32_t r = 0; r < model->inertia.count; r++)
        trk_rows_add_square(&model->inertia, r, model->mass[r], model->n, out_mass);
}

int32_t trk_model_find_law(const trk_model *model)
{
    for (int32_t j = 0; j < model->nonlinear_count; j++)
        if (model->laws[model->nonlinear[j]].law)
            return model->nonlinear[j];
    return -1;
}

void trk_model_link_tangent(const trk_model *model, int32_t link, const double *q, const double *v,
                            double *out_stiffness, double *out_damping)
{
    const trk_link_law *law = &model->laws[link];
    trk_law_hint hint = {0, 0};
    trk_law_point point;
    trk_link_law_evaluate(law, trk_rows_dot(&model->links, link, q ? q : model->static_q),
                          v ? trk_rows_dot(&model->links, link, v) : 0, &hint, &point);
    *out_stiffness = law->stiffness + point.stiffness;
    *out_damping = law->damping + point.damping;
}

void trk_model_get_tangent(const trk_model *model, const double *q, const double *v,
                           double *out_damping, double *out_stiffness)
{
    if (!model)
        return;
    size_t size = (size_t)model->n * (size_t)model->n * sizeof(double);
    if (out_damping)
        memset(out_damping, 0, size);
    if (out_stiffness)
        memset(out_stiffness, 0, size);
    for (int32_t k = 0; k < model->links.count; k++) {
        double stiffness, damping;
        trk_model_link_tangent(model, k, q, v, &stiffness, &damping);
        if (out_damping)
            trk_rows_add_square(&model->links, k, damping, model->n, out_damping);
        if (out_stiffness)
            trk_rows_add_square(&model->links, k, stiffness, model->n, out_stiffness);
    }
}

trk_status trk_model_get_link_row(const trk_model *model, int32_t link, double *out_b,
                                  double *out_g)
{
    if (!out_b || link < 1 || link > trk_model_count(model, TRK_PART_LINK))
        return TRK_E_ARGUMENT;
    trk_rows_expand(&model->links, link - 1, model->n, out_b);
    if (out_g)
        trk_rows_expand(&model->roads, link - 1, model->names[TRK_PART_ROAD].count, out_g);
    return TRK_OK;
}

trk_status trk_model_get_row(const trk_model *model, trk_part part, int32_t id, double *out_row)
{
    if (!out_row || id < 1 || id > trk_model_count(model, part))
        return TRK_E_ARGUMENT;
    if (part == TRK_PART_PORT)
        trk_rows_expand(&model->ports, id - 1, model->n, out_row);
    else if (part == TRK_PART_SENSOR && model->sensor_link[id - 1] >= 0)
        trk_rows_expand(&model->links, model->sensor_link[id - 1], model->n, out_row);
    else if (part == TRK_PART_SENSOR)
        trk_rows_expand(&model->sensors, id - 1, model->n, out_row);
    else
        return TRK_E_ARGUMENT;
    return TRK_OK;
}

void trk_model_get_link_force(const trk_model *model, const double *e, const double *rate,
                              double *out_force)
{
    if (!model || !e || !rate || !out_force)
        return;
    for (int32_t k = 0; k < trk_model_named_links(model); k++)
        out_force[k] = trk_link_law_force(&model->laws[k], e[k], rate[k]);
}
