/* SPDX-License-Identifier: MIT */
/**
 * @file  truckride/model.h
 * @brief A compiled vehicle: rows, matrices, static equilibrium.
 *
 * Compiling numbers the coordinates q (body by body, in the order x, y, z, roll,
 * pitch, yaw) and writes every link as one sparse row over them:
 *
 *     e = B q - G u                                                   (MODEL.1)
 *     M q'' + B^T f(e, e') = P p + w                                  (MODEL.2)
 *     M = A^T diag(m) A                                               (MODEL.3)
 *
 * with road heights u, loads p on the force ports, weight w, and inertia rows A
 * of the bodies, point masses and beams. Beams add rows to B behind those of the links; what is
 * told "by link" leaves them out, matrices hold them. Around a state,
 * K = B^T diag(df/de) B and C = B^T diag(df/de') B                    (MODEL.4).
 *
 * Gravity. Without (the default) q is measured from static equilibrium: whatever
 * force the links carry at q = 0 is balanced by the weight, and only the change
 * of force acts. With gravity, q is measured from the drawn position, the weight
 * acts, and compiling finds the static equilibrium.
 *
 * A model is immutable and may be shared by any number of threads.
 */
#ifndef TRUCKRIDE_MODEL_H
#define TRUCKRIDE_MODEL_H

#include <truckride/spec.h>

/** A compiled vehicle; immutable. */
typedef struct trk_model trk_model;

/** Standard gravity [m/s^2]. */
#define TRK_STANDARD_GRAVITY 9.80665

/** Options of trk_model_compile(). */
typedef struct trk_model_options {
    size_t  struct_size; /**< [byte] set by trk_model_options_init()                       */
    double  gravity;     /**< [m/s^2] downwards, >= 0; default 0: measure from equilibrium */
    int32_t allow_free;  /**< [-] 1 admits bodies that no chain of links ties to ground or road; default 0 */
} trk_model_options;

/** Set every field to its default. Call as trk_model_options_init(&o, sizeof o). */
TRK_API void trk_model_options_init(trk_model_options *options, size_t struct_size);

/**
 * Compile a spec. The spec may be changed or destroyed afterwards.
 *
 * @param options   NULL for no gravity
 * @param out_model owned by caller; NULL on failure
 * @retval TRK_E_ARGUMENT    a pointer is NULL
 * @retval TRK_E_OPTIONS     options come from a newer header and set an unknown field
 * @retval TRK_E_RANGE       gravity is negative or not finite; a lever arm, an inertia, a weight
 *                           or a force at rest leaves the range of numbers. The message names it.
 * @retval TRK_E_MODEL       no body; a coordinate without mass or inertia; a coordinate that
 *                           no link acts on; a body not tied to ground or road. The message
 *                           names it.
 * @retval TRK_E_SINGULAR    with gravity: nothing carries the weight along the coordinate named
 * @retval TRK_E_CONVERGENCE with gravity: no static equilibrium was found
 * @retval TRK_E_MEMORY      no memory
 */
TRK_API trk_status trk_model_compile(trk_context *context, const trk_spec *spec,
                                     const trk_model_options *options,
                                     trk_model **out_model) TRK_MUST_CHECK;

/** Free a model. NULL is allowed. */
TRK_API void trk_model_destroy(trk_model *model);

/** Name of the vehicle; owned by the model. */
TRK_API const char *trk_model_name(const trk_model *model);

/** Number of parts of a kind, coordinates included; 0 for an unknown kind. */
TRK_API int32_t trk_model_count(const trk_model *model, trk_part part);

/** Id of the part with that name, 0 if there is none. Coordinates are called "body.pitch". */
TRK_API int32_t trk_model_find(const trk_model *model, trk_part part, const char *name);

/** Name of a part, NULL if there is none; owned by the model. */
TRK_API const char *trk_model_part_name(const trk_model *model, trk_part part, int32_t id);

/** Unit of a coordinate ("m", "rad"), sensor, link force or port ("N", "N m"), road
 *  ("m"); NULL if there is no such part. Static storage. */
TRK_API const char *trk_model_unit(const trk_model *model, trk_part part, int32_t id);

/** Gravity the model was compiled with [m/s^2]. */
TRK_API double trk_model_gravity(const trk_model *model);

/** Place x [m] and y [m] of a road input, NULL skips one. @retval TRK_E_ARGUMENT no such road */
TRK_API trk_status trk_model_get_road_place(const trk_model *model, int32_t road, double *out_x,
                                            double *out_y) TRK_MUST_CHECK;

/**
 * Static equilibrium.
 *
 * @param out_q     [m, rad] coordinates, 0 without gravity; length coordinates; NULL to skip
 * @param out_force [N, N m] force of every link, minus the tire load for a tire (an axle load
 *                  is minus the sum over its tires);
 *                  length links; NULL to skip
 */
TRK_API void trk_model_get_static(const trk_model *model, double *out_q, double *out_force);

/** Mass matrix M of (MODEL.3) [kg, kg m, kg m^2], row-major, coordinates x coordinates. */
TRK_API void trk_model_get_mass(const trk_model *model, double *out_mass);

/**
 * Tangent damping C and stiffness K of (MODEL.4), row-major, coordinates x coordinates. Laws with
 * memory stand at rest at q: friction sticks, and no air flows (LAW.6).
 *
 * @param q             [m, rad] state to linearise about; NULL for static equilibrium
 * @param v             [m/s, rad/s] NULL for rest
 * @param out_damping   [N s/m, N s, N m s/rad] NULL to skip
 * @param out_stiffness [N/m, N, N m/rad] NULL to skip
 */
TRK_API void trk_model_get_tangent(const trk_model *model, const double *q, const double *v,
                                   double *out_damping, double *out_stiffness);

/**
 * Row of B and of G for one link (MODEL.1).
 *
 * @param out_b [-, m] length coordinates
 * @param out_g [-]    length road inputs; NULL to skip
 * @retval TRK_E_ARGUMENT a pointer is NULL or there is no such link
 */
TRK_API trk_status trk_model_get_link_row(const trk_model *model, int32_t link, double *out_b,
                                          double *out_g) TRK_MUST_CHECK;

/**
 * Row over the coordinates of a force port (a column of P) or of a sensor of a body.
 *
 * @param part    TRK_PART_PORT or TRK_PART_SENSOR
 * @param out_row [-, m] length coordinates; of the link for a sensor of a link
 * @retval TRK_E_ARGUMENT a pointer is NULL, or there is no such part
 */
TRK_API trk_status trk_model_get_row(const trk_model *model, trk_part part, int32_t id,
                                     double *out_row) TRK_MUST_CHECK;

/**
 * Force f of every link [N, N m] at given elongation and rate (SPEC.3), as it acts
 * in (MODEL.2): without gravity less the force at rest. The memory of laws is that of a link
 * that has stood at this elongation for long (LAW.5): friction carries nothing, air is in balance.
 *
 * @param e         [m, rad] length links
 * @param rate      [m/s, rad/s] length links
 * @param out_force [N, N m] length links
 */
TRK_API void trk_model_get_link_force(const trk_model *model, const double *e, const double *rate,
                                      double *out_force);

#endif
