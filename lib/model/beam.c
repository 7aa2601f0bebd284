/* SPDX-License-Identifier: MIT */
/* Beams of a spec as rows of a model (SPEC.6): links without a name, and inertia. */
#include "model/build.h"

#include "system/beam.h"

/* A beam, and where it lies. */
typedef struct placed_beam {
    const trk_beam_options *options;
    int32_t id;
    double axes[3][3];
} placed_beam;

int64_t trk_model_most_beam_rows(const trk_spec *spec)
{
    int64_t count = 0;
    for (int32_t k = 0; k < trk_spec_count(spec, TRK_PART_BEAM); k++)
        count +=
            TRK_BEAM_STIFFNESS_ROWS + (spec->beams[k].mass_damping > 0 ? TRK_BEAM_INERTIA_ROWS : 0);
    return count;
}

/* From the motions of the ends along the axes of the beam to the coordinates of its bodies. */
static void open_row(const trk_model *model, const trk_spec *spec, const placed_beam *beam,
                     const double *ends, trk_open_row *row)
{
    const int32_t body[2] = {beam->options->from_body, beam->options->to_body};
    const double *point[2] = {beam->options->from_point, beam->options->to_point};
    *row = (trk_open_row){0};
    for (int end = 0; end < 2; end++) {
        double force[3] = {0}, moment[3] = {0};
        const double *motion = ends + end * TRK_FREEDOMS;
        if (body[end] == 0) /* clamped to the ground */
            continue;
        for (int axis = 0; axis < 3; axis++)
            for (int k = 0; k < 3; k++) {
                force[k] += motion[axis] * beam->axes[axis][k];
                moment[k] += motion[3 + axis] * beam->axes[axis][k];
            }
        trk_open_row_add(model, spec, body[end], TRK_MOTION_TRANSLATION, point[end], force, 1, row);
        trk_open_row_add(model, spec, body[end], TRK_MOTION_ROTATION, point[end], moment, 1, row);
    }
}

static trk_status add_link(trk_model *model, int32_t beam, const trk_open_row *row,
                           double stiffness, double damping)
{
    if (row->count == 0 || (stiffness == 0 && damping == 0))
        return TRK_OK;
    int32_t link = model->links.count;
    trk_status status = trk_open_row_append(model->context, &model->links, row);
    if (status == TRK_OK)
        status = trk_rows_append(model->context, &model->roads, 0, NULL, NULL);
    if (status != TRK_OK)
        return status;
    model->laws[link] = (trk_link_law){.stiffness = stiffness, .damping = damping};
    model->link_beam[link - trk_model_named_links(model)] = beam;
    model->memory[link + 1] = model->memory[link];
    return TRK_OK;
}

static trk_status add_stiffness(trk_model *model, const trk_spec *spec, const placed_beam *beam,
                                double length)
{
    trk_beam_row rows[TRK_BEAM_STIFFNESS_ROWS];
    const int count = trk_beam_stiffness_rows(beam->options, length, rows);
    trk_status status = TRK_OK;
    for (int k = 0; status == TRK_OK && k < count; k++) {
        trk_open_row row;
        open_row(model, spec, beam, rows[k].row, &row);
        status = add_link(model, beam->id, &row, rows[k].factor,
                          beam->options->stiffness_damping * rows[k].factor);
    }
    return status;
}

static trk_status add_inertia(trk_model *model, const trk_spec *spec, const placed_beam *beam,
                              double length)
{
    trk_beam_row rows[TRK_BEAM_INERTIA_ROWS];
    const int count = trk_beam_inertia_rows(beam->options, length, rows);
    trk_status status = TRK_OK;
    for (int k = 0; status == TRK_OK && k < count; k++) {
        trk_open_row row;
        double lift = 0;
        for (int axis = 0; axis < 3; axis++)
            lift += (rows[k].row[axis] + rows[k].row[TRK_FREEDOMS + axis]) * beam->axes[axis][2];
        open_row(model, spec, beam, rows[k].row, &row);
        status = trk_model_add_inertia(model, &row, rows[k].factor, lift);
        if (status == TRK_OK)
            status =
                add_link(model, beam->id, &row, 0, beam->options->mass_damping * rows[k].factor);
    }
    return status;
}

trk_status trk_model_build_beams(trk_model *model, const trk_spec *spec)
{
    model->link_beam =
        trk_new(model->context, trk_model_most_beam_rows(spec), sizeof *model->link_beam);
    if (!model->link_beam)
        return TRK_E_MEMORY;
    trk_status status = TRK_OK;
    for (int32_t k = 0; status == TRK_OK && k < trk_spec_count(spec, TRK_PART_BEAM); k++) {
        double sine;
        placed_beam beam = {.options = &spec->beams[k], .id = k + 1};
        const double length = trk_beam_axes(beam.options, beam.axes, &sine);
        status = add_stiffness(model, spec, &beam, length);
        if (status == TRK_OK)
            status = add_inertia(model, spec, &beam, length);
    }
    return status;
}
