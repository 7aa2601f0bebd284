/* SPDX-License-Identifier: MIT */
/**
 * @file  truckride/spectrum.h
 * @brief Spectra of measured or simulated channels: Welch PSD, cross spectrum, coherence,
 *        frequency response, band RMS, peaks.
 *
 * All spectra are one-sided, of real samples, estimated by averaging the windowed
 * periodograms of overlapping segments (docs/theory.md, section SPECTRUM). With the
 * same settings they are those of scipy.signal.welch, csd and coherence. Frequency k
 * of a segment of L samples is k sample_rate / L, k = 0 .. L / 2.
 *
 * The caller allocates the results: ask trk_psd_length() first. On failure no result
 * is written.
 */
#ifndef TRUCKRIDE_SPECTRUM_H
#define TRUCKRIDE_SPECTRUM_H

#include <truckride/base.h>

/** Window of a segment, periodic (DFT-even), cosine sums as SPECTRUM.2. */
typedef int32_t trk_window;
enum {
    TRK_WINDOW_HANN            = 0, /**< side lobes -31 dB; the usual choice              */
    TRK_WINDOW_RECTANGULAR     = 1, /**< narrowest peak, -13 dB; for periodic signals     */
    TRK_WINDOW_HAMMING         = 2, /**< -43 dB                                           */
    TRK_WINDOW_BLACKMAN        = 3, /**< -58 dB                                           */
    TRK_WINDOW_BLACKMAN_HARRIS = 4, /**< -92 dB                                           */
    TRK_WINDOW_FLAT_TOP        = 5, /**< amplitude of a sine to 0.02 dB between two bins  */
    TRK_WINDOW_KAISER          = 6  /**< shape by trk_spectrum_options.kaiser_beta        */
};

/** What is taken off each segment before the window. */
typedef int32_t trk_detrend;
enum {
    TRK_DETREND_CONSTANT = 0, /**< its mean                      */
    TRK_DETREND_NONE     = 1, /**< nothing                       */
    TRK_DETREND_LINEAR   = 2  /**< its least-squares straight line */
};

/** Unit of a PSD or cross spectrum. */
typedef int32_t trk_scaling;
enum {
    TRK_SCALING_DENSITY  = 0, /**< [any^2/Hz]: level of noise, area is the mean square    */
    TRK_SCALING_SPECTRUM = 1  /**< [any^2]: height of a sine of amplitude A is A^2 / 2    */
};

/** How a spectrum is estimated. */
typedef struct trk_spectrum_options {
    size_t      struct_size;    /**< [byte] set by trk_spectrum_options_init()                 */
    int64_t     segment_length; /**< [-] samples of a segment, >= 1; default 0: 4096, or all
                                     samples if they are fewer                               */
    double      overlap;        /**< [-] 0 <= overlap < 1: segments share
                                     floor(overlap * segment_length) samples; default 0.5    */
    trk_window  window;         /**< [-] default TRK_WINDOW_HANN                               */
    trk_detrend detrend;        /**< [-] default TRK_DETREND_CONSTANT                          */
    trk_scaling scaling;        /**< [-] default TRK_SCALING_DENSITY                           */
    int32_t     reserved;       /**< [-] must be 0                                             */
    double      kaiser_beta;    /**< [-] 0 .. 700, Kaiser window only: 0 is rectangular, 8.6
                                     (default) like Blackman                                 */
} trk_spectrum_options;

/** Set every field to its default. Call as trk_spectrum_options_init(&o, sizeof o). */
TRK_API void trk_spectrum_options_init(trk_spectrum_options *options, size_t struct_size);

/**
 * Number of frequencies of a spectrum: segment length / 2 + 1, rounded down.
 *
 * @param options NULL for the defaults
 * @param count   number of samples
 * @return 0 if the options are not valid or count is shorter than one segment;
 *         trk_psd() then says why
 */
TRK_API int64_t trk_psd_length(const trk_spectrum_options *options, int64_t count);

/** Number of segments that are averaged; arguments and 0 as trk_psd_length(). Samples after
 *  the last whole segment are not used. */
TRK_API int64_t trk_psd_segments(const trk_spectrum_options *options, int64_t count);

/**
 * Frequencies of a spectrum.
 *
 * @param count         number of samples
 * @param sample_rate   [Hz] > 0
 * @param options       NULL for the defaults
 * @param out_frequency [Hz] length trk_psd_length(options, count), from 0 to sample_rate / 2
 *                      (odd segments end half a bin below)
 * @retval TRK_E_ARGUMENT a pointer is NULL, or an option has an unknown value
 * @retval TRK_E_OPTIONS  options come from a newer header and set an unknown field
 * @retval TRK_E_RANGE    an option or sample_rate is out of range, or count is shorter than
 *                        one segment
 */
