/* SPDX-License-Identifier: MIT */
/*
 * Adding many parts to a spec without asking after each: the first failure sticks
 * and turns all later calls into nothing.
 */
#ifndef TRK_VEHICLE_BUILDER_H
#define TRK_VEHICLE_BUILDER_H

#include "base/base.h"
#include <truckride/spec.h>

typedef struct trk_builder {
    trk_context *context;
    trk_spec *spec;
    trk_status status;
} trk_builder;

void trk_builder_begin(trk_builder *builder, trk_context *context, const char *name);

/* Hand the spec over, or destroy it if anything failed. Returns the status. */
trk_status trk_builder_end(trk_builder *builder, trk_spec **out_spec);

/* Names are printf formats, so that sides and ends can be written into them. */
int32_t trk_builder_body(trk_builder *builder, int32_t freedoms, double mass, const double *inertia,
                         const double *cg, const char *name, ...) TRK_PRINTF(6, 7);
int32_t trk_builder_road(trk_builder *builder, double x, double y, const char *name, ...)
    TRK_PRINTF(4, 5);
int32_t trk_builder_link(trk_builder *builder, const trk_link_options *link, const char *name, ...)
    TRK_PRINTF(3, 4);
void trk_builder_port(trk_builder *builder, int32_t body, const double *point, int axis,
                      const char *name, ...) TRK_PRINTF(5, 6);
/* Acceleration of a body point along axis 0 x, 1 y, 2 z. */
void trk_builder_accelerometer(trk_builder *builder, int32_t body, const double *point, int axis,
                               const char *name, ...) TRK_PRINTF(5, 6);
void trk_builder_force_sensor(trk_builder *builder, int32_t link, const char *name, ...)
    TRK_PRINTF(3, 4);

#endif
