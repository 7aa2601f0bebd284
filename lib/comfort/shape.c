/* SPDX-License-Identifier: MIT */
/* Least squares in cosines, then spectral factorisation by Newton's method (COMFORT.5). */
#include "comfort/shape.h"
#include "linalg/small.h"

#include <math.h>
#include <string.h>

enum { TAPS = TRK_SHAPE_TAPS, NEWTON_STEPS = 60 };

/* Above this angle only the sign matters; 80 Hz at 200 Hz lies at 0.8 pi. */
static const double band = 0.85 * 3.14159265358979323846, weight_beyond = 0.05;

/* Coefficients c of sum c_k cos(k angle), fitted to power. */
static bool fit_cosines(int32_t nodes, const double *angle, const double *power, double *c)
{
    double matrix[TAPS * TAPS] = {0};
    memset(c, 0, TAPS * sizeof *c);
    for (int32_t i = 0; i < nodes; i++) {
        double weight = (angle[i] < band ? 1 : weight_beyond) / power[i], row[TAPS];
        for (int k = 0; k < TAPS; k++)
            row[k] = weight * cos(k * angle[i]);
        for (int k = 0; k < TAPS; k++) {
            c[k] += row[k] * weight * power[i];
            for (int j = 0; j < TAPS; j++)
                matrix[k * TAPS + j] += row[k] * row[j];
        }
    }
    return trk_small_solve(TAPS, matrix, c);
}

/* One Newton step for sum_i b_i b_{i+k} = r_k; size of the step relative to b_0, or -1. */
static double newton(const double *r, double *b)
{
    double matrix[TAPS * TAPS], step[TAPS];
    for (int k = 0; k < TAPS; k++) {
        step[k] = r[k];
        for (int i = 0; i + k < TAPS; i++)
            step[k] -= b[i] * b[i + k];
        for (int j = 0; j < TAPS; j++)
            matrix[k * TAPS + j] = (j + k < TAPS ? b[j + k] : 0) + (j >= k ? b[j - k] : 0);
    }
    if (!trk_small_solve(TAPS, matrix, step))
        return -1;
    double size = 0;
    for (int k = 0; k < TAPS; k++) {
        b[k] += step[k];
        size = fmax(size, fabs(step[k]));
    }
    return size / fabs(b[0]);
}

bool trk_shape_fit(int32_t nodes, const double *angle, const double *power, double *out_taps)
{
    double r[TAPS];
    if (!fit_cosines(nodes, angle, power, r) || !(r[0] > 0))
        return false;
    for (int k = 1; k < TAPS; k++)
        r[k] /= 2;
    /* From a lone tap Newton's method arrives at the factor with all zeros inside the circle
     * (G. Wilson, SIAM J. Numer. Anal. 6 (1969) 1-7). */
    double b[TAPS] = {sqrt(r[0])}, size = 1;
    for (int step = 0; step < NEWTON_STEPS && size > 1e-13; step++) {
        size = newton(r, b);
        if (size < 0)
            return false;
    }
    memcpy(out_taps, b, sizeof b);
    return size <= 1e-13;
}
