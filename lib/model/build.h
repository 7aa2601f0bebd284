/* SPDX-License-Identifier: MIT */
/* Rows being written: what turns parts of a spec into rows of a model. */
#ifndef TRK_MODEL_BUILD_H
#define TRK_MODEL_BUILD_H

#include "model/model.h"
#include "spec/spec.h"

/* A row over the freedoms of two bodies; entries of one coordinate are added on appending. */
typedef struct trk_open_row {
    int32_t count;
    int32_t column[4 * TRK_FREEDOMS];
    double value[4 * TRK_FREEDOMS];
} trk_open_row;

/*
 * Add the motion of a body point along d, or the rotation of the body about d (SPEC.1), times a
 * sign.
 */
void trk_open_row_add(const trk_model *model, const trk_spec *spec, int32_t body, trk_motion motion,
                      const double *point, const double *d, double sign, trk_open_row *row);

trk_status trk_open_row_append(trk_context *context, trk_rows *rows, const trk_open_row *row);

/* One inertia row, and its weight: `lift` is what it reads when everything rises by 1 m. */
trk_status trk_model_add_inertia(trk_model *model, const trk_open_row *row, double mass,
                                 double lift);

/* Most rows that beams add to the links; the rows of all beams, after the links. */
int64_t trk_model_most_beam_rows(const trk_spec *spec);
trk_status trk_model_build_beams(trk_model *model, const trk_spec *spec);

#endif