TRK_API trk_status trk_psd_frequencies(trk_context *context, int64_t count, double sample_rate,
                                       const trk_spectrum_options *options,
                                       double *out_frequency) TRK_MUST_CHECK;

/**
 * One-sided power spectral density by Welch's averaged periodograms (SPECTRUM.3).
 *
 * @param count       number of samples
 * @param x           [any] samples, length count
 * @param sample_rate [Hz] > 0
 * @param options     NULL for 4096 samples, Hann window, 50 % overlap, constant detrend
 * @param out_density [any^2/Hz, or any^2] length trk_psd_length(options, count)
 * @retval TRK_E_ARGUMENT a pointer is NULL, or an option has an unknown value
 * @retval TRK_E_OPTIONS  options come from a newer header and set an unknown field
 * @retval TRK_E_RANGE    an option or sample_rate is out of range, count is shorter than one
 *                        segment, a sample is not finite (the message names it), or its
 *                        square overflows
 * @retval TRK_E_MEMORY   no memory
 * Source: P. D. Welch, IEEE Trans. Audio Electroacoust. 15 (1967) 70-73.
 */
TRK_API trk_status trk_psd(trk_context *context, int64_t count, const double *x,
                           double sample_rate, const trk_spectrum_options *options,
                           double *out_density) TRK_MUST_CHECK;

/**
 * One-sided cross spectral density of x and y, the average of conj(X) Y (SPECTRUM.4).
 * Its phase is that of y relative to x: negative if y lags.
 *
 * @param count       number of samples
 * @param x           [any] length count
 * @param y           [any] length count
 * @param sample_rate [Hz] > 0
 * @param options     NULL for the defaults
 * @param out_cross   [unit of x * unit of y / Hz, or without / Hz] real and imaginary parts
 *                    in turn, length 2 * trk_psd_length(options, count)
 * Errors as trk_psd().
 */
TRK_API trk_status trk_csd(trk_context *context, int64_t count, const double *x, const double *y,
                           double sample_rate, const trk_spectrum_options *options,
                           double *out_cross) TRK_MUST_CHECK;

/**
 * Magnitude-squared coherence |Pxy|^2 / (Pxx Pyy), 0 .. 1 (SPECTRUM.5).
 *
 * With a single segment it is 1 whatever the signals; the bias of N independent
 * segments is about (1 - coherence)^2 / N. NaN where Pxx or Pyy is exactly zero.
 *
 * @param count         number of samples
 * @param x             [any] length count
 * @param y             [any] length count
 * @param options       NULL for the defaults; scaling makes no difference
 * @param out_coherence [-] length trk_psd_length(options, count)
 * Errors as trk_psd().
 * Source: G. C. Carter, C. H. Knapp, A. H. Nuttall, IEEE Trans. Audio Electroacoust. 21
 * (1973) 337-344.
 */
TRK_API trk_status trk_coherence(trk_context *context, int64_t count, const double *x,
                                 const double *y, const trk_spectrum_options *options,
                                 double *out_coherence) TRK_MUST_CHECK;

/**
 * Frequency response from x to y by the H1 estimator Pxy / Pxx (SPECTRUM.6): least squares
 * if only y is disturbed by noise. NaN where Pxx is exactly zero.
 *
 * @param count        number of samples
 * @param x            [any] input, length count
 * @param y            [any] output, length count
 * @param options      NULL for the defaults; scaling makes no difference
 * @param out_response [unit of y / unit of x] real and imaginary parts in turn, length
 *                     2 * trk_psd_length(options, count)
 * Errors as trk_psd().
 * Source: J. S. Bendat, A. G. Piersol, Random Data, 4th ed., Wiley 2010, ch. 6.
 */
TRK_API trk_status trk_frf_h1(trk_context *context, int64_t count, const double *x,
                              const double *y, const trk_spectrum_options *options,
                              double *out_response) TRK_MUST_CHECK;

/**
 * PSD divided by a reference, to compare shapes (SPECTRUM.7).
 *
 * @param length         number of values
 * @param density        [any^2/Hz] length length
 * @param reference      [any^2/Hz] > 0, e.g. the maximum of the measurement that this PSD is
 *                       compared with; 0 for the maximum of density itself
 * @param out_normalised [-] length length; may be density
 * @param out_reference  [any^2/Hz] the divisor; NULL to skip
 * @retval TRK_E_ARGUMENT a pointer is NULL
 * @retval TRK_E_RANGE    length < 1, a density is negative or not finite, reference is negative
 *                        or not finite, or the maximum is 0 and nothing to divide by, or a
 *                        quotient overflows
 */
