/* SPDX-License-Identifier: MIT */
/* A model with linear links in place of its own. */
#ifndef TRK_MODEL_LINEAR_COPY_H
#define TRK_MODEL_LINEAR_COPY_H

#include "model/model.h"

/*
 * Copy of a model, without gravity, whose links have stiffnesses and dampings only, by link. Its
 * coordinates are measured from where it was linearised. It shares nothing with the model.
 */
trk_status trk_model_copy_linear(trk_context *context, const trk_model *model,
                                 const double *stiffness, const double *damping,
                                 trk_model **out_model);

#endif
