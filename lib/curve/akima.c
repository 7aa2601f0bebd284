/* SPDX-License-Identifier: MIT */
/* Akima's slopes: an outlier disturbs its neighbours only (CURVE.4). */
#include "curve/slopes.h"

#include <math.h>

/* Secant k; beyond either end two more are extrapolated linearly. */
static double secant(int64_t count, const double *x, const double *y, int64_t k)
{
    int64_t last = count - 2;
    if (k < 0) {
        double m0 = secant(count, x, y, 0);
        return m0 + (double)-k * (m0 - secant(count, x, y, 1));
    }
    if (k > last) {
        double m0 = secant(count, x, y, last);
        return m0 + (double)(k - last) * (m0 - secant(count, x, y, last - 1));
    }
    return (y[k + 1] - y[k]) / (x[k + 1] - x[k]);
}

void trk_akima_slopes(int64_t count, const double *x, const double *y, double *out_slopes)
{
    if (count == 2) {
        out_slopes[0] = out_slopes[1] = (y[1] - y[0]) / (x[1] - x[0]);
        return;
    }
    double largest = 0.0; /* sum of the two weights */
    for (int64_t k = 0; k < count; k++) {
        double weights = fabs(secant(count, x, y, k + 1) - secant(count, x, y, k)) +
                         fabs(secant(count, x, y, k - 1) - secant(count, x, y, k - 2));
        largest = fmax(largest, weights);
    }
    for (int64_t k = 0; k < count; k++) {
        double m[4]; /* two secants before the point, two after */
        for (int j = 0; j < 4; j++)
            m[j] = secant(count, x, y, k - 2 + j);
        double before = fabs(m[3] - m[2]), after = fabs(m[1] - m[0]);
        /* Both weights vanish where two straight lines meet: the mean direction. */
        if (before + after > 1e-9 * largest)
            out_slopes[k] = (before * m[1] + after * m[2]) / (before + after);
        else
            out_slopes[k] = 0.5 * (m[0] + m[3]);
    }
}
