/* SPDX-License-Identifier: MIT */
/* Straight lines of beam elements, and static answers by a dense solver of their own. */
#ifndef TRK_TESTS_BEAMS_H
#define TRK_TESTS_BEAMS_H

#include <truckride/model.h>

enum {
    SUPPORT_ALL =
        TRK_FREE_X | TRK_FREE_Y | TRK_FREE_Z | TRK_FREE_ROLL | TRK_FREE_PITCH | TRK_FREE_YAW
};

typedef struct support_line {
    trk_beam_options section; /* ends are not used                                       */
    int32_t elements;
    double origin[3], axis[3];  /* [m] first node, [-] unit vector along the line          */
    double length;              /* [m] of all elements                                     */
    double offset[3];           /* [m] of the centres of gravity of the nodes              */
    int32_t first, inner, last; /* freedoms of the nodes, 0: clamped to the ground         */
} support_line;

/* A line of 2 m along x of a steel section 80 x 50 mm, Euler-Bernoulli, all nodes free. */
void support_line_init(support_line *line, int32_t elements);

/* Nodes "node.0", "node.1", ... and beams "beam.1", ...; every status is checked. */
trk_spec *support_line_spec(trk_context *context, const support_line *line);

/* Compiles and destroys the spec. */
trk_model *support_line_model(trk_context *context, trk_spec *spec, double gravity,
                              int32_t allow_free);

/* q of K q = load by Cholesky's method, q in place of the load; length coordinates. */
void support_deflect(trk_context *context, const trk_model *model, double *load);

#endif
