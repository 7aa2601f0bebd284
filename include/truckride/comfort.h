/* SPDX-License-Identifier: MIT */
/**
 * @file  truckride/comfort.h
 * @brief Numbers for people and roads out of signals: ISO 2631-1 frequency weighting and dose
 *        values, exposure limits, tire loads, suspension travel, road-friendliness.
 *
 * From an acceleration to a comfort number: weight it (trk_weighting_filter, or trk_psd_weight()
 * on a PSD), measure it (trk_vibration_measure(), or trk_band_rms() on the PSD), combine the axes
 * (trk_vibration_total()) and look the sum up (trk_comfort_reactions()). Rotational accelerations
 * [rad/s^2] take the place of [m/s^2] with TRK_WEIGHTING_WE.
 *
 * Samples must be finite and at most 1e75 in magnitude, so that their fourth powers stay finite.
 * Equations: docs/theory.md, section COMFORT.
 */
#ifndef TRUCKRIDE_COMFORT_H
#define TRUCKRIDE_COMFORT_H

#include <truckride/model.h>

/** Frequency weighting of ISO 2631-1:1997 (parameters of ISO 8041-1), or its band limits alone. */
typedef int32_t trk_weighting;
enum {
    TRK_WEIGHTING_WK       = 1, /**< vertical: seat, feet, standing                         */
    TRK_WEIGHTING_WD       = 2, /**< horizontal: seat; back y, z                            */
    TRK_WEIGHTING_WC       = 3, /**< back x                                                 */
    TRK_WEIGHTING_WE       = 4, /**< rotation of the seat                                   */
    TRK_WEIGHTING_WJ       = 5, /**< vertical, head of a lying person                       */
    TRK_WEIGHTING_WF       = 6, /**< vertical, motion sickness                              */
    TRK_WEIGHTING_WB       = 7, /**< vertical after BS 6841:1987 and ISO 2631-4             */
    TRK_WEIGHTING_BAND     = 8, /**< band limits 0.4 to 100 Hz of Wb, Wc, Wd, We, Wj, Wk    */
    TRK_WEIGHTING_BAND_LOW = 9  /**< band limits 0.08 to 0.63 Hz of Wf                      */
};

/** Name as the standards write it, "Wk"; NULL for an unknown weighting. Static storage. */
TRK_API const char *trk_weighting_name(trk_weighting weighting);

/**
 * Magnitude [-] of the analogue weighting (COMFORT.1).
 *
 * @param frequency [Hz] >= 0
 * @return NaN for an unknown weighting, or a frequency that is negative or not finite
 */
TRK_API double trk_weighting_factor(trk_weighting weighting, double frequency);

/**
 * Complex analogue weighting (COMFORT.1) for exp(+i 2 pi f t).
 *
 * @param count        number of frequencies
 * @param frequency    [Hz] >= 0, length count
 * @param out_response [-] real and imaginary parts in turn, length 2 * count
 * @retval TRK_E_ARGUMENT a pointer is NULL, or the weighting is unknown
 * @retval TRK_E_RANGE    count is negative, or a frequency is negative or not finite
 * Source: ISO 2631-1:1997 annex A; ISO 8041-1:2017 formulae (1) to (5).
 */
TRK_API trk_status trk_weighting_response(trk_context *context, trk_weighting weighting,
                                          int64_t count, const double *frequency,
                                          double *out_response) TRK_MUST_CHECK;

/**
 * Weight a one-sided PSD: density times the squared magnitude at the frequency of each bin
 * (COMFORT.2). Its trk_band_rms() is the weighted RMS.
 *
 * @param length         number of frequencies
 * @param density        [m^2/s^4/Hz] length length
 * @param frequency_step [Hz] > 0
 * @param out_density    [m^2/s^4/Hz] length length; may be density
 * @retval TRK_E_ARGUMENT a pointer is NULL, or the weighting is unknown
 * @retval TRK_E_RANGE    length < 1, a density is negative or not finite, or frequency_step is
 *                        out of range
 */
