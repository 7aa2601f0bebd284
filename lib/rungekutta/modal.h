/* SPDX-License-Identifier: MIT */
/*
 * Steps of a small system in the modes of its linear springs (RUNGEKUTTA.6): q = Phi y with
 * Phi^T M Phi = I and Phi^T K0 Phi = diag(kappa), so that
 *
 *     y'' = F - kappa y - C y' - Z g(x),    x = X_q y + X_v y' + shift
 *
 * with the linear dampers C, the modal force F of road and loads, and the argument x of each
 * curve: an elongation or a rate. F and the shift are linear in the inputs: heights and
 * velocities of the roads, loads on the ports.
 */
#ifndef TRK_RUNGEKUTTA_MODAL_H
#define TRK_RUNGEKUTTA_MODAL_H

#include "curve/curve.h"
#include "model/model.h"

enum {
    TRK_EXPLICIT_LANES = 8,        /* all columns are padded to this many rows */
    TRK_EXPLICIT_STATE_BLOCKS = 4, /* largest system, in blocks of lanes       */
    TRK_EXPLICIT_TABLE_BLOCKS = 3, /* most tables: curves of all links         */
    TRK_EXPLICIT_TABLES = TRK_EXPLICIT_TABLE_BLOCKS * TRK_EXPLICIT_LANES,
    TRK_EXPLICIT_INPUTS = 3 /* heights, velocities, loads */
};

/* The piece of each table that was used last, scaled, as structure of arrays. */
typedef struct trk_explicit_pieces {
    double *lower, *upper, *origin, *c0, *c1, *c2, *c3;
} trk_explicit_pieces;

/* A curve of a link: force = scale * curve(x + offset) - rest. */
typedef struct trk_explicit_table {
    const trk_curve *curve; /* borrowed from the model                              */
    int32_t link;           /* 0-based                                              */
    bool of_rate;           /* a damper curve                                       */
    double scale, offset, rest;
    const trk_piece *piece; /* the one used last, of all pieces of force over x     */
} trk_explicit_table;

/* All matrices column-major, columns of padded rows; padding is zero. */
typedef struct trk_explicit {
    trk_context *context;
    double *block;                      /* memory of all arrays of doubles here            */
    int32_t n, tables, springs;         /* coordinates, curves, curves over an elongation  */
    int32_t state_blocks, table_blocks; /* padded n and tables in units of lanes           */
    int32_t inputs[TRK_EXPLICIT_INPUTS];
    bool is_shifted; /* a link with a curve stands on the road          */
    double h;
    double *phi, *inverse;              /* Phi and Phi^-1 = Phi^T M, n x n row-major       */
    double *kappa;                      /* state rows                                      */
    double *damping;                    /* C: state rows x n                               */
    double *from_v;                     /* X_v: table rows x n                             */
    double *from_q;                     /* X_q: table rows x n                             */
    double *influence;                  /* Z: state rows x tables                          */
    double *drive[TRK_EXPLICIT_INPUTS]; /* of F: state rows x inputs                    */
    double *shift[TRK_EXPLICIT_INPUTS]; /* of x: table rows x inputs                    */
    double *weight;                     /* modal weight, state rows                     */
    double *zeros;                      /* as many as the longest input has             */
    double *row;                        /* the state: (y, y', y'', g), each padded      */
    double *scratch_q, *scratch_v;      /* state rows                                   */
    double *scratch_x, *scratch_g;      /* table rows                                   */
    trk_explicit_pieces pieces;
    trk_piece *all_pieces; /* of all tables, each in its order                     */
    trk_explicit_table table[TRK_EXPLICIT_TABLES];
} trk_explicit;

/* Inputs of many steps: at the middle and at the end of the first, and from step to step. */
typedef struct trk_explicit_run {
    int64_t count;
    const double *input[2][TRK_EXPLICIT_INPUTS];
    int64_t stride[TRK_EXPLICIT_INPUTS];
    double *rows; /* count states, aligned; NULL: none are kept */
} trk_explicit_run;

/*
 * Take steps from the state in `row`, which becomes the last one, and record each. Returns
 * their number; fewer than count if the motion of the next one is not finite.
 */
typedef int64_t (*trk_explicit_kernel)(trk_explicit *s, const trk_explicit_run *run);

int64_t trk_explicit_kernel_base(trk_explicit *s, const trk_explicit_run *run);
int64_t trk_explicit_kernel_avx2(trk_explicit *s, const trk_explicit_run *run);
int64_t trk_explicit_kernel_avx512(trk_explicit *s, const trk_explicit_run *run);

/* The kernel for the registers of this processor. */
trk_explicit_kernel trk_explicit_choose_kernel(void);

/* Form the matrices if the system is fit for this path; *out NULL with TRK_OK if not. */
trk_status trk_explicit_create(trk_context *context, const trk_model *model, double h,
                               trk_explicit **out);
void trk_explicit_destroy(trk_explicit *s);

/* Numbers of a state, and those of y, y' or y'' in it. */
static inline int64_t trk_explicit_part(const trk_explicit *s)
{
    return (int64_t)s->state_blocks * TRK_EXPLICIT_LANES;
}

static inline int64_t trk_explicit_width(const trk_explicit *s)
{
    return 3 * trk_explicit_part(s) + (int64_t)s->table_blocks * TRK_EXPLICIT_LANES;
}

/* Set the state from q, q', q'' of the model with the road given. */
void trk_explicit_set_state(trk_explicit *s, const trk_model *model, const double *q,
                            const double *v, const double *a, const double *height,
                            const double *velocity);

/* out := Phi x for part 0 (q), 1 (q') or 2 (q'') of the state. */
void trk_explicit_get_part(const trk_explicit *s, int part, double *out);

/* Fetch the pieces of the tables whose argument left its piece: those with their bit set. */
void trk_explicit_fetch_pieces(trk_explicit *s, const double *x, uint32_t left);

#endif
