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
    double *q, *v, *a;                /* state, length n; in modal coordinates if modal */
    double *next_q, *next_v, *next_a; /* of the step being taken                        */
    trk_action now, middle, end;      /* road and loads at t, t + h/2, t + h            */
    double *v2, *v3, *v4, *q_stage;   /* (RUNGEKUTTA.1), length n                       */
    double *a2, *a3, *a4;
    double *out_q, *out_v, *out_a; /* state in the model's coordinates, when asked for */
    trk_law_hint *hints;           /* by link                                          */
    trk_rows no_links;
    trk_assembly assembly;    /* factors of M                                     */
    trk_explicit_step *modal; /* a faster way for small systems (RUNGEKUTTA.7); NULL: none */
    trk_explicit_kernel kernel;
};

/* trk_rungekutta_create() without the check of the step. */
trk_status trk_rungekutta_build(trk_context *context, const trk_model *model, double step,
                                trk_rungekutta **out_stepper);

/* a = M^-1 (P p + w - B^T f(q, v)) in the model's coordinates. */
trk_status trk_rungekutta_accelerate(trk_rungekutta *stepper, const double *q, const double *v,
                                     const trk_action *action, double *out_a);

/* Copy road and load if they are finite, else name the entry. NULL is zeros. */
trk_status trk_rungekutta_take_action(trk_rungekutta *stepper, const double *height,
                                      const double *velocity, const double *load,
                                      trk_action *action);

#endif
