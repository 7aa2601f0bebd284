/* SPDX-License-Identifier: MIT */
/*
 * A beam element (SPEC.6) as rows over the motions of its two ends in its own axes,
 *
 *     (u_x, u_y, u_z, theta_x, theta_y, theta_z) of the first end, then of the second:
 *
 * K = sum k row^T row over six natural deformations, M = sum m row^T row over at most twelve
 * inertia rows, all k and m > 0.
 */
#ifndef TRK_SYSTEM_BEAM_H
#define TRK_SYSTEM_BEAM_H

#include <truckride/spec.h>

enum { TRK_BEAM_ENDS = 12, TRK_BEAM_STIFFNESS_ROWS = 6, TRK_BEAM_INERTIA_ROWS = 12 };

typedef struct trk_beam_row {
    double row[TRK_BEAM_ENDS];
    double factor; /* k [N/m, N m/rad] or m [kg, kg m^2] */
} trk_beam_row;

/* The rows that have a stiffness; returns their number. */
int trk_beam_stiffness_rows(const trk_beam_options *beam, double length,
                            trk_beam_row out[TRK_BEAM_STIFFNESS_ROWS]);

/* The rows of the consistent mass matrix; returns their number. */
int trk_beam_inertia_rows(const trk_beam_options *beam, double length,
                          trk_beam_row out[TRK_BEAM_INERTIA_ROWS]);

#endif