TRK_API trk_status trk_psd_weight(trk_context *context, trk_weighting weighting, int64_t length,
                                  const double *density, double frequency_step,
                                  double *out_density) TRK_MUST_CHECK;

/** Exact centre 10^(band / 10) [Hz] of a third-octave band: band 0 is 1 Hz, 10 is 10 Hz
 *  (IEC 61260-1, COMFORT.3). */
TRK_API double trk_third_octave_centre(int32_t band);

/**
 * RMS in third-octave bands from a one-sided PSD, bins cut by an edge in proportion (COMFORT.3).
 *
 * @param length         number of frequencies
 * @param density        [any^2/Hz] length length
 * @param frequency_step [Hz] > 0
 * @param first_band     lowest band, -60 to 60; -10 is 0.1 Hz
 * @param bands          number of bands, >= 1, the last one at most 60
 * @param out_rms        [any] length bands
 * @retval TRK_E_ARGUMENT a pointer is NULL
 * @retval TRK_E_RANGE    length < 1, a band, a density or frequency_step is out of range, or a
 *                        sum overflows
 */
TRK_API trk_status trk_third_octave_rms(trk_context *context, int64_t length,
                                        const double *density, double frequency_step,
                                        int32_t first_band, int32_t bands,
                                        double *out_rms) TRK_MUST_CHECK;

/**
 * Weighted RMS from third-octave values: sqrt(sum (W_i a_i)^2), W_i at the exact centres
 * (COMFORT.4).
 *
 * @param first_band as trk_third_octave_rms()
 * @param bands      as trk_third_octave_rms()
 * @param rms        [m/s^2] length bands, >= 0
 * @param out_rms    [m/s^2]
 * @retval TRK_E_ARGUMENT a pointer is NULL, or the weighting is unknown
 * @retval TRK_E_RANGE    a band or a value is out of range
 */
TRK_API trk_status trk_third_octave_weight(trk_context *context, trk_weighting weighting,
                                           int32_t first_band, int32_t bands, const double *rms,
                                           double *out_rms) TRK_MUST_CHECK;

/** A weighting as a recursive filter that takes a signal of any length block by block. */
typedef struct trk_weighting_filter trk_weighting_filter;

/** Slowest sample rate of a weighting filter [Hz]: below, the band up to 80 Hz does not fit. */
#define TRK_WEIGHTING_RATE_MINIMUM 200.0

/** Fastest sample rate of a weighting filter [Hz]. */
#define TRK_WEIGHTING_RATE_MAXIMUM 1e6

/**
 * Create a weighting filter at rest (COMFORT.5).
 *
 * Its magnitude stays within 0.05 % of the analogue one from 0.01 Hz to 80 Hz and to 0.4 of the
 * sample rate, whatever the rate: the analogue poles are mapped exactly, and a short minimum-phase
 * section fitted to the analogue magnitude takes out what sampling does near the Nyquist
 * frequency. It has no delay; its output is even early, by 0.4 to 1.2 samples (Wf 1.5), up to
 * 0.2 of the sample rate by the same time to 0.05 of a sample, which keeps the waveform.
 *
 * @param sample_rate [Hz] TRK_WEIGHTING_RATE_MINIMUM to TRK_WEIGHTING_RATE_MAXIMUM
 * @param out_filter  owned by caller; NULL on failure
 * @retval TRK_E_ARGUMENT a pointer is NULL, or the weighting is unknown
 * @retval TRK_E_RANGE    sample_rate is out of range
 * @retval TRK_E_MEMORY   no memory
 */
TRK_API trk_status trk_weighting_filter_create(trk_context *context, trk_weighting weighting,
                                               double sample_rate,
                                               trk_weighting_filter **out_filter) TRK_MUST_CHECK;

/** Free a filter. NULL is allowed. */
TRK_API void trk_weighting_filter_destroy(trk_weighting_filter *filter);

/**
 * Start again as if the input had always been level [m/s^2]; 0 is rest. With the first sample
 * as level, an offset (gravity, a zero error) makes no transient.
 */
