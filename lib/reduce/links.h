/* SPDX-License-Identifier: MIT */
/* Links of a reduced model: named ones row by row, those of the component's beams merged. */
#ifndef TRK_REDUCE_LINKS_H
#define TRK_REDUCE_LINKS_H

#include "reduce/transform.h"

/* Names of `out` must stand. modal_damping < 0: modes keep the damping of the beams. */
trk_status trk_reduce_build_links(trk_transform *transform, double modal_damping, trk_model *out);

#endif
