/* SPDX-License-Identifier: MIT */
/* Inside of a road: octaves of random lapped cosines on grids, splines through them. */
#ifndef TRK_ROAD_ROAD_H
#define TRK_ROAD_ROAD_H

#include "signal/signal.h"

#include <truckride/road.h>

/*
 * TRK_ROAD_HOP grid points from one lapped block to the next; a block has twice as many. Each
 * octave takes the cosines from a quarter to half of the highest: its grid has four points in
 * its shortest wave, as many as the spline needs (ROAD.5). The lowest octave may take
 * TRK_ROAD_SPARE more below, which saves an octave for the band of ISO 8608, 257 to 1.
 */
enum {
    TRK_ROAD_HOP = 256,
    TRK_ROAD_SPARE = 8,
    TRK_ROAD_LINES = TRK_ROAD_HOP / 4 + TRK_ROAD_SPARE,
    TRK_ROAD_FIRST_LINE = TRK_ROAD_HOP / 4 - TRK_ROAD_SPARE,
    TRK_ROAD_ANGLES = 4 * TRK_ROAD_HOP
};

typedef struct trk_octave {
    double per_metre;                 /* grid points                                         */
    double origin;                    /* [grid points] of x = 0                              */
    int32_t first;                    /* lines below have no amplitude; a multiple of 4      */
    bool flips;                       /* some line is not the same left and right            */
    double amplitude[TRK_ROAD_LINES]; /* [m]                                                 */
    uint16_t flip[TRK_ROAD_LINES];    /* chance that right is the opposite of left, / 2^16   */
} trk_octave;

/* The kind of signal that trk_road_create() makes. */
typedef struct trk_track {
    trk_signal signal; /* first: the track is a signal */
    int64_t seed;
    double contact_length, ramp_start, ramp_length;
    double farthest; /* [m] the road is level where a double no longer resolves its waves */
    double cosine[TRK_ROAD_ANGLES]; /* of odd multiples of pi / ANGLES */
    int32_t octave_count;
    trk_octave *octaves; /* highest first */
} trk_track;

/* What an evaluation remembers of one octave: the line amplitudes of two blocks, grid points. */
enum { TRK_ROAD_POINTS = 64 };
typedef struct trk_octave_reader {
    const trk_track *track;
    int32_t octave;
    int64_t block[2], point[TRK_ROAD_POINTS];
    double line[2][TRK_ROAD_LINES];
    double height[TRK_ROAD_POINTS];
} trk_octave_reader;

void trk_octave_reader_start(trk_octave_reader *reader, const trk_track *track, int32_t octave);

/* Coefficient of the spline at a grid point [m] (ROAD.4); the same bits whatever was read before. */
double trk_octave_read(trk_octave_reader *reader, int64_t point);

/* The one kind of all tracks. */
extern const trk_signal_kind trk_track_kind;

/* Options of the caller, defaults filled in, checked. */
trk_status trk_road_read_options(trk_context *context, const trk_road_options *options,
                                 trk_road_options *out);

/* (ROAD.1) inside the band and out of it. */
double trk_road_power_law(const trk_road_options *options, double wavenumber);

/* (ROAD.2), with what does not depend on the wavenumber prepared. */
enum { TRK_COHERENCE_NODES = 276 };
typedef struct trk_coherence_rule {
    const trk_road_options *options; /* borrowed */
    double reach[TRK_COHERENCE_NODES], weight[TRK_COHERENCE_NODES];
} trk_coherence_rule;
void trk_coherence_rule_set(trk_coherence_rule *rule, const trk_road_options *options);
double trk_coherence_of(const trk_coherence_rule *rule, double wavenumber);

#endif
