/* SPDX-License-Identifier: MIT */
/* Region of stability of the method, and the stiffest eigenvalues of a model. */
#ifndef TRK_RUNGEKUTTA_LIMIT_H
#define TRK_RUNGEKUTTA_LIMIT_H

#include "base/base.h"
#include <truckride/rungekutta.h>

#include <complex.h>

/*
 * Longest h for which |R(s lambda)| <= 1 for all s <= h (RUNGEKUTTA.2); an eigenvalue with
 * positive real part is taken as undamped. Infinite for lambda = 0.
 */
double trk_rungekutta_stable_step(double complex lambda);

/*
 * As trk_rungekutta_find_limit(), with the stiffest row of B, of a link or of a beam, counted
 * from 1; 0: none.
 */
trk_status trk_rungekutta_find_stiffest(trk_context *context, const trk_model *model,
                                        double *out_step, int32_t *out_row);

/* Linearised model y'' = -M^-1 (B^T k B y + B^T c B y') by its links. */
typedef struct trk_linearised {
    const trk_model *model;
    const double *stiffness, *damping; /* k, c by link */
    double scale;                      /* [1/s] about the largest frequency, > 0 */
} trk_linearised;

/* Eigenvalues of largest size of a linearised model (RUNGEKUTTA.5). */
typedef struct trk_spectrum_edge trk_spectrum_edge;

/* Workspace for n coordinates, holding the factors of M. */
trk_status trk_spectrum_edge_create(trk_context *context, const trk_model *model,
                                    trk_spectrum_edge **out);
void trk_spectrum_edge_destroy(trk_spectrum_edge *edge);

/* The eigenvalues re + i im into edge, *out_count of them. */
trk_status trk_spectrum_edge_find(trk_spectrum_edge *edge, const trk_linearised *linearised,
                                  const double **out_re, const double **out_im, int32_t *out_count);

/* b M^-1 b^T for the row of one link: one over the mass that it sees. */
trk_status trk_spectrum_edge_mobility(trk_spectrum_edge *edge, int32_t link, double *out);

#endif
