/* SPDX-License-Identifier: MIT */
/**
 * @file  truckride/series.h
 * @brief Sampled channels: names, units, sample rate. What a run records.
 *
 * Equally spaced samples of several channels over one time axis. Each channel is
 * contiguous in memory, so that it can be handed to trk_psd() or to a plotting
 * library without a copy.
 */
#ifndef TRUCKRIDE_SERIES_H
#define TRUCKRIDE_SERIES_H

#include <truckride/base.h>

/** Channels over one time axis. */
typedef struct trk_series trk_series;

/**
 * Create a series of zeros with channels named "1", "2", ... and unit "".
 *
 * @param channels    >= 1
 * @param samples     >= 1, per channel
 * @param sample_rate [Hz] > 0
 * @param start       [s] time of the first sample
 * @param out_series  owned by caller; NULL on failure
 * @retval TRK_E_ARGUMENT a pointer is NULL
 * @retval TRK_E_RANGE    a count, the rate or start is out of range
 * @retval TRK_E_MEMORY   no memory
 */
TRK_API trk_status trk_series_create(trk_context *context, int32_t channels, int64_t samples,
                                     double sample_rate, double start,
                                     trk_series **out_series) TRK_MUST_CHECK;

/** Free a series. NULL is allowed. */
TRK_API void trk_series_destroy(trk_series *series);

/**
 * Name a channel and its unit.
 *
 * @param channel 1 .. trk_series_channels()
 * @param name    not empty, not used by another channel; copied
 * @param unit    e.g. "m/s^2"; copied
 * @retval TRK_E_ARGUMENT a pointer is NULL, or no such channel
 * @retval TRK_E_NAME     the name is empty or taken
 * @retval TRK_E_MEMORY   no memory
 */
TRK_API trk_status trk_series_label(trk_series *series, int32_t channel, const char *name,
                                    const char *unit) TRK_MUST_CHECK;

/** Number of channels. */
TRK_API int32_t trk_series_channels(const trk_series *series);

/** Number of samples of each channel. */
TRK_API int64_t trk_series_samples(const trk_series *series);

/** Sample rate [Hz]. */
TRK_API double trk_series_rate(const trk_series *series);

/** Time of the first sample [s]. */
TRK_API double trk_series_start(const trk_series *series);

/** Number of the channel with that name, 0 if there is none. */
TRK_API int32_t trk_series_find(const trk_series *series, const char *name);

/** Name of a channel, NULL if there is no such channel; owned by the series. */
TRK_API const char *trk_series_name(const trk_series *series, int32_t channel);

/** Unit of a channel, NULL if there is no such channel; owned by the series. */
TRK_API const char *trk_series_unit(const trk_series *series, int32_t channel);

/** Samples of a channel [its unit], length trk_series_samples(); NULL if there is no
 *  such channel; owned by the series. */
TRK_API const double *trk_series_data(const trk_series *series, int32_t channel);

/** The same for writing [its unit]. */
TRK_API double *trk_series_data_mutable(trk_series *series, int32_t channel);

/**
 * Resample all channels at another rate over the same time span.
 *
 * A linear-phase low-pass (sinc with a Kaiser window) is flat to 1e-4 up to 0.8 of
 * the lower of the two Nyquist frequencies and 80 dB down beyond it; it acts before
 * picking on the way down and interpolates on the way up (SERIES.1). It reaches 30
 * samples of the slower rate to either side; beyond its ends the series is continued
 * by its end values. The first sample stays at its time, the last does not go past
 * the old one.
 *
 * @param sample_rate [Hz] > 0; the ratio to the old rate must be p/q with p, q <= 1000
 * @param out_series  owned by caller; NULL on failure
 * @retval TRK_E_ARGUMENT a pointer is NULL
 * @retval TRK_E_RANGE    sample_rate out of range or no such ratio
 * @retval TRK_E_MEMORY   no memory
 */
TRK_API trk_status trk_series_resample(trk_context *context, const trk_series *series,
                                       double sample_rate, trk_series **out_series) TRK_MUST_CHECK;

/**
 * Write as CSV (RFC 4180, but lines end with a line feed alone): header line
 * "time [s],name [unit],...", without [] where the unit is "", then a line a sample,
 * numbers with 9 digits and a decimal point in every locale. A label with a comma, a
 * quote or a line break is quoted.
 *
 * @param path  file to write; an existing one is replaced
 * @param every write each every-th sample, >= 1 (1 writes all)
 * @retval TRK_E_ARGUMENT a pointer is NULL
 * @retval TRK_E_RANGE    every < 1
 * @retval TRK_E_FILE     the file cannot be written (the message names it and the
 *                        system's reason); what was written is removed
 * @retval TRK_E_MEMORY   no memory
 */
TRK_API trk_status trk_series_write_csv(trk_context *context, const trk_series *series,
                                        const char *path, int64_t every) TRK_MUST_CHECK;

#endif
