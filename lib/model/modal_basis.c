/* SPDX-License-Identifier: MIT */
/* Undamped modes of the linear springs, accurate in a relative sense (NEWMARK.14). */
#include "model/modal_basis.h"

#include <float.h>
#include <math.h>
#include <string.h>

enum { MOST_SWEEPS = 60 };

/* Lower triangle L of M = L L^T in place, row-major. */
static bool factorize(int32_t n, double *m)
{
    for (int32_t j = 0; j < n; j++)
        for (int32_t i = j; i < n; i++) {
            double sum = m[i * n + j];
            for (int32_t k = 0; k < j; k++)
                sum -= m[i * n + k] * m[j * n + k];
            if (i > j)
                m[i * n + j] = sum / m[j * n + j];
            else if (sum > 0)
                m[j * n + j] = sqrt(sum);
            else
                return false;
        }
    return true;
}

/* x := L^-1 x: a row b of the links becomes b L^-T. */
static void solve_lower(int32_t n, const double *l, double *x)
{
    for (int32_t i = 0; i < n; i++) {
        for (int32_t k = 0; k < i; k++)
            x[i] -= l[i * n + k] * x[k];
        x[i] /= l[i * n + i];
    }
}

/* x := L^-T x */
static void solve_upper(int32_t n, const double *l, double *x)
{
    for (int32_t i = n - 1; i >= 0; i--) {
        for (int32_t k = i + 1; k < n; k++)
            x[i] -= l[k * n + i] * x[k];
        x[i] /= l[i * n + i];
    }
}

static double dot(int32_t n, const double *x, const double *y)
{
    double sum = 0;
    for (int32_t i = 0; i < n; i++)
        sum += x[i] * y[i];
    return sum;
}

static void rotate(int32_t n, double c, double s, double *x, double *y)
{
    for (int32_t i = 0; i < n; i++) {
        double t = c * x[i] - s * y[i];
        y[i] = s * x[i] + c * y[i];
        x[i] = t;
    }
}

/*
 * Rotate pairs of the n columns of g (each of length m), and those of v alike, until they are
 * orthogonal. Source: J. Demmel, K. Veselic, SIAM J. Matrix Anal. Appl. 13 (1992) 1204-1245.
 */
static bool orthogonalise(int32_t m, int32_t n, double *g, double *v)
{
    bool rotated = true;
    double size = dot(m * n, g, g); /* columns below its rounding are zero: rigid modes */
    for (int sweep = 0; rotated && sweep < MOST_SWEEPS; sweep++) {
        rotated = false;
        for (int32_t i = 0; i < n; i++)
            for (int32_t j = i + 1; j < n; j++) {
                double *x = g + i * m, *y = g + j * m;
                double a = dot(m, x, x), b = dot(m, y, y), c = dot(m, x, y);
                if (fabs(c) <= 4 * DBL_EPSILON * sqrt(a * b) ||
                    fmin(a, b) <= DBL_EPSILON * DBL_EPSILON * size)
                    continue;
                double zeta = (b - a) / (2 * c),
                       t = copysign(1, zeta) / (fabs(zeta) + sqrt(1 + zeta * zeta)),
                       cosine = 1 / sqrt(1 + t * t);
                rotate(m, cosine, cosine * t, x, y);
                rotate(n, cosine, cosine * t, v + i * n, v + j * n);
                rotated = true;
            }
    }
    return !rotated;
}

/* From the columns v of the rotations to Phi = L^-T V and Phi^T M = V^T L^T. */
static void transform(int32_t n, const double *l, const double *v, double *phi, double *phi_inverse,
                      double *column)
{
    for (int32_t j = 0; j < n; j++) {
        for (int32_t i = 0; i < n; i++) {
            phi_inverse[j * n + i] = 0;
            for (int32_t k = 0; k <= i; k++)
                phi_inverse[j * n + i] += l[i * n + k] * v[j * n + k];
        }
        memcpy(column, v + j * n, (size_t)n * sizeof *v);
        solve_upper(n, l, column);
        for (int32_t i = 0; i < n; i++)
            phi[i * n + j] = column[i];
    }
}

trk_status trk_modal_basis(trk_context *context, const trk_model *model, double *phi,
                           double *phi_inverse, double *lambda)
{
    int32_t n = model->n, m = model->links.count;
    double *block = trk_new(context, 2 * (int64_t)n * n + (int64_t)m * n + n, sizeof *block);
    if (!block)
        return TRK_E_MEMORY;
    double *l = block, *v = l + n * n, *g = v + n * n, *row = g + m * n;
    for (int32_t r = 0; r < model->inertia.count; r++)
        trk_rows_add_square(&model->inertia, r, model->mass[r], n, l);
    bool good = factorize(n, l);
    for (int32_t k = 0; good && k < m; k++) {
        trk_rows_expand(&model->links, k, n, row);
        solve_lower(n, l, row);
        for (int32_t i = 0; i < n; i++)
            g[i * m + k] = sqrt(model->laws[k].stiffness) * row[i];
    }
    for (int32_t i = 0; i < n; i++)
        v[i * n + i] = 1;
    good = good && orthogonalise(m, n, g, v);
    for (int32_t i = 0; good && i < n; i++)
        lambda[i] = dot(m, g + i * m, g + i * m);
    if (good)
        transform(n, l, v, phi, phi_inverse, row);
    trk_free(context, block);
    return good ? TRK_OK : TRK_E_SINGULAR;
}
