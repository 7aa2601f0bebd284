/* SPDX-License-Identifier: MIT */
/* The part of a model that is reduced: which of its coordinates are interface, which interior. */
#ifndef TRK_REDUCE_COMPONENT_H
#define TRK_REDUCE_COMPONENT_H

#include "model/model.h"

typedef struct trk_component {
    trk_context *context;
    const trk_model *model;
    int32_t count, interface_count; /* coordinates; the interface comes first               */
    int32_t *coordinate;            /* by component coordinate: that of the model           */
    int32_t *place;                 /* by coordinate of the model: in the component, -1: outside */
    double *stiffness, *damping;    /* tangents at rest, by link                            */
} trk_component;

/*
 * The coordinates of the bodies whose names match. TRK_E_NAME: none; TRK_E_MODEL: no interior.
 * Clear it even on failure.
 */
trk_status trk_component_find(trk_context *context, const trk_model *model, const char *pattern,
                              trk_component *out);
void trk_component_clear(trk_component *component);

/* Does a row touch coordinates of the component, and does it touch others? */
bool trk_component_touches(const trk_component *component, const trk_rows *rows, int32_t row);
bool trk_component_leaves(const trk_component *component, const trk_rows *rows, int32_t row);

/* Name of a component coordinate, "frame.left.3.z". */
const char *trk_component_name(const trk_component *component, int32_t k);

#endif
