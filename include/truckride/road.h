/* SPDX-License-Identifier: MIT */
/**
 * @file  truckride/road.h
 * @brief Random roads of ISO 8608: two tracks of given spectrum and coherence, without end.
 *
 * A road is a pair of signals over distance, for trk_excitation_add_profile(). Its heights are
 * a function of the seed and the place alone: they do not repeat, may be asked for anywhere and
 * in any order, and have the same bits on every machine. They are Gaussian (kurtosis 3 within
 * 0.1), with the one-sided displacement PSD over the wavenumber n [cycles/m]
 *
 *     G(n) = unevenness (n / 0.1 m^-1)^-waviness,   low <= n <= high        (ROAD.1)
 *
 * and nothing outside of this band. On a stretch of 100 km the power in each third octave
 * is that of (ROAD.1) within 5 %, nearer than noise would keep it (ROAD.8 says how likely).
 */
#ifndef TRUCKRIDE_ROAD_H
#define TRUCKRIDE_ROAD_H

#include <truckride/signal.h>

/** Classes of ISO 8608:2016. */
typedef int32_t trk_road_class;
enum {
    TRK_ROAD_CLASS_A = 1, /**< very good: unevenness 16e-6 m^3; each class has 4 times the last */
    TRK_ROAD_CLASS_B = 2, /**< good: 64e-6 m^3                                                  */
    TRK_ROAD_CLASS_C = 3, /**< average: 256e-6 m^3                                              */
    TRK_ROAD_CLASS_D = 4, /**< poor: 1024e-6 m^3                                                */
    TRK_ROAD_CLASS_E = 5, /**< very poor: 4096e-6 m^3                                           */
    TRK_ROAD_CLASS_F = 6, /**< 16384e-6 m^3                                                     */
    TRK_ROAD_CLASS_G = 7, /**< 65536e-6 m^3                                                     */
    TRK_ROAD_CLASS_H = 8  /**< 262144e-6 m^3                                                    */
};

/** How the left and the right track belong together (ROAD.2). */
typedef int32_t trk_road_tracks;
enum {
    TRK_ROAD_TRACKS_ISOTROPIC   = 0, /**< as two lines over an isotropic surface               */
    TRK_ROAD_TRACKS_EXPONENTIAL = 1, /**< coherence exp(-2 pi coherence_decay n track_width)   */
    TRK_ROAD_TRACKS_EQUAL       = 2, /**< coherence 1: no roll                                 */
    TRK_ROAD_TRACKS_INDEPENDENT = 3  /**< coherence 0                                          */
};

/** Which road. */
typedef struct trk_road_options {
    size_t  struct_size;     /**< [byte] set by trk_road_options_init()                        */
    double  unevenness;      /**< [m^3] G at 0.1 cycles/m, 0 to 1e6; trk_road_class_unevenness();
                                  default 16e-6: the mean of class A                           */
    double  waviness;        /**< [-] 1 to 4; default 2                                        */
    double  low;             /**< [1/m] band, >= 1e-6 cycles/m; default 0.011                  */
    double  high;            /**< [1/m] > low, at most 1e4; default 2.83                       */
    int64_t seed;            /**< [-] any number; another seed is another road; default 1      */
    trk_road_tracks tracks;  /**< [-] default TRK_ROAD_TRACKS_ISOTROPIC                        */
    int32_t reserved;        /**< [-] must be 0                                                */
    double  track_width;     /**< [m] distance of the tracks, >= 0; default 2                  */
    double  coherence_decay; /**< [-] of TRK_ROAD_TRACKS_EXPONENTIAL, >= 0; default 1          */
    double  contact_length;  /**< [m] the height is averaged over this length ahead and behind,
                                  half each; 0 for a point, else 0.001 / high to 250 / high;
                                  default 0                                                    */
    double  ramp_start;      /**< [m] with a ramp: the road is level before; default 0         */
    double  ramp_length;     /**< [m] >= 0, over which the road then grows to its full height as
                                  half a cosine; default 0: no ramp, uneven everywhere         */
} trk_road_options;

/** Set every field to its default. Call as trk_road_options_init(&o, sizeof o). */
TRK_API void trk_road_options_init(trk_road_options *options, size_t struct_size);

/** Unevenness [m^3] of a class: the geometric mean of its limits, 16e-6 4^(class - 1); 0 if there is no such class. */
TRK_API double trk_road_class_unevenness(trk_road_class road_class);

/**
 * Create both tracks of a road (ROAD.3 to ROAD.7), each a signal [m over m] with exact
 * derivative. It takes 8 KB and 0.7 KB for each octave of the band.
 *
 * @param options   NULL for the defaults
 * @param out_left  owned by caller; NULL on failure
 * @param out_right owned by caller; NULL on failure; may itself be NULL: one track only
 * @retval TRK_E_ARGUMENT a pointer is NULL, or tracks is unknown
 * @retval TRK_E_OPTIONS  options come from a newer header and set an unknown field
 * @retval TRK_E_RANGE    an option is out of its range
 * @retval TRK_E_MEMORY   no memory
 * Source: ISO 8608:2016; lapped transform: J. P. Princen, A. B. Bradley, IEEE Trans. Acoust.,
 * Speech, Signal Process. 34 (1986) 1153-1161.
 */
