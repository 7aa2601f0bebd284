/* SPDX-License-Identifier: MIT */
/* Body of every FFT kernel; included once per kernel with REAL, LANES and TARGET defined. */

/*
 * REAL is the number type: double, or a vector of LANES doubles, on which + - * act
 * lane by lane. TARGET is the attribute that lets a function use wider registers;
 * every function carries it, otherwise the compiler would split the vectors.
 * Passes are Stockham's (SPECTRUM.11): sorted output, contiguous inner loop.
 */
#include <stdbool.h>
#include "spectrum/kernel.h"

typedef struct cell {
    REAL re, im;
} cell;

#define INLINE TARGET static inline

INLINE cell add(cell a, cell b)
{
    return (cell){a.re + b.re, a.im + b.im};
}

INLINE cell subtract(cell a, cell b)
{
    return (cell){a.re - b.re, a.im - b.im};
}

/* a - i b */
INLINE cell subtract_i(cell a, cell b)
{
    return (cell){a.re + b.im, a.im - b.re};
}

/* a + i b */
INLINE cell add_i(cell a, cell b)
{
    return (cell){a.re - b.im, a.im + b.re};
}

INLINE cell scale(cell a, double c)
{
    return (cell){a.re * c, a.im * c};
}

INLINE cell times(cell a, const double *w)
{
    return (cell){a.re * w[0] - a.im * w[1], a.re * w[1] + a.im * w[0]};
}

/* Store output k of column p; the first column's factors are one. */
#define PUT(k, value) (b[(k)*s] = turn ? times((value), w + 2 * ((k)-1)) : (value))

INLINE void column2(const cell *a, int64_t step, cell *b, int64_t s, const double *w, bool turn)
{
    for (int64_t q = 0; q < s; q++, a++, b++) {
        cell a0 = a[0], a1 = a[step];
        b[0] = add(a0, a1);
        PUT(1, subtract(a0, a1));
    }
}

INLINE void column3(const cell *a, int64_t step, cell *b, int64_t s, const double *w, bool turn)
{
    const double sin60 = 0.86602540378443864676;
    for (int64_t q = 0; q < s; q++, a++, b++) {
        cell sum = add(a[step], a[2 * step]);
        cell difference = scale(subtract(a[step], a[2 * step]), sin60);
        cell middle = subtract(a[0], scale(sum, 0.5));
        b[0] = add(a[0], sum);
        PUT(1, subtract_i(middle, difference));
        PUT(2, add_i(middle, difference));
    }
}

INLINE void column4(const cell *a, int64_t step, cell *b, int64_t s, const double *w, bool turn)
{
    for (int64_t q = 0; q < s; q++, a++, b++) {
        cell sum02 = add(a[0], a[2 * step]), difference02 = subtract(a[0], a[2 * step]);
        cell sum13 = add(a[step], a[3 * step]), difference13 = subtract(a[step], a[3 * step]);
        b[0] = add(sum02, sum13);
        PUT(1, subtract_i(difference02, difference13));
        PUT(2, subtract(sum02, sum13));
        PUT(3, add_i(difference02, difference13));
    }
}

INLINE void column5(const cell *a, int64_t step, cell *b, int64_t s, const double *w, bool turn)
{
    const double cos72 = 0.30901699437494742410, sin72 = 0.95105651629515357212;
    const double cos144 = -0.80901699437494742410, sin144 = 0.58778525229247312917;
    for (int64_t q = 0; q < s; q++, a++, b++) {
        cell sum14 = add(a[step], a[4 * step]), difference14 = subtract(a[step], a[4 * step]);
        cell sum23 = add(a[2 * step], a[3 * step]);
        cell difference23 = subtract(a[2 * step], a[3 * step]);
        cell even1 = add(a[0], add(scale(sum14, cos72), scale(sum23, cos144)));
        cell even2 = add(a[0], add(scale(sum14, cos144), scale(sum23, cos72)));
        cell odd1 = add(scale(difference14, sin72), scale(difference23, sin144));
        cell odd2 = subtract(scale(difference14, sin144), scale(difference23, sin72));
        b[0] = add(a[0], add(sum14, sum23));
        PUT(1, subtract_i(even1, odd1));
        PUT(2, subtract_i(even2, odd2));
        PUT(3, add_i(even2, odd2));
        PUT(4, add_i(even1, odd1));
    }
}

INLINE void column8(const cell *a, int64_t step, cell *b, int64_t s, const double *w, bool turn)
{
    const double sin45 = 0.70710678118654752440;
    for (int64_t q = 0; q < s; q++, a++, b++) {
        cell sum04 = add(a[0], a[4 * step]), difference04 = subtract(a[0], a[4 * step]);
        cell sum26 = add(a[2 * step], a[6 * step]);
        cell difference26 = subtract(a[2 * step], a[6 * step]);
        cell even0 = add(sum04, sum26), even2 = subtract(sum04, sum26);
        cell even1 = subtract_i(difference04, difference26);
        cell even3 = add_i(difference04, difference26);
        cell sum15 = add(a[step], a[5 * step]), difference15 = subtract(a[step], a[5 * step]);
        cell sum37 = add(a[3 * step], a[7 * step]);
        cell difference37 = subtract(a[3 * step], a[7 * step]);
        cell odd0 = add(sum15, sum37), odd2 = subtract(sum15, sum37);
        cell odd1 = subtract_i(difference15, difference37);
        cell odd3 = add_i(difference15, difference37);
        /* times exp(-i pi/4) and exp(-3 i pi/4) */
        odd1 = (cell){(odd1.re + odd1.im) * sin45, (odd1.im - odd1.re) * sin45};
        odd3 = (cell){(odd3.im - odd3.re) * sin45, (odd3.re + odd3.im) * -sin45};
        b[0] = add(even0, odd0);
        PUT(1, add(even1, odd1));
        PUT(2, subtract_i(even2, odd2));
        PUT(3, add(even3, odd3));
        PUT(4, subtract(even0, odd0));
        PUT(5, subtract(even1, odd1));
        PUT(6, add_i(even2, odd2));
        PUT(7, subtract(even3, odd3));
    }
}

