/* SPDX-License-Identifier: MIT */
/* The parts of the road-simulator example. */
#ifndef ROAD_SIMULATOR_H
#define ROAD_SIMULATOR_H

#include <stdio.h>
#include <truckride/truckride.h>

/* Stop the program with the library's own sentence. */
void check(trk_context *context, trk_status status);

/* Open directory/name for writing or stop. */
FILE *open_result(const char *directory, const char *name);

/* The study of section 7 and 8.4 of the thesis: sweep, spectra, damper configurations. */
void run_study(trk_context *context, const char *directory, double amplitude);

/* The verification of section 6: step and sine against an independent integrator. */
void run_verification(trk_context *context, const char *directory);

#endif
