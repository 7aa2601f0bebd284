/* SPDX-License-Identifier: MIT */
/* The road that a word names: "iso:class=C:speed=70", "csv:kerb.csv:speed=30". */
#ifndef TRUCKRIDE_COMMON_ROAD_H
#define TRUCKRIDE_COMMON_ROAD_H

#include "common/text.h"

#include <truckride/truckride.h>

/* An excitation, with the signals it borrows. */
typedef struct road {
    trk_excitation *excitation;
    trk_signal **signal;
    int signals, room;
    double duration; /* [s] that a recorded road lasts; 0: any */
} road;

/*
 * Make the road of a word for a model. `duration` [s] is that of the run, for sweeps.
 * False: either `wrong` says what is wrong with the word, or it is empty and *out_status is the
 * failure of the library. End with road_close() in any case.
 */
bool road_open(trk_context *context, const trk_model *model, const char *text, double duration,
               road *out, complaint *wrong, trk_status *out_status);
void road_close(road *r);

/* The same word explained, for help texts. */
extern const char road_help[];

/* Used by the kinds of roads: what is being read. */
typedef struct road_reader {
    trk_context *context;
    const trk_model *model;
    road *out;
    complaint *wrong;
    trk_status status;
} road_reader;

/* Room for one more signal, which the road then owns. */
trk_signal **road_signal(road_reader *r);

/* Settings "name=number" by name, each with its place in `value`. */
bool road_settings(road_reader *r, char *rest, const char *const *names, double *value);

/* csv, erd, rpc: recorded heights; crg: a surface. `rest` is FILE[:SETTING...]. */
bool road_recorded(road_reader *r, const char *kind, char *rest);
bool road_surface(road_reader *r, char *rest);

#endif
