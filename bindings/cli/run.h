/* SPDX-License-Identifier: MIT */
/* A vehicle on a road: what simulate and psd have in common. */
#ifndef TRUCKRIDE_CLI_RUN_H
#define TRUCKRIDE_CLI_RUN_H

#include "session.h"
#include "common/road.h"

/* Their options; the first member of the settings of both. */
typedef struct run_options {
    shared shared;
    const char *road, *sensors;
    double duration, step; /* duration 0: that of the road, else 10 s */
    int32_t method;
    int64_t every;
} run_options;

extern const argument run_arguments[];

/* Defaults. */
run_options run_defaults(void);

/* Open the road, settle the duration and look at --sensors; EXIT_DONE or the exit code. road_close() in any case. */
int run_road(session *s, run_options *o, const trk_model *model, road *out_road);

/* Drive over it, with a progress bar. */
int run_series(session *s, const run_options *o, const trk_model *model, const road *r,
               trk_series **out_series);

/* Keep only the channels that match --sensors, in their order; the series is replaced. */
int run_select(session *s, const char *patterns, trk_series **series);

#endif