TRK_API void trk_weighting_filter_reset(trk_weighting_filter *filter, double level);

/**
 * Filter the next block. Blocks of any sizes give the same output bit by bit.
 *
 * @param count number of samples, >= 0
 * @param x     [m/s^2] length count
 * @param out_y [m/s^2] length count; may be x
 * @retval TRK_E_ARGUMENT a pointer is NULL
 * @retval TRK_E_RANGE    count is negative, or a sample is not finite or too large; nothing was
 *                        filtered
 */
TRK_API trk_status trk_weighting_filter_process(trk_weighting_filter *filter, int64_t count,
                                                const double *x, double *out_y) TRK_MUST_CHECK;

/**
 * Weight a whole signal from rest: create, process, destroy.
 *
 * @param count       number of samples, >= 0
 * @param x           [m/s^2] length count
 * @param sample_rate [Hz] as trk_weighting_filter_create()
 * @param out_y       [m/s^2] length count; may be x
 * Errors as trk_weighting_filter_create() and trk_weighting_filter_process().
 */
TRK_API trk_status trk_weighting_apply(trk_context *context, trk_weighting weighting,
                                       int64_t count, const double *x, double sample_rate,
                                       double *out_y) TRK_MUST_CHECK;

/** How a running RMS averages. */
typedef int32_t trk_averaging;
enum {
    TRK_AVERAGING_LINEAR      = 0, /**< evenly over the last integration time */
    TRK_AVERAGING_EXPONENTIAL = 1  /**< with exp(-age / integration time)     */
};

/**
 * Running RMS (COMFORT.6) at every sample; the signal is zero before its first sample.
 *
 * @param averaging        linear averages over the nearest whole number of samples, at least one
 * @param count            number of samples, >= 0
 * @param x                [any] length count
 * @param sample_rate      [Hz] > 0
 * @param integration_time [s] > 0; ISO 2631-1 recommends 1
 * @param out_rms          [any] length count; may be x
 * @retval TRK_E_ARGUMENT a pointer is NULL, or averaging is unknown
 * @retval TRK_E_RANGE    count is negative, a sample is not finite or too large, or sample_rate
 *                        or integration_time is out of range
 * @retval TRK_E_MEMORY   no memory
 * Source: ISO 2631-1:1997, 6.3.1, equations (2) and (3).
 */
TRK_API trk_status trk_running_rms(trk_context *context, trk_averaging averaging, int64_t count,
                                   const double *x, double sample_rate, double integration_time,
                                   double *out_rms) TRK_MUST_CHECK;

/** Reasons why the basic method is not sufficient (ISO 2631-1 6.2.1, 6.3.3). Added up. */
enum {
    TRK_ADDITIONAL_CREST = 1, /**< crest factor > 9                       */
    TRK_ADDITIONAL_MTVV  = 2, /**< mtvv / rms > 1.5                       */
    TRK_ADDITIONAL_VDV   = 4  /**< vdv / (rms duration^(1/4)) > 1.75      */
};

/** What ISO 2631-1 says about one weighted acceleration (COMFORT.6, COMFORT.7). */
typedef struct trk_vibration {
    size_t  struct_size;      /**< [byte] set by the caller to sizeof the struct                 */
    double  duration;         /**< [s] samples / sample rate                                     */
    double  rms;              /**< [m/s^2] a_w                                                   */
    double  peak;             /**< [m/s^2] largest magnitude                                     */
    double  crest_factor;     /**< [-] peak / rms; NaN without vibration, as the other ratios    */
    double  mtvv;             /**< [m/s^2] largest linear running RMS                            */
    double  mtvv_exponential; /**< [m/s^2] largest exponential running RMS                       */
    double  vdv;              /**< [m/s^1.75] fourth-power vibration dose value                  */
    double  evdv;             /**< [m/s^1.75] estimated: 1.4 rms duration^(1/4)                  */
    double  msdv;             /**< [m/s^1.5] rms duration^(1/2), motion sickness if weighted Wf  */
    double  mtvv_ratio;       /**< [-] mtvv / rms                                                */
    double  vdv_ratio;        /**< [-] vdv / (rms duration^(1/4))                                */
    int32_t additional;       /**< [-] sum of TRK_ADDITIONAL_..., 0: the basic method suffices   */
    int32_t reserved;         /**< [-] 0                                                         */
} trk_vibration;

