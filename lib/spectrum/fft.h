/* SPDX-License-Identifier: MIT */
/* Discrete Fourier transforms of any length, forward, several sequences at once. */
#ifndef TRK_SPECTRUM_FFT_H
#define TRK_SPECTRUM_FFT_H

#include "base/base.h"
#include "spectrum/kernel.h"

/*
 * Plan for Z[k] = sum_j z[j] exp(-2 pi i j k / n) of `kernel->lanes` sequences, laid out
 * in cells as kernel.h says. Immutable. Lengths whose prime factors are at most 31 are
 * transformed by passes (SPECTRUM.11), others by Bluestein's convolution (SPECTRUM.12).
 * n >= 1.
 */
typedef struct trk_fft trk_fft;

trk_status trk_fft_create(trk_context *context, int64_t n, const trk_fft_kernel *kernel,
                          trk_fft **out_fft);
void trk_fft_destroy(trk_fft *fft);

/* Length in doubles of each of the two buffers of trk_fft_forward(). */
int64_t trk_fft_buffer(const trk_fft *fft);

/* Transform data, with work as scratch; both are overwritten. Returns the one of them that
 * holds the result, so that no pass is spent on copying. */
double *trk_fft_forward(const trk_fft *fft, double *data, double *work);

/*
 * The same for real sequences: data holds n rows of `lanes` samples, the result n / 2 + 1
 * cells. An even length costs a complex transform of half the length (SPECTRUM.13).
 */
typedef struct trk_real_fft trk_real_fft;

trk_status trk_real_fft_create(trk_context *context, int64_t n, const trk_fft_kernel *kernel,
                               trk_real_fft **out_fft);
void trk_real_fft_destroy(trk_real_fft *fft);
int64_t trk_real_fft_buffer(const trk_real_fft *fft);
double *trk_real_fft_forward(const trk_real_fft *fft, double *data, double *work);

#endif
