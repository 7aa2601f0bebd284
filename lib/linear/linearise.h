/* SPDX-License-Identifier: MIT */
/* One turn of statistical linearisation: respond, then find mean position and links. */
#ifndef TRK_LINEAR_LINEARISE_H
#define TRK_LINEAR_LINEARISE_H

#include "linear/equivalent.h"
#include "linear/random.h"
#include "model/model.h"
#include "system/assembly.h"

/* A link with a curve or law, how it moves, and what it is nearest to. */
typedef struct trk_moved_link {
    double e_deviation, v_deviation; /* standard deviations of elongation and rate */
    trk_equivalent equivalent;
    double correction[2], before[2]; /* of stiffness and damping, relative; in the turn before */
} trk_moved_link;

typedef struct trk_linearisation {
    trk_context *context;
    const trk_model *model;
    trk_model *linear; /* owned: the model with the links found so far */
    int64_t count;
    const double *frequency, *input;
    trk_moved_link *links; /* by index in model->nonlinear                         */
    double *mean;          /* position [m, rad], length n                          */
    double *excess;        /* of the mean forces [N, N m], then how far it moves   */
    double *slope;         /* of the mean force of every link                      */
    double complex *h;     /* of one link, by input                                */
    double *e_form,
        *v_form; /* spectra of elongation and rate at the last frequency, by nonlinear */
    trk_assembly assembly;
} trk_linearisation;

/* From static equilibrium and the tangents there; clear it even on failure. */
trk_status trk_linearisation_start(trk_context *context, const trk_model *model, int64_t count,
                                   const double *frequency, const double *input,
                                   trk_linearisation *out);
void trk_linearisation_clear(trk_linearisation *l);

/* Standard deviations of all links of the linear model as it is. */
trk_status trk_linearisation_respond(trk_linearisation *l);

/* Equivalents for that motion about the mean position that balances their mean forces, to a
 * tolerance in standard deviations. */
trk_status trk_linearisation_move(trk_linearisation *l, double tolerance);

/* TRK_E_MODEL: a mode grows. */
trk_status trk_linearisation_check(trk_linearisation *l);

#endif