TRK_API trk_status trk_psd_normalise(trk_context *context, int64_t length, const double *density,
                                     double reference, double *out_normalised,
                                     double *out_reference) TRK_MUST_CHECK;

/**
 * RMS of the part of a signal between two frequencies, from its one-sided PSD (SPECTRUM.8).
 *
 * The power density[k] * frequency_step of bin k lies evenly between half a bin below and
 * half a bin above its frequency (bin 0: from 0 to half a bin); bins cut by the band count in
 * proportion. A band from 0 to sample_rate takes everything, which by Parseval is the mean
 * square of the windowed samples.
 *
 * @param length         number of frequencies
 * @param density        [any^2/Hz] length length
 * @param frequency_step [Hz] > 0, sample_rate / segment length
 * @param low            [Hz] >= 0
 * @param high           [Hz] >= low; may lie beyond the last bin
 * @param out_rms        [any]
 * @retval TRK_E_ARGUMENT a pointer is NULL
 * @retval TRK_E_RANGE    length < 1, a density is negative or not finite, frequency_step, low
 *                        or high is out of range, or the sum overflows
 */
TRK_API trk_status trk_band_rms(trk_context *context, int64_t length, const double *density,
                                double frequency_step, double low, double high,
                                double *out_rms) TRK_MUST_CHECK;

/** Order of found peaks. */
typedef int32_t trk_peak_order;
enum {
    TRK_PEAK_ORDER_HEIGHT    = 0, /**< highest first          */
    TRK_PEAK_ORDER_FREQUENCY = 1  /**< lowest frequency first */
};

/** Options of trk_psd_peaks(). */
typedef struct trk_peak_options {
    size_t         struct_size;        /**< [byte] set by trk_peak_options_init()              */
    double         minimum_height;     /**< [any^2/Hz] >= 0; default 0                         */
    double         minimum_prominence; /**< [any^2/Hz] >= 0; default 0                         */
    double         minimum_distance;   /**< [Hz] >= 0 between two peaks, else the lower one is
                                            dropped; default 0                                */
    trk_peak_order order;              /**< [-] default TRK_PEAK_ORDER_HEIGHT                  */
    int32_t        reserved;           /**< [-] must be 0                                      */
} trk_peak_options;

/** Set every field to its default. Call as trk_peak_options_init(&o, sizeof o). */
TRK_API void trk_peak_options_init(trk_peak_options *options, size_t struct_size);

/**
 * Peaks of a PSD: local maxima selected by height, then distance, then prominence, with the
 * definitions of scipy.signal.find_peaks (SPECTRUM.9). The first and the last bin are no
 * peaks. Of two equally high peaks too close together the one of lower frequency stays.
 *
 * The frequency is that of the vertex of the parabola through the logarithms of the
 * densities at the peak and its two neighbours (SPECTRUM.10), which is exact for a Gaussian
 * and, in a Hann window, within 0.02 bin for a sine; on a plateau of two or more equal bins
 * its middle, beside a zero the frequency of the bin.
 *
 * @param length         number of frequencies
 * @param density        [any^2/Hz] length length
 * @param frequency_step [Hz] > 0
 * @param options        NULL for all peaks, highest first
 * @param capacity       room in each of the arrays, >= 0
 * @param out_frequency  [Hz] interpolated, length capacity; NULL to skip
 * @param out_height     [any^2/Hz] density of the bin, length capacity; NULL to skip
 * @param out_prominence [any^2/Hz] height above the higher one of the lowest points towards
 *                       the next higher peak on either side, length capacity; NULL to skip
 * @param out_count      number of peaks found; if it exceeds capacity, the first capacity of
 *                       them in the order asked for were written
 * @retval TRK_E_ARGUMENT a pointer is NULL, or an option has an unknown value
 * @retval TRK_E_OPTIONS  options come from a newer header and set an unknown field
 * @retval TRK_E_RANGE    length < 1, capacity < 0, a density is negative or not finite, or
 *                        frequency_step or an option is out of range
 * @retval TRK_E_MEMORY   no memory
 */
TRK_API trk_status trk_psd_peaks(trk_context *context, int64_t length, const double *density,
                                 double frequency_step, const trk_peak_options *options,
                                 int64_t capacity, double *out_frequency, double *out_height,
                                 double *out_prominence, int64_t *out_count) TRK_MUST_CHECK;

#endif
