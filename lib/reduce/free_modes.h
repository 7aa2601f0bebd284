/* SPDX-License-Identifier: MIT */
/* Second reduction: the component as a whole to its lowest free modes (REDUCE.4). */
#ifndef TRK_REDUCE_FREE_MODES_H
#define TRK_REDUCE_FREE_MODES_H

#include "reduce/basis.h"

/* T becomes T Y, Y the `count` lowest modes of the component in T without what holds it. */
trk_status trk_basis_use_free_modes(trk_basis *basis, const trk_component *component,
                                    int32_t count);

#endif
