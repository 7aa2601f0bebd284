/* SPDX-License-Identifier: MIT */
/* Reduce a component of a model (REDUCE.1 to REDUCE.4). */
#include <truckride/reduce.h>

#include "reduce/assemble.h"

#include <math.h>

static const trk_reduce_options defaults = {sizeof defaults, "*.*", 20, 0, -1};

void trk_reduce_options_init(trk_reduce_options *options, size_t struct_size)
{
    trk_write_defaults(options, struct_size, &defaults, sizeof defaults);
}

static trk_status check(trk_context *context, const trk_reduce_options *options)
{
    if (!options->pattern)
        return trk_fail(context, TRK_E_ARGUMENT, "trk_reduce_options: pattern is NULL");
    if (options->modes < 0 || options->interface_modes < 0)
        return trk_fail(context, TRK_E_RANGE,
                        "trk_reduce_options: modes is %d and interface_modes %d; numbers >= 0 are "
                        "needed",
                        (int)options->modes, (int)options->interface_modes);
    if (options->modal_damping != -1 &&
        !(options->modal_damping >= 0 && isfinite(options->modal_damping)))
        return trk_fail(context, TRK_E_RANGE,
                        "trk_reduce_options: modal_damping is %g; a finite number >= 0, or -1, is "
                        "needed",
                        options->modal_damping);
    return TRK_OK;
}

static trk_status build(const trk_component *component, const trk_reduce_options *options,
                        trk_model *out)
{
    trk_basis basis;
    trk_status status = trk_basis_create(component, options, &basis);
    if (status == TRK_OK)
        status = trk_reduce_assemble(component, &basis, options->modal_damping, out);
    trk_basis_clear(&basis);
    if (status == TRK_OK)
        status = trk_model_check_mass(out);
    return status == TRK_OK ? trk_model_solve_static(out) : status;
}

trk_status trk_model_reduce(trk_context *context, const trk_model *model,
                            const trk_reduce_options *options, trk_model **out_model)
{
    TRK_REQUIRE(context, out_model, "trk_model_reduce");
    *out_model = NULL;
    TRK_REQUIRE(context, context, "trk_model_reduce");
    TRK_REQUIRE(context, model, "trk_model_reduce");
    trk_reduce_options known = defaults;
    trk_status status =
        trk_read_options(context, "trk_reduce_options", options, &known, sizeof known);
    if (status == TRK_OK)
        status = check(context, &known);
    if (status != TRK_OK)
        return status;
    trk_model *out = trk_new(context, 1, sizeof *out);
    if (!out)
        return TRK_E_MEMORY;
    out->context = context;
    out->gravity = model->gravity;
    trk_component component;
    status = trk_component_find(context, model, known.pattern, &component);
    if (status == TRK_OK)
        status = build(&component, &known, out);
    trk_component_clear(&component);
    if (status != TRK_OK) {
        trk_model_destroy(out);
        return status;
    }
    *out_model = out;
    return TRK_OK;
}
