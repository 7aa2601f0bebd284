/* SPDX-License-Identifier: MIT */
/* Window functions: sums of cosines, and Kaiser's (SPECTRUM.2). */
#include "spectrum/window.h"
#include "spectrum/roots.h"

#include <math.h>

enum { MAX_TERMS = 5 };

/*
 * Coefficients a_j of w(i) = sum_j (-1)^j a_j cos(2 pi j i / n). Sources: F. J. Harris,
 * Proc. IEEE 66 (1978) 51-83; flat top: G. D'Antona, A. Ferrero, Digital Signal Processing
 * for Measurement Systems, Springer 2006, p. 70.
 */
static const double coefficients[][MAX_TERMS] = {
    [TRK_WINDOW_HANN] = {0.5, 0.5},
    [TRK_WINDOW_RECTANGULAR] = {1.0},
    [TRK_WINDOW_HAMMING] = {0.54, 0.46},
    [TRK_WINDOW_BLACKMAN] = {0.42, 0.50, 0.08},
    [TRK_WINDOW_BLACKMAN_HARRIS] = {0.35875, 0.48829, 0.14128, 0.01168},
    [TRK_WINDOW_FLAT_TOP] = {0.21557895, 0.41663158, 0.277263158, 0.083578947, 0.006947368},
};

static void fill_cosines(const double *a, int64_t n, const double *root, double *out)
{
    for (int64_t i = 0; i < n; i++) {
        double sum = a[0], sign = -1;
        int64_t angle = i; /* j i modulo n */
        for (int j = 1; j < MAX_TERMS && a[j] != 0; j++, sign = -sign) {
            sum += sign * a[j] * root[2 * angle];
            angle = angle + i < n ? angle + i : angle + i - n;
        }
        out[i] = sum;
    }
}

/* Modified Bessel function I_0: its power series, all terms positive. */
static double bessel_i0(double x)
{
    double term = 1, sum = 1;
    for (double k = 1; term > 1e-17 * sum; k++) {
        term *= (0.5 * x / k) * (0.5 * x / k);
        sum += term;
    }
    return sum;
}

static void fill_kaiser(double beta, int64_t n, double *out)
{
    const double top = bessel_i0(beta);
    for (int64_t i = 0; i < n; i++) {
        const double t = 2.0 * (double)i / (double)n - 1.0;
        out[i] = bessel_i0(beta * sqrt(1.0 - t * t)) / top;
    }
}

trk_status trk_window_fill(trk_context *context, trk_window window, double beta, int64_t n,
                           double *out)
{
    if (n == 1 || window == TRK_WINDOW_RECTANGULAR) {
        for (int64_t i = 0; i < n; i++)
            out[i] = 1;
        return TRK_OK;
    }
    if (window == TRK_WINDOW_KAISER) {
        fill_kaiser(beta, n, out);
        return TRK_OK;
    }
    double *root = trk_new(context, 2 * n, sizeof *root);
    if (!root)
        return TRK_E_MEMORY;
    trk_roots_fill(n, root);
    fill_cosines(coefficients[window], n, root, out);
    trk_free(context, root);
    return TRK_OK;
}
