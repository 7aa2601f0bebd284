/* SPDX-License-Identifier: MIT */
/* Slopes that keep a monotone table monotone (CURVE.3). */
#include "curve/slopes.h"

#include <math.h>

static int sign(double a)
{
    return (a > 0.0) - (a < 0.0);
}

/* Harmonic mean of the secants, weighted by the spacings (CURVE.3a). */
static double inner_slope(double h0, double h1, double m0, double m1)
{
    if (sign(m0) * sign(m1) <= 0)
        return 0.0;
    double w0 = 2.0 * h1 + h0, w1 = h1 + 2.0 * h0;
    double mean = (w0 + w1) / (w0 / m0 + w1 / m1);
    /* The mean is below three times either secant; rounding must not spoil that,
     * because monotonicity is proven from it. */
    double limit = 3.0 * fmin(fabs(m0), fabs(m1));
    return fabs(mean) > limit ? copysign(limit, mean) : mean;
}

/* Parabola through the three points at an end, limited (CURVE.3b). h0, m0 belong to the end. */
static double end_slope(double h0, double h1, double m0, double m1)
{
    double d = ((2.0 * h0 + h1) * m0 - h0 * m1) / (h0 + h1);
    if (sign(d) != sign(m0))
        return 0.0;
    if (sign(m0) != sign(m1) && fabs(d) > 3.0 * fabs(m0))
        return 3.0 * m0;
    return d;
}

void trk_pchip_slopes(int64_t count, const double *x, const double *y, double *out_slopes)
{
    double h0 = x[1] - x[0], m0 = (y[1] - y[0]) / h0;
    if (count == 2) {
        out_slopes[0] = out_slopes[1] = m0;
        return;
    }
    for (int64_t k = 1; k < count - 1; k++) {
        double h1 = x[k + 1] - x[k], m1 = (y[k + 1] - y[k]) / h1;
        if (k == 1)
            out_slopes[0] = end_slope(h0, h1, m0, m1);
        out_slopes[k] = inner_slope(h0, h1, m0, m1);
        if (k == count - 2)
            out_slopes[count - 1] = end_slope(h1, h0, m1, m0);
        h0 = h1;
        m0 = m1;
    }
}
