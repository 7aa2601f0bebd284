/* SPDX-License-Identifier: MIT */
/* Turn a spec into coordinates and rows. */
#include "model/build.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/*
 * Add sign times the motion of a body point along a unit direction d (SPEC.1):
 * d . (u_cg + theta x r) = d . u_cg + (r x d) . theta, with r = point - cg.
 */
void trk_open_row_add(const trk_model *model, const trk_spec *spec, int32_t body, trk_motion motion,
                      const double *point, const double *d, double sign, trk_open_row *row)
{
    double coefficient[TRK_FREEDOMS] = {0};
    const double *cg = spec->bodies[body - 1].cg;
    double r[3] = {point[0] - cg[0], point[1] - cg[1], point[2] - cg[2]};
    if (motion == TRK_MOTION_TRANSLATION) {
        memcpy(coefficient, d, 3 * sizeof *d);
        coefficient[3] = r[1] * d[2] - r[2] * d[1];
        coefficient[4] = r[2] * d[0] - r[0] * d[2];
        coefficient[5] = r[0] * d[1] - r[1] * d[0];
    } else {
        memcpy(coefficient + 3, d, 3 * sizeof *d);
    }
    for (int k = 0; k < TRK_FREEDOMS; k++) {
        int32_t column = model->coordinate[body - 1][k];
        if (column < 0 || coefficient[k] == 0)
            continue;
        row->column[row->count] = column;
        row->value[row->count++] = sign * coefficient[k];
    }
}

static void unit_vector(const double *direction, double *out)
{
    double length = hypot(hypot(direction[0], direction[1]), direction[2]);
    for (int k = 0; k < 3; k++)
        out[k] = direction[k] / length;
}

trk_status trk_open_row_append(trk_context *context, trk_rows *rows, const trk_open_row *row)
{
    return trk_rows_append(context, rows, row->count, row->column, row->value);
}

static trk_status number_coordinates(trk_model *model, const trk_spec *spec)
{
    static const char *const suffix[TRK_FREEDOMS] = {"x", "y", "z", "roll", "pitch", "yaw"};
    int32_t bodies = trk_spec_count(spec, TRK_PART_BODY);
    model->coordinate = trk_new(model->context, bodies, sizeof *model->coordinate);
    model->is_rotation = trk_new(model->context, (int64_t)bodies * TRK_FREEDOMS, sizeof(bool));
    if (!model->coordinate || !model->is_rotation)
        return TRK_E_MEMORY;
    for (int32_t b = 0; b < bodies; b++)
        for (int k = 0; k < TRK_FREEDOMS; k++) {
            model->coordinate[b][k] = -1;
            if (!(spec->bodies[b].freedoms & (1 << k)))
                continue;
            char name[TRK_NAME_LENGTH + 8];
            snprintf(name, sizeof name, "%s.%s", spec->names[TRK_PART_BODY].text[b], suffix[k]);
            trk_status status = trk_names_add(model->context, &model->names[TRK_PART_COORDINATE],
                                              "coordinate", name);
            if (status != TRK_OK)
                return status;
            model->is_rotation[model->n] = k >= 3;
            model->coordinate[b][k] = model->n++;
        }
    return TRK_OK;
}

trk_status trk_model_add_inertia(trk_model *model, const trk_open_row *row, double mass,
                                 double lift)
{
    if (row->count == 0 || mass == 0)
        return TRK_OK;
    trk_status status = trk_open_row_append(model->context, &model->inertia, row);
    if (status == TRK_OK)
        status = trk_grow(model->context, (void **)&model->mass, &model->mass_capacity,
                          model->inertia.count, sizeof *model->mass);
    if (status != TRK_OK)
        return status;
    model->mass[model->inertia.count - 1] = mass;
    trk_rows_add(&model->inertia, model->inertia.count - 1, -mass * lift * model->gravity,
                 model->weight);
    return TRK_OK;
}

