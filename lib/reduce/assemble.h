/* SPDX-License-Identifier: MIT */
/* The reduced model: rows of the old one over the new coordinates (REDUCE.2). */
#ifndef TRK_REDUCE_ASSEMBLE_H
#define TRK_REDUCE_ASSEMBLE_H

#include "reduce/basis.h"

/* Fill an empty model of the context, statics not yet solved; the caller destroys it on failure. */
trk_status trk_reduce_assemble(const trk_component *component, const trk_basis *basis,
                               double modal_damping, trk_model *out);

#endif
