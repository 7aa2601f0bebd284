/* SPDX-License-Identifier: MIT */
/* Inside of a stepper. */
#ifndef TRK_NEWMARK_NEWMARK_H
#define TRK_NEWMARK_NEWMARK_H

#include "model/model.h"
#include "newmark/kernel.h"
#include "system/assembly.h"
#include <truckride/newmark.h>

/* Everything that a step replaces; two of them take turns. */
typedef struct trk_state {
    double *q, *v, *a;         /* length n                                             */
    double *height, *velocity; /* road at this time, length roads                      */
    double *force;             /* g of the non-linear links, length p                  */
    double *memory;            /* of their laws, as model->memory deals it out         */
    double *rest;              /* r(q, v, t) of (NEWMARK.1), length n; only if alpha_f */
} trk_state;

struct trk_newmark {
    trk_context *context;
    const trk_model *model;
    trk_newmark_options options;
    double start;             /* [s] time = start + taken * step                      */
    int64_t taken;            /* steps since the state was set                        */
    trk_state now, next;      /* now is behind if fast->is_ahead: trk_fast_settle()   */
    trk_assembly assembly;    /* holds the factors of S0 of (NEWMARK.4)               */
    double *block;            /* memory of all arrays of doubles here                 */
    double *load_row;         /* P p + w, length n                                    */
    double *residual;         /* length n                                             */
    double *link_factor;      /* of B^T diag(s) B in S0, length links                 */
    double force_scale;       /* largest link force of the last step, a lower bound [N, N m] */
    double force_floor;       /* rounding of the largest table force (NEWMARK.12) [N, N m] */
    int32_t p;                /* non-linear links                                     */
    int32_t *nonlinear_index; /* by link: place among the non-linear ones or -1       */
    trk_law_hint *hints;      /* p                                                    */
    double *influence;        /* Z = B_p S0^-1, p x n (NEWMARK.5)                     */
    double *coupling;         /* D = B_p S0^-1 B_p^T, p x p                           */
    double *e_free, *v_free;  /* state of those links were g zero, p                  */
    double *past[3];          /* g one, two and three steps ago, p                    */
    double *trial, *mismatch; /* Newton on g, p                                       */
    double *pull, *reach;     /* D times its correction, D g; p                       */
    double *root;             /* of the slopes, p                                     */
    double *slope;            /* t of (NEWMARK.7), p                                  */
    double *jacobian;         /* p x p                                                */
    trk_fast *fast;           /* a faster way for small systems (NEWMARK.13); NULL: none */
    trk_fast_kernel kernel;   /* its kernel; NULL: take the general way all the same  */
    trk_newmark_statistics statistics;
};

/*
 * Many steps in one call, with what every sensor needs recorded after each (see record.c).
 *
 * height, velocity: count x roads; load: count x ports, row-major; NULL is zeros. The result is
 * that of `count` calls of trk_newmark_step(), bit for bit. *out_taken: steps taken; fewer than
 * count only with a status, which is then that of the step that failed.
 *
 * out_rows NULL: nothing is recorded. Else count rows of trk_newmark_row_width() numbers each, 64
 * byte aligned, written for the steps taken: the raw state
 *
 *     row = (displacements, velocities, accelerations, forces g of the links with a curve)
 *
 * each part padded to whole cache lines, in coordinates of the stepper's own choice, modal or
 * physical, that do not change in its life. Sensors, and whatever else is linear in
 * the motion, are read by
 *
 *     sensor = on_row . row + on_height . u + on_velocity . u'
 *
 * with u, u' the road at the end of that step.
 */
trk_status trk_newmark_record(trk_newmark *stepper, int64_t count, const double *height,
                              const double *velocity, const double *load, double *out_rows,
                              int64_t *out_taken);

/* The step by solver, rows and laws, whatever the system. */
trk_status trk_newmark_step_general(trk_newmark *stepper, const double *height,
                                    const double *velocity, const double *load);

/* Numbers in a row: a multiple of 8. */
int64_t trk_newmark_row_width(const trk_newmark *stepper);

/* The raw state now, as trk_newmark_record() writes it: the row of step 0, for instance. */
void trk_newmark_get_row(const trk_newmark *stepper, double *out_row);

/*
 * The matrices above, a row a sensor: on_row is sensors x row width, on_height and on_velocity are
 * sensors x roads; all row-major.
 */
void trk_newmark_get_sensor_rows(const trk_newmark *stepper, double *out_on_row,
                                 double *out_on_height, double *out_on_velocity);

/* Ways to take a step. */
enum {
    TRK_KERNEL_GENERAL = 0,  /* any system: solver, laws and rows of the model */
    TRK_KERNEL_PORTABLE = 1, /* the others: small systems in modal coordinates */
    TRK_KERNEL_AVX2 = 2,
    TRK_KERNEL_AVX512 = 3
};

/*
 * Take that way from the next step on; for tests and measurements, as trk_newmark_create()
 * takes the fastest. false: this build, processor or system does not have it; nothing changes.
 */
bool trk_newmark_set_kernel(trk_newmark *stepper, int32_t kernel);

/* Set the fastest. */
void trk_newmark_choose_kernel(trk_newmark *stepper);

/*
 * Newton on the forces of the non-linear links (NEWMARK.6), from the start in
 * next.force. On success next.force is the answer. TRK_E_CONVERGENCE: the message is recorded.
 */
trk_status trk_newmark_solve_forces(trk_newmark *stepper);

/*
 * From mismatch and slope of the last evaluation: the correction d into trial, D d into pull. Returns
 * s(0) of (NEWMARK.21), >= 0 but for rounding; not finite: no correction. Slopes < 0 may be
 * replaced by 0.
 */
double trk_newmark_find_direction(trk_newmark *stepper);

/* Factor S0 = (1 - alpha_m) M + (1 - alpha_f) (gamma h C0 + beta h^2 K0) (NEWMARK.4). */
trk_status trk_newmark_factorize(trk_newmark *stepper);

/* Copy road and load if they are finite, loads into load_row as P p + w; else name the entry.
 * NULL is zeros. */
trk_status trk_newmark_take_inputs(trk_newmark *stepper, const double *height,
                                   const double *velocity, const double *load, trk_state *state);

/* Largest force of all links at a state. */
double trk_newmark_largest_force(const trk_newmark *stepper, const trk_state *state);

/* r := r - B^T (k e + c e') at a state. */
void trk_newmark_subtract_linear(const trk_newmark *stepper, const trk_state *state, double *r);

/* Elongation and rate of one link at a state. */
static inline double trk_newmark_elongation(const trk_newmark *stepper, const trk_state *state,
                                            int32_t link)
{
    return trk_rows_dot(&stepper->model->links, link, state->q) -
           trk_rows_dot(&stepper->model->roads, link, state->height);
}

static inline double trk_newmark_rate(const trk_newmark *stepper, const trk_state *state,
                                      int32_t link)
{
    return trk_rows_dot(&stepper->model->links, link, state->v) -
           trk_rows_dot(&stepper->model->roads, link, state->velocity);
}

/* Force k e + c e' of the linear part of a link at a state. */
static inline double trk_newmark_linear_force(const trk_newmark *stepper, const trk_state *state,
                                              int32_t link)
{
    const trk_link_law *law = &stepper->model->laws[link];
    double force = 0; /* a link may have a curve only */
    if (law->stiffness != 0)
        force += law->stiffness * trk_newmark_elongation(stepper, state, link);
    if (law->damping != 0)
        force += law->damping * trk_newmark_rate(stepper, state, link);
    return force;
}

#endif