/** Measures a weighted acceleration block by block; memory for one integration time only. */
typedef struct trk_vibration_meter trk_vibration_meter;

/**
 * Create a meter that has seen nothing.
 *
 * @param sample_rate      [Hz] > 0
 * @param integration_time [s] > 0 of the running RMS; ISO 2631-1 recommends 1
 * @param out_meter        owned by caller; NULL on failure
 * @retval TRK_E_ARGUMENT a pointer is NULL
 * @retval TRK_E_RANGE    sample_rate or integration_time is out of range
 * @retval TRK_E_MEMORY   no memory
 */
TRK_API trk_status trk_vibration_meter_create(trk_context *context, double sample_rate,
                                              double integration_time,
                                              trk_vibration_meter **out_meter) TRK_MUST_CHECK;

/** Free a meter. NULL is allowed. */
TRK_API void trk_vibration_meter_destroy(trk_vibration_meter *meter);

/** Forget everything measured. */
TRK_API void trk_vibration_meter_reset(trk_vibration_meter *meter);

/**
 * Measure the next block. Blocks of any sizes give the same numbers bit by bit.
 *
 * @param count number of samples, >= 0
 * @param x     [m/s^2] weighted acceleration, length count
 * @retval TRK_E_ARGUMENT a pointer is NULL
 * @retval TRK_E_RANGE    count is negative, or a sample is not finite or too large; nothing was
 *                        measured
 */
TRK_API trk_status trk_vibration_meter_process(trk_vibration_meter *meter, int64_t count,
                                               const double *x) TRK_MUST_CHECK;

/** Numbers so far. @retval TRK_E_ARGUMENT a pointer is NULL @retval TRK_E_RANGE no sample yet
 *  @retval TRK_E_OPTIONS struct_size is not set */
TRK_API trk_status trk_vibration_meter_read(const trk_vibration_meter *meter,
                                            trk_vibration *out_vibration) TRK_MUST_CHECK;

/**
 * Measure a whole signal with 1 s integration time: create, process, read, destroy.
 *
 * @param count         number of samples, >= 1
 * @param x             [m/s^2] weighted acceleration, length count
 * @param sample_rate   [Hz] > 0
 * @param out_vibration its struct_size is set
 * @retval TRK_E_OPTIONS struct_size is not set
 * Further errors as trk_vibration_meter_create() and trk_vibration_meter_process().
 */
TRK_API trk_status trk_vibration_measure(trk_context *context, int64_t count, const double *x,
                                         double sample_rate,
                                         trk_vibration *out_vibration) TRK_MUST_CHECK;

/** Where a seated person is shaken and which way: the twelve axes of ISO 2631-1. */
typedef int32_t trk_axis;
enum {
    TRK_AXIS_SEAT_X = 1, TRK_AXIS_SEAT_Y     = 2,  TRK_AXIS_SEAT_Z   = 3, /**< seat surface   */
    TRK_AXIS_SEAT_ROLL = 4, TRK_AXIS_SEAT_PITCH = 5, TRK_AXIS_SEAT_YAW = 6, /**< its rotation */
    TRK_AXIS_BACK_X = 7, TRK_AXIS_BACK_Y     = 8,  TRK_AXIS_BACK_Z   = 9, /**< backrest       */
    TRK_AXIS_FEET_X = 10, TRK_AXIS_FEET_Y    = 11, TRK_AXIS_FEET_Z   = 12 /**< floor          */
};

