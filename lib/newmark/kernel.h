/* SPDX-License-Identifier: MIT */
/*
 * The step of a small system in modal coordinates (NEWMARK.15 to .19), packed for registers.
 *
 * Between two steps the system is held as what the next one needs: the predicted velocities v~,
 * z = y~ - r v~, and `free`, the part of v_f that does not depend on the drives:
 *
 *     v_f = free + sum_k drive_k d_k              d: roads, loads
 *     x_f = W' v_f - G_p u'                       rates were the forces g of the curves zero
 *     g   : x = x_f - K g, g = G(x)               K = kappa D
 *     v1  = T v_f - Z g
 *     v~' = c1 v1 + c2 v~,  z' = z + c3 v1 + c4 v~,  free' = v~' - L (z' + r v~')
 *
 * Links with equal rows share one row here: G is the sum of their curves, held as layers of one
 * table a lane.
 */
#ifndef TRK_NEWMARK_KERNEL_H
#define TRK_NEWMARK_KERNEL_H

#include "newmark/modal.h"

enum {
    TRK_FAST_MODES = 32,  /* largest system                        */
    TRK_FAST_ROWS = 24,   /* most rows of links with curves        */
    TRK_FAST_LAYERS = 4,  /* most curves on one row                */
    TRK_FAST_HISTORY = 6, /* rates that the next one is guessed by */
    TRK_FAST_SENSORS = 4, /* read at once                          */
    TRK_FAST_PADDING = 8  /* arrays are padded to this many        */
};

/*
 * Sizes that kernels are compiled for, in registers of 2, 4 and 8 numbers: of a column of modes
 * and of one of rows with curves, smallest first. Those of the ready-made vehicles fit closely.
 */
#define TRK_FAST_SIZES_2(X)                                                                        \
    X(1, 0)                                                                                        \
    X(1, 1)                                                                                        \
    X(2, 0) X(2, 1) X(4, 0) X(4, 1) X(4, 2) X(7, 0) X(7, 2) X(7, 4) X(7, 6) X(16, 0) X(16, 12)
#define TRK_FAST_SIZES_4(X)                                                                        \
    X(1, 0) X(1, 1) X(2, 0) X(2, 1) X(4, 0) X(4, 1) X(4, 2) X(4, 3) X(8, 0) X(8, 6)
#define TRK_FAST_SIZES_8(X) X(1, 0) X(1, 1) X(2, 0) X(2, 1) X(2, 2) X(4, 0) X(4, 3)

/* The piece of each table of a layer that was used last, scaled, as structure of arrays. */
typedef struct trk_fast_layer {
    double *lower, *upper, *origin, *c0, *c1, *c2, *c3;
    struct trk_fast_table {
        const trk_curve *curve;     /* borrowed; NULL: no table in this lane   */
        int32_t nonlinear;          /* place of its link among the non-linear  */
        int32_t piece;              /* of the curve, used last                 */
        double scale, offset, rest; /* force = scale * curve(x + offset) - rest */
    } table[TRK_FAST_ROWS];
} trk_fast_layer;

