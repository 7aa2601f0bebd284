/* SPDX-License-Identifier: MIT */
/**
 * @file  truckride/law.h
 * @brief Force laws beyond springs, dampers and curves: contact, stops, friction, air.
 *
 * A law gives the force f [N, N m] of a link from its elongation e and rate v = e', both positive
 * in extension, and from what it remembers, z. Given to a link (trk_link_options.law) it acts beside
 * the link's stiffness, damping and curves. A law is a pure function: a time step tries as often as
 * it likes from the memory of the last good step and commits once.
 *
 *  | law        | memory              | for                                                     |
 *  |------------|---------------------|---------------------------------------------------------|
 *  | tire       | none                | tire that lifts off the road                            |
 *  | stops      | none                | bump and rebound stop                                   |
 *  | leaf       | friction force      | inter-leaf friction of a leaf spring                    |
 *  | friction   | friction force      | dry friction: stick and slip                            |
 *  | air spring | mass of air         | bellows, with or without an auxiliary volume            |
 *  | seal       | none                | friction of damper and cylinder seals (Stribeck)        |
 *
 * Where a model is linearised (modes, frequency response), a law with memory stands at rest:
 * friction sticks, and no air flows. A law is immutable and may be shared by threads.
 */
#ifndef TRUCKRIDE_LAW_H
#define TRUCKRIDE_LAW_H

#include <truckride/curve.h>

/** A force law; immutable. */
typedef struct trk_law trk_law;

/** Kinds of laws. */
typedef int32_t trk_law_kind;
enum {
    TRK_LAW_TIRE       = 1, /**< trk_law_create_tire()       */
    TRK_LAW_STOPS      = 2, /**< trk_law_create_stops()      */
    TRK_LAW_LEAF       = 3, /**< trk_law_create_leaf()       */
    TRK_LAW_FRICTION   = 4, /**< trk_law_create_friction()   */
    TRK_LAW_AIR_SPRING = 5, /**< trk_law_create_air_spring() */
    TRK_LAW_SEAL       = 6  /**< trk_law_create_seal()       */
};

/**
 * Tire in contact with the road or off it. With the deflection d = d_0 - e, d_0 that of the preload,
 * and the spring's force s(d) = k d + k_2 d^2, 0 for d < 0:
 *
 *     f = -(s - max(-s, min(s, c e')))                                     (LAW.10)
 *
 * The damper's force is at most the spring's: the tire never pulls, and the force does not jump
 * where it lands.
 */
typedef struct trk_tire_options {
    size_t struct_size; /**< [byte] set by trk_tire_options_init()                           */
    double stiffness;   /**< [N/m] k >= 0, > 0 unless stiffening is; default 0               */
    double stiffening;  /**< [N/m^2] k_2 >= 0; default 0                                     */
    double damping;     /**< [N s/m] c >= 0; default 0                                       */
    double preload;     /**< [N] >= 0, load at e = 0: the static load of a model without gravity,
                             0 where gravity finds it; default 0                             */
} trk_tire_options;

/** Bump and rebound stop (LAW.11): no force within the clearances, beyond them that of a stiffness and a curve. */
typedef struct trk_stops_options {
    size_t           struct_size;       /**< [byte] set by trk_stops_options_init()             */
    double           bump_clearance;    /**< [m or rad] >= 0, compression at which the bump stop touches; default 0 */
    double           bump_stiffness;    /**< [N/m or N m/rad] >= 0; default 0                   */
    const trk_curve *bump_curve;        /**< [N over m, or N m over rad] force over compression of the stop,
                                             >= 0, 0 at 0, copied; default NULL                 */
    double           rebound_clearance; /**< [m or rad] >= 0, extension at which the rebound stop touches; default 0 */
    double           rebound_stiffness; /**< [N/m or N m/rad] >= 0; default 0                   */
    const trk_curve *rebound_curve;     /**< [N over m, or N m over rad] as bump_curve; default NULL */
} trk_stops_options;