/** What is judged; the multipliers depend on it. */
typedef int32_t trk_purpose;
enum {
    TRK_PURPOSE_COMFORT = 0, /**< ISO 2631-1 clause 8: all twelve axes                     */
    TRK_PURPOSE_HEALTH  = 1  /**< ISO 2631-1 clause 7, 2002/44/EC: seat x, y, z only       */
};

/**
 * Weighting and multiplying factor k of an axis (COMFORT.8).
 *
 * @param out_weighting  NULL to skip
 * @param out_multiplier [-, m/rad for rotations] NULL to skip
 * @retval TRK_E_ARGUMENT no such axis or purpose, or the purpose does not know the axis
 */
TRK_API trk_status trk_axis_get(trk_axis axis, trk_purpose purpose, trk_weighting *out_weighting,
                                double *out_multiplier) TRK_MUST_CHECK;

/**
 * Vibration total value sqrt(sum (k_i a_i)^2) over any of the axes (COMFORT.8): of one point for
 * its a_v, of all measured axes for the overall value.
 *
 * @param count   number of axes, >= 1
 * @param axis    length count; each at most once
 * @param rms     [m/s^2, rad/s^2] weighted RMS, >= 0, length count
 * @param out_sum [m/s^2]
 * @retval TRK_E_ARGUMENT a pointer is NULL, an axis or purpose is unknown, an axis comes twice
 * @retval TRK_E_RANGE    count < 1, or a value is negative, not finite or too large
 */
TRK_API trk_status trk_vibration_total(trk_context *context, trk_purpose purpose, int32_t count,
                                       const trk_axis *axis, const double *rms,
                                       double *out_sum) TRK_MUST_CHECK;

/** Reactions in public transport, ISO 2631-1 C.2.3. The bands overlap; added up. */
enum {
    TRK_REACTION_NOT_UNCOMFORTABLE       = 1,  /**< below 0.315 m/s^2      */
    TRK_REACTION_A_LITTLE_UNCOMFORTABLE  = 2,  /**< 0.315 to 0.63 m/s^2    */
    TRK_REACTION_FAIRLY_UNCOMFORTABLE    = 4,  /**< 0.5 to 1 m/s^2         */
    TRK_REACTION_UNCOMFORTABLE           = 8,  /**< 0.8 to 1.6 m/s^2       */
    TRK_REACTION_VERY_UNCOMFORTABLE      = 16, /**< 1.25 to 2.5 m/s^2      */
    TRK_REACTION_EXTREMELY_UNCOMFORTABLE = 32  /**< above 2 m/s^2          */
};

/**
 * All reactions whose band holds an overall vibration total value: sum of TRK_REACTION_..., ends
 * included. 0 for a value that is negative or NaN.
 *
 * @param total [m/s^2] of trk_vibration_total() for comfort
 */
TRK_API int32_t trk_comfort_reactions(double total);

/** Words of one reaction, "fairly uncomfortable"; NULL for anything else. Static storage. */
TRK_API const char *trk_comfort_text(int32_t reaction);

/** Where a daily exposure lies (2002/44/EC). */
typedef int32_t trk_exposure;
enum {
    TRK_EXPOSURE_BELOW_ACTION = 0, /**< the action value is not exceeded                  */
    TRK_EXPOSURE_ABOVE_ACTION = 1, /**< above the action value, up to the limit value     */
    TRK_EXPOSURE_ABOVE_LIMIT  = 2  /**< above the limit value, or NaN                     */
};

#define TRK_EXPOSURE_A8_ACTION  0.5  /**< [m/s^2] 2002/44/EC article 3(2)    */
#define TRK_EXPOSURE_A8_LIMIT   1.15 /**< [m/s^2] 2002/44/EC article 3(2)    */
#define TRK_EXPOSURE_VDV_ACTION 9.1  /**< [m/s^1.75] 2002/44/EC article 3(2) */
#define TRK_EXPOSURE_VDV_LIMIT  21.0 /**< [m/s^1.75] 2002/44/EC article 3(2) */

