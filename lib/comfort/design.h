/* SPDX-License-Identifier: MIT */
/* Digital design of a weighting: the analogue poles, and a fitted shape (COMFORT.5). */
#ifndef TRK_COMFORT_DESIGN_H
#define TRK_COMFORT_DESIGN_H

#include "comfort/weighting.h"

enum { TRK_SECTIONS_MAX = 4, TRK_SHAPE_TAPS = 5 };

/*
 * direct + residue / (z - pole) + conjugate, run as s' = pole s + x with complex s: unlike a
 * direct form it keeps its digits when the pole comes close to 1 (0.08 Hz at 10 kHz).
 */
typedef struct trk_section {
    double pole_re, pole_im, direct, residue_re, residue_im;
} trk_section;

/* The sections in series, then (b0 + ... + b4 z^-4) / ((1 + 0.3 z^-1) (1 + 0.7 z^-1)). */
typedef struct trk_design {
    int32_t sections;
    trk_section section[TRK_SECTIONS_MAX];
    double shape[TRK_SHAPE_TAPS];
} trk_design;

/* Denominator of the shape, 1 + TRK_SHAPE_A1 z^-1 + TRK_SHAPE_A2 z^-2. */
#define TRK_SHAPE_A1 1.0
#define TRK_SHAPE_A2 0.21

/* TRK_E_INTERNAL: no minimum-phase shape was found (not seen at any allowed rate). */
trk_status trk_design_weighting(trk_context *context, const trk_weighting_parameters *p,
                                double sample_rate, trk_design *out_design);

/* Response at the angle 2 pi f / sample_rate, 0 to pi. */
double complex trk_design_response(const trk_design *design, double angle);

#endif
