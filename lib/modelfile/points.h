/* SPDX-License-Identifier: MIT */
/* Points of a curve that is being made. */
#ifndef TRK_MODELFILE_POINTS_H
#define TRK_MODELFILE_POINTS_H

#include "modelfile/reader.h"

typedef struct trk_points {
    int64_t count;
    double *x, *y; /* one block, at x */
} trk_points;

/* Room for a number of points. */
trk_status trk_points_take(trk_reader *reader, trk_points *p, int64_t count);

/* From the table that `csv` of the group names. */
trk_status trk_points_from_csv(trk_reader *reader, const trk_node *csv, const trk_node *group,
                               trk_subject subject, trk_points *p);

#endif
