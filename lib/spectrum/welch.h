/* SPDX-License-Identifier: MIT */
/* Averaged periodograms of one or two records: the sums behind all public spectra. */
#ifndef TRK_SPECTRUM_WELCH_H
#define TRK_SPECTRUM_WELCH_H

#include "spectrum/fft.h"
#include "spectrum/settings.h"

/* Which averages are wanted. */
enum { TRK_WELCH_XX = 1, TRK_WELCH_YY = 2, TRK_WELCH_XY = 4 };

typedef struct trk_welch {
    trk_context *context;
    trk_spectrum_settings settings;
    const trk_fft_kernel *kernel;
    trk_real_fft *fft;
    double *window;
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

/* A one-sided value at frequency k is the average times scale times sides (SPECTRUM.3). */
double trk_welch_scale(const trk_welch *welch, double sample_rate);
double trk_welch_sides(const trk_welch *welch, int64_t k);

#endif
