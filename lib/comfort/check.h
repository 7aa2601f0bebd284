/* SPDX-License-Identifier: MIT */
/* Checks that the functions of this room share; what is the public function, for messages. */
#ifndef TRK_COMFORT_CHECK_H
#define TRK_COMFORT_CHECK_H

#include "base/base.h"

#include <stddef.h>

/* Fourth powers of samples up to here, and long sums of them, stay finite. */
#define TRK_COMFORT_LARGEST 1e75

/* count >= minimum, and every sample finite and not larger than TRK_COMFORT_LARGEST. */
trk_status trk_comfort_check_samples(trk_context *context, const char *what, const char *name,
                                     int64_t minimum, int64_t count, const double *x);

/* minimum <= value <= TRK_COMFORT_LARGEST. */
trk_status trk_comfort_check_value(trk_context *context, const char *what, const char *name,
                                   double value, double minimum);

/* 0 < value < infinity. */
trk_status trk_comfort_check_positive(trk_context *context, const char *what, const char *name,
                                      double value);

/* The caller's result struct says how large it is. */
trk_status trk_comfort_check_result(trk_context *context, const char *what, const void *result);

#endif