#define DEFINE_PASS(R)                                                                             \
    TARGET static void radix##R(const trk_fft_pass *pass, const double *x, double *y)              \
    {                                                                                              \
        const int64_t s = pass->stride, m = pass->columns;                                         \
        column##R((const cell *)x, s *m, (cell *)y, s, pass->twiddle, false);                      \
        for (int64_t p = 1; p < m; p++)                                                            \
            column##R((const cell *)x + s * p, s * m, (cell *)y + R * s * p, s,                    \
                      pass->twiddle + 2 * (R - 1) * p, true);                                      \
    }

DEFINE_PASS(2)
DEFINE_PASS(3)
DEFINE_PASS(4)
DEFINE_PASS(5)
DEFINE_PASS(8)

/* Any odd radix, by sums and differences of mirrored inputs: half the work of the definition. */
TARGET static void general_point(const cell *a, int64_t step, int64_t radix, const double *root,
                                 cell *b, int64_t s, const double *w)
{
    cell sum[TRK_FFT_LARGEST_RADIX / 2 + 1], difference[TRK_FFT_LARGEST_RADIX / 2 + 1];
    const int64_t half = radix / 2;
    const bool turn = true;
    cell total = a[0];
    for (int64_t j = 1; j <= half; j++) {
        sum[j] = add(a[j * step], a[(radix - j) * step]);
        difference[j] = subtract(a[j * step], a[(radix - j) * step]);
        total = add(total, sum[j]);
    }
    b[0] = total;
    for (int64_t k = 1; k <= half; k++) {
        cell even = a[0], odd = {(REAL){0}, (REAL){0}};
        for (int64_t j = 1, jk = k; j <= half; j++, jk = jk + k < radix ? jk + k : jk + k - radix) {
            even = add(even, scale(sum[j], root[2 * jk]));
            odd = subtract(odd, scale(difference[j], root[2 * jk + 1]));
        }
        PUT(k, subtract_i(even, odd));
        PUT(radix - k, add_i(even, odd));
    }
}

TARGET static void general(const trk_fft_pass *pass, const double *x, double *y)
{
    const int64_t s = pass->stride, m = pass->columns, r = pass->radix;
    for (int64_t p = 0; p < m; p++)
        for (int64_t q = 0; q < s; q++)
            general_point((const cell *)x + s * p + q, s * m, r, pass->root,
                          (cell *)y + r * s * p + q, s, pass->twiddle + 2 * (r - 1) * p);
}

TARGET static void multiply(int64_t count, const double *factor, double *x)
{
    cell *z = (cell *)x;
    for (int64_t k = 0; k < count; k++)
        z[k] = times(z[k], factor + 2 * k);
}

TARGET static void conjugate_multiply(int64_t count, const double *factor, double *x)
{
    cell *z = (cell *)x;
    for (int64_t k = 0; k < count; k++)
        z[k] = times((cell){z[k].re, -z[k].im}, factor + 2 * k);
}

TARGET static void split_real(int64_t half, const double *root, const double *z_in, double *x_out)
{
    const cell *z = (const cell *)z_in;
    cell *x = (cell *)x_out;
    x[0] = (cell){z[0].re + z[0].im, (REAL){0}};
    x[half] = (cell){z[0].re - z[0].im, (REAL){0}};
    for (int64_t k = 1; k <= half - k; k++) {
        cell a = scale(z[k], 0.5), b = scale(z[half - k], 0.5);
        cell even = {a.re + b.re, a.im - b.im};
        cell odd = times((cell){a.im + b.im, b.re - a.re}, root + 2 * k);
        x[k] = add(even, odd);
        x[half - k] = (cell){even.re - odd.re, odd.im - even.im};
    }
}

/* Windowed samples less their trend, the lanes side by side (SPECTRUM.3). */
TARGET static void load(int64_t n, const trk_fft_segment *segment, const double *window,
                        double *rows)
{
    const double middle = 0.5 * (double)(n - 1);
    for (int64_t i = 0; i < n; i++)
        for (int l = 0; l < LANES; l++) {
            const trk_fft_segment *from = &segment[l];
            const double trend = from->mean + from->slope * ((double)i - middle);
            rows[LANES * i + l] = (from->x[i] - trend) * (from->gain * window[i]);
        }
}

TARGET static void add_power(int64_t count, const double *x_in, double *sum_out)
{
    const cell *x = (const cell *)x_in;
    REAL *sum = (REAL *)sum_out;
    for (int64_t k = 0; k < count; k++)
        sum[k] += x[k].re * x[k].re + x[k].im * x[k].im;
}

TARGET static void add_cross(int64_t count, const double *x_in, const double *y_in, double *sum_out)
{
    const cell *x = (const cell *)x_in, *y = (const cell *)y_in;
    cell *sum = (cell *)sum_out;
    for (int64_t k = 0; k < count; k++) {
        sum[k].re += x[k].re * y[k].re + x[k].im * y[k].im;
        sum[k].im += x[k].re * y[k].im - x[k].im * y[k].re;
    }
}

#define KERNEL                                                                                     \
    {                                                                                              \
        LANES, radix2, radix3, radix4, radix5, radix8, general, multiply, conjugate_multiply,      \
            split_real, add_power, add_cross, load                                                 \
    }
