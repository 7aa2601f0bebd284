/* SPDX-License-Identifier: MIT */
/**
 * @file  truckride/linear.h
 * @brief Modes, frequency response and steady spectra of a model about a working point.
 *
 * With the tangents of (MODEL.4):
 *
 *     K phi = omega^2 M phi,  phi^T M phi = 1                         (LINEAR.1)
 *     (lambda^2 M + lambda C + K) phi = 0                             (LINEAR.2)
 *     (K + i w C - w^2 M) q = B^T (k + i w c) G u + P p               (LINEAR.3)
 *     S_y = H S_u H^H                                                 (LINEAR.6)
 *
 * Needs TRK_FEATURE_LAPACK.
 */
#ifndef TRUCKRIDE_LINEAR_H
#define TRUCKRIDE_LINEAR_H

#include <truckride/excitation.h>
#include <truckride/law.h>
#include <truckride/road.h>
#include <truckride/spectrum.h>

/** Modes of a model about a working point; immutable. */
typedef struct trk_modes trk_modes;

/**
 * Undamped modes (LINEAR.1), by rising frequency, mass-normalised.
 *
 * @param q         [m, rad] working point; NULL for static equilibrium
 * @param out_modes owned by caller; NULL on failure
 * @retval TRK_E_ARGUMENT    a pointer is NULL
 * @retval TRK_E_RANGE       the working point is not finite
 * @retval TRK_E_UNSUPPORTED this build has no LAPACK
 * @retval TRK_E_CONVERGENCE LAPACK did not converge
 * @retval TRK_E_INTERNAL    LAPACK failed
 * @retval TRK_E_MEMORY      no memory
 * A negative eigenvalue omega^2 (the working point is not stable) is given as a
 * negative frequency -sqrt(-omega^2) / 2 pi. Frequencies below about sqrt(n 1e-16) of the
 * largest one are lost in its rounding and given as 0.
 */
TRK_API trk_status trk_modes_create_undamped(trk_context *context, const trk_model *model,
                                             const double *q, trk_modes **out_modes) TRK_MUST_CHECK;

/**
 * The `count` lowest undamped modes (LINEAR.1), as trk_modes_create_undamped() gives them, but
 * for large models by shift-invert Lanczos (LINEAR.20): time and memory grow with the entries of
 * the sparse factor, not with a power of the number of coordinates. Each mode is checked by its
 * residual, and that none is left out by counting eigenvalues below a frequency (LINEAR.21).
 *
 * @param q         [m, rad] working point; NULL for static equilibrium
 * @param count     number of modes, 1 to the number of coordinates
 * @param out_modes owned by caller; NULL on failure
 * @retval TRK_E_RANGE       count is out of range, or the working point is not finite
 * @retval TRK_E_UNSUPPORTED this build has no LAPACK; the model is large, and it has no ARPACK or
 *                           CHOLMOD
 * @retval TRK_E_CONVERGENCE the modes asked for were not found, or one may be missing
 * Further errors as trk_modes_create_undamped(). Calls from several threads take turns.
 * Source: R. B. Lehoucq, D. C. Sorensen, C. Yang, ARPACK Users' Guide, SIAM, 1998.
 */
TRK_API trk_status trk_modes_create_lowest(trk_context *context, const trk_model *model,
                                           const double *q, int32_t count,
                                           trk_modes **out_modes) TRK_MUST_CHECK;

/**
 * Damped modes (LINEAR.2), by rising natural frequency |lambda| / 2 pi: one for each
 * complex pair and one for each real eigenvalue (overdamped). A motion that nothing
 * holds or damps gives two zero eigenvalues, its place and its speed.
 *
 * @param q [m, rad] working point; NULL for static equilibrium
 * @param v [m/s, rad/s] velocity at which curves are linearised; NULL for rest
 * Further arguments and errors as trk_modes_create_undamped().
 */
TRK_API trk_status trk_modes_create_damped(trk_context *context, const trk_model *model,
                                           const double *q, const double *v,
                                           trk_modes **out_modes) TRK_MUST_CHECK;

/** Free modes. NULL is allowed. */
TRK_API void trk_modes_destroy(trk_modes *modes);

/** Number of modes. */
TRK_API int32_t trk_modes_count(const trk_modes *modes);

/** Natural frequency |lambda| / 2 pi [Hz] of mode 1 .. count; NaN if there is no such mode. */
TRK_API double trk_modes_frequency(const trk_modes *modes, int32_t mode);

