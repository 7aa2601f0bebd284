/* SPDX-License-Identifier: MIT */
/* Expected value and slope of a piecewise cubic under a Gaussian (LINEAR.32). */
#include "linear/gaussian.h"

#include "curve/curve.h"

/* Integrals of y^k phi(y), k = 0 .. 3, over a piece. */
typedef struct moments {
    double of[4];
} moments;

static double density(double y)
{
    return isinf(y) ? 0 : 0.39894228040143267794 * exp(-0.5 * y * y);
}

/* Probability of a .. b, its tails without the difference from 1. */
static double probability(double a, double b)
{
    const double root = 0.70710678118654752440;
    if (a >= 0)
        return 0.5 * (erfc(a * root) - erfc(b * root));
    if (b <= 0)
        return 0.5 * (erfc(-b * root) - erfc(-a * root));
    return 0.5 * (erf(b * root) - erf(a * root));
}

static moments moments_over(double a, double b)
{
    const double at_a = density(a), at_b = density(b);
    const double a1 = at_a > 0 ? a * at_a : 0, b1 = at_b > 0 ? b * at_b : 0;
    const double a2 = at_a > 0 ? a * a1 : 0, b2 = at_b > 0 ? b * b1 : 0;
    moments m;
    m.of[0] = probability(a, b);
    m.of[1] = at_a - at_b;
    m.of[2] = m.of[0] + a1 - b1;
    m.of[3] = 2 * m.of[1] + a2 - b2;
    return m;
}

void trk_gaussian_curve(const trk_curve *curve, double mean, double deviation, double *out_value,
                        double *out_slope)
{
    if (!(deviation > 0)) {
        trk_curve_point(curve, mean, &(int32_t){0}, out_value, out_slope);
        return;
    }
    double value = 0, slope = 0;
    for (int32_t k = 0; k <= curve->count; k++) {
        const trk_piece *p = &curve->pieces[k];
        const moments m =
            moments_over((p->lower - mean) / deviation, (p->upper - mean) / deviation);
        if (m.of[0] == 0)
            continue;
        /* The cubic about the mean, in deviations. */
        const double d = mean - p->origin, s = deviation,
                     c2 = k == 0 || k == curve->count ? 0 : p->c2,
                     c3 = k == 0 || k == curve->count ? 0 : p->c3;
        const double first = p->c1 + d * (2 * c2 + d * 3 * c3), second = c2 + 3 * d * c3;
        value += (p->c0 + d * (p->c1 + d * (c2 + d * c3))) * m.of[0] +
                 s * (first * m.of[1] + s * (second * m.of[2] + s * c3 * m.of[3]));
        slope += first * m.of[0] + s * (2 * second * m.of[1] + s * 3 * c3 * m.of[2]);
    }
    *out_value = value;
    *out_slope = slope;
}
