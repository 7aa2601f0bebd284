/* SPDX-License-Identifier: MIT */
/* From the table of a curve to its pieces. */
#ifndef TRK_CURVE_PIECES_H
#define TRK_CURVE_PIECES_H

#include "curve/curve.h"

/*
 * Allocate and fill curve->pieces from its table and kinds, and the slope range.
 * TRK_E_RANGE: a slope overflows. TRK_E_MEMORY. On failure the caller frees the curve.
 */
trk_status trk_curve_set_pieces(trk_context *context, trk_curve *curve);

#endif
