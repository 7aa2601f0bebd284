/* SPDX-License-Identifier: MIT */
/**
 * @file  truckride/spec.h
 * @brief Describe a vehicle: bodies, links, road inputs, force ports, sensors.
 *
 * A spec is a mutable description in the user's words. trk_model_compile() turns
 * it into equations; nothing is derived by hand. Everything has a name, unique
 * among parts of its kind, and an id counted from 1 in order of adding.
 *
 * Points are given in the vehicle's axes in its drawn position [m]. Rotations are
 * small: a point p of a body with centre of gravity cg moves by
 *
 *     u(p) = u_cg + theta x (p - cg)                                  (SPEC.1)
 *
 * A link has the elongation and the force
 *
 *     e = d . (u_to - u_from)                                         (SPEC.2)
 *     f = k e + c e' + a_s s(e + e_0) + a_d g(e') + law(e, e', z)     (SPEC.3)
 *
 * with direction d, stiffness k, damping c, spring curve s, damper curve g and
 * their scales, and a law of its own (law.h); f > 0 pulls the two ends together. u_from is zero on the ground
 * and (0, 0, u) on a road input of height u.
 */
#ifndef TRUCKRIDE_SPEC_H
#define TRUCKRIDE_SPEC_H

#include <truckride/law.h>

/** The description of a vehicle. */
typedef struct trk_spec trk_spec;

/** Kinds of named parts. */
typedef int32_t trk_part;
enum {
    TRK_PART_BODY       = 1, /**< rigid body                                     */
    TRK_PART_LINK       = 2, /**< spring and damper between two points           */
    TRK_PART_ROAD       = 3, /**< road input, a height u(t) under a tire         */
    TRK_PART_PORT       = 4, /**< point and direction where a load p(t) acts     */
    TRK_PART_SENSOR     = 5, /**< what a run records                             */
    TRK_PART_MASS       = 6, /**< point mass fixed to a body                     */
    TRK_PART_COORDINATE = 7, /**< coordinate of a compiled model, "cab.pitch"    */
    TRK_PART_BEAM       = 8  /**< beam between two bodies, with stiffness and mass */
};

/** Coordinates that a body may own; the others are fixed. Add them up. */
enum {
    TRK_FREE_X     = 1,  /**< forward */
    TRK_FREE_Y     = 2,  /**< left    */
    TRK_FREE_Z     = 4,  /**< up      */
    TRK_FREE_ROLL  = 8,  /**< about x */
    TRK_FREE_PITCH = 16, /**< about y, nose down positive */
    TRK_FREE_YAW   = 32  /**< about z */
};

/** Translation of a point along a direction, or rotation of a body about it. */
typedef int32_t trk_motion;
enum { TRK_MOTION_TRANSLATION = 0, TRK_MOTION_ROTATION = 1 };

/** Options of trk_spec_add_body(). */
typedef struct trk_body_options {
    size_t  struct_size;   /**< [byte] set by trk_body_options_init()                        */
    int32_t freedoms;      /**< [-] sum of TRK_FREE_...; default TRK_FREE_Z                  */
    double  mass;          /**< [kg] >= 0; compiling needs mass on every free translation,
                                from here, point masses or beams; default 0                  */
    double  inertia[3];    /**< [kg m^2] about x, y, z through cg, >= 0, likewise; default 0  */
    double  cg[3];         /**< [m] centre of gravity in the drawn position; default 0       */
} trk_body_options;

/** Options of trk_spec_add_link(). */
typedef struct trk_link_options {
    size_t           struct_size;   /**< [byte] set by trk_link_options_init()               */
    trk_motion       motion;        /**< [-] rotation makes an anti-roll bar; default translation */
    int32_t          from_body;     /**< [-] body id; 0 (default): ground, or from_road       */
    int32_t          from_road;     /**< [-] road id, with from_body 0; default 0: none       */
    int32_t          to_body;       /**< [-] body id; 0 is the ground                         */
    double           from_point[3]; /**< [m] not used on ground and road; default 0           */
    double           to_point[3];   /**< [m] default 0                                        */
    double           direction[3];  /**< [-] any length > 0; default (0, 0, 1)                */
    double           stiffness;     /**< [N/m or N m/rad] k; may be negative; default 0       */
    double           damping;       /**< [N s/m or N m s/rad] c >= 0; default 0               */
    const trk_curve *spring_curve;  /**< [N over m, or N m over rad] s, copied; default NULL  */
    const trk_curve *damper_curve;  /**< [N over m/s, or N m over rad/s] g, copied; default NULL */
    double           spring_scale;  /**< [-] a_s >= 0; default 1                              */
    double           damper_scale;  /**< [-] a_d >= 0; default 1                              */
    double           spring_offset; /**< [m or rad] e_0, place on the curve at e = 0; default 0 */
    const trk_law   *law;           /**< [-] acts beside the others, copied; default NULL: none */
} trk_link_options;

