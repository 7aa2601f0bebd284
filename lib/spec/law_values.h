/* SPDX-License-Identifier: MIT */
/* Parameters of a law, of any kind that has a field to vary. */
#ifndef TRK_SPEC_LAW_VALUES_H
#define TRK_SPEC_LAW_VALUES_H

#include "base/base.h"
#include <truckride/spec.h>

typedef struct trk_law_values {
    trk_law_kind kind; /* 0: no law, or nothing to vary in it */
    union {
        trk_tire_options tire;
        trk_stops_options stops;
        trk_leaf_options leaf;
        trk_friction_options friction;
        trk_seal_options seal;
    } of;
    double curve_scale; /* of the curves of stops [-] */
} trk_law_values;

enum { TRK_LAW_NUMBERS = 2 }; /* the most that a field has */

/* law may be NULL. Curves in *out are owned by the law. */
void trk_law_values_read(const trk_law *law, trk_law_values *out);

/* Places of the numbers of a field, curves aside; returns how many. */
int32_t trk_law_values_list(trk_law_values *values, trk_field field, double *out[TRK_LAW_NUMBERS]);

/* Has the law curves that a stiffness scales? */
bool trk_law_values_have_curves(const trk_law_values *values);

/* The law with these values. */
trk_status trk_law_values_make(trk_context *context, const char *name, const trk_law_values *values,
                               trk_law **out_law);

#endif