static const double axis[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

static trk_status build_inertia(trk_model *model, const trk_spec *spec)
{
    trk_status status = TRK_OK;
    for (int32_t b = 1; b <= trk_spec_count(spec, TRK_PART_BODY); b++) {
        const trk_body_options *body = &spec->bodies[b - 1];
        for (int k = 0; status == TRK_OK && k < TRK_FREEDOMS; k++) {
            trk_open_row row = {0};
            trk_open_row_add(model, spec, b, k < 3 ? TRK_MOTION_TRANSLATION : TRK_MOTION_ROTATION,
                             body->cg, axis[k % 3], 1, &row);
            status = trk_model_add_inertia(model, &row, k < 3 ? body->mass : body->inertia[k - 3],
                                           k == 2);
        }
    }
    for (int32_t m = 0; m < trk_spec_count(spec, TRK_PART_MASS); m++) {
        const trk_point_mass *mass = &spec->masses[m];
        for (int k = 0; status == TRK_OK && k < 3; k++) {
            trk_open_row row = {0};
            trk_open_row_add(model, spec, mass->body, TRK_MOTION_TRANSLATION, mass->point, axis[k],
                             1, &row);
            status = trk_model_add_inertia(model, &row, mass->mass, k == 2);
        }
    }
    return status;
}

static trk_status build_law(trk_model *model, const trk_link_options *link, trk_link_law *law)
{
    *law = (trk_link_law){.stiffness = link->stiffness,
                          .damping = link->damping,
                          .spring_scale = link->spring_scale,
                          .damper_scale = link->damper_scale,
                          .spring_offset = link->spring_offset};
    trk_status status = TRK_OK;
    if (link->spring_curve)
        status = trk_curve_copy(model->context, link->spring_curve, &law->spring);
    if (status == TRK_OK && link->damper_curve)
        status = trk_curve_copy(model->context, link->damper_curve, &law->damper);
    if (status == TRK_OK && link->law)
        status = trk_law_copy(model->context, link->law, &law->law);
    if (status == TRK_OK && model->gravity == 0)
        law->rest = trk_link_law_force(law, 0, 0);
    return status;
}

static trk_status build_links(trk_model *model, const trk_spec *spec)
{
    int32_t count = trk_spec_count(spec, TRK_PART_LINK);
    model->laws =
        trk_new(model->context, count + trk_model_most_beam_rows(spec), sizeof *model->laws);
    model->link_motion = trk_new(model->context, count, sizeof *model->link_motion);
    model->nonlinear = trk_new(model->context, count, sizeof *model->nonlinear);
    model->memory =
        trk_new(model->context, count + trk_model_most_beam_rows(spec) + 1, sizeof *model->memory);
    if (!model->laws || !model->link_motion || !model->nonlinear || !model->memory)
        return TRK_E_MEMORY;
    for (int32_t k = 0; k < count; k++) {
        const trk_link_options *link = &spec->links[k];
        double d[3];
        unit_vector(link->direction, d);
        trk_open_row row = {0};
        if (link->to_body)
            trk_open_row_add(model, spec, link->to_body, link->motion, link->to_point, d, 1, &row);
        if (link->from_body)
            trk_open_row_add(model, spec, link->from_body, link->motion, link->from_point, d, -1,
                             &row);
        trk_status status = trk_open_row_append(model->context, &model->links, &row);
        if (status == TRK_OK)
            status = trk_rows_append(model->context, &model->roads, link->from_road ? 1 : 0,
                                     &(int32_t){link->from_road - 1}, &d[2]);
        if (status == TRK_OK)
            status = build_law(model, link, &model->laws[k]);
        if (status != TRK_OK)
            return status;
        model->link_motion[k] = link->motion;
        model->memory[k + 1] = model->memory[k] + trk_link_law_states(&model->laws[k]);
        if (!trk_link_law_is_linear(&model->laws[k]))
            model->nonlinear[model->nonlinear_count++] = k;
    }
    return TRK_OK;
}

static trk_status build_ports(trk_model *model, const trk_spec *spec)
{
    int32_t count = trk_spec_count(spec, TRK_PART_PORT);
    model->port_motion = trk_new(model->context, count, sizeof *model->port_motion);
    if (!model->port_motion)
        return TRK_E_MEMORY;
    trk_status status = TRK_OK;
    for (int32_t k = 0; status == TRK_OK && k < count; k++) {
        const trk_port_options *port = &spec->ports[k];
        double d[3];
        unit_vector(port->direction, d);
        trk_open_row row = {0};
        trk_open_row_add(model, spec, port->body, port->motion, port->point, d, 1, &row);
        model->port_motion[k] = port->motion;
        status = trk_open_row_append(model->context, &model->ports, &row);
    }
    return status;
}

static trk_status build_sensors(trk_model *model, const trk_spec *spec)
{
    int32_t count = trk_spec_count(spec, TRK_PART_SENSOR);
    model->sensor_quantity = trk_new(model->context, count, sizeof *model->sensor_quantity);
    model->sensor_motion = trk_new(model->context, count, sizeof *model->sensor_motion);
    model->sensor_link = trk_new(model->context, count, sizeof *model->sensor_link);
    if (!model->sensor_quantity || !model->sensor_motion || !model->sensor_link)
        return TRK_E_MEMORY;
    trk_status status = TRK_OK;
    for (int32_t k = 0; status == TRK_OK && k < count; k++) {
        const trk_sensor_options *sensor = &spec->sensors[k];
        bool of_body = sensor->quantity <= TRK_QUANTITY_ACCELERATION;
        trk_open_row row = {0};
        if (of_body) {
            double d[3];
            unit_vector(sensor->direction, d);
            trk_open_row_add(model, spec, sensor->body, sensor->motion, sensor->point, d, 1, &row);
        }
        model->sensor_quantity[k] = sensor->quantity;
        model->sensor_link[k] = of_body ? -1 : sensor->link - 1;
        model->sensor_motion[k] = of_body ? sensor->motion : model->link_motion[sensor->link - 1];
        status = trk_open_row_append(model->context, &model->sensors, &row);
    }
    return status;
}

static trk_status copy_names(trk_model *model, const trk_spec *spec)
{
    int32_t roads = trk_spec_count(spec, TRK_PART_ROAD);
    model->name = trk_copy_text(model->context, spec->name);
    model->road_x = trk_new(model->context, roads, sizeof *model->road_x);
    model->road_y = trk_new(model->context, roads, sizeof *model->road_y);
    if (!model->name || !model->road_x || !model->road_y)
        return TRK_E_MEMORY;
    for (int32_t k = 0; k < roads; k++) {
        model->road_x[k] = spec->roads[k].x;
        model->road_y[k] = spec->roads[k].y;
    }
    trk_status status = TRK_OK;
    for (trk_part part = 1; status == TRK_OK && part <= TRK_SPEC_PARTS; part++)
        status = trk_names_copy(model->context, &spec->names[part], &model->names[part]);
    return status;
}

trk_status trk_model_build(trk_model *model, const trk_spec *spec)
{
    if (trk_spec_count(spec, TRK_PART_BODY) == 0)
        return trk_fail(model->context, TRK_E_MODEL, "the spec has no body");
    trk_status status = copy_names(model, spec);
    if (status == TRK_OK)
        status = number_coordinates(model, spec);
    if (status != TRK_OK)
        return status;
    model->weight = trk_new(model->context, model->n, sizeof *model->weight);
    model->static_q = trk_new(model->context, model->n, sizeof *model->static_q);
    model->static_force = trk_new(
        model->context, trk_spec_count(spec, TRK_PART_LINK) + trk_model_most_beam_rows(spec),
        sizeof *model->static_force);
    if (!model->weight || !model->static_q || !model->static_force)
        return TRK_E_MEMORY;
    status = build_inertia(model, spec);
    if (status == TRK_OK)
        status = build_links(model, spec);
    if (status == TRK_OK)
        status = trk_model_build_beams(model, spec);
    if (status == TRK_OK)
        status = build_ports(model, spec);
    if (status == TRK_OK)
        status = build_sensors(model, spec);
    return status;
}
