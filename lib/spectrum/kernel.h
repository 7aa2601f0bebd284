/* SPDX-License-Identifier: MIT */
/* The inner loops of the FFT as a table of functions: one table per register width. */
#ifndef TRK_SPECTRUM_KERNEL_H
#define TRK_SPECTRUM_KERNEL_H

#include <stdint.h>

/*
 * A kernel transforms `lanes` sequences side by side. Its unit of data is a
 * cell: the real parts of one element of every lane, then the imaginary parts,
 *     data[2 lanes k + l] = Re z_l[k],  data[2 lanes k + lanes + l] = Im z_l[k].
 * One lane is the usual interleaved complex array. Arrays are aligned to the
 * register, as trk_new() does. Twiddle factors are shared by the lanes and
 * stored as plain complex numbers.
 */
typedef struct trk_fft_pass {
    int64_t radix;
    int64_t columns;       /* m: length of this pass's transforms over the radix */
    int64_t stride;        /* s: product of the radices of the passes before     */
    const double *twiddle; /* w^(p k), k = 1 .. radix - 1 for each column p       */
    const double *root;    /* the radix-th roots of one; only for the general pass */
} trk_fft_pass;

enum { TRK_FFT_LARGEST_RADIX = 31 };

/* One pass of (SPECTRUM.11), x to y; they must not overlap. */
typedef void (*trk_fft_run_pass)(const trk_fft_pass *pass, const double *x, double *y);

/* One segment of a record on its way into a lane. */
typedef struct trk_fft_segment {
    const double *x;
    double mean, slope; /* trend mean + slope (i - (n - 1) / 2) to take off */
    double gain;        /* 0 for a lane without a segment, else 1          */
} trk_fft_segment;

typedef struct trk_fft_kernel {
    int64_t lanes;
    trk_fft_run_pass radix2, radix3, radix4, radix5, radix8, general;
    /* x[k] = x[k] f[k] and x[k] = conj(x[k]) f[k] for count cells. */
    void (*multiply)(int64_t count, const double *factor, double *x);
    void (*conjugate_multiply)(int64_t count, const double *factor, double *x);
    /* (SPECTRUM.13): spectrum X[0 .. half] of a real sequence from the transform z of its
     * even and odd samples; root are the 2 half-th roots of one. X must not overlap z. */
    void (*split_real)(int64_t half, const double *root, const double *z, double *X);
    /* sum[k] += |x[k]|^2, one sum per lane. */
    void (*add_power)(int64_t count, const double *x, double *sum);
    /* sum[k] += conj(x[k]) y[k], a cell of sums each. */
    void (*add_cross)(int64_t count, const double *x, const double *y, double *sum);
    /* rows[lanes i + l] = windowed, detrended sample i of segment l, for n samples. */
    void (*load)(int64_t n, const trk_fft_segment *segment, const double *window, double *rows);
} trk_fft_kernel;

extern const trk_fft_kernel trk_fft_kernel_scalar; /* one lane                          */
extern const trk_fft_kernel trk_fft_kernel_lanes;  /* four lanes in any vector registers */

/* The fastest several-lane kernel of this processor. Every kernel performs the same
 * operations in the same order, so all of them give the same bits. */
const trk_fft_kernel *trk_fft_kernel_widest(void);

#endif
