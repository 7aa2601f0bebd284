/* SPDX-License-Identifier: MIT */
/*
 * The step in modal coordinates: everything constant that a fast kernel needs, unpadded.
 *
 * With alpha_m = alpha_f = 0 and q = Phi y, where Phi^T M Phi = I and Phi^T K0 Phi = diag(lambda)
 * (NEWMARK.14), masses and linear springs leave one recurrence a mode. What couples the modes are
 * the `tables` links with a curve, with force g, and the `dampers` links with linear damping, with
 * force c e'. The latter are eliminated once and for all. A step from (y0, v0, a0), all modal, is
 *
 *     y~ = y0 + h v0 + h^2 (1/2 - beta) a0        v~ = v0 + h (1 - gamma) a0
 *     F  = weight + sum_k height_k u_k + sum_k port_k p_k
 *     v_f = v~ + kappa s^-1 (F - lambda y~)                                     (NEWMARK.15)
 *
 * the modal velocity were there no forces but those of masses and springs, kappa = gamma h,
 * s = 1 + beta h^2 lambda; then, u and u' at the end of the step,
 *
 *     x_d = W_d v_f - G_d u'              rates of the damped links without damping or curves
 *     f_d = A x_d                         their forces without curves
 *     x_f = W' v_f - G' u'                rates of the links with curves were g zero
 *     x   = x_f - kappa D g               rates                                  (NEWMARK.16)
 *     e   = W_p (y~ - r v~) + r x - G_p (u - r u')        elongations, r = beta h / gamma
 *     g   = law(e, x)                     solved for g: `tables` equations
 *     v1  = v_f - kappa s^-1 (W'^T g + W_d^T f_d)                                (NEWMARK.17)
 *     a1  = (v1 - v~) / kappa             y1 = y~ + r (v1 - v~)
 *
 * g is only what the curves add (law.h): a link with a curve and with linear damping is in both
 * lists; its linear stiffness is in lambda. Both products use the same rows W' and W_d.
 *
 * The stepper packs these numbers for one trajectory, a
 * batch packs those of many variants side by side.
 */
#ifndef TRK_NEWMARK_MODAL_H
#define TRK_NEWMARK_MODAL_H

#include "model/modal_basis.h"
#include <truckride/newmark.h>

/* A link with a curve; the laws are those of the model. */
typedef struct trk_modal_table {
    int32_t link;            /* 0-based link of the model                                      */
    const trk_link_law *law; /* borrowed: g = a_s spring(e + e_0) + a_d damper(x) - rest       */
} trk_modal_table;

/* All matrices row-major, rows as named; lengths in elements. */
typedef struct trk_modal_form {
    trk_context *context;
    double *block;   /* memory of all arrays of doubles here              */
    int32_t n;       /* modes = coordinates                               */
    int32_t tables;  /* links with a curve, in the order of the model     */
    int32_t dampers; /* links with linear damping, in that order          */
    int32_t roads, ports;
    double h, beta, gamma;  /* of the step                                       */
    double kappa, r;        /* gamma h, beta h / gamma                           */
    double *phi;            /* Phi, coordinate x mode: q = Phi y                 */
    double *phi_inverse;    /* Phi^T M, mode x coordinate: y = Phi^T M q         */
    double *lambda;         /* n, >= 0                                           */
    double *inverse;        /* s^-1, n                                           */
    double *table_rows;     /* W_p = B_p Phi, tables x n                         */
    double *damper_rows;    /* W_d = B_d Phi, dampers x n                        */
    double *reduced_rows;   /* W', tables x n                                    */
    double *damping;        /* A, dampers x dampers, symmetric                   */
    double *coupling;       /* D, tables x tables, symmetric                     */
    double *table_road;     /* G_p, tables x roads                               */
    double *damper_road;    /* G_d, dampers x roads                              */
    double *reduced_road;   /* G', tables x roads                                */
    double *height_force;   /* of one metre of road, roads x n                   */
    double *port_force;     /* of one newton, ports x n                          */
    double *weight;         /* n                                                 */
    trk_modal_table *table; /* tables                                            */
    int32_t *damper_link;   /* dampers: 0-based links of the model               */
} trk_modal_form;

/*
 * Form the arrays above. *out is NULL with TRK_OK if this form does not exist: alpha_m or
 * alpha_f is not zero, or a link has a negative linear stiffness or damping. Dense, n^3: meant
 * for up to about 64 coordinates; the caller decides. The options have been read and checked.
 */
trk_status trk_modal_form_create(trk_context *context, const trk_model *model,
                                 const trk_newmark_options *options, trk_modal_form **out);
void trk_modal_form_destroy(trk_modal_form *form);

#endif
