/* SPDX-License-Identifier: MIT */
/* The standard quarter car of the IRI (ROUGHNESS.1). */
#ifndef TRK_ROUGHNESS_GOLDEN_H
#define TRK_ROUGHNESS_GOLDEN_H

#include "base/base.h"

/* Stiffnesses and damping over the sprung mass, unsprung over sprung mass, speed. */
#define TRK_GOLDEN_TIRE 653.0       /* [1/s^2] */
#define TRK_GOLDEN_SPRING 63.3      /* [1/s^2] */
#define TRK_GOLDEN_DAMPER 6.0       /* [1/s]   */
#define TRK_GOLDEN_MASS 0.15        /* [-]     */
#define TRK_GOLDEN_SPEED (80 / 3.6) /* [m/s]  */

/*
 * x(i+1) = transition x(i) + input slope(i) over one sample at 80 km/h, slope constant in between
 * (ROUGHNESS.2); x = (z_s', z_s'', z_u', z_u'') over the speed. The World Bank's ST and PR.
 */
typedef struct trk_golden_step {
    double transition[4][4], input[4];
} trk_golden_step;

void trk_golden_create(double spacing, trk_golden_step *out_step);

#endif
