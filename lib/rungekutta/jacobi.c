/* SPDX-License-Identifier: MIT */
/* Cholesky reduction and cyclic Jacobi rotations (RUNGEKUTTA.8). */
#include "rungekutta/jacobi.h"

#include <float.h>
#include <math.h>

enum { MAX_SWEEPS = 30 };

/* M = L L^T, L into the lower triangle. */
static void factorize(int32_t n, double *m)
{
    for (int32_t j = 0; j < n; j++)
        for (int32_t i = j; i < n; i++) {
            double sum = m[i * n + j];
            for (int32_t k = 0; k < j; k++)
                sum -= m[i * n + k] * m[j * n + k];
            m[i * n + j] = i == j ? sqrt(sum) : sum / m[j * n + j];
        }
}

/* K := L^-1 K L^-T, by columns, then by rows. */
static void reduce(int32_t n, const double *l, double *k)
{
    for (int pass = 0; pass < 2; pass++)
        for (int32_t c = 0; c < n; c++)
            for (int32_t i = 0; i < n; i++) {
                double *x = pass == 0 ? k + c : k + c * n;
                int32_t stride = pass == 0 ? n : 1;
                double sum = x[i * stride];
                for (int32_t j = 0; j < i; j++)
                    sum -= l[i * n + j] * x[j * stride];
                x[i * stride] = sum / l[i * n + i];
            }
}

/* Rotate rows and columns p, q so that a[p][q] vanishes; u takes the product of rotations. */
static void rotate(int32_t n, double *a, double *u, int32_t p, int32_t q)
{
    double off = a[p * n + q];
    double theta = (a[q * n + q] - a[p * n + p]) / (2 * off);
    double t = (theta < 0 ? -1 : 1) / (fabs(theta) + hypot(theta, 1));
    double c = 1 / hypot(t, 1), s = t * c;
    for (int32_t i = 0; i < n; i++) {
        double x = a[i * n + p], y = a[i * n + q];
        a[i * n + p] = c * x - s * y;
        a[i * n + q] = s * x + c * y;
    }
    for (int32_t i = 0; i < n; i++) {
        double x = a[p * n + i], y = a[q * n + i];
        a[p * n + i] = c * x - s * y;
        a[q * n + i] = s * x + c * y;
        x = u[i * n + p];
        y = u[i * n + q];
        u[i * n + p] = c * x - s * y;
        u[i * n + q] = s * x + c * y;
    }
    a[p * n + q] = a[q * n + p] = 0;
}

static void diagonalise(int32_t n, double *a, double *u)
{
    double largest = 0;
    for (int32_t i = 0; i < n * n; i++)
        largest = fmax(largest, fabs(a[i]));
    for (int sweep = 0, rotated = 1; rotated && sweep < MAX_SWEEPS; sweep++) {
        rotated = 0;
        for (int32_t p = 0; p < n; p++)
            for (int32_t q = p + 1; q < n; q++)
                if (fabs(a[p * n + q]) > 0.01 * DBL_EPSILON * largest) {
                    rotate(n, a, u, p, q);
                    rotated = 1;
                }
    }
}

void trk_jacobi_modes(int32_t n, double *k, double *m, double *out_lambda, double *out_phi,
                      double *work)
{
    factorize(n, m);
    reduce(n, m, k);
    for (int32_t i = 0; i < n; i++)
        for (int32_t j = 0; j < n; j++)
            work[i * n + j] = i == j;
    diagonalise(n, k, work);
    for (int32_t c = 0; c < n; c++) { /* phi = L^-T u */
        out_lambda[c] = k[c * n + c];
        for (int32_t i = n; i-- > 0;) {
            double sum = work[i * n + c];
            for (int32_t j = i + 1; j < n; j++)
                sum -= m[j * n + i] * out_phi[j * n + c];
            out_phi[i * n + c] = sum / m[i * n + i];
        }
    }
}
