/* SPDX-License-Identifier: MIT */
/* Inside of the leaf spring's friction: its motion (leaf.c) and its energy (leaf_energy.c). */
#ifndef TRK_LAW_LEAF_H
#define TRK_LAW_LEAF_H

#include "law/law.h"

typedef struct trk_leaf {
    trk_law base;
    trk_leaf_options options; /* approach_rebound filled in                   */
    double floor;             /* [N, N m] R is never below (LAW.12e)          */
    double end;               /* [m, rad] elongation from which R is the floor */
} trk_leaf;

/* Memory: the friction force r, and where it acted. */
enum { TRK_LEAF_FORCE, TRK_LEAF_PLACE };

/* R(e), half the width of the hysteresis. */
static inline double trk_leaf_width(const trk_leaf *leaf, double e)
{
    return e < leaf->end ? leaf->options.friction - leaf->options.friction_slope * e : leaf->floor;
}

/* Energy that the friction gives back (LAW.12d) and its loss (LAW.12e). */
double trk_leaf_stored(const trk_law *law, const double *z, double e);
double trk_leaf_lost(const trk_law *law, const double *z, double e, double v);

#endif
