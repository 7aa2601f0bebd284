/* SPDX-License-Identifier: MIT */
/* Check that the routines around LAPACK share: LAPACK may loop for ever on a NaN. */
#ifndef TRK_LINALG_DENSE_INPUT_H
#define TRK_LINALG_DENSE_INPUT_H

#include "base/base.h"

/* TRK_E_RANGE, naming the entry, unless a (rows x columns, column-major) is finite;
 * parts is 1 for real and 2 for interleaved complex entries. */
trk_status trk_require_finite(trk_context *context, const char *what, int32_t rows, int32_t columns,
                              int32_t parts, const double *a);

#endif
