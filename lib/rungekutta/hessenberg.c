/* SPDX-License-Identifier: MIT */
/* QR iteration on a complex Hessenberg matrix (RUNGEKUTTA.6). */
#include "rungekutta/hessenberg.h"

#include "linalg/complex.h"

#include <float.h>
#include <math.h>

enum { MAX_STEPS = 60 }; /* for one eigenvalue */

/* Product without the treatment of infinities, which costs most of the time. */
static inline double complex times(double complex a, double complex b)
{
    return trk_complex(creal(a) * creal(b) - cimag(a) * cimag(b),
                       creal(a) * cimag(b) + cimag(a) * creal(b));
}

static double size(double complex z)
{
    return fabs(creal(z)) + fabs(cimag(z));
}

/* The eigenvalue of the last 2 x 2 block of rows 0 .. last that lies nearer to its last entry. */
static double complex find_shift(int32_t n, const double complex *h, int32_t last)
{
    const double complex *lower = h + (int64_t)last * n + last, *upper = lower - n;
    double complex half = (upper[-1] - lower[0]) / 2;
    double complex root = csqrt(times(half, half) + times(upper[0], lower[-1]));
    if (creal(half) * creal(root) + cimag(half) * cimag(root) < 0)
        root = -root;
    double complex sum = half + root;
    return size(sum) > 0 ? lower[0] - times(upper[0], lower[-1]) / sum : lower[0];
}

/* (x, y) := (c x + s y, c y - conj(s) x), the rotation that takes (a, b) to (r, 0). */
typedef struct rotation {
    double c;
    double complex s;
} rotation;

static rotation find_rotation(double complex a, double complex b)
{
    double length = cabs(a), r = hypot(length, cabs(b));
    if (length == 0)
        return (rotation){0, 1};
    return (rotation){length / r, times(a / length, conj(b)) / r};
}

/* One QR step on rows and columns first .. last. */
static void step(int32_t n, double complex *h, int32_t first, int32_t last, double complex shift)
{
    rotation before = {1, 0};
    for (int32_t k = first; k <= last; k++)
        h[(int64_t)k * n + k] -= shift;
    for (int32_t k = first; k <= last; k++) {
        rotation now = {1, 0};
        if (k < last) {
            double complex *x = h + (int64_t)k * n, *y = x + n;
            now = find_rotation(x[k], y[k]);
            for (int32_t j = k; j <= last; j++) {
                double complex a = x[j], b = y[j];
                x[j] = now.c * a + times(now.s, b);
                y[j] = now.c * b - times(conj(now.s), a);
            }
        }
        if (k > first) /* columns k - 1, k: row k + 1 does not use them any more */
            for (int32_t i = first; i <= k; i++) {
                double complex *x = h + (int64_t)i * n + k - 1, a = x[0], b = x[1];
                x[0] = before.c * a + times(conj(before.s), b);
                x[1] = before.c * b - times(before.s, a);
            }
        before = now;
    }
    for (int32_t k = first; k <= last; k++)
        h[(int64_t)k * n + k] += shift;
}

/* First row of the last block that does not fall apart. */
static int32_t find_block(int32_t n, const double complex *h, int32_t last)
{
    int32_t k = last;
    for (; k > 0; k--) {
        const double complex *d = h + (int64_t)k * n + k;
        if (size(d[-1]) <= DBL_EPSILON * (size(d[0]) + size(d[-1 - n])))
            break;
    }
    return k;
}

bool trk_hessenberg_eigenvalues(int32_t n, double complex *h, double complex *out_lambda)
{
    for (int64_t k = 0; k < (int64_t)n * n; k++)
        if (!isfinite(size(h[k])))
            return false;
    int32_t steps = 0;
    for (int32_t last = n - 1; last >= 0;) {
        int32_t first = find_block(n, h, last);
        const double complex *corner = h + (int64_t)last * n + last;
        if (first == last) {
            out_lambda[last--] = *corner;
            steps = 0;
            continue;
        }
        if (steps++ == MAX_STEPS)
            return false;
        bool stuck = steps % 10 == 0; /* a shift that breaks a cycle */
        step(n, h, first, last, stuck ? *corner + cabs(corner[-1]) : find_shift(n, h, last));
    }
    return true;
}