/**
 * Daily exposure A(8) = sqrt(sum k^2 a_i^2 T_i / 8 h) along one axis (COMFORT.9). The exposure
 * of a person is the largest of the three axes of the seat.
 *
 * @param axis     TRK_AXIS_SEAT_X, _Y or _Z, for k of TRK_PURPOSE_HEALTH
 * @param count    number of tasks of the day, >= 1
 * @param rms      [m/s^2] weighted RMS of each task, >= 0, length count
 * @param duration [s] of each task, >= 0, length count
 * @param out_a8   [m/s^2]
 * @retval TRK_E_ARGUMENT a pointer is NULL, or the axis is none of the three
 * @retval TRK_E_RANGE    count < 1, or a value is negative, not finite or too large
 * Source: Directive 2002/44/EC, annex B.
 */
TRK_API trk_status trk_daily_a8(trk_context *context, trk_axis axis, int32_t count,
                                const double *rms, const double *duration,
                                double *out_a8) TRK_MUST_CHECK;

/**
 * Daily vibration dose value k (sum VDV_i^4 T_i / t_i)^(1/4) along one axis (COMFORT.9): each
 * task lasts T_i and was measured for t_i.
 *
 * @param axis     as trk_daily_a8()
 * @param count    number of tasks of the day, >= 1
 * @param vdv      [m/s^1.75] of each measurement, >= 0, length count
 * @param measured [s] duration of each measurement, > 0, length count
 * @param duration [s] of each task, >= 0, length count
 * @param out_vdv  [m/s^1.75]
 * Errors as trk_daily_a8().
 */
TRK_API trk_status trk_daily_vdv(trk_context *context, trk_axis axis, int32_t count,
                                 const double *vdv, const double *measured,
                                 const double *duration, double *out_vdv) TRK_MUST_CHECK;

/** Where an A(8) [m/s^2] lies. */
TRK_API trk_exposure trk_exposure_of_a8(double a8);

/** Where a daily VDV [m/s^1.75] lies. */
TRK_API trk_exposure trk_exposure_of_vdv(double vdv);

/**
 * SEAT factors: weighted vibration on the seat over that on the floor (COMFORT.10); below 1 the
 * seat isolates. Both signals are weighted alike, from a start at their first samples.
 *
 * @param weighting   TRK_WEIGHTING_WK for the vertical
 * @param count       number of samples, >= 1
 * @param seat        [m/s^2] acceleration on the seat, length count
 * @param floor       [m/s^2] acceleration at the seat's base, length count
 * @param sample_rate [Hz] as trk_weighting_filter_create()
 * @param out_rms     [-] ratio of weighted RMS; NULL to skip
 * @param out_vdv     [-] ratio of VDV, the one to use with shocks; NULL to skip
 * @retval TRK_E_RANGE the floor does not vibrate, or as the filter's and the meter's
 * Further errors as trk_weighting_filter_create() and trk_weighting_filter_process().
 * Source: ISO 10326-1; M. J. Griffin, Handbook of Human Vibration, Academic Press 1990, ch. 9.
 */
TRK_API trk_status trk_seat_factor(trk_context *context, trk_weighting weighting, int64_t count,
                                   const double *seat, const double *floor, double sample_rate,
                                   double *out_rms, double *out_vdv) TRK_MUST_CHECK;

/**
 * Load [N] of an axle, or of a single tire, from the forces [N] that sensors of its tires recorded
 * (COMFORT.11): static_load minus their sum, as tires push with negative force.
 *
 * @param tires       number of tires, >= 1
 * @param count       number of samples, >= 0
 * @param force       [N] link force of each tire, tires pointers to count samples each
 * @param static_load [N] what the recorded forces leave out: 0 if the model was compiled with
 *                    gravity; if without, minus the sum of the tires' entries of
 *                    trk_model_get_static() of the same spec compiled with gravity
 * @param out_load    [N] length count
 * @retval TRK_E_ARGUMENT a pointer is NULL
 * @retval TRK_E_RANGE    tires < 1, count is negative, or a value is not finite or too large
 */
