/* SPDX-License-Identifier: MIT */
/*
 * The step of a small system in the modes of its linear springs (RUNGEKUTTA.7):
 * q = Phi y with Phi^T M Phi = I and Phi^T K0 Phi = diag(kappa), so that
 *
 *     y'' = F - kappa y - C y' - Z g(x),    x = X_q y + X_v y' + shift
 *
 * with the linear dampers C, the modal force F of road and loads, and the argument x of each
 * curve: an elongation or a rate.
 */
#ifndef TRK_RUNGEKUTTA_MODAL_H
#define TRK_RUNGEKUTTA_MODAL_H

#include "base/base.h"
#include <truckride/curve.h>
#include <truckride/model.h>

enum {
    TRK_EXPLICIT_LANES = 8,        /* all columns are padded to this many rows */
    TRK_EXPLICIT_STATE_BLOCKS = 4, /* largest system, in blocks of lanes       */
    TRK_EXPLICIT_TABLE_BLOCKS = 3, /* most tables: curves of all links         */
    TRK_EXPLICIT_TABLES = TRK_EXPLICIT_TABLE_BLOCKS * TRK_EXPLICIT_LANES
};

/* The piece of each table that was used last, scaled, as structure of arrays. */
typedef struct trk_explicit_pieces {
    double *lower, *upper, *origin, *c0, *c1, *c2, *c3;
} trk_explicit_pieces;

typedef struct trk_explicit_step {
    trk_context *context;
    double *block;                      /* memory of all arrays of doubles here            */
    int32_t n, tables, springs;         /* coordinates, curves, curves over an elongation  */
    int32_t road_links, columns;        /* links on the road; those and the force ports    */
    bool is_shifted;                    /* a link with a curve stands on the road          */
    int32_t state_blocks, table_blocks; /* padded n and tables in units of lanes           */
    double h;
    double *phi, *inverse;         /* Phi and Phi^-1 = Phi^T M, n x n row-major       */
    double *kappa;                 /* state rows                                      */
    double *from_v;                /* C above X_v: (state + table rows) x n, column-major */
    double *from_q;                /* X_q: table rows x n                             */
    double *influence;             /* Z: state rows x tables                          */
    double *from_drive;            /* state rows x columns                            */
    double *weight;                /* modal weight, state rows                        */
    double *drive[2];              /* forces of the columns at t + h/2, t + h         */
    double *shift[2];              /* of the arguments, table rows                    */
    double *scratch_q, *scratch_v; /* state rows                                      */
    double *scratch_x, *scratch_g; /* table rows                                      */
    trk_explicit_pieces pieces;
    int32_t *source; /* by column: link on the road, then ports                        */
    struct trk_explicit_table {
        const trk_curve *curve; /* borrowed from the model                             */
        int32_t link;
        bool of_rate;               /* a damper curve                                      */
        double scale, offset, rest; /* force = scale * curve(x + offset) - rest            */
    } table[TRK_EXPLICIT_TABLES];
} trk_explicit_step;

/* Arrays of the state before and after; all padded, padding zero. */
typedef struct trk_explicit_states {
    const double *q, *v, *a;
    double *out_q, *out_v, *out_a;
} trk_explicit_states;

/* Take a step. false: the motion is not finite, outputs undefined. */
typedef bool (*trk_explicit_kernel)(trk_explicit_step *step, const trk_explicit_states *states);

/* The kernel for the registers of this processor. */
trk_explicit_kernel trk_explicit_choose_kernel(void);

struct trk_rungekutta;

/* Form the matrices if the system is of a size for this path; *out NULL if not. */
trk_status trk_explicit_create(struct trk_rungekutta *stepper, trk_explicit_step **out);
void trk_explicit_destroy(trk_explicit_step *step);

/* Forces and shifts of what acts, into drive[when] and shift[when]: 0 at t + h/2, 1 at t + h. */
void trk_explicit_set_drive(trk_explicit_step *step, const trk_model *model, int when,
                            const double *height, const double *velocity, const double *load);

/* out := A x, A n x n row-major. */
void trk_explicit_transform(int32_t n, const double *a, const double *x, double *out);

/* Fetch the pieces of all tables whose argument left its piece. */
void trk_explicit_fetch_pieces(trk_explicit_step *step, const double *x);

bool trk_explicit_kernel_base(trk_explicit_step *step, const trk_explicit_states *states);
bool trk_explicit_kernel_avx2(trk_explicit_step *step, const trk_explicit_states *states);
bool trk_explicit_kernel_avx512(trk_explicit_step *step, const trk_explicit_states *states);

#endif
