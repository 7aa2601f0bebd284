/* SPDX-License-Identifier: MIT */
/**
 * @file  truckride/calibrate.h
 * @brief Fit parameters of a vehicle to measured eigenfrequencies, damping, peaks and curves.
 *
 * A calibration holds a copy of a spec, parameters p that act on its links and bodies,
 * and targets: measured values t_i with standard uncertainty s_i. It minimises
 *
 *     Q(p) = 1/2 sum w_i^2 ((y_i(p) - t_i) / s_i)^2,  lower <= p <= upper   (CALIBRATE.1)
 *
 * with NLopt, by a gradient method when every target has a gradient, derivative-free
 * when one is the peak or curve of a simulated run. It then judges the answer by itself: it
 * evaluates it again, checks that it is a minimum, which targets are met, which
 * parameters the targets determine at all, and how well. TRK_OK means: all targets
 * are met and all parameters are determined; anything else has a status of its own,
 * and the answer so far can be read all the same.
 *
 * The same calls give the same answer, bit by bit (limits of time apart).
 * Needs TRK_FEATURE_NLOPT and TRK_FEATURE_LAPACK.
 */
#ifndef TRUCKRIDE_CALIBRATE_H
#define TRUCKRIDE_CALIBRATE_H

#include <truckride/excitation.h>
#include <truckride/newmark.h>
#include <truckride/simulate.h>
#include <truckride/spectrum.h>

/** Parameters, targets and the last answer; owns a copy of the spec. */
typedef struct trk_calibration trk_calibration;

/** Options of trk_calibration_add_parameter(). */
typedef struct trk_parameter_options {
    size_t      struct_size; /**< [byte] set by trk_parameter_options_init()               */
    trk_meaning meaning;     /**< [-] default TRK_MEANING_FACTOR                           */
    int32_t     reserved;    /**< [-] must be 0                                            */
    double      start;       /**< [- or unit of the value] to begin with, > 0; default 1   */
    double      lower;       /**< [- or unit of the value] least, > 0; default 0.01        */
    double      upper;       /**< [- or unit of the value] largest, > lower; default 100   */
} trk_parameter_options;

/** Kinds of targets. */
typedef int32_t trk_target;
enum {
    TRK_TARGET_UNDAMPED_FREQUENCY = 1, /**< [Hz] of a mode without damping                        */
    TRK_TARGET_DAMPED_FREQUENCY   = 2, /**< [Hz] Im lambda / 2 pi of an oscillating damped mode   */
    TRK_TARGET_DAMPING_RATIO      = 3, /**< [-] of an oscillating damped mode                     */
    TRK_TARGET_PSD_PEAK           = 4, /**< [Hz] of the highest peak of a sensor's PSD in a band  */
    TRK_TARGET_PSD_CURVE          = 5, /**< [-] PSD of a sensor over frequency, compared by logarithm */
    TRK_TARGET_RESPONSE_CURVE     = 6  /**< [-] magnitude of a frequency response, road to sensor, by logarithm */
};

/** Options of trk_calibration_add_target(). */
typedef struct trk_target_options {
    size_t        struct_size;   /**< [byte] set by trk_target_options_init()                       */
    trk_target    kind;          /**< [-] default TRK_TARGET_UNDAMPED_FREQUENCY                     */
    double        value;         /**< [Hz or -] measured value, > 0; not used by curves             */
    double        uncertainty;   /**< [Hz or -] standard uncertainty s_i > 0 of the value, of the natural logarithm for curves; default 0: 1 % */
    double        weight;        /**< [-] w_i > 0; default 1                                        */
    const char   *coordinate;    /**< modes: the one with most energy in it, "front_axle.z"         */
    const double *shape;         /**< [m, rad] modes, instead of coordinate: the one most like it by MAC, length coordinates; copied */
    const char   *sensor;        /**< peaks and curves: name of the sensor                          */
    double        low;           /**< [Hz] peaks: lower end of the band; default 0                  */
    double        high;          /**< [Hz] peaks: upper end of the band; default 0: no end          */
    int64_t       count;         /**< [-] curves: number of points                                  */
    const double *frequency;     /**< [Hz] curves: rising, length count; copied                     */
    const double *magnitude;     /**< [unit^2/Hz or unit/m] curves: measured, > 0, length count; copied */
    const double *road_gain;     /**< [m] response: length roads; copied; NULL: 1 on all            */
} trk_target_options;