TRK_API trk_status trk_road_create(trk_context *context, const trk_road_options *options,
                                   trk_signal **out_left, trk_signal **out_right) TRK_MUST_CHECK;

/**
 * One-sided PSD of each track: (ROAD.1), times (sin(pi n l) / (pi n l))^2 of the contact length
 * l. At speed v the wheels see density(f / v) / v over the frequency f.
 *
 * @param options     NULL for the defaults
 * @param count       number of wavenumbers
 * @param wavenumber  [1/m] cycles per metre, >= 0, length count
 * @param out_density [m^3] length count; 0 outside of the band
 * @retval TRK_E_RANGE an option or a wavenumber is out of range
 * Further errors as trk_road_create().
 */
TRK_API trk_status trk_road_density(trk_context *context, const trk_road_options *options,
                                    int64_t count, const double *wavenumber,
                                    double *out_density) TRK_MUST_CHECK;

/**
 * Coherence of left and right (ROAD.2): the real ratio of cross spectrum and PSD, as
 * trk_road_cross_spectra() takes it; its square is what trk_coherence() estimates.
 *
 * @param options       NULL for the defaults
 * @param count         number of wavenumbers
 * @param wavenumber    [1/m] cycles per metre, >= 0, length count
 * @param out_coherence [-] 0 to 1, length count
 * Errors as trk_road_density().
 * Source: K. M. A. Kamash, J. D. Robson, J. Sound Vib. 57 (1978) 89-100.
 */
TRK_API trk_status trk_road_coherence(trk_context *context, const trk_road_options *options,
                                      int64_t count, const double *wavenumber,
                                      double *out_coherence) TRK_MUST_CHECK;

/*
 * What of a profile a tire passes on (enveloping). A profile is given by equally spaced heights,
 * linear between them and level beyond its ends. Heights and slopes that come out make a signal with
 * trk_signal_create_samples(), as any profile for trk_excitation_add_profile().
 */

/**
 * Moving average over the length of the contact patch (ROAD.11), the exact integral.
 *
 * @param count      number of heights, >= 1
 * @param spacing    [m] > 0
 * @param height     [m] at most 1e12, length count
 * @param length     [m] of the patch, half ahead and half behind; > 0
 * @param out_height [m] length count; not `height`
 * @param out_slope  [-] exact derivative at the samples, length count; NULL to skip
 * @retval TRK_E_ARGUMENT a pointer is NULL, or two of the arrays are the same
 * @retval TRK_E_RANGE    a value is out of range; the message names it
 * @retval TRK_E_MEMORY   no memory
 */
TRK_API trk_status trk_envelope_average(trk_context *context, int64_t count, double spacing,
                                        const double *height, double length, double *out_height,
                                        double *out_slope) TRK_MUST_CHECK;

/**
 * By how much the moving average changes a wave (ROAD.11): sin(pi n l) / (pi n l) [-]. Negative where the
 * wave comes out upside down.
 *
 * @param wavenumber [1/m] n
 * @param length     [m] l
 */
TRK_API double trk_envelope_weight(double wavenumber, double length);

/**
 * Rigid tread band (ROAD.12): height of the hub of a rigid wheel that rolls over the profile, less
 * its radius. Exact for the profile between the samples, too.
 *
 * @param spacing    [m] > 0
 * @param height     [m] at most 1e12, length count
 * @param radius     [m] > 0
 * @param out_height [m] length count; not `height`
 * @param out_slope  [-] of the path of the hub, at a corner one of both; length count; NULL to skip
 * Further arguments and errors as trk_envelope_average(). Takes no memory.
 * Source: K. Captain, A. Boghani, D. Wormley, Vehicle System Dynamics 8 (1979) 1-32.
 */
TRK_API trk_status trk_envelope_rigid_band(trk_context *context, int64_t count, double spacing,
                                           const double *height, double radius, double *out_height,
                                           double *out_slope) TRK_MUST_CHECK;

/**
 * A profile as a tire passes it on, over the distance start to start + (count - 1) spacing: rigid tread
 * band, then moving average of its hub heights.
 *
 * @param profile    [m over m] from trk_crg_profile(), trk_signal_read_csv(), trk_road_create(), ...
 * @param start      [m]
 * @param spacing    [m] > 0; a tenth of the patch or of the shortest wave, or less
 * @param count      number of samples, >= 2
 * @param radius     [m] of the tread band; 0 for none
 * @param length     [m] of the average; 0 for none
 * @param out_signal owned by caller; NULL on failure; its ends are held
 * @retval TRK_E_RANGE a value is out of range, or both radius and length are 0
 * Further errors as trk_envelope_average() and trk_envelope_rigid_band().
 */
TRK_API trk_status trk_envelope_signal(trk_context *context, const trk_signal *profile,
                                       double start, double spacing, int64_t count, double radius,
                                       double length, trk_signal **out_signal) TRK_MUST_CHECK;

#endif