/** Frequency of the free oscillation, Im lambda / 2 pi [Hz]; 0 for an overdamped mode. */
TRK_API double trk_modes_damped_frequency(const trk_modes *modes, int32_t mode);

/** Damping ratio -Re lambda / |lambda| [-]; 0 undamped, 1 overdamped, negative unstable. */
TRK_API double trk_modes_damping_ratio(const trk_modes *modes, int32_t mode);

/**
 * Mode shape: real part and imaginary part [m, rad, times 1/sqrt(kg m^2) or 1/sqrt(kg)],
 * length coordinates, NULL skips one. Scaled so that phi^H M phi = 1; the
 * component with most energy is real and positive.
 * @retval TRK_E_ARGUMENT modes is NULL or there is no such mode
 */
TRK_API trk_status trk_modes_get_shape(const trk_modes *modes, int32_t mode, double *out_re,
                                       double *out_im) TRK_MUST_CHECK;

/**
 * Share of the kinetic energy of a mode in each coordinate,
 * Re(conj(phi_i) (M phi)_i) (LINEAR.4) [-], summing to 1; length coordinates.
 * @retval TRK_E_ARGUMENT a pointer is NULL or there is no such mode
 */
TRK_API trk_status trk_modes_get_energy(const trk_modes *modes, int32_t mode,
                                        double *out_share) TRK_MUST_CHECK;

/** Coordinate id that takes most of the energy of a mode, 0 if there is no such mode. */
TRK_API int32_t trk_modes_dominant(const trk_modes *modes, int32_t mode);

/** Name of that coordinate, "front_axle.z"; two modes may have the same; NULL if there is no such mode; owned by the modes. */
TRK_API const char *trk_modes_label(const trk_modes *modes, int32_t mode);

/**
 * Frequency response of all sensors (LINEAR.3) to
 * u_j = road_gain[j] exp(-i w road_delay[j]) and p_k = load_gain[k].
 *
 * @param q            [m, rad] working point; NULL for static equilibrium
 * @param v            [m/s, rad/s] velocity at which curves are linearised; NULL for rest
 * @param count        number of frequencies
 * @param frequency    [Hz] >= 0, length count
 * @param road_gain    [m] length roads; NULL for zero
 * @param road_delay   [s] length roads; NULL for zero
 * @param load_gain    [N, N m] length ports; NULL for zero
 * @param out_response [unit of the sensor] count x sensors complex numbers, row-major,
 *                     interleaved (re, im)
 * @retval TRK_E_ARGUMENT    a pointer is NULL
 * @retval TRK_E_RANGE       a value is not finite, or a frequency is negative
 * @retval TRK_E_SINGULAR    an undamped resonance lies exactly at a frequency
 * @retval TRK_E_UNSUPPORTED this build has no LAPACK
 * @retval TRK_E_MEMORY      no memory
 */
TRK_API trk_status trk_frequency_response(trk_context *context, const trk_model *model,
                                          const double *q, const double *v, int64_t count,
                                          const double *frequency, const double *road_gain,
                                          const double *road_delay, const double *load_gain,
                                          double *out_response) TRK_MUST_CHECK;

/**
 * Cross spectra of the road inputs of a vehicle that drives at constant speed over a
 * homogeneous road, whose left and right track are alike (LINEAR.9): for inputs i, j
 *
 *     S_ij = S(f) g_ij exp(i w (x_j - x_i) / speed),   g_ij = 1 on one side, else coherence
 *
 * @param count      number of frequencies
 * @param frequency  [Hz] >= 0, length count
 * @param density    [m^2/Hz] one-sided PSD of the height of one track, length count
 * @param speed      [m/s] > 0
 * @param coherence  [-] of left and right, 0 .. 1: the real ratio of cross spectrum and PSD (the
 *                   square root of the ordinary coherence), length count; NULL for 1
 * @param out_input  [m^2/Hz] as the argument `input` of trk_response_psd(); zero for ports
 * @retval TRK_E_ARGUMENT a pointer is NULL
 * @retval TRK_E_RANGE    a value is not finite or out of range
 * Source: C. J. Dodds, J. D. Robson, J. Sound Vib. 31 (1973) 175-183.
 */
TRK_API trk_status trk_road_cross_spectra(trk_context *context, const trk_model *model,
                                          int64_t count, const double *frequency,
                                          const double *density, double speed,
                                          const double *coherence,
                                          double *out_input) TRK_MUST_CHECK;

