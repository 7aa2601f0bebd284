/* SPDX-License-Identifier: MIT */
/* Window functions. */
#ifndef TRK_SPECTRUM_WINDOW_H
#define TRK_SPECTRUM_WINDOW_H

#include "base/base.h"
#include <truckride/spectrum.h>

/* Window of n >= 1 samples, periodic (SPECTRUM.2); window and beta are valid. */
trk_status trk_window_fill(trk_context *context, trk_window window, double beta, int64_t n,
                           double *out);

#endif
