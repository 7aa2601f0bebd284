/* SPDX-License-Identifier: MIT */
/* The parts of the tire calibration. */
#ifndef CALIBRATE_TIRES_H
#define CALIBRATE_TIRES_H

#include "common/trim.h"

enum { VARIANTS = 3, METHODS = 3 };

/* What is matched to the measured frequency, in the order of trying. */
typedef struct method {
    const char *name;
    trk_target kind;
} method;

extern const method methods[METHODS];

/* A model in one variant and what came of trimming it. */
typedef struct trimmed {
    const truck_model *model;
    const char *variant;
    trk_spec *spec; /* with the original tires */
    trimming by[METHODS];
} trimmed;

/* Trim by all methods. */
void calibrate(trk_context *context, trimmed *t);

/* One line per method and axle. */
void write_factor_head(FILE *table);
void write_factors(const trimmed *t, FILE *table);

/* What the library says of those that did not simply succeed. */
void print_remarks(const trimmed *t);

/*
 * Full sweeps with original and trimmed tires: spectra of the axles and table of peaks.
 * Returns the largest relative difference of a peak from that of the calibration's run.
 */
double write_spectra(trk_context *context, const trimmed *t, const char *directory, FILE *peaks);
void write_peaks_head(FILE *peaks);

#endif
