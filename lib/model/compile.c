/* SPDX-License-Identifier: MIT */
/* Compile a spec: build the rows, check them, find static equilibrium. */
#include "model/model.h"

#include <math.h>

static const trk_model_options defaults = {sizeof defaults, 0, 0};

void trk_model_options_init(trk_model_options *options, size_t struct_size)
{
    trk_write_defaults(options, struct_size, &defaults, sizeof defaults);
}

static trk_status compile(trk_model *model, const trk_spec *spec, const trk_model_options *options)
{
    trk_status status = trk_model_build(model, spec);
    if (status == TRK_OK)
        status = trk_model_check_numbers(model);
    if (status == TRK_OK && !options->allow_free)
        status = trk_model_check_ties(model, spec);
    if (status == TRK_OK)
        status = trk_model_check_mass(model);
    if (status == TRK_OK)
        status = trk_model_solve_static(model);
    return status;
}

trk_status trk_model_compile(trk_context *context, const trk_spec *spec,
                             const trk_model_options *options, trk_model **out_model)
{
    TRK_REQUIRE(context, out_model, "trk_model_compile");
    *out_model = NULL;
    TRK_REQUIRE(context, context, "trk_model_compile");
    TRK_REQUIRE(context, spec, "trk_model_compile");
    trk_model_options known = defaults;
    trk_status status =
        trk_read_options(context, "trk_model_options", options, &known, sizeof known);
    if (status != TRK_OK)
        return status;
    if (!isfinite(known.gravity) || known.gravity < 0)
        return trk_fail(context, TRK_E_RANGE,
                        "trk_model_options: gravity is %g m/s^2; a finite number >= 0 is needed",
                        known.gravity);
    trk_model *model = trk_new(context, 1, sizeof *model);
    if (!model)
        return TRK_E_MEMORY;
    model->context = context;
    model->gravity = known.gravity;
    status = compile(model, spec, &known);
    if (status != TRK_OK) {
        trk_model_destroy(model);
        return status == TRK_E_MEMORY ? status
                                      : trk_fail_within(context, status, "%s", trk_spec_name(spec));
    }
    *out_model = model;
    return TRK_OK;
}

void trk_model_destroy(trk_model *model)
{
    if (!model)
        return;
    trk_context *context = model->context;
    for (int32_t k = 0; model->laws && k < model->names[TRK_PART_LINK].count; k++) {
        trk_curve_destroy(model->laws[k].spring);
        trk_curve_destroy(model->laws[k].damper);
        trk_law_destroy(model->laws[k].law);
    }
    for (trk_part part = 0; part <= TRK_MODEL_PARTS; part++)
        trk_names_clear(context, &model->names[part]);
    trk_rows_clear(context, &model->inertia);
    trk_rows_clear(context, &model->links);
    trk_rows_clear(context, &model->roads);
    trk_rows_clear(context, &model->ports);
    trk_rows_clear(context, &model->sensors);
    void *blocks[] = {model->name,          model->coordinate,      model->is_rotation,
                      model->mass,          model->weight,          model->laws,
                      model->link_motion,   model->nonlinear,       model->port_motion,
                      model->sensor_motion, model->sensor_quantity, model->sensor_link,
                      model->memory,        model->link_beam,       model->road_x,
                      model->road_y,        model->static_q,        model->static_force};
    for (size_t k = 0; k < sizeof blocks / sizeof *blocks; k++)
        trk_free(context, blocks[k]);
    trk_free(context, model);
}