/**
 * Options of trk_spec_add_beam(): a straight beam (SPEC.6), by its stiffness and mass per length. The
 * functions trk_beam_options_...() fill them in from a section. Its axis runs from from_point to
 * to_point; `up` and the axis span the plane in which bending is about the section's y axis.
 */
typedef struct trk_beam_options {
    size_t  struct_size;      /**< [byte] set by trk_beam_options_init()                        */
    int32_t from_body;        /**< [-] body id; 0 (default): clamped to the ground              */
    int32_t to_body;          /**< [-] another body id; 0 (default) is the ground               */
    double  from_point[3];    /**< [m] fixed to from_body; default 0                            */
    double  to_point[3];      /**< [m] fixed to to_body; default 0                              */
    double  up[3];            /**< [-] z axis of the section, not along the beam; default (0, 0, 1) */
    double  axial;            /**< [N] E A >= 0; default 0                                      */
    double  torsion;          /**< [N m^2] G J >= 0; default 0                                  */
    double  bending_y;        /**< [N m^2] E I_y >= 0, deflection along z; default 0            */
    double  bending_z;        /**< [N m^2] E I_z >= 0, deflection along y; default 0            */
    double  shear_y;          /**< [N] G A k_y of deflection along y; default 0: no shear (Euler-Bernoulli), > 0 Timoshenko */
    double  shear_z;          /**< [N] G A k_z of deflection along z; default 0: no shear       */
    double  mass_per_length;  /**< [kg/m] >= 0; default 0                                       */
    double  inertia_x;        /**< [kg m] >= 0, rotary inertia per length about the axis; default 0 */
    double  inertia_y;        /**< [kg m] >= 0, about y of the section; default 0               */
    double  inertia_z;        /**< [kg m] >= 0, about z of the section; default 0               */
    double  mass_damping;     /**< [1/s] >= 0, alpha of Rayleigh damping C = alpha M + beta K; default 0 */
    double  stiffness_damping; /**< [s] >= 0, beta; default 0                                   */
} trk_beam_options;

/** What a sensor measures. */
typedef int32_t trk_quantity;
enum {
    TRK_QUANTITY_DISPLACEMENT = 0, /**< [m or rad] of a body point or body rotation */
    TRK_QUANTITY_VELOCITY     = 1, /**< [m/s or rad/s]                              */
    TRK_QUANTITY_ACCELERATION = 2, /**< [m/s^2 or rad/s^2]                          */
    TRK_QUANTITY_ELONGATION   = 3, /**< [m or rad] e of a link                      */
    TRK_QUANTITY_RATE         = 4, /**< [m/s or rad/s] e' of a link                 */
    TRK_QUANTITY_FORCE        = 5  /**< [N or N m] f of a link                      */
};

/** Options of trk_spec_add_sensor(). */
typedef struct trk_sensor_options {
    size_t       struct_size;  /**< [byte] set by trk_sensor_options_init()                  */
    trk_quantity quantity;     /**< [-] default TRK_QUANTITY_ACCELERATION                    */
    int32_t      body;         /**< [-] body id, for the first three quantities; default 0   */
    int32_t      link;         /**< [-] link id, for the last three; default 0               */
    trk_motion   motion;       /**< [-] of the body; default translation                     */
    double       point[3];     /**< [m] point of the body; default 0                         */
    double       direction[3]; /**< [-] any length > 0; default (0, 0, 1)                    */
} trk_sensor_options;

/** Options of trk_spec_add_port(). */
typedef struct trk_port_options {
    size_t     struct_size;  /**< [byte] set by trk_port_options_init()                      */
    int32_t    body;         /**< [-] body id the load acts on                               */
    trk_motion motion;       /**< [-] force or, with rotation, moment; default translation   */
    double     point[3];     /**< [m] point of the body; default 0                           */
    double     direction[3]; /**< [-] positive load acts this way, any length > 0; default (0, 0, 1) */
} trk_port_options;

/** What of a part is varied: by trk_spec_vary(), a calibration or a study. */
typedef int32_t trk_field;
enum {
    TRK_FIELD_STIFFNESS    = 1, /**< of a link: stiffness, scale of the spring curve, and of a tire or stops law */
    TRK_FIELD_DAMPING      = 2, /**< of a link: damping, scale of the damper curve, and of a tire law */
    TRK_FIELD_MASS         = 3, /**< of a body: mass                                      */
    TRK_FIELD_INERTIA      = 4, /**< of a body: moments of inertia about all axes         */
    TRK_FIELD_MASS_INERTIA = 5, /**< of a body: mass and moments of inertia               */
    TRK_FIELD_FRICTION     = 6, /**< of a link: friction forces of its leaf, friction or seal law */
    TRK_FIELD_APPROACH     = 7, /**< of a link: approach lengths of its leaf law          */
    TRK_FIELD_BENDING      = 8  /**< of a beam: all its stiffnesses                       */
};

