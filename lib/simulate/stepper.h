/* SPDX-License-Identifier: MIT */
/* The time integration of a run, whichever it is, and what drives it. */
#ifndef TRK_SIMULATE_STEPPER_H
#define TRK_SIMULATE_STEPPER_H

#include "base/base.h"
#include <truckride/simulate.h>

/* One of the two; the other is NULL. */
typedef struct trk_stepper {
    trk_newmark *newmark;
    trk_rungekutta *rungekutta;
} trk_stepper;

/* Road and loads of a block of steps: at each end, or at each middle and end in turn. */
typedef struct trk_drive {
    trk_context *context;
    const trk_excitation *excitation; /* borrowed */
    int64_t roads, ports;
    double *height, *velocity, *load;
} trk_drive;

/* TRK_E_ARGUMENT: unknown method. Of newmark, a Runge-Kutta stepper takes the step only. */
trk_status trk_stepper_create(trk_context *context, const trk_model *model, trk_method method,
                              const trk_newmark_options *newmark, trk_stepper *out);
void trk_stepper_destroy(trk_stepper *stepper);

double trk_stepper_step_size(const trk_stepper *stepper);
double trk_stepper_time(const trk_stepper *stepper);
void trk_stepper_read_sensors(const trk_stepper *stepper, double *out_values);

/* Memory for blocks of `steps`; the excitation is borrowed. Clear it even on failure. */
trk_status trk_drive_create(trk_context *context, const trk_excitation *excitation, int64_t steps,
                            trk_drive *out);
void trk_drive_clear(trk_drive *drive);

/* The steps first + 1 .. first + count of a run from `start`. */
void trk_drive_evaluate(trk_drive *drive, const trk_stepper *stepper, int64_t count, double start,
                        int64_t first);

/* Set the state at `start`; q and v may be NULL. Uses the memory of the drive. */
trk_status trk_stepper_start(trk_stepper *stepper, trk_drive *drive, double start, const double *q,
                             const double *v);

/* Numbers of a row that trk_stepper_record() writes. */
int64_t trk_stepper_row_width(const trk_stepper *stepper);

/* Sensors as matrices on a row and on the road at the end of a step (newmark.h). */
void trk_stepper_get_sensor_rows(const trk_stepper *stepper, double *out_on_row,
                                 double *out_on_height, double *out_on_velocity);

/* Rows of road and loads that one step takes from a drive; the last is its end. */
int64_t trk_stepper_drive_rows(const trk_stepper *stepper);

/* The steps of a block at once; rows NULL: nothing is recorded. */
trk_status trk_stepper_record(trk_stepper *stepper, const trk_drive *drive, int64_t count,
                              double *out_rows);

/* Take step k of the block, 0-based. */
trk_status trk_stepper_step(trk_stepper *stepper, const trk_drive *drive, int64_t k);

#endif
