/* SPDX-License-Identifier: MIT */
/* Running mean of squares over a window of samples, and exponentially (COMFORT.6). */
#ifndef TRK_COMFORT_RUNNING_H
#define TRK_COMFORT_RUNNING_H

#include "base/base.h"
#include <truckride/comfort.h>

/*
 * Sums over the last `length` squares without drift and without subtraction: time is cut into
 * blocks of that length; the window is the end of the last block, whose sums from each place to
 * its end are kept, and the beginning of the present one, which is summed up as it comes.
 */
typedef struct trk_running {
    int64_t length, place; /* place of the next sample in the present block        */
    double *square;        /* squares of the present block, then sums to the end of the last one */
    double present;        /* sum of the present block                             */
    double decay, exponential;
} trk_running;

/* TRK_E_RANGE: integration_time or the window is out of range. */
trk_status trk_running_create(trk_context *context, const char *what, double sample_rate,
                              double integration_time, trk_running *out_running);
void trk_running_destroy(trk_context *context, trk_running *running);
void trk_running_reset(trk_running *running);

/* Take the next sample; the mean square of each kind. */
double trk_running_linear(trk_running *running, double x);
double trk_running_exponential(trk_running *running, double x);

#endif