/** What the number that varies a field means. */
typedef int32_t trk_meaning;
enum {
    TRK_MEANING_FACTOR = 0, /**< factor on the values of the spec                          */
    TRK_MEANING_VALUE  = 1  /**< the value itself, the same for all it acts on [N/m, N s/m, kg, ...] */
};

/** Set every field to its default. Call as trk_X_options_init(&o, sizeof o). */
TRK_API void trk_body_options_init(trk_body_options *options, size_t struct_size);
TRK_API void trk_link_options_init(trk_link_options *options, size_t struct_size);
TRK_API void trk_beam_options_init(trk_beam_options *options, size_t struct_size);
TRK_API void trk_sensor_options_init(trk_sensor_options *options, size_t struct_size);
TRK_API void trk_port_options_init(trk_port_options *options, size_t struct_size);

/**
 * Create an empty spec.
 *
 * @param name     how messages call the vehicle; copied
 * @param out_spec owned by caller; NULL on failure
 * @retval TRK_E_ARGUMENT a pointer is NULL
 * @retval TRK_E_MEMORY   no memory
 */
TRK_API trk_status trk_spec_create(trk_context *context, const char *name,
                                   trk_spec **out_spec) TRK_MUST_CHECK;

/** Copy a spec into a context (which may be another one). Errors as trk_spec_create(). */
TRK_API trk_status trk_spec_copy(trk_context *context, const trk_spec *spec,
                                 trk_spec **out_spec) TRK_MUST_CHECK;

/** Free a spec. NULL is allowed. */
TRK_API void trk_spec_destroy(trk_spec *spec);

/** Name of the vehicle; owned by the spec. */
TRK_API const char *trk_spec_name(const trk_spec *spec);

/**
 * Add a rigid body.
 *
 * @param name     not empty, at most 127 characters, not used by another body; copied
 * @param options  copied
 * @param out_body receives the id; NULL to skip
 * @retval TRK_E_ARGUMENT a pointer is NULL, or freedoms has an unknown bit or is 0
 * @retval TRK_E_OPTIONS  options come from a newer header and set an unknown field
 * @retval TRK_E_RANGE    a value is not finite or negative
 * @retval TRK_E_NAME     the name is empty, too long or taken
 * @retval TRK_E_MEMORY   no memory
 */
TRK_API trk_status trk_spec_add_body(trk_spec *spec, const char *name,
                                     const trk_body_options *options,
                                     int32_t *out_body) TRK_MUST_CHECK;

/**
 * Fix a point mass to a body: an engine, a fuel tank. It adds inertia about the
 * body's coordinates and, under gravity, weight.
 *
 * @param body     id of the body
 * @param mass     [kg] > 0
 * @param point    [m] length 3
 * @param out_mass receives the id; NULL to skip
 * Errors as trk_spec_add_body().
 */
TRK_API trk_status trk_spec_add_mass(trk_spec *spec, const char *name, int32_t body, double mass,
                                     const double *point, int32_t *out_mass) TRK_MUST_CHECK;

/**
 * Add a road input: a height u(t) [m] and its rate, imposed from outside.
 *
 * @param x        [m] place along the vehicle, used for the delay between axles
 * @param y        [m] place across the vehicle, > 0 on the left
 * @param out_road receives the id; NULL to skip
 * Errors as trk_spec_add_body().
 */
TRK_API trk_status trk_spec_add_road(trk_spec *spec, const char *name, double x, double y,
                                     int32_t *out_road) TRK_MUST_CHECK;

/**
 * Add a link.
 *
 * @retval TRK_E_ARGUMENT an id does not exist, both ends are the same or fixed, or a
 *                        torsional link ends on a road
 * @retval TRK_E_RANGE    a value is not finite or out of its range, or the direction is zero
 * Further arguments and errors as trk_spec_add_body().
 */
TRK_API trk_status trk_spec_add_link(trk_spec *spec, const char *name,
                                     const trk_link_options *options,
                                     int32_t *out_link) TRK_MUST_CHECK;

/**
 * Add a beam. Its two bodies may be nodes without mass of their own, if the beam gives them some.
 *
 * @retval TRK_E_ARGUMENT an id does not exist, or both ends are one body or the ground
 * @retval TRK_E_RANGE    a value is not finite or negative, the length is zero, or `up` runs along the beam
 * Further arguments and errors as trk_spec_add_body().
 */
