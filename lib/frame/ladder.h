/* SPDX-License-Identifier: MIT */
/* Inside of adding a ladder frame. */
#ifndef TRK_FRAME_LADDER_H
#define TRK_FRAME_LADDER_H

#include "base/base.h"
#include <truckride/frame.h>

enum { TRK_FRAME_NODES = 1000000 };

/* TRK_E_RANGE with a message unless all numbers and places are good; pointers are not NULL. */
trk_status trk_frame_check(trk_context *context, const char *name, const trk_frame_options *o);

/* 0-based station at x, -1: none. */
int32_t trk_frame_station(const trk_frame_options *o, double x);

/* Nodes of both rails, infinite if too many. */
double trk_frame_count(const trk_frame_options *o);

#endif
