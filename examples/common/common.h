/* SPDX-License-Identifier: MIT */
/* What the examples share: result files, the road-simulator run and its spectra. */
#ifndef EXAMPLES_COMMON_H
#define EXAMPLES_COMMON_H

#include <stdio.h>
#include <truckride/truckride.h>

/* Print the library's message and end the program unless status is TRK_OK. */
void check(trk_context *context, trk_status status);

/* malloc() that ends the program when there is no memory. */
void *allocate(size_t size);

/* Create a file of results, or end the program. */
FILE *open_result(const char *directory, const char *name);

/* Print to a file and to stdout. */
void print_both(FILE *file, const char *format, ...);

/* Compile a spec and destroy it. */
trk_model *compile(trk_context *context, trk_spec *spec);

/* Set the scale of a link's damper curve. */
void set_damper_scale(trk_context *context, trk_spec *spec, const char *link, double scale);

/* An excitation with all wheels of a model on one sweep, whose signal is left for the caller to
 * destroy after it. */
trk_excitation *create_sweep(trk_context *context, const trk_model *model,
                             const trk_sweep_options *options, trk_signal **out_signal);

/* Run the road-simulator sweep, 0.8 to 20 Hz in 480 s at 1 ms with all wheels in phase;
 * amplitude [m] is that at 1 Hz. */
trk_series *run_sweep(trk_context *context, const trk_model *model, double amplitude);

/* Hann windows of 8.192 s: frequencies 0.12 Hz apart. */
void spectrum_settings(trk_spectrum_options *settings, double overlap);

/* A sweep passes each frequency once, and the segments see it pass at different places of their
 * windows. At an overlap of 0.75 that leaves a ripple of about 1 % with peaks of its own, up to
 * 0.15 Hz beside the true one; at 0.9 it is gone. */
#define SMOOTH_OVERLAP 0.9

/* [Hz] between two frequencies of the spectrum. */
double frequency_step(const trk_series *series, const trk_spectrum_options *settings);

/* PSD of a channel [unit^2/Hz], trk_psd_length() values, for the caller to free(). */
double *psd_of(trk_context *context, const trk_series *series, const char *channel,
               const trk_spectrum_options *settings);

/* Up to capacity peaks of a channel's PSD from a frequency [Hz] to the end of the sweep, highest
 * first, that stand out of their surroundings by a part of their height and are 1 Hz apart.
 * Returns how many. */
int32_t find_peaks(trk_context *context, const trk_series *series, const char *channel, double from,
                   double part, int32_t capacity, double *out_frequency, double *out_height);

/* RMS of a channel; 0 where symmetry leaves nothing but rounding. */
double rms_of(const trk_series *series, const char *channel);

#endif
