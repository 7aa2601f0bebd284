/* SPDX-License-Identifier: MIT */
/* Response of the coordinates to unit inputs, by damped modes where they suffice (LINEAR.7). */
#ifndef TRK_LINEAR_SUPERPOSITION_H
#define TRK_LINEAR_SUPERPOSITION_H

#include "linear/modes.h"
#include "linear/tangent.h"

#include <complex.h>

typedef struct trk_superposition {
    trk_context *context;
    const trk_model *model;
    trk_tangent tangent;                   /* M, C, K                                     */
    double *link_stiffness, *link_damping; /* tangents, by link                           */
    int32_t n, inputs;                     /* coordinates; roads and ports                */
    double *push, *push_rate;              /* force of input j: push + i w push_rate, inputs x n */
    trk_modes *modes;                      /* NULL: the modes do not span the motion      */
    double complex *share, *share_rate;    /* phi^T push / a, modes x inputs              */
    double complex *matrix;                /* K + i w C - w^2 M                           */
    double complex *probe, *probe_push;    /* combination of the inputs, n                */
    double complex *q;                     /* response to each input, inputs x n          */
    int64_t direct;                        /* frequencies that were solved for            */
} trk_superposition;

/* Modes and projections about a working point; clear it even on failure. */
trk_status trk_superposition_create(trk_context *context, const trk_model *model, const double *q,
                                    const double *v, trk_superposition *out);
void trk_superposition_clear(trk_superposition *s);

/* Responses to all unit inputs at omega into s->q. TRK_E_SINGULAR: an undamped resonance. */
trk_status trk_superposition_solve(trk_superposition *s, double omega);

/* The same by solving the equations of motion, without modes. */
trk_status trk_superposition_solve_directly(trk_superposition *s, double omega);

#endif