TRK_API trk_status trk_axle_load(trk_context *context, int32_t tires, int64_t count,
                                 const double *const *force, double static_load,
                                 double *out_load) TRK_MUST_CHECK;

/** How a tire or an axle loads the road (COMFORT.12). */
typedef struct trk_load_numbers {
    size_t struct_size;   /**< [byte] set by the caller to sizeof the struct                    */
    double mean;          /**< [N] mean load                                                    */
    double deviation;     /**< [N] standard deviation                                           */
    double dynamic_load_coefficient; /**< [-] deviation / mean                                  */
    double maximum;       /**< [N] peak load                                                    */
    double minimum;       /**< [N]                                                              */
    double impact_factor; /**< [-] maximum / mean                                               */
    double lift_off;      /**< [-] share of samples with load <= 0                              */
} trk_load_numbers;

/**
 * Numbers of a load.
 *
 * @param count       number of samples, >= 1
 * @param load        [N] of trk_axle_load(), length count
 * @param out_numbers its struct_size is set
 * @retval TRK_E_ARGUMENT a pointer is NULL
 * @retval TRK_E_OPTIONS  struct_size is not set
 * @retval TRK_E_RANGE    count < 1, a sample is not finite or too large, or the mean is not > 0
 * Source: D. Cebon, Handbook of Vehicle-Road Interaction, Swets & Zeitlinger 1999, ch. 1.
 */
TRK_API trk_status trk_load_measure(trk_context *context, int64_t count, const double *load,
                                    trk_load_numbers *out_numbers) TRK_MUST_CHECK;

/** How far a suspension moves (COMFORT.13). */
typedef struct trk_travel_numbers {
    size_t struct_size;  /**< [byte] set by the caller to sizeof the struct */
    double mean;         /**< [m]                                           */
    double rms;          /**< [m] about the mean                            */
    double minimum;      /**< [m]                                           */
    double maximum;      /**< [m]                                           */
    double peak_to_peak; /**< [m] maximum - minimum                         */
} trk_travel_numbers;

/**
 * Numbers and percentiles of a travel.
 *
 * @param count       number of samples, >= 1
 * @param travel      [m] elongation of the suspension link, length count
 * @param out_numbers its struct_size is set; NULL to skip
 * @param percentiles number of percentiles, >= 0
 * @param percent     [%] 0 to 100, length percentiles; NULL if there are none
 * @param out_travel  [m] value that percent of the samples do not exceed, linear between
 *                    samples; length percentiles; NULL if there are none
 * @retval TRK_E_ARGUMENT a pointer is NULL
 * @retval TRK_E_OPTIONS  struct_size is not set
 * @retval TRK_E_RANGE    a count is out of range, a sample is not finite or too large, or a
 *                        percentage is not 0 to 100
 * @retval TRK_E_MEMORY   no memory for a sorted copy
 */
TRK_API trk_status trk_travel_measure(trk_context *context, int64_t count, const double *travel,
                                      trk_travel_numbers *out_numbers, int32_t percentiles,
                                      const double *percent, double *out_travel) TRK_MUST_CHECK;

/** Free vertical oscillation above an axle after a drop (COMFORT.14). */
typedef struct trk_axle_transient {
    size_t struct_size;      /**< [byte] set by the caller to sizeof the struct               */
    double damped_frequency; /**< [Hz] from first to second compression peak                  */
    double frequency;        /**< [Hz] undamped: damped_frequency / sqrt(1 - damping_ratio^2) */
    double damping_ratio;    /**< [-] D, part of critical                                     */
    double first_time;       /**< [s] of the first compression peak                           */
    double first_amplitude;  /**< [m] of the first compression peak, > 0                      */
    double second_amplitude; /**< [m] of the second one, > 0                                  */
} trk_axle_transient;