/** The run that peaks and PSD curves are taken from; needed by these targets only. */
typedef struct trk_run_options {
    size_t  struct_size;    /**< [byte] set by trk_run_options_init()                              */
    double  duration;       /**< [s] > 0; default 480                                              */
    double  step;           /**< [s] > 0; default 0.001                                            */
    int64_t segment_length; /**< [-] samples of a PSD segment; default 8192                        */
    double  overlap;        /**< [-] of segments, 0 <= overlap < 1; default 0.9, so that a sweep leaves no ripple                   */
} trk_run_options;

/** Options of trk_calibration_solve(). */
typedef struct trk_solve_options {
    size_t  struct_size;     /**< [byte] set by trk_solve_options_init()                           */
    int64_t max_evaluations; /**< [-] of the model in each start, >= 1; default 200                */
    double  max_time;        /**< [s] in all, > 0; default 0: no limit                             */
    int32_t starts;          /**< [-] starting points, the first is the given one; default 1       */
    int32_t seed;            /**< [-] of the further starting points; default 1                    */
    double  met;             /**< [-] a target is met within so many standard uncertainties, > 0; default 2 */
} trk_solve_options;

/** Set every field to its default. Call as trk_X_options_init(&o, sizeof o). */
TRK_API void trk_parameter_options_init(trk_parameter_options *options, size_t struct_size);
TRK_API void trk_target_options_init(trk_target_options *options, size_t struct_size);
TRK_API void trk_run_options_init(trk_run_options *options, size_t struct_size);
TRK_API void trk_solve_options_init(trk_solve_options *options, size_t struct_size);

/**
 * Create a calibration without parameters and targets.
 *
 * @param spec            copied; the factors of the parameters refer to its values
 * @param options         how its models are compiled; NULL for no gravity
 * @param out_calibration owned by caller; NULL on failure
 * @retval TRK_E_ARGUMENT    a pointer is NULL
 * @retval TRK_E_UNSUPPORTED this build has no NLopt or no LAPACK
 * Further errors as trk_model_compile().
 */
TRK_API trk_status trk_calibration_create(trk_context *context, const trk_spec *spec,
                                          const trk_model_options *options,
                                          trk_calibration **out_calibration) TRK_MUST_CHECK;

/** Free a calibration. NULL is allowed. */
TRK_API void trk_calibration_destroy(trk_calibration *calibration);

/**
 * Add a parameter, a factor. It does nothing until trk_calibration_act_on().
 *
 * @param name          not empty, not used by another parameter; copied
 * @param options       NULL for 1 within 0.01 to 100
 * @param out_parameter receives the id; NULL to skip
 * @retval TRK_E_ARGUMENT a pointer is NULL
 * @retval TRK_E_OPTIONS  options come from a newer header and set an unknown field
 * @retval TRK_E_RANGE    not 0 < lower <= start <= upper < infinity, or lower = upper
 * @retval TRK_E_NAME     the name is empty or taken
 * @retval TRK_E_MEMORY   no memory
 */
TRK_API trk_status trk_calibration_add_parameter(trk_calibration *calibration, const char *name,
                                                 const trk_parameter_options *options,
                                                 int32_t *out_parameter) TRK_MUST_CHECK;

/**
 * Let a parameter act: value = parameter^power * value of the spec, or, with
 * TRK_MEANING_VALUE, value = parameter^power. Several calls tie several parts to one
 * parameter; power 1 is usual, other powers tie them unequally. A value needs a single
 * number to replace: not a spring or damper curve, not TRK_FIELD_INERTIA.
 *
 * @param parameter id
 * @param pattern   name of the link or body; '*' stands for any text: "front_*_tire"
 * @param power     [-] finite, not 0
 * @param out_count receives the number of parts that matched; NULL to skip
 * @retval TRK_E_ARGUMENT a pointer is NULL, there is no such parameter or field
 * @retval TRK_E_RANGE    power is 0 or not finite
 * @retval TRK_E_NAME     nothing matches the pattern
 * @retval TRK_E_MODEL    a part that matches is already acted on in this field, or has nothing
 *                        there to scale
 * @retval TRK_E_MEMORY   no memory
 */