typedef struct trk_fast {
    trk_context *context;
    trk_modal_form *form;
    double *block; /* memory of all arrays of doubles here                */
    int32_t rows, roads, ports;
    int32_t modes;                   /* n                                                   */
    int32_t mode_lanes, row_lanes;   /* most numbers in a packed column of any kernel       */
    int32_t mode_blocks, row_blocks; /* lengths of packed columns, in registers of `width`  */
    int32_t row_stride;              /* the second in numbers                               */
    int32_t mode_stride;             /* the first in numbers                                */
    int64_t size;                    /* of block                                            */
    int32_t lane[TRK_FAST_ROWS * TRK_FAST_LAYERS]; /* row of each non-linear link           */
    int32_t first[TRK_FAST_ROWS]; /* place of a link of that row among the non-linear    */
    int32_t springs, layers;      /* the first `springs` layers are of the elongation    */
    bool on_velocity;             /* road velocities act other than through `ratio`      */
    bool on_rows;                 /* roads act on rows with curves                       */
    int32_t most_corrections;     /* of the rates in one step                            */
    double r, inverse_kappa;
    double c1, c2, c3, c4;   /* of v~' and z'                                       */
    double tolerance, floor; /* of the table forces                                 */
    double limit;            /* of their mismatch in the next step                  */
    double whole_row;        /* bound of |S K| (NEWMARK.20)                         */
    /* Columns of matrices, padded to registers; K and Z with a padded number of columns. */
    double *to_rows, *to_modes;  /* W', T: of v_f                                       */
    double *elongation;          /* W_p: of z                                           */
    double *coupling, *diagonal; /* K and its diagonal                                  */
    double *influence;           /* Z                                                   */
    double *height_drive;        /* of u + ratio u'                                     */
    double *velocity_drive;      /* of u', if on_velocity                               */
    double *load_drive, *ratio;
    double *road_rows; /* G_p                                                 */
    /* Vectors. */
    double *weight, *restoring;    /* kappa s^-1 w, L = kappa s^-1 lambda                 */
    double *curvature, *reach;     /* C, b of (NEWMARK.19)                                */
    double *v1;                    /* the velocities                                      */
    double *v, *z, *old_v, *old_z; /* v~ and z of the step to come, and those that led to v1 */
    double *free;
    double *past[TRK_FAST_HISTORY]; /* x now, one, two, ... steps ago                      */
    double *force;                  /* g                                                   */
    double *work_modes, *work_rows;
    double *worst; /* forces corrected in the step that took most of it   */
    trk_fast_layer layer[TRK_FAST_LAYERS];
    double *layer_value, *layer_slope; /* of the last evaluation, layers x padded rows        */
    double *moved;                     /* the rates since it, if there are several layers     */
    double *zeros;                     /* for drives that are NULL                            */
    double *to_physical;               /* Phi                                                 */
    double *row;                       /* the raw state (record.c), and the road behind it    */
    bool is_ahead;                     /* of the physical state in stepper->now               */
    /* Sensors by groups: where their columns end, columns of `row`, factors for each sensor. */
    int64_t *sensor_end;
    int32_t *sensor_column;
    double *sensor_factor;
    int64_t iterations; /* corrections so far, and most in one step            */
    int32_t max_iterations;
} trk_fast;

/* What drives `count` steps; strides are in doubles, 0 for an array of zeros. */
typedef struct trk_fast_run {
    int64_t count;
    const double *height, *velocity, *load;
    int64_t height_stride, velocity_stride, load_stride;
    double *out_rows; /* NULL: not recorded */
    int64_t row_width;
} trk_fast_run;

/* Take steps; returns how many. Fewer than count: the next one did not converge, or is not
 * finite, and has not happened. */
typedef int64_t (*trk_fast_kernel)(trk_fast *fast, const trk_fast_run *run);

int64_t trk_fast_kernel_base(trk_fast *fast, const trk_fast_run *run);
int64_t trk_fast_kernel_avx2(trk_fast *fast, const trk_fast_run *run);
int64_t trk_fast_kernel_avx512(trk_fast *fast, const trk_fast_run *run);

struct trk_newmark;

/* The first of the sizes above for registers of `width` that holds modes and rows. */
void trk_fast_choose_size(int32_t width, int32_t modes, int32_t rows, int32_t *out_mode_blocks,
                          int32_t *out_row_blocks);

/* Form and memory if the system is of a kind and size for this path; *out NULL if not. */
trk_status trk_fast_create(struct trk_newmark *stepper, trk_fast **out);
void trk_fast_destroy(trk_fast *fast);

/* Lay the numbers out for registers of `width` doubles; the state is then undefined. */
void trk_fast_pack(trk_fast *fast, const struct trk_newmark *stepper, int32_t width);

/* Take the state of stepper->now; `steady`: rates were always so, else one more step passed. */
void trk_fast_adopt(trk_fast *fast, const struct trk_newmark *stepper, bool steady);

/* Modal displacements, velocities and accelerations, each of length n. */
void trk_fast_get_motion(const trk_fast *fast, double *out_y, double *out_v, double *out_a);

/* Coordinates, velocities, accelerations at the modal state; NULL to skip. */
void trk_fast_get_state(const trk_fast *fast, double *out_q, double *out_v, double *out_a);

/* What trk_fast_read_sensors() needs; after trk_fast_create(). TRK_E_MEMORY: the stepper is to be
 * destroyed. */
trk_status trk_fast_create_sensors(struct trk_newmark *stepper);

/* Values of all sensors if a kernel took the last step; false: read them elsewhere. */
bool trk_fast_read_sensors(const struct trk_newmark *stepper, double *out_values);

/* Bring stepper->now up to the modal state. */
void trk_fast_settle(const struct trk_newmark *stepper);

/* Fetch the pieces of a layer whose argument left its piece. */
void trk_fast_fetch(trk_fast_layer *layer, int32_t rows, const double *argument);

#endif