/**
 * Frequency and damping ratio from the first two compression peaks of a transient (COMFORT.14).
 *
 * A compression peak is the lowest point between two crossings of the level at rest, the motion
 * beside it reaching 0.2 % of the largest deviation; it lies inside the record, refined by
 * the parabola through three samples.
 *
 * @param count         number of samples, >= 3
 * @param travel        [m] suspension elongation (negative is compression), length count
 * @param sample_rate   [Hz] > 0
 * @param rest          [m] its value at rest afterwards
 * @param out_transient its struct_size is set
 * @retval TRK_E_ARGUMENT a pointer is NULL
 * @retval TRK_E_OPTIONS  struct_size is not set
 * @retval TRK_E_RANGE    an argument or a sample is out of range, or the record has no two
 *                        compression peaks of falling height: the damping is too strong, or the
 *                        record too short or not free
 * Source: Directive 96/53/EC, annex II, 3 and 4.
 */
TRK_API trk_status trk_axle_transient_measure(trk_context *context, int64_t count,
                                              const double *travel, double sample_rate,
                                              double rest,
                                              trk_axle_transient *out_transient) TRK_MUST_CHECK;

/** Options of trk_axle_drop(). */
typedef struct trk_axle_drop_options {
    size_t struct_size; /**< [byte] set by trk_axle_drop_options_init()              */
    double height;      /**< [m] > 0; default 0.08 as in 96/53/EC annex II 4         */
    double duration;    /**< [s] > 0, long enough to come to rest; default 10        */
    double step;        /**< [s] > 0 of the integration; default 0.001               */
} trk_axle_drop_options;

/** Set every field to its default. Call as trk_axle_drop_options_init(&o, sizeof o). */
TRK_API void trk_axle_drop_options_init(trk_axle_drop_options *options, size_t struct_size);

/**
 * Let an axle of a model drop off a step: the road under its wheels falls by the height at once,
 * from static equilibrium, and the elongation of a suspension link is measured as by
 * trk_axle_transient_measure(); its level at rest is the mean over the last fifth of the run.
 *
 * Wheel hop adds peaks of its own where it is weakly damped, as without dampers. A second peak
 * above 5 Hz is taken for one of those and refused, and two of them may be no falling peaks at
 * all. Take the damping ratio of the mode then, trk_modes_damping_ratio().
 *
 * @param roads         number of road inputs under the axle, >= 1
 * @param road          their ids, length roads
 * @param link          id of a spring or damper between axle and chassis
 * @param options       NULL for 80 mm
 * @param out_transient its struct_size is set
 * @retval TRK_E_ARGUMENT a pointer is NULL, or there is no such road or link
 * @retval TRK_E_OPTIONS  options come from a newer header and set an unknown field, or
 *                        struct_size of out_transient is not set
 * @retval TRK_E_RANGE    an option is out of range, the second peak is that of wheel hop, or as
 *                        trk_axle_transient_measure()
 * @retval TRK_E_MEMORY   no memory
 * Further errors as trk_newmark_create() and trk_newmark_step().
 */
TRK_API trk_status trk_axle_drop(trk_context *context, const trk_model *model, int32_t roads,
                                 const int32_t *road, int32_t link,
                                 const trk_axle_drop_options *options,
                                 trk_axle_transient *out_transient) TRK_MUST_CHECK;

/** Conditions of 96/53/EC annex II that an axle does not meet. Added up. */
enum {
    TRK_UNFRIENDLY_FREQUENCY = 1, /**< frequency above 2.0 Hz                              */
    TRK_UNFRIENDLY_DAMPING   = 2, /**< damping ratio not above 20 % of critical            */
    TRK_UNFRIENDLY_DAMPERS   = 4  /**< without dampers more than 50 % of it is left        */
};

/**
 * Is the suspension of a driving axle equivalent to an air suspension?
 *
 * @param frequency       [Hz] damped_frequency of the transient, dampers working
 * @param damping_ratio   [-] D, dampers working
 * @param without_dampers [-] D with the hydraulic dampers removed
 * @return sum of TRK_UNFRIENDLY_..., 0 if all conditions are met; a NaN does not meet its own
 */
TRK_API int32_t trk_road_friendliness(double frequency, double damping_ratio,
                                      double without_dampers);

#endif
