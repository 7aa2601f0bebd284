/* SPDX-License-Identifier: MIT */
/* Check that the routines around LAPACK share. */
#include "linalg/dense_input.h"

#include <math.h>

trk_status trk_require_finite(trk_context *context, const char *what, int32_t rows, int32_t columns,
                              int32_t parts, const double *a)
{
    int64_t length = (int64_t)parts * rows * columns;
    for (int64_t k = 0; k < length; k++)
        if (!isfinite(a[k])) {
            int64_t entry = k / parts;
            return trk_fail(context, TRK_E_RANGE,
                            "%s: entry (%lld, %lld) is %g, expected a finite number", what,
                            (long long)(entry % rows), (long long)(entry / rows), a[k]);
        }
    return TRK_OK;
}
