/* SPDX-License-Identifier: MIT */
/*
 * Variants side by side, one in each lane of a vector register (BATCH.1 to BATCH.8).
 *
 * An array of `count` numbers a variant holds count x width doubles: number i of lane l stands
 * at [i * width + l]. No operation crosses lanes, so a variant gets the same bits in every
 * lane and beside any others.
 */
#ifndef TRK_BATCH_LANES_H
#define TRK_BATCH_LANES_H

#include "model/model.h"
#include <truckride/newmark.h>

enum {
    TRK_LANES_WIDEST = 8,
    TRK_LANES_MODES = 32,  /* largest system                              */
    TRK_LANES_TABLES = 24, /* most curves                                 */
    TRK_LANES_ROWS = 64,   /* most links that act apart, and most ports   */
    TRK_LANES_BLOCK = 128, /* steps whose excitation is evaluated at once */
    TRK_LANES_TILE = 4     /* recorded samples that sensors are read for at once */
};

/* A table of forces over an elongation or a rate; the same in all variants but for numbers. */
typedef struct trk_lanes_table {
    int32_t link; /* 0-based               */
    bool of_rate; /* a damper curve        */
    bool first;   /* carries the link's rest force */
    int32_t road; /* 0-based, -1: none     */
} trk_lanes_table;

/* What a sensor reads: rows on displacement, velocity, acceleration of the modes, and the road. */
typedef struct trk_lanes_sensor {
    int32_t id;       /* 0-based, in the models                  */
    int32_t row[3];   /* in sensor_rows, on x, v and a; -1: none */
    int32_t road;     /* 0-based, -1: none                       */
    int32_t table[2]; /* whose forces it adds, -1: none          */
} trk_lanes_sensor;

/* The piece of a curve that a table used last, scaled. */
typedef struct trk_lanes_pieces {
    double *lower, *upper, *origin, *c0, *c1, *c2, *c3; /* tables */
} trk_lanes_pieces;

/* Which curve a table of a variant has, and how it is scaled: scale * curve(x + offset) - rest. */
typedef struct trk_lanes_curve {
    const trk_curve *curve;
    double scale, offset, rest;
    int32_t hint;
} trk_lanes_curve;

typedef struct trk_lanes {
    trk_context *context;
    int32_t width;                              /* lanes                                      */
    int32_t n, roads, ports, links;             /* as in the models                           */
    int32_t sensors;                            /* that are recorded                          */
    int32_t tables, rate_tables;                /* those of rates stand first                 */
    int32_t road_links;                         /* links on a road: the first of the rows     */
    int32_t rows, most_rows;                    /* see `dense`                                */
    bool dense;                                 /* C in full instead of by rows (BATCH.3)     */
    bool loaded;                                /* some load of the block is not zero         */
    bool shared;                                /* one road and load for all, not by lanes    */
    double h, q_predict, v_predict, bh2, gh, r; /* of the step                                */
    double tolerance;                           /* of the table forces                        */
    int64_t record_every, until_record;         /* steps                                      */
    int64_t samples;                            /* recorded in this block                     */
    trk_lanes_table table[TRK_LANES_TABLES];
    int32_t *row_link;        /* most_rows: 0-based links                                */
    int32_t *row_road;        /* road_links: 0-based roads of the first rows             */
    trk_lanes_sensor *sensor; /* sensors                                                 */
    int32_t part_rows[3];     /* rows of sensors on x, v, a, which stand in this order   */
    trk_lanes_curve *curve;   /* tables x width                                          */
    double *block;            /* memory of all arrays of doubles below, of block_size    */
    int64_t block_size;
    double *x, *v, *a;             /* modal state, n                                          */
    double *before_x, *before_v;   /* at the start of the block, n                            */
    double *force[4];              /* of the tables: now, one, two, three steps ago           */
    double *largest;               /* 1: largest table force of the last step                 */
    double *floor;                 /* 1: rounding of table forces (NEWMARK.12)                */
    double *failed;                /* 1: not zero: this lane did not converge in this block   */
    double *tau, *inverse;         /* n (BATCH.2)                                             */
    double *weight;                /* n                                                       */
    double *damping;               /* n x n, if dense                                         */
    double *row, *row_damping;     /* W_r: most_rows x n; c: most_rows                        */
    double *row_height, *row_rate; /* k G, c G: road_links                                    */
    double *port;                  /* ports x n                                               */
    double *table_row, *coupling;  /* W_t: tables x n; E: tables x tables                     */
    double *neighbours;            /* sum of |E_tu| over u other than t: tables               */
    double *table_road;            /* G of its link, tables                                   */
    double *sensor_rows;           /* sum of part_rows x n                                    */
    double *sensor_height,
        *sensor_rate; /* sensors                                                 */
    double *by_lane;  /* memory for the drives of the block if not shared        */
    double *tile;     /* TILE x (3 n + tables)                                   */
    double *products; /* of the tile: sum of part_rows x TILE                    */
    double *recorded; /* width x sensors x BLOCK: of each lane on its own         */
    double *psi;      /* n x n, coordinate x mode, of each lane: q = psi x       */
    trk_lanes_pieces piece;
    /* Drives of the block, BLOCK x roads, roads, ports: numbers if shared, else numbers x width. */
    const double *height, *velocity, *load;
} trk_lanes;

