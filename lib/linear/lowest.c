/* SPDX-License-Identifier: MIT */
/* Lowest undamped modes of a model of any size. */
#include "linear/modes.h"
#include "linear/tangent.h"
#include "linear/vibration.h"

#include "model/model.h"

static trk_status solve(const trk_model *model, const double *tangent, trk_modes *modes)
{
    const trk_vibration rows = {.name = model->name,
                                .n = model->n,
                                .inertia = &model->inertia,
                                .mass = model->mass,
                                .links = &model->links,
                                .tangent = tangent};
    trk_status status =
        trk_vibration_lowest(modes->context, &rows, modes->count, modes->lambda_im, modes->re);
    if (status != TRK_OK)
        return status;
    trk_modes_take_roots(modes);
    return trk_modes_finish(modes, model);
}

trk_status trk_modes_create_lowest(trk_context *context, const trk_model *model, const double *q,
                                   int32_t count, trk_modes **out_modes)
{
    TRK_REQUIRE(context, out_modes, "trk_modes_create_lowest");
    *out_modes = NULL;
    TRK_REQUIRE(context, context, "trk_modes_create_lowest");
    TRK_REQUIRE(context, model, "trk_modes_create_lowest");
    if (count < 1 || count > model->n)
        return trk_fail(context, TRK_E_RANGE,
                        "trk_modes_create_lowest: %d modes of %d coordinates, expected 1 to %d",
                        (int)count, (int)model->n, (int)model->n);
    trk_status status = trk_check_working_point(context, model, q, NULL);
    if (status != TRK_OK)
        return status;
    double *tangent = trk_new(context, model->links.count, sizeof *tangent), ignored;
    trk_modes *modes = NULL;
    status = tangent ? trk_modes_allocate(context, model->n, count, &modes) : TRK_E_MEMORY;
    if (status == TRK_OK) {
        for (int32_t k = 0; k < model->links.count; k++)
            trk_model_link_tangent(model, k, q, NULL, &tangent[k], &ignored);
        modes->count = count;
        status = solve(model, tangent, modes);
    }
    trk_free(context, tangent);
    if (status != TRK_OK) {
        trk_modes_destroy(modes);
        return status;
    }
    *out_modes = modes;
    return TRK_OK;
}