/**
 * Inter-leaf friction of a leaf spring (LAW.12): a force r that approaches the half-width R of the
 * hysteresis exponentially over the distance beta, however long the steps. The spring itself is the
 * link's stiffness or curve.
 *
 *     dr/|de| = (R(e) sign(e') - r) / beta,   R(e) = max(R_0, friction - friction_slope e)
 *
 * R_0 = friction_slope max(0, approach_rebound - approach_bump) / 2: below it friction could give
 * energy.
 *
 * Source: P. S. Fancher, R. D. Ervin, C. C. MacAdam, C. B. Winkler, SAE Paper 800905 (1980).
 */
typedef struct trk_leaf_options {
    size_t struct_size;      /**< [byte] set by trk_leaf_options_init()                        */
    double friction;         /**< [N or N m] R at e = 0, > 0, >= R_0; default 0, must be set    */
    double friction_slope;   /**< [N/m or N m/rad] >= 0, growth with compression; default 0          */
    double approach_bump;    /**< [m or rad] beta while compressing, > 0; default 0, must be set */
    double approach_rebound; /**< [m or rad] beta while extending; default 0: as approach_bump */
} trk_leaf_options;

/** Dry friction (LAW.13): elastic up to the friction force, then sliding at it. */
typedef struct trk_friction_options {
    size_t struct_size; /**< [byte] set by trk_friction_options_init()                       */
    double friction;    /**< [N or N m] > 0; default 0, must be set                          */
    double stiffness;   /**< [N/m or N m/rad] > 0 while it sticks; default 0, must be set    */
} trk_friction_options;

/**
 * Air spring (LAW.14): bellows with an effective area, polytropic change of state, and an auxiliary
 * volume behind a throttle:
 *
 *     f = -(p - p_ambient) A(e),   V = volume + area e + area_slope e^2 / 2,   A(e) = dV/de
 *
 * Without volume or area there is no force: a run that comes there does not converge.
 */
typedef struct trk_air_spring_options {
    size_t struct_size;      /**< [byte] set by trk_air_spring_options_init()                 */
    double pressure;         /**< [Pa] absolute, at e = 0, > ambient; default 0, must be set  */
    double volume;           /**< [m^3] of the bellows at e = 0, > 0; default 0, must be set  */
    double area;             /**< [m^2] effective area at e = 0, > 0; default 0, must be set  */
    double area_slope;       /**< [m] dA/de; default 0                                        */
    double exponent;         /**< [-] polytropic, 1 (isothermal) to 1.6; default 1.38         */
    double ambient;          /**< [Pa] > 0; default 101325                                    */
    double auxiliary_volume; /**< [m^3] >= 0; default 0: none                                 */
    double conductance;      /**< [kg/(s Pa)] of the throttle, >= 0; default 0: closed        */
    double temperature;      /**< [K] > 0, of the air at rest; default 293.15                 */
} trk_air_spring_options;

/** Friction of seals (LAW.15): Stribeck curve, smooth through zero. */
typedef struct trk_seal_options {
    size_t struct_size; /**< [byte] set by trk_seal_options_init()                           */
    double sliding;     /**< [N or N m] >= 0, friction at speed; default 0                   */
    double breakaway;   /**< [N or N m] >= sliding, at low speed; default 0: as sliding      */
    double stribeck;    /**< [m/s or rad/s] > 0, speed over which it falls from breakaway to sliding; default 0.1 */
    double creep;       /**< [m/s or rad/s] > 0, speed at which it is 0.76 of its height: tanh(1); default 0.001 */
} trk_seal_options;

/** Set every field to its default. Call as trk_X_options_init(&o, sizeof o). */
TRK_API void trk_tire_options_init(trk_tire_options *options, size_t struct_size);
TRK_API void trk_stops_options_init(trk_stops_options *options, size_t struct_size);
TRK_API void trk_leaf_options_init(trk_leaf_options *options, size_t struct_size);
TRK_API void trk_friction_options_init(trk_friction_options *options, size_t struct_size);
TRK_API void trk_air_spring_options_init(trk_air_spring_options *options, size_t struct_size);
TRK_API void trk_seal_options_init(trk_seal_options *options, size_t struct_size);

