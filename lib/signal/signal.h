/* SPDX-License-Identifier: MIT */
/* Inside of a signal: a kind (one file each) and its parameters. */
#ifndef TRK_SIGNAL_SIGNAL_H
#define TRK_SIGNAL_SIGNAL_H

#include <math.h>

#include "base/base.h"
#include <truckride/curve.h>
#include <truckride/signal.h>

/* Places handed to a kind in one call: its loops stay in the first-level cache. */
enum { TRK_SIGNAL_BLOCK = 128 };

typedef struct trk_signal_kind {
    /* Value and derivative at each x, count <= TRK_SIGNAL_BLOCK. Where the derivative jumps
     * it is the one to the right; a NaN x gives NaN. The result at an x does not depend
     * on the others. */
    void (*evaluate)(const trk_signal *signal, int64_t count, const double *x, double *value,
                     double *rate);
    void (*destroy)(trk_signal *signal); /* frees what the kind allocated; NULL: nothing */
} trk_signal_kind;

typedef struct trk_step {
    double start, length, height;
} trk_step;

typedef struct trk_sine {
    double start, amplitude, frequency, phase_turns;
} trk_sine;

/* The sweep about one place inside it; see SIGNAL.3. */
typedef struct trk_sweep_panel {
    double centre;    /* distance from the start of the sweep         */
    double frequency; /* there                                        */
    double amplitude; /* there                                        */
    double turns;     /* phase there, whole turns dropped             */
} trk_sweep_panel;

typedef struct trk_sweep {
    double start, duration, growth, amplitude_exponent; /* growth: ln(f1 / f0) / duration */
    double panels_per_unit;
    int32_t panel_count;
    trk_sweep_panel *panels;
} trk_sweep;

/* A sample and the derivative there, per spacing. */
typedef struct trk_sample {
    double value, slope;
} trk_sample;

typedef struct trk_samples {
    int64_t count;
    double start, spacing;
    trk_sample *at;
} trk_samples;

struct trk_signal {
    const trk_signal_kind *kind;
    trk_context *context;
    union {
        trk_step step;
        trk_sine sine;
        trk_sweep sweep;
        trk_samples samples;
        trk_curve *points;
    };
};

/* Zeroed signal of a kind; NULL when out of memory. */
trk_signal *trk_signal_new(trk_context *context, const trk_signal_kind *kind);

/* TRK_E_RANGE "what: name is nan, expected a finite value" unless it is finite. */
trk_status trk_signal_check_finite(trk_context *context, const char *what, const char *name,
                                   double value);

/* The same for a value that must also be > 0. */
trk_status trk_signal_check_positive(trk_context *context, const char *what, const char *name,
                                     double value);

#endif
