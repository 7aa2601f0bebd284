/* SPDX-License-Identifier: MIT */
/* Inside of a surface, and the steps of reading one (CRG.1, CRG.2). */
#ifndef TRK_CRG_CRG_H
#define TRK_CRG_CRG_H

#include "files/text.h"
#include <truckride/crg.h>

struct trk_crg {
    trk_context *context;
    int64_t rows, columns;
    double u, increment;               /* of the first row; between rows                      */
    double *v;                         /* length columns, increasing                          */
    double *grid;                      /* rows x columns                                      */
    double *line;                      /* z of the reference line at each row                 */
    double *banking;                   /* at each row; NULL: none                             */
    bool even;                         /* v has equal steps: no search                        */
    trk_crg_border border_u, border_v; /* never TRK_CRG_BORDER_FILE            */
    double offset_u, offset_v;
};

/* Numbers of the header; the order is that of the names in header.c. */
typedef enum trk_crg_key {
    TRK_CRG_START_U,
    TRK_CRG_END_U,
    TRK_CRG_INCREMENT,
    TRK_CRG_V_RIGHT,
    TRK_CRG_V_LEFT,
    TRK_CRG_V_INCREMENT,
    TRK_CRG_START_S,
    TRK_CRG_END_S,
    TRK_CRG_START_B,
    TRK_CRG_END_B,
    TRK_CRG_START_Z,
    TRK_CRG_END_Z,
    TRK_CRG_BORDER_MODE_U,
    TRK_CRG_BORDER_MODE_V,
    TRK_CRG_BORDER_OFFSET_U,
    TRK_CRG_BORDER_OFFSET_V,
    TRK_CRG_SCALE_Z,
    TRK_CRG_SCALE_SLOPE,
    TRK_CRG_SCALE_BANKING,
    TRK_CRG_NAN_MODE,
    TRK_CRG_NAN_OFFSET,
    TRK_CRG_KEYS
} trk_crg_key;

/* A column of the data. */
typedef struct trk_crg_column {
    enum { TRK_CRG_IGNORED, TRK_CRG_SLOPE, TRK_CRG_BANKING, TRK_CRG_AT, TRK_CRG_NUMBERED } kind;
    double v; /* TRK_CRG_AT: [m]; TRK_CRG_NUMBERED: its number */
    int64_t line;
} trk_crg_column;

typedef struct trk_crg_reader {
    trk_context *context;
    const char *begin; /* of the file */
    trk_text text;
    trk_crg *crg;
    double value[TRK_CRG_KEYS];
    bool given[TRK_CRG_KEYS];
    int32_t field; /* [byte] of a number in the data; 0: no format yet */
    bool ascii, padded;
    trk_crg_column *column;
    int64_t columns, capacity;
    int64_t *place;       /* column of the data of each column of the grid  */
    double *slope, *bank; /* length rows, NULL where there is no such column */
} trk_crg_reader;

/* header.c: all sections up to the $$$$ line; text then stands at the data. */
trk_status trk_crg_read_header(trk_crg_reader *r);

/* columns.c: one line of $KD_DEFINITION; then the v axis and where its columns stand. */
trk_status trk_crg_read_column(trk_crg_reader *r, trk_slice line);
trk_status trk_crg_build_axis(trk_crg_reader *r);

/* data.c: rows of the grid, slope and banking. */
trk_status trk_crg_read_data(trk_crg_reader *r);

/* line.c: scales, missing heights, z of the reference line, banking. */
trk_status trk_crg_finish(trk_crg_reader *r, trk_crg_missing missing);

/* evaluate.c: height at a row from 0, without interpolation along u. */
double trk_crg_row_height(const trk_crg *crg, int64_t row, double v);

#endif
