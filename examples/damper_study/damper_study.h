/* SPDX-License-Identifier: MIT */
/* The parts of the damper study. */
#ifndef DAMPER_STUDY_H
#define DAMPER_STUDY_H

#include "common/trim.h"

enum { STANDARD, HARDER, UNDAMPED, CONFIGURATIONS };
enum { FRONT_AXLE, REAR_AXLE, FRAME, CAB_FRONT, CAB_REAR, PLACES };
enum { QUARTER, HALF, FULL, STUDIED };

/* What one accelerometer saw in one configuration. */
typedef struct response {
    double peak;     /* [Hz] highest peak in the axle band (axles) or anywhere, NaN: none */
    double height;   /* [(m/s^2)^2/Hz] of that peak                                       */
    double rms;      /* [m/s^2] in all                                                    */
    double axle_rms; /* [m/s^2] in the axle band alone                                    */
} response;

/* A model with trimmed tires. */
typedef struct study {
    const truck_model *model;
    double factor[MAX_AXLES];              /* on the tire stiffness                 */
    double eigenfrequency[CONFIGURATIONS]; /* [Hz] damped, of the front axle's mode */
    double damping_ratio[CONFIGURATIONS];  /* [-] of that mode at rest              */
    response seen[CONFIGURATIONS][PLACES];
} study;

extern const char *const configuration_names[CONFIGURATIONS];

/* Accelerometer at a place of a model; NULL: it has none there. */
const char *sensor_at(int studied, int place);

/* The band of the front axle's resonance [Hz]. */
extern const double resonance[2];

/* Trim the tires, run all configurations, write spectra. */
void run_configurations(trk_context *context, int studied, const char *directory, study *out);

/* Force of the front damper over velocity in all configurations. */
void write_damper_curves(trk_context *context, const char *directory);

/* The table and what it says. */
void write_table(const study *s, int studied, FILE *table);
void write_findings(const study *all, FILE *findings);

#endif