TRK_API trk_status trk_calibration_act_on(trk_calibration *calibration, int32_t parameter,
                                          trk_field field, const char *pattern, double power,
                                          int32_t *out_count) TRK_MUST_CHECK;

/**
 * Add a target.
 *
 * @param name       for the report; not empty, not used by another target; copied
 * @param out_target receives the id; NULL to skip
 * @retval TRK_E_ARGUMENT a pointer is NULL, an unknown kind, or what the kind needs is missing
 * @retval TRK_E_RANGE    a value is out of range
 * @retval TRK_E_NAME     the name is empty or taken, or there is no such coordinate or sensor
 * @retval TRK_E_MEMORY   no memory
 */
TRK_API trk_status trk_calibration_add_target(trk_calibration *calibration, const char *name,
                                              const trk_target_options *options,
                                              int32_t *out_target) TRK_MUST_CHECK;

/**
 * Give the run that PSD peaks and PSD curves are taken from.
 *
 * @param excitation borrowed
 * @param options    NULL for 480 s at 1 ms
 * @retval TRK_E_ARGUMENT a pointer is NULL, or the excitation does not fit the vehicle
 * @retval TRK_E_OPTIONS  options come from a newer header and set an unknown field
 * @retval TRK_E_RANGE    an option is out of range
 */
TRK_API trk_status trk_calibration_set_run(trk_calibration *calibration,
                                           const trk_excitation *excitation,
                                           const trk_run_options *options) TRK_MUST_CHECK;

/**
 * Values and, where there are gradients, derivatives of all targets at given parameters.
 *
 * @param parameter    [- or unit of the value] length parameters
 * @param out_value    [Hz or -] length trk_calibration_values(): one per target, for a curve
 *                     the logarithm of model over measurement at each point
 * @param out_jacobian [per unit of the parameter] values x parameters, row-major
 *                     (CALIBRATE.2, CALIBRATE.3); NULL to skip
 * @retval TRK_E_ARGUMENT    a pointer is NULL
 * @retval TRK_E_RANGE       a parameter is not finite or not > 0
 * @retval TRK_E_TARGET      no oscillating mode, or no peak in the band, for the target named
 * @retval TRK_E_UNSUPPORTED a Jacobian is asked for, but a target is taken from a run
 * Further errors as trk_model_compile(), trk_modes_create_damped() and trk_simulate().
 */
TRK_API trk_status trk_calibration_evaluate(trk_calibration *calibration,
                                            const double *parameter, double *out_value, double *out_jacobian) TRK_MUST_CHECK;

/** Number of values of trk_calibration_evaluate(): targets, a curve counting its points. */
TRK_API int32_t trk_calibration_values(const trk_calibration *calibration);

/**
 * Solve (CALIBRATE.1).
 *
 * When every target has a gradient and the answer would be TRK_OK, up to four short further
 * starts beside it look for a second answer (CALIBRATE.6). This finds most, not all; more
 * starts find more. max_evaluations holds for each of them; one evaluation at the start and
 * one to judge an answer come on top.
 *
 * @param options  NULL for one start and 200 evaluations
 * @param progress called at every evaluation with the fraction of those allowed; NULL for none
 * @param user     handed to progress; borrowed
 * @retval TRK_OK            every target is met, every parameter is determined
 * @retval TRK_E_ARGUMENT    calibration is NULL; no parameter, no target, or no run for a target
 *                           that needs one; a parameter acts on nothing
 * @retval TRK_E_TARGET      a minimum, but some target is not met there: out of reach, or in
 *                           contradiction to another; the message names the worst
 * @retval TRK_E_IDENTIFY    the targets leave a parameter undetermined; the message names it; or two
 *                           sets of parameters meet them
 * @retval TRK_E_LIMIT       evaluations or time ran out before a minimum was reached
 * @retval TRK_E_CONVERGENCE no minimum was reached for another reason, or the model could not
 *                           be evaluated at the start; the message says why
 * @retval TRK_E_CANCELLED   progress returned non-zero
 * @retval TRK_E_MEMORY      no memory
 */
