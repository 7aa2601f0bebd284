/* SPDX-License-Identifier: MIT */
/*
 * The step of a small system as a few dense products (NEWMARK.13).
 *
 * With alpha_m = alpha_f = 0 the acceleration with all table forces zero, and the argument
 * x (elongation or rate) of each table with its force zero, are linear in the predicted state
 * and in what drives the system. Their matrices are formed once; a step is then
 *
 *     (a_free, x_free) = L_q q~ + L_v v~ + L_d d
 *     x = x_free - kappa D g,  g = table(x)          solved for g
 *     a = a_free - Z^T g
 *
 * The kernels below do the same in registers of different width. They try a fixed number of
 * iterations and say when that was not enough: then the general path takes the step.
 */
#ifndef TRK_NEWMARK_DENSE_H
#define TRK_NEWMARK_DENSE_H

#include "base/base.h"
#include <truckride/curve.h>

enum {
    TRK_DENSE_LANES = 8,        /* all columns are padded to this many rows      */
    TRK_DENSE_STATE_BLOCKS = 4, /* largest system, in blocks of lanes            */
    TRK_DENSE_TABLE_BLOCKS = 3, /* most tables: curves of all links              */
    TRK_DENSE_TABLES = TRK_DENSE_TABLE_BLOCKS * TRK_DENSE_LANES
};

/* The piece of each table that was used last, scaled, as structure of arrays. */
typedef struct trk_dense_pieces {
    double *lower, *upper, *origin, *c0, *c1, *c2, *c3;
} trk_dense_pieces;

typedef struct trk_dense_step {
    trk_context *context;
    double *block;                      /* memory of all arrays of doubles here                */
    int32_t n, tables, columns;         /* coordinates, curves, drives                         */
    int32_t state_blocks, table_blocks; /* padded n and tables in units of lanes           */
    double h, q_predict, v_predict;     /* predictors of (NEWMARK.2), (NEWMARK.3)              */
    double q_factor, v_factor;          /* beta h^2, gamma h                                   */
    double tolerance, floor;            /* of the table forces                                 */
    int32_t most_corrections;           /* of the table forces in one step                     */
    double force_scale;                 /* lower bound of the largest link force, last step    */
    double *from_q, *from_v;            /* L_q, L_v: (state + table rows) x n, column-major    */
    double *from_drive;                 /* L_d: (state + table rows) x columns                 */
    double *drive;                      /* d: road heights, road velocities, loads, 1          */
    double *influence;                  /* Z^T: state rows x tables                            */
    double *coupling, *diagonal;        /* D: table rows x tables, and its diagonal            */
    double *kappa;                      /* beta h^2 of a spring table, gamma h of a damper's   */
    double *force_bound;                /* times |a|: lower bounds of the largest link force   */
    double *scratch;                    /* table rows                                          */
    double *mismatch;                   /* table rows: before the last correction              */
    double *force[5];                   /* of the tables: now, one, two, three steps ago, next */
    trk_dense_pieces pieces;
    struct trk_dense_table {
        const trk_curve *curve;     /* borrowed from the model                             */
        int32_t link;               /* place of its link among the non-linear ones         */
        bool of_rate;               /* a damper curve                                      */
        double scale, offset, rest; /* force = scale * curve(x + offset) - rest            */
    } table[TRK_DENSE_TABLES];
} trk_dense_step;

/* Arrays of the state before and after; all padded, padding zero. */
typedef struct trk_dense_states {
    const double *q, *v, *a;
    double *out_q, *out_v, *out_a;
} trk_dense_states;

/*
 * Take a step; the table forces go to force[4]. Returns the number of their corrections, or
 * -1: not converged, outputs undefined.
 */
typedef int32_t (*trk_dense_kernel)(trk_dense_step *step, const trk_dense_states *states);

/* The kernel for the registers of this processor. */
trk_dense_kernel trk_dense_choose_kernel(void);

struct trk_newmark;

/*
 * Form the matrices if the system is of a kind and size for this path; *out NULL if not.
 * Uses stepper->next as scratch and leaves it zero.
 */
trk_status trk_dense_create(struct trk_newmark *stepper, trk_dense_step **out);
void trk_dense_destroy(trk_dense_step *step);

/* Take the table forces from a state that was reached otherwise; `steady`: as their past, too. */
void trk_dense_adopt(trk_dense_step *step, const struct trk_newmark *stepper, bool steady);

/* Fetch the pieces of all tables whose argument left its piece. */
void trk_dense_fetch_pieces(trk_dense_step *step, const double *x);

int32_t trk_dense_kernel_base(trk_dense_step *step, const trk_dense_states *states);
int32_t trk_dense_kernel_avx2(trk_dense_step *step, const trk_dense_states *states);
int32_t trk_dense_kernel_avx512(trk_dense_step *step, const trk_dense_states *states);

#endif
