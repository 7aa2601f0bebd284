/* SPDX-License-Identifier: MIT */
/* Singular value decomposition. */
#include "linalg/eigen.h"

#ifdef TRUCKRIDE_WITH_LAPACK

#include "linalg/dense_input.h"
#include "linalg/lapack.h"

static int32_t call_dgesvd(int32_t rows, int32_t columns, double *a, double *s, double *vt,
                           double *work, int32_t size)
{
    const int32_t one = 1;
    double no_u;
    int32_t info = 0;
    dgesvd_("N", "A", &rows, &columns, a, &rows, s, &no_u, &one, vt, &columns, work, &size, &info,
            1, 1);
    return info;
}

trk_status trk_singular_values(trk_context *context, int32_t rows, int32_t columns, double *a,
                               double *out_singular, double *out_vt)
{
    trk_status status = trk_require_finite(context, "singular values", rows, columns, 1, a);
    if (status != TRK_OK)
        return status;
    double best = 0;
    call_dgesvd(rows, columns, a, out_singular, out_vt, &best, -1);
    int32_t size = (int32_t)best;
    double *work = trk_new(context, size, sizeof *work);
    if (!work)
        return TRK_E_MEMORY;
    int32_t info = call_dgesvd(rows, columns, a, out_singular, out_vt, work, size);
    trk_free(context, work);
    if (info > 0)
        return trk_fail(context, TRK_E_CONVERGENCE,
                        "the singular value decomposition did not converge");
    return info == 0 ? TRK_OK : trk_fail(context, TRK_E_INTERNAL, "dgesvd: argument %d", -info);
}

#endif
