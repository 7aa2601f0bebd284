/* SPDX-License-Identifier: MIT */
/* The parts of the study. */
#ifndef THESIS_REVISITED_H
#define THESIS_REVISITED_H

#include "common/trim.h"

/* What stands for the real truck: its axles' frequencies as rigid, frictionless models must have them. */
enum { ORIGINAL, TRIMMED_TIRES, LEAF_FRICTION, EXPLANATIONS };
enum { STANDARD, UNDAMPED, DAMPERS };

extern const char *const explanation_names[EXPLANATIONS], *const damper_names[DAMPERS];

/* The run of every spectrum here: cylinder motion within 15 mm, as the thesis plots it, is 12 mm
 * at 1 Hz under a sweep from 0.8 Hz. */
extern const double sweep_amplitude; /* [m] at 1 Hz */

/* Measured peak of the front axle without its damper [Hz]. */
extern const double measured_undamped;

/* Published range of a physical parameter. */
typedef struct range {
    const char *name, *unit;
    double low, high;
} range;

enum { TIRE, FRONT_FRICTION, FRONT_APPROACH, REAR_FRICTION, REAR_APPROACH, PARAMETERS };
extern const range published[PARAMETERS];

/* Physical parameters fitted within their ranges. */
typedef struct fit {
    trk_status status;
    char message[512];
    trk_parameter_result parameter[PARAMETERS]; /* fitted 0: not one of this model */
    int64_t evaluations;
} fit;

/* Give every suspension spring of a model a leaf law; values by parameter. */
void add_leaf_laws(trk_context *context, const truck_model *m, trk_spec *spec, const double *value);

/* Two vehicles in one spec: `twin`, with a prefix to the names of its parts, beside what is there. */
void add_twin(trk_context *context, trk_spec *spec, const trk_spec *twin, const char *prefix);

/* Fit tires and leaf friction to the measured peaks with and without the front damper. */
void fit_leaf(trk_context *context, const truck_model *m, fit *out);

/* Trim tires alone to the measured peaks, as the thesis does: factors by axle. */
void trim_only_tires(trk_context *context, const truck_model *m, double *out_factor);

/* A model under an explanation. factor: of the trimmed tires. */
trk_spec *create_explained(trk_context *context, const truck_model *m, int explanation, int damper,
                           const double *factor, const fit *fitted);

enum { AMPLITUDES = 4 };
extern const double amplitudes[AMPLITUDES]; /* [m] at 1 Hz */

/* What all runs came to. */
typedef struct outcome {
    const truck_model *model;
    double factor[MAX_AXLES]; /* of the trimmed tires */
    fit fitted;
    double peak[EXPLANATIONS][DAMPERS][MAX_AXLES]; /* [Hz] */
    double by_amplitude[AMPLITUDES][DAMPERS];      /* [Hz] front axle, with friction; half truck */
} outcome;

/* Friction over travel of the front spring as fitted: loop.csv. */
void write_loop(trk_context *context, const fit *fitted, const char *directory);

void write_spectra(trk_context *context, const outcome *o, const char *directory,
                   trk_series *series[EXPLANATIONS][DAMPERS]);
void write_findings(const outcome *all, FILE *findings);

/* Peaks of frame, axles and cab of a truck from a model file, with its frame and with a rigid one. */
void compare_frames(trk_context *context, const char *path, const char *directory, FILE *findings);

#endif
