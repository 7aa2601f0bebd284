/* SPDX-License-Identifier: MIT */
/* Inside of an explicit stepper. */
#ifndef TRK_RUNGEKUTTA_RUNGEKUTTA_H
#define TRK_RUNGEKUTTA_RUNGEKUTTA_H

#include "model/model.h"
#include "rungekutta/modal.h"
#include "system/assembly.h"
#include <truckride/rungekutta.h>

/* What acts at one time. */
typedef struct trk_action {
    double *height, *velocity; /* road, length roads */
    double *load;              /* length ports       */
} trk_action;

struct trk_rungekutta {
    trk_context *context;
    const trk_model *model;
    double step;                      /* [s]                                        */
    double start;                     /* [s] time = start + taken * step            */
    int64_t taken;                    /* steps since the state was set              */
    double *block;                    /* memory of all arrays of doubles here       */
    double *q, *v, *a;                /* state, length n; if modal, as last looked at */
    double *next_q, *next_v, *next_a; /* of the step being taken                    */
    trk_action now, middle, end;      /* road and loads at t, t + h/2, t + h        */
    double *v2, *v3, *v4, *q_stage;   /* (RUNGEKUTTA.1), length n                   */
    double *a2, *a3, *a4;
    double *out_q, *out_v, *out_a;          /* state in the model's coordinates, when asked for */
    trk_law_hint *hints;                    /* by link                                          */
    int32_t *spring_column, *damper_column; /* by link: scratch of record.c             */
    trk_rows no_links;
    trk_assembly assembly; /* factors of M                                     */
    trk_explicit *modal;   /* a faster way for small systems (RUNGEKUTTA.6); NULL: none */
    trk_explicit_kernel kernel;
};

/* trk_rungekutta_create() without the check of the step. */
trk_status trk_rungekutta_build(trk_context *context, const trk_model *model, double step,
                                trk_rungekutta **out_stepper);

/*
 * Many steps in one call. height, velocity: 2 count x roads, load: 2 count x ports, row-major, a
 * row for the middle and one for the end of each step; NULL is zeros. The result is that of
 * `count` calls of trk_rungekutta_step(), bit for bit. *out_taken: steps taken; fewer than
 * count only with a status, which is then that of the step that failed.
 *
 * out_rows NULL: nothing is recorded. Else count rows of trk_rungekutta_row_width() numbers each,
 * 64 byte aligned, written for the steps taken: the raw state, as trk_newmark_record() has it.
 */
trk_status trk_rungekutta_record(trk_rungekutta *stepper, int64_t count, const double *height,
                                 const double *velocity, const double *load, double *out_rows,
                                 int64_t *out_taken);

/* Numbers in a row: a multiple of 8. */
int64_t trk_rungekutta_row_width(const trk_rungekutta *stepper);

/* The raw state now, as trk_rungekutta_record() writes it. */
void trk_rungekutta_get_row(const trk_rungekutta *stepper, double *out_row);

/* Sensors as matrices on a row and on the road, as trk_newmark_get_sensor_rows() has them. */
void trk_rungekutta_get_sensor_rows(const trk_rungekutta *stepper, double *out_on_row,
                                    double *out_on_height, double *out_on_velocity);

/* Force g of a link (LAW.2) in the present state, which is in the model's coordinates. */
double trk_rungekutta_curve_force(const trk_rungekutta *stepper, int32_t link);

/* a = M^-1 (P p + w - B^T f(q, v)) in the model's coordinates. */
trk_status trk_rungekutta_accelerate(trk_rungekutta *stepper, const double *q, const double *v,
                                     const trk_action *action, double *out_a);

/* Copy road and load if they are finite, else name the entry. NULL is zeros. */
trk_status trk_rungekutta_take_action(trk_rungekutta *stepper, const double *height,
                                      const double *velocity, const double *load,
                                      trk_action *action);

#endif
