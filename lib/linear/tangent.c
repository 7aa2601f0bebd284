/* SPDX-License-Identifier: MIT */
#include "linear/tangent.h"

#include <math.h>

static trk_status check(trk_context *context, const trk_model *model, const char *what,
                        const double *values)
{
    for (int32_t k = 1; values && k <= trk_model_count(model, TRK_PART_COORDINATE); k++)
        if (!isfinite(values[k - 1]))
            return trk_fail(context, TRK_E_RANGE,
                            "%s: working point: %s of '%s' is %g; a finite number is needed",
                            trk_model_name(model), what,
                            trk_model_part_name(model, TRK_PART_COORDINATE, k), values[k - 1]);
    return TRK_OK;
}

trk_status trk_check_working_point(trk_context *context, const trk_model *model, const double *q,
                                   const double *v)
{
    trk_status status = check(context, model, "displacement", q);
    return status == TRK_OK ? check(context, model, "velocity", v) : status;
}

trk_status trk_tangent_create(trk_context *context, const trk_model *model, const double *q,
                              const double *v, trk_tangent *out)
{
    trk_status status = trk_check_working_point(context, model, q, v);
    if (status != TRK_OK)
        return status;
    int32_t n = trk_model_count(model, TRK_PART_COORDINATE);
    int64_t square = (int64_t)n * n;
    double *block = trk_new(context, 3 * square, sizeof *block);
    if (!block)
        return TRK_E_MEMORY;
    *out = (trk_tangent){n, block, block + square, block + 2 * square};
    trk_model_get_mass(model, out->mass);
    trk_model_get_tangent(model, q, v, out->damping, out->stiffness);
    return TRK_OK;
}
