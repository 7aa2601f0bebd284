/* SPDX-License-Identifier: MIT */
/* Force curve of a bump or rebound stop: force over compression of the stop. */
#ifndef TRK_LAW_STOP_CURVE_H
#define TRK_LAW_STOP_CURVE_H

#include "law/law.h"

/* A stop pushes at every compression, and begins to at 0: else TRK_E_RANGE. NULL is allowed. */
trk_status trk_stop_curve_check(trk_context *context, const trk_law_ops *ops, const char *name,
                                const char *field, const trk_curve *curve);

/* Integral of the curve from 0 to x > 0, piece by piece. */
double trk_stop_curve_area(const trk_curve *curve, double x);

#endif