/**
 * The same for a road of ISO 8608: spectrum (ROAD.1) over the frequency f = n speed, with the
 * coherence of its tracks (ROAD.2) and its contact length. Seed and ramp do not matter.
 *
 * @param road      NULL for the defaults
 * @param speed     [m/s] > 0
 * @param count     number of frequencies
 * @param frequency [Hz] >= 0, length count; outside of low speed .. high speed there is no road
 * @param out_input [m^2/Hz] as the argument `input` of trk_response_psd(); zero for ports
 * @retval TRK_E_ARGUMENT a pointer is NULL
 * @retval TRK_E_OPTIONS  options come from a newer header and set an unknown field
 * @retval TRK_E_RANGE    an option or a value is out of range
 * @retval TRK_E_MEMORY   no memory
 */
TRK_API trk_status trk_road_input_spectra(trk_context *context, const trk_model *model,
                                          const trk_road_options *road, double speed,
                                          int64_t count, const double *frequency,
                                          double *out_input) TRK_MUST_CHECK;

/**
 * Power spectral density of every sensor from the spectra of road inputs and loads, without
 * time stepping (LINEAR.6), and its RMS (LINEAR.10). Responses are superposed from damped modes
 * and each is checked by its residual; where the modes do not suffice (LINEAR.8), it is solved for.
 *
 * The inputs are the roads, then the ports. Entry (i, j) of a matrix is the one-sided cross
 * spectrum as trk_csd() gives it for x = input i and y = input j; each matrix is Hermitian and
 * positive semidefinite, of which only the entries j >= i are read.
 *
 * @param q           [m, rad] working point; NULL for static equilibrium
 * @param v           [m/s, rad/s] velocity at which curves are linearised; NULL for rest
 * @param count       number of frequencies
 * @param frequency   [Hz] >= 0, rising, length count
 * @param input       [unit of input i * unit of input j / Hz] count x inputs x inputs complex
 *                    numbers, row-major, interleaved (re, im)
 * @param out_density [unit of the sensor ^2 / Hz] sensors x count, row-major; NULL to skip
 * @param out_rms     [unit of the sensor] RMS in the band from the first to the last frequency,
 *                    by the trapezoidal rule, length sensors; NULL to skip
 * @retval TRK_E_ARGUMENT    a pointer is NULL, or both outputs are
 * @retval TRK_E_RANGE       a value is not finite or out of range
 * @retval TRK_E_SINGULAR    an undamped resonance lies exactly at a frequency
 * @retval TRK_E_UNSUPPORTED this build has no LAPACK
 * @retval TRK_E_CONVERGENCE LAPACK did not converge
 * @retval TRK_E_MEMORY      no memory
 * Source: D. E. Newland, Random Vibrations, 3rd ed., 1993, chapter 8.
 */
TRK_API trk_status trk_response_psd(trk_context *context, const trk_model *model, const double *q,
                                    const double *v, int64_t count, const double *frequency,
                                    const double *input, double *out_density,
                                    double *out_rms) TRK_MUST_CHECK;

/**
 * The same for an excitation over a span of time: what trk_simulate() and trk_psd() estimate
 * from `samples` samples, but with Welch's method applied to the inputs (LINEAR.11). They
 * differ by what the vehicle remembers beyond a segment, (LINEAR.12) says how much.
 *
 * @param q           [m, rad] working point; NULL for static equilibrium
 * @param v           [m/s, rad/s] velocity at which curves are linearised; NULL for rest
 * @param start       [s] time of the first sample
 * @param step        [s] > 0 from sample to sample
 * @param samples     number of samples
 * @param options     NULL for the defaults; density or spectrum as asked for
 * @param out_density [unit of the sensor ^2 / Hz, or ^2] sensors x trk_psd_length(options,
 *                    samples), row-major: each row as trk_psd() gives it for a channel
 * @param out_rms     [unit of the sensor] of the whole density, as trk_band_rms(), length sensors;
 *                    NULL to skip; with spectrum scaling there is none
 * @retval TRK_E_ARGUMENT a pointer is NULL, or the excitation does not fit the model
 * Further errors as trk_response_psd() and trk_psd().
 */
