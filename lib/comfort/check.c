/* SPDX-License-Identifier: MIT */
/* Checks that the functions of this room share. */
#include "comfort/check.h"

#include <math.h>
#include <string.h>

trk_status trk_comfort_check_samples(trk_context *context, const char *what, const char *name,
                                     int64_t minimum, int64_t count, const double *x)
{
    if (count < minimum)
        return trk_fail(context, TRK_E_RANGE, "%s: count is %lld samples, expected >= %lld", what,
                        (long long)count, (long long)minimum);
    for (int64_t i = 0; i < count; i++)
        if (!(fabs(x[i]) <= TRK_COMFORT_LARGEST))
            return trk_fail(context, TRK_E_RANGE, "%s: %s[%lld] is %g, expected at most %g in size",
                            what, name, (long long)i, x[i], TRK_COMFORT_LARGEST);
    return TRK_OK;
}

trk_status trk_comfort_check_value(trk_context *context, const char *what, const char *name,
                                   double value, double minimum)
{
    if (value >= minimum && value <= TRK_COMFORT_LARGEST)
        return TRK_OK;
    return trk_fail(context, TRK_E_RANGE, "%s: %s is %g, expected %g to %g", what, name, value,
                    minimum, TRK_COMFORT_LARGEST);
}

trk_status trk_comfort_check_positive(trk_context *context, const char *what, const char *name,
                                      double value)
{
    if (value > 0 && isfinite(value))
        return TRK_OK;
    return trk_fail(context, TRK_E_RANGE, "%s: %s is %g, expected > 0 and finite", what, name,
                    value);
}

trk_status trk_comfort_check_result(trk_context *context, const char *what, const void *result)
{
    size_t given;
    memcpy(&given, result, sizeof given);
    /* As in base/options.c: no struct of results is as small as a pointer. */
    if (given > sizeof(void *) && given <= 65536)
        return TRK_OK;
    return trk_fail(context, TRK_E_OPTIONS,
                    "%s: struct_size is %zu, expected the size of the result struct", what, given);
}
