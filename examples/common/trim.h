/* SPDX-License-Identifier: MIT */
/* The models of the reference tractor, and trimming their tires to measured frequencies. */
#ifndef EXAMPLES_TRIM_H
#define EXAMPLES_TRIM_H

#include "common/common.h"

enum { MAX_AXLES = 2, SIDES = 2 };

/* An axle of a model: what its parts are called and what was measured on the truck. */
typedef struct truck_axle {
    const char *name;
    double measured;   /* [Hz] peak of its PSD on the road simulator       */
    const char *tires; /* pattern                                          */
    const char *dampers[SIDES];
    const char *coordinate; /* vertical                                         */
    const char *sensor;     /* its vertical accelerometer, on the left          */
} truck_axle;

typedef struct truck_model {
    const char *name, *title;
    trk_vehicle vehicle;
    int32_t axles;
    truck_axle axle[MAX_AXLES];
} truck_model;

enum { QUARTER_FRONT, QUARTER_REAR, HALF_TRUCK, TRUCK_3D, TRUCK_MODELS };
/* An axle's peak lies between the bounce of frame and cab and the end of the sweep [Hz]. */
extern const double axle_band[2];

extern const truck_model truck_models[TRUCK_MODELS];

/* The thesis prints its peaks to 0.2 Hz: half of that is taken for a standard uncertainty. */
extern const double peak_uncertainty; /* [Hz] */

/* What came of trimming. */
typedef struct trimming {
    trk_status status;
    int32_t solved;     /* 1: fitted and after say something                     */
    char message[512];  /* of the library, unless status is TRK_OK               */
    char original[512]; /* why the original tires have no such frequency, or ""  */
    int64_t evaluations;
    double before[MAX_AXLES]; /* [Hz] frequency with the original tires, NaN: none     */
    double after[MAX_AXLES];  /* [Hz] with the fitted ones                             */
    trk_parameter_result factor[MAX_AXLES]; /* on the tire stiffness                         */
} trimming;

/*
 * Fit one factor on the tire stiffness of each axle so that its frequency of a kind
 * (eigenfrequency of the axle's mode, or peak of its PSD above the bounce of frame and cab) is
 * the measured one.
 * start: factors to begin with; run and sweep: for TRK_TARGET_PSD_PEAK, else NULL.
 */
void trim_tires(trk_context *context, const truck_model *m, const trk_spec *spec, trk_target kind,
                const double *start, const trk_run_options *run, const trk_excitation *sweep,
                trimming *out);

/* Multiply the tire stiffness of each axle. */
void scale_tires(trk_context *context, const truck_model *m, trk_spec *spec, const double *factor);

/* Scale the damper curves of the front axle; m->axle[0] must be the front one. */
void scale_front_dampers(trk_context *context, const truck_model *m, trk_spec *spec, double scale);

#endif
