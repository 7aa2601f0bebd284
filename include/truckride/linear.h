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
 * @param frequency  [Hz] > 0, length count
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
 * @param out_density [unit of the sensor ^2 / Hz] sensors x count, row-major
 * @param out_rms     [unit of the sensor] RMS in the band from the first to the last frequency,
 *                    by the trapezoidal rule, length sensors; NULL to skip
 * @retval TRK_E_ARGUMENT    a pointer is NULL
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

#endif
