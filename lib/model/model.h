/* SPDX-License-Identifier: MIT */
/* Inside of a compiled model: rows, laws, names. Read-only after compiling. */
#ifndef TRK_MODEL_MODEL_H
#define TRK_MODEL_MODEL_H

#include "base/names.h"
#include "law/link_law.h"
#include "system/rows.h"
#include <truckride/model.h>

enum {
    TRK_FREEDOMS = 6,               /* x, y, z, roll, pitch, yaw of a body           */
    TRK_MODEL_PARTS = TRK_PART_BEAM /* kinds of named parts of a model are 1 .. this */
};

struct trk_model {
    trk_context *context;
    char *name;
    double gravity;                       /* [m/s^2]                               */
    trk_names names[TRK_MODEL_PARTS + 1]; /* by trk_part                           */
    int32_t n;                            /* coordinates                           */
    int32_t (*coordinate)[TRK_FREEDOMS];  /* by body: 0-based coordinate or -1     */
    bool *is_rotation;                    /* by coordinate                         */
    trk_rows inertia;                     /* A of (MODEL.3)                        */
    double *mass;                         /* m of (MODEL.3), by row of A           */
    int64_t mass_capacity;
    double *weight;                      /* w of (MODEL.2) [N, N m], length n     */
    trk_rows links;                      /* B of (MODEL.1)                        */
    trk_rows roads;                      /* G of (MODEL.1), a row a link          */
    trk_link_law *laws;                  /* by link                               */
    trk_motion *link_motion;             /* by named link                         */
    int32_t *link_beam;                  /* by link without a name: its beam's id */
    int32_t nonlinear_count, *nonlinear; /* 0-based links with a curve or a law   */
    int32_t *memory; /* by link: first of its doubles of memory; length links + 1, the last is
                        the number of all                                         */
    trk_rows ports;  /* P^T of (MODEL.2), a row a port        */
    trk_motion *port_motion;       /* by port                               */
    trk_rows sensors;              /* a row a sensor; empty if of a link    */
    trk_quantity *sensor_quantity; /* by sensor                             */
    trk_motion *sensor_motion;     /* by sensor                             */
    int32_t *sensor_link;          /* by sensor: 0-based link, -1: a body's */
    double *road_x, *road_y;       /* by road input [m]                     */
    double *static_q;              /* length n                              */
    double *static_force;          /* by link [N, N m]                      */
};

/* Compile steps, in this order; each returns with the message recorded. */
trk_status trk_model_build(trk_model *model, const trk_spec *spec);
trk_status trk_model_check_numbers(const trk_model *model);
trk_status trk_model_check_ties(const trk_model *model, const trk_spec *spec);
trk_status trk_model_check_mass(const trk_model *model);
trk_status trk_model_solve_static(trk_model *model);

/* First link with a law of its own, 0-based; -1: none. */
int32_t trk_model_find_law(const trk_model *model);

/* The named links come first among the rows of B, those of beams follow without a name. */
static inline int32_t trk_model_named_links(const trk_model *model)
{
    return model->names[TRK_PART_LINK].count;
}

/* Name of a link, or of the beam that has this row; *out_word "link" or "beam". 0-based. */
const char *trk_model_link_name(const trk_model *model, int32_t link, const char **out_word);

/* Tangents of one link at state (q, v), NULL for static equilibrium and rest, road level. */
void trk_model_link_tangent(const trk_model *model, int32_t link, const double *q, const double *v,
                            double *out_stiffness, double *out_damping);

/*
 * The link to blame when a matrix with link factors s is not positive definite at a
 * 0-based coordinate: the one that takes most from that diagonal entry, else from
 * any. -1: none takes anything.
 */
int32_t trk_model_blame(const trk_model *model, const double *s, int32_t coordinate);

/* Sentence and status TRK_E_SINGULAR for a matrix `what` that failed at a coordinate. */
trk_status trk_model_fail_singular(trk_context *context, const trk_model *model, const char *what,
                                   const double *s, int32_t coordinate);

#endif