/**
 * Create a law.
 *
 * @param name    how messages call the law, "front leaf spring"; copied
 * @param options copied, curves too
 * @param out_law owned by caller; NULL on failure
 * @retval TRK_E_ARGUMENT a pointer is NULL
 * @retval TRK_E_OPTIONS  options come from a newer header and set an unknown field
 * @retval TRK_E_RANGE    a value is not finite or out of its range; the message names it
 * @retval TRK_E_MEMORY   no memory
 */
TRK_API trk_status trk_law_create_tire(trk_context *context, const char *name,
                                       const trk_tire_options *options,
                                       trk_law **out_law) TRK_MUST_CHECK;
TRK_API trk_status trk_law_create_stops(trk_context *context, const char *name,
                                        const trk_stops_options *options,
                                        trk_law **out_law) TRK_MUST_CHECK;
TRK_API trk_status trk_law_create_leaf(trk_context *context, const char *name,
                                       const trk_leaf_options *options,
                                       trk_law **out_law) TRK_MUST_CHECK;
TRK_API trk_status trk_law_create_friction(trk_context *context, const char *name,
                                           const trk_friction_options *options,
                                           trk_law **out_law) TRK_MUST_CHECK;
TRK_API trk_status trk_law_create_air_spring(trk_context *context, const char *name,
                                             const trk_air_spring_options *options,
                                             trk_law **out_law) TRK_MUST_CHECK;
TRK_API trk_status trk_law_create_seal(trk_context *context, const char *name,
                                       const trk_seal_options *options,
                                       trk_law **out_law) TRK_MUST_CHECK;

/** Copy a law into a context (which may be another one). Errors as the create functions. */
TRK_API trk_status trk_law_copy(trk_context *context, const trk_law *law,
                                trk_law **out_law) TRK_MUST_CHECK;

/** Free a law. NULL is allowed. */
TRK_API void trk_law_destroy(trk_law *law);

/** Kind of a law, 0 for NULL. */
TRK_API trk_law_kind trk_law_get_kind(const trk_law *law);

/** Name given at creation; owned by the law. */
TRK_API const char *trk_law_name(const trk_law *law);

/**
 * Read the parameters of a law back into a struct whose struct_size is set. Curves in it are owned by the law.
 * @retval TRK_E_ARGUMENT a pointer is NULL or the law is of another kind
 * @retval TRK_E_OPTIONS  struct_size is not set
 */
TRK_API trk_status trk_law_get_tire(const trk_law *law, trk_tire_options *out_options) TRK_MUST_CHECK;
TRK_API trk_status trk_law_get_stops(const trk_law *law, trk_stops_options *out_options) TRK_MUST_CHECK;
TRK_API trk_status trk_law_get_leaf(const trk_law *law, trk_leaf_options *out_options) TRK_MUST_CHECK;
TRK_API trk_status trk_law_get_friction(const trk_law *law, trk_friction_options *out_options) TRK_MUST_CHECK;
TRK_API trk_status trk_law_get_air_spring(const trk_law *law, trk_air_spring_options *out_options) TRK_MUST_CHECK;
TRK_API trk_status trk_law_get_seal(const trk_law *law, trk_seal_options *out_options) TRK_MUST_CHECK;

/**
 * Force of a law along a path, from rest at its first point: to look at a hysteresis loop. Between the
 * points e is straight; the force at a point is that with the rate with which it is reached.
 *
 * @param count     number of points
 * @param step      [s] > 0 from point to point
 * @param e         [m or rad] elongation, length count
 * @param out_force [N or N m] length count
 * @param out_lost  [J] energy dissipated up to the point (LAW.16), length count; NULL to skip
 * @retval TRK_E_ARGUMENT a pointer is NULL or count is below 1
 * @retval TRK_E_RANGE    a value is not finite, or the path leaves what the law can do (an air spring
 *                        without volume); the message names the point
 */
TRK_API trk_status trk_law_trace(trk_context *context, const trk_law *law, int64_t count, double step,
                                 const double *e, double *out_force,
                                 double *out_lost) TRK_MUST_CHECK;

#endif
