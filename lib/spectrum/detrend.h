/* SPDX-License-Identifier: MIT */
/* Trend of a segment. */
#ifndef TRK_SPECTRUM_DETREND_H
#define TRK_SPECTRUM_DETREND_H

#include "spectrum/kernel.h"
#include <truckride/spectrum.h>

/* Segment x of n >= 1 samples with its trend mean + slope (i - (n - 1) / 2). */
trk_fft_segment trk_detrend_fit(trk_detrend detrend, int64_t n, const double *x);

#endif
