/* SPDX-License-Identifier: MIT */
/* Checks that the add functions share, each with a sentence that names the part and the field. */
#include "spec/spec.h"

#include <math.h>

trk_status trk_check_finite(trk_context *context, const char *what, const char *name,
                            const char *field, int32_t count, const double *values)
{
    for (int32_t k = 0; k < count; k++)
        if (!isfinite(values[k]))
            return trk_fail(context, TRK_E_RANGE, "%s '%s': %s is %g; a finite number is needed",
                            what, name, field, values[k]);
    return TRK_OK;
}

trk_status trk_check_not_negative(trk_context *context, const char *what, const char *name,
                                  const char *field, double value)
{
    if (isfinite(value) && value >= 0)
        return TRK_OK;
    return trk_fail(context, TRK_E_RANGE, "%s '%s': %s is %g; a finite number >= 0 is needed", what,
                    name, field, value);
}

trk_status trk_check_direction(trk_context *context, const char *what, const char *name,
                               const double *direction)
{
    trk_status status = trk_check_finite(context, what, name, "direction", 3, direction);
    if (status != TRK_OK)
        return status;
    double length = hypot(hypot(direction[0], direction[1]), direction[2]);
    if (isfinite(length) && length > 0)
        return TRK_OK;
    return trk_fail(context, TRK_E_RANGE,
                    "%s '%s': direction has length %g; any direction but zero is needed", what,
                    name, length);
}

trk_status trk_check_id(const trk_spec *spec, const char *what, const char *name, trk_part part,
                        int32_t id)
{
    int32_t count = trk_spec_count(spec, part);
    if (id >= 1 && id <= count)
        return TRK_OK;
    return trk_fail(spec->context, TRK_E_ARGUMENT,
                    "%s '%s': there is no %s %d (ids run from 1 to %d)", what, name,
                    trk_part_word(part), id, count);
}
