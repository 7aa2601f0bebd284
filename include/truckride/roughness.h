/* SPDX-License-Identifier: MIT */
/**
 * @file  truckride/roughness.h
 * @brief Roughness of a measured road profile: IRI, MRI, HRI, and what an ISO 8608 road has.
 *
 * The International Roughness Index is the mean speed between the masses of a standard quarter
 * car at 80 km/h, over the speed (ROUGHNESS.1 to ROUGHNESS.3). Everything here is in slope
 * [m/m]: times 1000 it is the usual [m/km] or [mm/m].
 *
 * A profile holds heights at equal distances of at most TRK_IRI_SPACING_MAXIMUM, the limit of the
 * World Bank's guidelines; 0.05 to 0.25 m is usual. Wavelengths that a coarser profile lacks
 * cannot be put back. Heights at unequal distances become equal ones by trk_signal_create_points()
 * and trk_signal_evaluate().
 */
#ifndef TRUCKRIDE_ROUGHNESS_H
#define TRUCKRIDE_ROUGHNESS_H

#include <truckride/base.h>

/** Largest distance between two heights of a profile [m]. */
#define TRK_IRI_SPACING_MAXIMUM 0.3

/** Options of the roughness functions. */
typedef struct trk_iri_options {
    size_t  struct_size; /**< [byte] set by trk_iri_options_init()                              */
    double  start_length;/**< [m] > 0: the car starts on the mean slope of this length; default 11,
                              half a second                                                     */
    int32_t smoothed;    /**< [-] 1: the profile was averaged over 250 mm when it was measured;
                              default 0: average it here                                        */
    int32_t reserved;    /**< [-] must be 0                                                     */
} trk_iri_options;

/** Set every field to its default. Call as trk_iri_options_init(&o, sizeof o). */
TRK_API void trk_iri_options_init(trk_iri_options *options, size_t struct_size);

/**
 * International Roughness Index of one wheel track (ROUGHNESS.3).
 *
 * @param count   number of heights, >= 2 and more than one averaging length of 0.25 m
 * @param height  [m] length count
 * @param spacing [m] > 0, at most TRK_IRI_SPACING_MAXIMUM
 * @param options NULL for the defaults
 * @param out_iri [m/m] times 1000 is m/km
 * @retval TRK_E_ARGUMENT a pointer is NULL
 * @retval TRK_E_OPTIONS  options come from a newer header and set an unknown field
 * @retval TRK_E_RANGE    count, spacing or an option is out of range, a height is not finite or
 *                        larger than 1e75 m
 * Source: M. W. Sayers, On the calculation of international roughness index from longitudinal
 * road profile, Transportation Research Record 1501 (1995) 1-12; ASTM E1926.
 */
TRK_API trk_status trk_iri(trk_context *context, int64_t count, const double *height,
                           double spacing, const trk_iri_options *options,
                           double *out_iri) TRK_MUST_CHECK;

/** Number of whole segments of trk_iri_segments() for its spacing [m] and segment_length [m];
 *  0 if an argument is out of range. */
TRK_API int64_t trk_iri_segment_count(int64_t count, double spacing,
                                      const trk_iri_options *options, double segment_length);

/**
 * IRI of consecutive segments, the car driving through: segments have round(segment_length /
 * spacing) samples, and their mean is the IRI of the profile they cover. Slopes after the last
 * whole segment are left out.
 *
 * @param segment_length [m] >= spacing; 20 and 100 are usual
 * @param segments       room in out_iri
 * @param out_iri        [m/m] the first min(segments, trk_iri_segment_count()) segments
 * @retval TRK_E_RANGE   segment_length is out of range, or segments is negative
 * Further parameters and errors as trk_iri():
 * @param count   number of heights
 * @param height  [m] length count
 * @param spacing [m]
 * @param options NULL for the defaults
 */
TRK_API trk_status trk_iri_segments(trk_context *context, int64_t count, const double *height,
                                    double spacing, const trk_iri_options *options,
                                    double segment_length, int64_t segments,
                                    double *out_iri) TRK_MUST_CHECK;

/**
 * Mean Roughness Index: mean of the IRI of both wheel tracks (ROUGHNESS.4).
 *
 * @param left    [m] heights of the left track, length count
 * @param right   [m] heights of the right track, length count
 * @param out_mri [m/m]
 * @param count   number of heights
 * @param spacing [m]
 * @param options NULL for the defaults
 * Errors as trk_iri().
 */
TRK_API trk_status trk_mri(trk_context *context, int64_t count, const double *left,
                           const double *right, double spacing, const trk_iri_options *options,
                           double *out_mri) TRK_MUST_CHECK;

/**
 * Half-car Roughness Index: IRI of the mean of both wheel tracks (ROUGHNESS.4); at most the MRI,
 * as roll is averaged out.
 *
 * @param left    [m] heights of the left track, length count
 * @param right   [m] heights of the right track, length count
 * @param out_hri [m/m]
 * @param count   number of heights
 * @param spacing [m]
 * @param options NULL for the defaults
 * @retval TRK_E_MEMORY no memory for the mean track
 * Further errors as trk_iri().
 */
TRK_API trk_status trk_hri(trk_context *context, int64_t count, const double *left,
                           const double *right, double spacing, const trk_iri_options *options,
                           double *out_hri) TRK_MUST_CHECK;

/**
 * Gain of the standard car [-]: amplitude of the slope between its masses over that of the road's
 * slope (ROUGHNESS.5), without the 250 mm average. Peaks 1.5376 at 0.0634 and 1.6765 at 0.4363
 * cycles/m.
 *
 * @param wavenumber [1/m] cycles per metre, >= 0
 * @return NaN for a wavenumber that is negative or not finite
 */
TRK_API double trk_iri_gain(double wavenumber);

/**
 * Expected IRI of a Gaussian road with the displacement PSD
 * G(n) = unevenness (n / 0.1 m^-1)^-waviness of ISO 8608 between two wavenumbers (ROUGHNESS.6),
 * without the 250 mm average; what lies below 1e-6 and above 1e7 cycles/m counts nothing. The
 * means of classes A, B, C, ... with waviness 2 and no limits
 * have 2.219, 4.438, 8.876, ... m/km.
 *
 * @param unevenness [m^3] G at 0.1 cycles/m, >= 0: 16e-6 for class A
 * @param waviness   [-] 1 to 4; 2 in ISO 8608
 * @param low        [1/m] >= 0
 * @param high       [1/m] > low; may be infinite
 * @param out_iri    [m/m]
 * @retval TRK_E_ARGUMENT a pointer is NULL
 * @retval TRK_E_RANGE    a value is out of range
 * Source: ISO 8608:2016; mean magnitude sqrt(2/pi) sigma of a Gaussian signal.
 */
TRK_API trk_status trk_iri_of_road(trk_context *context, double unevenness, double waviness,
                                   double low, double high, double *out_iri) TRK_MUST_CHECK;

#endif
