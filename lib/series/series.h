/* SPDX-License-Identifier: MIT */
/* Inside of a series. */
#ifndef TRK_SERIES_SERIES_H
#define TRK_SERIES_SERIES_H

#include "base/base.h"
#include <truckride/series.h>

typedef struct trk_channel {
    char *name, *unit;
    double *data; /* length samples, in the block of the series */
} trk_channel;

struct trk_series {
    trk_context *context;
    int32_t channels;
    int64_t samples;
    double sample_rate, start;
    trk_channel *channel; /* channel[id - 1]                                    */
    double *block;        /* samples of all channels: one block gets huge pages */
};

/* A series of the same channel names and units, but other samples. */
trk_status trk_series_create_like(trk_context *context, const trk_series *series, int64_t samples,
                                  double sample_rate, trk_series **out_series);

#endif
