/* SPDX-License-Identifier: MIT */
/* Inside of a spec: arrays of options, in the order of their ids. */
#ifndef TRK_SPEC_SPEC_H
#define TRK_SPEC_SPEC_H

#include "base/base.h"
#include "base/names.h"
#include <truckride/spec.h>

enum {
    TRK_SPEC_PARTS = TRK_PART_BEAM, /* kinds of parts a spec holds are 1 .. this; no coordinates */
    TRK_NAME_LENGTH = 127           /* longest name, without the terminating 0  */
};

typedef struct trk_road_place {
    double x, y; /* [m] */
} trk_road_place;

typedef struct trk_point_mass {
    int32_t body;
    double mass;     /* [kg] */
    double point[3]; /* [m]  */
} trk_point_mass;

struct trk_spec {
    trk_context *context;
    char *name;
    trk_names names[TRK_SPEC_PARTS + 1]; /* by trk_part; [0] is empty */
    int64_t capacity[TRK_SPEC_PARTS + 1];
    trk_body_options *bodies;
    trk_link_options *links; /* their curves and laws are owned by the spec */
    trk_road_place *roads;
    trk_port_options *ports;
    trk_sensor_options *sensors;
    trk_point_mass *masses;
    trk_beam_options *beams;
};

/* Kind of part in words, "link". */
const char *trk_part_word(trk_part part);

/*
 * Add a part: the name, and room for its options in *array, whose place count - 1
 * is zero on return. Nothing may fail afterwards.
 */
trk_status trk_spec_append(trk_spec *spec, trk_part part, const char *name, void **array,
                           size_t element_size);

/* Take away the bodies or beams that were added last, so that `count` are left. */
void trk_spec_shorten(trk_spec *spec, trk_part part, int32_t count);

/* Checks of one value or id; `what` and `name` say where in the message. */
trk_status trk_check_finite(trk_context *context, const char *what, const char *name,
                            const char *field, int32_t count, const double *values);
trk_status trk_check_not_negative(trk_context *context, const char *what, const char *name,
                                  const char *field, double value);
trk_status trk_check_direction(trk_context *context, const char *what, const char *name,
                               const double *direction);
/* Values of a link that any change of it must keep; all of a body. */
trk_status trk_check_link_values(trk_context *context, const char *name,
                                 const trk_link_options *link);
trk_status trk_check_body(trk_context *context, const char *name, const trk_body_options *body);
trk_status trk_check_beam_values(trk_context *context, const char *name,
                                 const trk_beam_options *beam);
trk_status trk_check_id(const trk_spec *spec, const char *what, const char *name, trk_part part,
                        int32_t id);

/* Unit axes x, y, z of a beam (SPEC.6); returns its length [m], *out_sine of the angle to `up`. */
double trk_beam_axes(const trk_beam_options *beam, double axes[3][3], double *out_sine);

#endif
