/* SPDX-License-Identifier: MIT */
/* Averaged periodograms of one or two records: the sums behind all public spectra. */
#ifndef TRK_SPECTRUM_WELCH_H
#define TRK_SPECTRUM_WELCH_H

#include "spectrum/fft.h"
#include "spectrum/settings.h"

/* Which averages are wanted. */
enum { TRK_WELCH_XX = 1, TRK_WELCH_YY = 2, TRK_WELCH_XY = 4 };

/* What records of one length and one setting share. Immutable; threads may share it. */
typedef struct trk_welch_plan {
    trk_context *context;
    trk_spectrum_settings settings;
    const trk_fft_kernel *kernel;
    trk_real_fft *fft;
    double *window;
} trk_welch_plan;

/* Plan for records of count samples; `what` stands in front of messages. On failure
 * everything is freed, on success end with trk_welch_plan_free(). */
trk_status trk_welch_plan_create(trk_context *context, const char *what, int64_t count,
                                 const trk_spectrum_options *options, trk_welch_plan *out_plan);
void trk_welch_plan_free(trk_welch_plan *plan);

/* Spectra of count segments from x on, in the lanes, the further lanes 0; count is at most
 * the number of lanes. The buffers hold trk_real_fft_buffer(plan->fft) each. */
const double *trk_welch_transform(const trk_welch_plan *plan, int64_t count, const double *x,
                                  double *const buffer[2]);

/* Sums of the lanes, count of each, become averages over the segments, in place; false if one
 * overflowed. */
bool trk_welch_reduce(const trk_welch_plan *plan, int64_t count, double *sum);

/* One-sided, scaled values of `parts` numbers a frequency (SPECTRUM.3, SPECTRUM.4). */
trk_status trk_welch_write(const trk_welch_plan *plan, const char *what, double sample_rate,
                           int64_t parts, const double *average, double *out);

typedef struct trk_welch {
    trk_welch_plan plan;
    double *buffer[4]; /* data and work of x, and of y */
    double *xx, *yy;   /* average of |X|^2, |Y|^2 over the segments, settings.length each   */
    double *xy;        /* average of conj(X) Y, real and imaginary in turn; NULL: not wanted */
} trk_welch;

/*
 * Average over the segments of x, and of y if it is not NULL, with the sums in `wanted`.
 * The spectra are those of the windowed samples, neither scaled nor one-sided yet. On
 * failure everything is freed; on success end with trk_welch_free().
 */
trk_status trk_welch_average(trk_context *context, const char *what, int64_t count, const double *x,
                             const double *y, const trk_spectrum_options *options, int wanted,
                             trk_welch *out_welch);
void trk_welch_free(trk_welch *welch);

#endif