TRK_API trk_status trk_spec_add_beam(trk_spec *spec, const char *name,
                                     const trk_beam_options *options,
                                     int32_t *out_beam) TRK_MUST_CHECK;

/** Add a force port. Arguments and errors as trk_spec_add_link(). */
TRK_API trk_status trk_spec_add_port(trk_spec *spec, const char *name,
                                     const trk_port_options *options,
                                     int32_t *out_port) TRK_MUST_CHECK;

/** Add a sensor. Arguments and errors as trk_spec_add_link(). */
TRK_API trk_status trk_spec_add_sensor(trk_spec *spec, const char *name,
                                       const trk_sensor_options *options,
                                       int32_t *out_sensor) TRK_MUST_CHECK;

/**
 * Read a part back into a struct whose struct_size is set (by its init function).
 * Curves in it are owned by the spec until the part is changed.
 * @retval TRK_E_ARGUMENT a pointer is NULL or the id does not exist
 * @retval TRK_E_OPTIONS  struct_size is not set
 */
TRK_API trk_status trk_spec_get_body(const trk_spec *spec, int32_t body,
                                     trk_body_options *out_options) TRK_MUST_CHECK;
TRK_API trk_status trk_spec_get_link(const trk_spec *spec, int32_t link,
                                     trk_link_options *out_options) TRK_MUST_CHECK;
TRK_API trk_status trk_spec_get_beam(const trk_spec *spec, int32_t beam,
                                     trk_beam_options *out_options) TRK_MUST_CHECK;
TRK_API trk_status trk_spec_get_sensor(const trk_spec *spec, int32_t sensor,
                                       trk_sensor_options *out_options) TRK_MUST_CHECK;
TRK_API trk_status trk_spec_get_port(const trk_spec *spec, int32_t port,
                                     trk_port_options *out_options) TRK_MUST_CHECK;

/**
 * Read a road input back.
 * @param out_x [m] NULL to skip
 * @param out_y [m] NULL to skip
 * @retval TRK_E_ARGUMENT spec is NULL or the id does not exist
 */
TRK_API trk_status trk_spec_get_road(const trk_spec *spec, int32_t road, double *out_x,
                                     double *out_y) TRK_MUST_CHECK;

/**
 * Read a point mass back.
 * @param out_body  NULL to skip
 * @param out_mass  [kg] NULL to skip
 * @param out_point [m] length 3; NULL to skip
 * @retval TRK_E_ARGUMENT spec is NULL or the id does not exist
 */
TRK_API trk_status trk_spec_get_mass(const trk_spec *spec, int32_t mass, int32_t *out_body,
                                     double *out_mass, double *out_point) TRK_MUST_CHECK;

/** Replace the options of a part; on failure it stays as it was. Errors as the add functions. */
TRK_API trk_status trk_spec_set_body(trk_spec *spec, int32_t body,
                                     const trk_body_options *options) TRK_MUST_CHECK;
TRK_API trk_status trk_spec_set_beam(trk_spec *spec, int32_t beam,
                                     const trk_beam_options *options) TRK_MUST_CHECK;
TRK_API trk_status trk_spec_set_link(trk_spec *spec, int32_t link,
                                     const trk_link_options *options) TRK_MUST_CHECK;

/**
 * Multiply or replace a field of all parts whose name matches a pattern. All or nothing.
 * A value needs a single number to replace: not a spring or damper curve, not
 * TRK_FIELD_INERTIA.
 *
 * @param pattern   name of the link or body; '*' stands for any text: "front_*_tire"
 * @param value     [- or unit of the field] the factor or the value, by meaning
 * @param out_count receives the number of parts that matched; NULL to skip
 * @retval TRK_E_ARGUMENT a pointer is NULL, there is no such field or meaning
 * @retval TRK_E_RANGE    value is not finite, or what comes out is out of range for the part
 * @retval TRK_E_NAME     nothing matches the pattern
 * @retval TRK_E_MODEL    a part that matches has nothing there to scale, or not one number to replace
 */
TRK_API trk_status trk_spec_vary(trk_spec *spec, trk_field field, const char *pattern,
                                 trk_meaning meaning, double value,
                                 int32_t *out_count) TRK_MUST_CHECK;

/** Number of parts of a kind; 0 for an unknown kind. */
TRK_API int32_t trk_spec_count(const trk_spec *spec, trk_part part);

/** Id of the part with that name, 0 if there is none. */
TRK_API int32_t trk_spec_find(const trk_spec *spec, trk_part part, const char *name);

/** Name of a part, NULL if there is none; owned by the spec. */
TRK_API const char *trk_spec_part_name(const trk_spec *spec, trk_part part, int32_t id);

#endif