TRK_API trk_status trk_response_psd_excited(trk_context *context, const trk_model *model,
                                            const double *q, const double *v,
                                            const trk_excitation *excitation, double start,
                                            double step, int64_t samples,
                                            const trk_spectrum_options *options,
                                            double *out_density, double *out_rms) TRK_MUST_CHECK;

/** Options of trk_model_linearise(). */
typedef struct trk_linearise_options {
    size_t  struct_size;    /**< [byte] set by trk_linearise_options_init()                       */
    double  tolerance;      /**< [-] > 0, of the stiffness and damping of each link, and of the mean
                                 elongation in standard deviations; default 1e-6                  */
    double  relaxation;     /**< [-] > 0, at most 1: share of each correction that is taken; it is
                                 halved whenever corrections grow; default 1                      */
    int32_t max_iterations; /**< [-] >= 1; default 100                                            */
    int32_t reserved;       /**< [-] must be 0                                                    */
} trk_linearise_options;

/** Set every field to its default. Call as trk_linearise_options_init(&o, sizeof o). */
TRK_API void trk_linearise_options_init(trk_linearise_options *options, size_t struct_size);

/**
 * Statistical linearisation: the linear links that are nearest to those of the model, in the mean
 * square of the force, while the vehicle moves under random inputs (LINEAR.31). Each depends on
 * how it moves, and the motion on all of them: found by iteration. Curves and laws without memory
 * are exact for Gaussian motion (LINEAR.32); laws with memory go through harmonic cycles whose
 * amplitudes are spread as those of narrow-band motion (LINEAR.33). The mean position moves where
 * forces are not symmetric (LINEAR.35). Without excitation the tangents at rest come out:
 * friction sticks.
 *
 * @param count         number of frequencies
 * @param frequency     [Hz] as of trk_response_psd(), length count; they must resolve the resonances
 * @param input         [unit of input i * unit of input j / Hz] as of trk_response_psd()
 * @param options       NULL for the defaults
 * @param out_stiffness [N/m or N m/rad] of every link, length links; NULL to skip
 * @param out_damping   [N s/m or N m s/rad] of every link, length links; NULL to skip
 * @param out_mean      [m, rad] mean position, measured as the model's coordinates, length
 *                      coordinates; NULL to skip
 * @param out_model     the model with these links, without gravity, its coordinates measured from the
 *                      mean position; it shares nothing with `model` and is owned by caller; NULL
 *                      on failure; NULL to skip
 * @retval TRK_E_ARGUMENT    a pointer is NULL
 * @retval TRK_E_OPTIONS     options come from a newer header and set an unknown field
 * @retval TRK_E_RANGE       a value is not finite or out of range, or a law leaves what it can do (an
 *                           air spring without volume); the message names the link
 * @retval TRK_E_SINGULAR    an undamped resonance lies exactly at a frequency, or nothing holds the
 *                           mean position against forces that are not symmetric
 * @retval TRK_E_MODEL       the linear vehicle is unstable: a mode has negative damping
 * @retval TRK_E_CONVERGENCE no end within max_iterations (the message names the link that changes
 *                           most), or LAPACK did not converge
 * @retval TRK_E_UNSUPPORTED this build has no LAPACK
 * @retval TRK_E_MEMORY      no memory
 * Source: J. B. Roberts, P. D. Spanos, Random Vibration and Statistical Linearization, 1990.
 */
TRK_API trk_status trk_model_linearise(trk_context *context, const trk_model *model, int64_t count,
                                       const double *frequency, const double *input,
                                       const trk_linearise_options *options, double *out_stiffness,
                                       double *out_damping, double *out_mean,
                                       trk_model **out_model) TRK_MUST_CHECK;

/**
 * Describing function of a law: stiffness and damping of the spring and damper that give the
 * harmonic of its force in a settled cycle e = mean + amplitude cos(2 pi frequency t) (LINEAR.33).
 *
 * @param mean          [m or rad]
 * @param amplitude     [m or rad] > 0
 * @param frequency     [Hz] > 0
 * @param out_stiffness [N/m or N m/rad] NULL to skip
 * @param out_damping   [N s/m or N m s/rad] NULL to skip
 * @retval TRK_E_ARGUMENT a pointer is NULL
 * @retval TRK_E_RANGE    a value is out of range, or the law leaves what it can do
 */
TRK_API trk_status trk_law_describe(trk_context *context, const trk_law *law, double mean,
                                    double amplitude, double frequency, double *out_stiffness,
                                    double *out_damping) TRK_MUST_CHECK;

#endif
