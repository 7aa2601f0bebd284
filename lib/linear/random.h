/* SPDX-License-Identifier: MIT */
/* Random response from a superposition that is at hand. */
#ifndef TRK_LINEAR_RANDOM_H
#define TRK_LINEAR_RANDOM_H

#include "linear/superposition.h"

/* trk_response_psd() without its checks and RMS. */
trk_status trk_random_response(trk_superposition *s, int64_t count, const double *frequency,
                               const double *input, double *out_density);

#endif