/* A kernel: the loops for registers of one kind. */
typedef struct trk_lanes_kernel {
    int32_t width;
    /* Take `count` steps with the drives of the block, and record. */
    void (*advance)(trk_lanes *lanes, int64_t count);
    /* Record the present state as sample 0, with the road of step 0 of the block. */
    void (*record_now)(trk_lanes *lanes);
} trk_lanes_kernel;

/* Kernels by number; NONE leaves all to the stepper. */
enum {
    TRK_BATCH_KERNEL_NONE = 0,
    TRK_BATCH_KERNEL_PORTABLE = 1,
    TRK_BATCH_KERNEL_AVX2 = 2,
    TRK_BATCH_KERNEL_AVX512 = 3,
    TRK_BATCH_KERNEL_BEST = 4
};

/* NULL: this build or this processor does not have it, or NONE. BEST is chosen by structure alone. */
const trk_lanes_kernel *trk_lanes_find_kernel(int32_t kernel, const trk_model *model);

extern const trk_lanes_kernel trk_lanes_portable, trk_lanes_avx2, trk_lanes_avx512;

/* Can models of this structure be stepped with these options in lanes? */
bool trk_lanes_fit(const trk_model *model, const trk_newmark_options *options);

/*
 * Room for `width` variants of that structure, in the caller's context. The model serves for its
 * structure only. sensor: 0-based ids of what is recorded, copied.
 */
trk_status trk_lanes_create(trk_context *context, const trk_model *model,
                            const trk_newmark_options *options, int64_t record_every,
                            int32_t sensors, const int32_t *sensor, int32_t width, trk_lanes **out);
void trk_lanes_destroy(trk_lanes *lanes);

/* Do both models have linear damping at the same links? Only such variants share a group. */
bool trk_lanes_alike(const trk_model *a, const trk_model *b);

/* Choose rows for a group of variants like this one. */
void trk_lanes_start(trk_lanes *lanes, const trk_model *model);

/*
 * Put a variant into a lane, at static equilibrium and rest under that road and load. `context`
 * is for scratch memory. *out_fits false: it cannot be stepped here (a negative stiffness, a
 * mass matrix that is not positive definite): the stepper takes it or says why not.
 */
trk_status trk_lanes_fill(trk_lanes *lanes, int32_t lane, trk_context *context,
                          const trk_model *model, const double *height, const double *velocity,
                          const double *load, bool *out_fits);

/* Repeat a lane in another one, so that it has something harmless to do. */
void trk_lanes_copy(trk_lanes *lanes, int32_t from, int32_t to);

/* Remember the state in front of a block, and q, v of a lane as they were then. */
void trk_lanes_keep(trk_lanes *lanes);
void trk_lanes_get_kept(const trk_lanes *lanes, int32_t lane, double *out_q, double *out_v);

/* Fetch the pieces of a table for all lanes whose argument x (width numbers) has left its own. */
void trk_lanes_fetch(const trk_lanes *lanes, int32_t table, const double *x);

#endif
