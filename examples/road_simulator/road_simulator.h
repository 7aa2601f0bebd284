/* SPDX-License-Identifier: MIT */
/* The parts of the road-simulator example. */
#ifndef ROAD_SIMULATOR_H
#define ROAD_SIMULATOR_H

#include "common/common.h"

/* The study of section 7 and 8.4 of the thesis: sweep, spectra, damper configurations. */
void run_study(trk_context *context, const char *directory, double amplitude);

/* The verification of section 6: step and sine against an independent integrator. */
void run_verification(trk_context *context, const char *directory);

#endif
