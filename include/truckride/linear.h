/* SPDX-License-Identifier: MIT */
/**
 * @file  truckride/linear.h
 * @brief Modes and frequency response of a model about a working point.
 *
 * With the tangents of (MODEL.4):
 *
 *     K phi = omega^2 M phi,  phi^T M phi = 1                         (LINEAR.1)
 *     (lambda^2 M + lambda C + K) phi = 0                             (LINEAR.2)
 *     (K + i w C - w^2 M) q = B^T (k + i w c) G u + P p               (LINEAR.3)
 *
 * Needs TRK_FEATURE_LAPACK.
 */
#ifndef TRUCKRIDE_LINEAR_H
#define TRUCKRIDE_LINEAR_H

#include <truckride/model.h>

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

#endif
