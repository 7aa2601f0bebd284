/* SPDX-License-Identifier: MIT */
/* Undamped modes (LINEAR.1). */
#include "linear/modes.h"
#include "linear/tangent.h"

#include "linalg/eigen.h"

#include <string.h>

static trk_status solve(const trk_model *model, trk_tangent *tangent, trk_modes *modes)
{
    int32_t n = tangent->n;
    trk_status status =
        trk_eigen_symmetric(modes->context, n, tangent->stiffness, tangent->mass, modes->lambda_im);
    if (status != TRK_OK)
        return status;
    trk_modes_clear_rounding(n, modes->lambda_im);
    modes->count = n;
    trk_modes_take_roots(modes);
    /* Column k of the result is row k of the shapes. */
    memcpy(modes->re, tangent->stiffness, (size_t)n * (size_t)n * sizeof *modes->re);
    return trk_modes_finish(modes, model);
}

trk_status trk_modes_create_undamped(trk_context *context, const trk_model *model, const double *q,
                                     trk_modes **out_modes)
{
    TRK_REQUIRE(context, out_modes, "trk_modes_create_undamped");
    *out_modes = NULL;
    TRK_REQUIRE(context, context, "trk_modes_create_undamped");
    TRK_REQUIRE(context, model, "trk_modes_create_undamped");
    trk_tangent tangent;
    trk_status status = trk_tangent_create(context, model, q, NULL, &tangent);
    if (status != TRK_OK)
        return status;
    trk_modes *modes;
    status = trk_modes_allocate(context, tangent.n, tangent.n, &modes);
    if (status == TRK_OK)
        status = solve(model, &tangent, modes);
    trk_free(context, tangent.mass);
    if (status != TRK_OK) {
        trk_modes_destroy(modes);
        return status;
    }
    *out_modes = modes;
    return TRK_OK;
}
