/* SPDX-License-Identifier: MIT */
/* Where the energy of a mode is, in words. */
#ifndef TRUCKRIDE_CLI_ENERGY_H
#define TRUCKRIDE_CLI_ENERGY_H

#include <truckride/truckride.h>

/*
 * "cab.z 62 %, frame.pitch 20 %": at most four with a twentieth of the energy or more, most first.
 * The nodes of a flexible frame, "frame.left.1.z", count together as "frame".
 */
void energy_text(const trk_model *model, const double *share, char *text, size_t room);

#endif