TRK_API trk_status trk_calibration_solve(trk_calibration *calibration,
                                         const trk_solve_options *options, trk_progress progress,
                                         void *user) TRK_MUST_CHECK;

/** What is known of a parameter after trk_calibration_solve(). */
typedef struct trk_parameter_result {
    size_t  struct_size; /**< [byte] set by the caller to sizeof the struct                */
    double  start;       /**< [- or unit of the value] at the start                        */
    double  fitted;      /**< [- or unit of the value] at the answer                       */
    double  low95;       /**< [- or unit of the value] lower end of the 95 % confidence interval (CALIBRATE.4); 0 if not determined */
    double  high95;      /**< [- or unit of the value] upper end; infinite if not determined */
    int32_t at_bound;    /**< [-] -1 at the lower, 1 at the upper bound, else 0            */
    int32_t determined;  /**< [-] 1 if the targets determine it                            */
} trk_parameter_result;

/** What is known of a target after trk_calibration_solve(). Of a curve: RMS of the logarithms. */
typedef struct trk_target_result {
    size_t  struct_size; /**< [byte] set by the caller to sizeof the struct                */
    double  measured;    /**< [Hz or -] value to reach                                     */
    double  before;      /**< [Hz or -] of the model at the start                          */
    double  after;       /**< [Hz or -] of the fitted model                                */
    double  residual;    /**< [-] (after - measured) / uncertainty                         */
    int32_t met;         /**< [-] 1 if within the limit of trk_solve_options               */
    int32_t reserved;    /**< [-] 0                                                        */
} trk_target_result;

/** Results. @retval TRK_E_ARGUMENT a pointer is NULL, no such id, or nothing was solved since the
 *  last parameter or target was added
 *  @retval TRK_E_OPTIONS struct_size is not set */
TRK_API trk_status trk_calibration_get_parameter(trk_calibration *calibration,
                                                 int32_t parameter,
                                                 trk_parameter_result *out_result) TRK_MUST_CHECK;
TRK_API trk_status trk_calibration_get_target(trk_calibration *calibration, int32_t target,
                                              trk_target_result *out_result) TRK_MUST_CHECK;

/** Evaluations of the model in the last solve, those that failed, and starts that were made. */
TRK_API int64_t trk_calibration_evaluations(const trk_calibration *calibration);
TRK_API int64_t trk_calibration_failures(const trk_calibration *calibration);

/**
 * Jacobian at the answer, weighted: w_i / s_i * d y_i / d ln p_j, and its singular
 * values, falling.
 *
 * @param out_jacobian [-] values x parameters, row-major; NULL to skip
 * @param out_singular [-] length min(values, parameters); NULL to skip
 * @retval TRK_E_ARGUMENT calibration is NULL or nothing was solved yet
 */
TRK_API trk_status trk_calibration_get_jacobian(const trk_calibration *calibration,
                                                double *out_jacobian,
                                                double *out_singular) TRK_MUST_CHECK;

/** The whole answer in words: parameters, targets, why it stopped. "" before; owned by the calibration. */
TRK_API const char *trk_calibration_report(const trk_calibration *calibration);

/**
 * Set the fitted values in a spec: usually the one the calibration was made from.
 *
 * @param spec must have the links and bodies acted on, by name; their stiffness, damping,
 *             scale, mass or inertia become those of the fitted copy; on failure it stays as it was,
 *             but for TRK_E_MEMORY, when some may be changed already
 * @retval TRK_E_ARGUMENT a pointer is NULL or nothing was solved yet
 * @retval TRK_E_NAME     the spec has no such link or body
 * @retval TRK_E_MEMORY   no memory
 */
TRK_API trk_status trk_calibration_apply(trk_calibration *calibration,
                                         trk_spec *spec) TRK_MUST_CHECK;

#endif
