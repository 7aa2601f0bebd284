/* SPDX-License-Identifier: MIT */
/* Units as texts and their factors to SI (FILES.5). */
#ifndef TRK_FILES_UNIT_H
#define TRK_FILES_UNIT_H

#include <math.h>

/* Factor to SI, 0 if the unit is unknown; *out_si: the SI unit, static text. */
double trk_unit_factor(const char *unit, const char **out_si);

/* A rate is the reciprocal of a step that files give with 7 digits or so: a whole number as near
 * as 1e-6 is meant. */
static inline double trk_round_rate(double rate)
{
    const double whole = nearbyint(rate);
    return whole >= 1 && fabs(rate - whole) <= 1e-6 * whole ? whole : rate;
}

#endif
