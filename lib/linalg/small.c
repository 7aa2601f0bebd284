/* SPDX-License-Identifier: MIT */
/* LU with partial pivoting of small dense systems (LINALG.5). */
#include "linalg/small.h"

#include <float.h>
#include <math.h>

/*
 * Bring the largest entry of each row to 1, so that the choice of pivots, and the rule
 * when one counts as zero, do not depend on the units of the equations.
 */
static bool equilibrate(int32_t n, double *a, double *b)
{
    for (int32_t i = 0; i < n; i++) {
        double *row = a + (int64_t)i * n;
        double largest = 0.0, sum = 0.0;
        for (int32_t j = 0; j < n; j++) {
            largest = fmax(largest, fabs(row[j]));
            sum += row[j];
        }
        /* fmax passes over a NaN, the sum does not. */
        if (!(largest > 0.0) || !isfinite(sum) || !isfinite(b[i]))
            return false;
        double scale = 1.0 / largest;
        for (int32_t j = 0; j < n; j++)
            row[j] *= scale;
        b[i] *= scale;
    }
    return true;
}

static int32_t find_pivot(int32_t n, const double *a, int32_t k)
{
    int32_t best = k;
    for (int32_t i = k + 1; i < n; i++)
        if (fabs(a[(int64_t)i * n + k]) > fabs(a[(int64_t)best * n + k]))
            best = i;
    return best;
}

static void swap_rows(int32_t n, double *a, double *b, int32_t i, int32_t k)
{
    for (int32_t j = k; j < n; j++) {
        double kept = a[(int64_t)i * n + j];
        a[(int64_t)i * n + j] = a[(int64_t)k * n + j];
        a[(int64_t)k * n + j] = kept;
    }
    double kept = b[i];
    b[i] = b[k];
    b[k] = kept;
}

bool trk_small_solve(int32_t n, double *a, double *b)
{
    if (!equilibrate(n, a, b))
        return false;
    for (int32_t k = 0; k < n; k++) {
        int32_t best = find_pivot(n, a, k);
        if (best != k)
            swap_rows(n, a, b, best, k);
        const double *pivot_row = a + (int64_t)k * n;
        if (!(fabs(pivot_row[k]) > n * DBL_EPSILON))
            return false;
        double reciprocal = 1.0 / pivot_row[k];
        for (int32_t i = k + 1; i < n; i++) {
            double *row = a + (int64_t)i * n;
            double factor = row[k] * reciprocal;
            for (int32_t j = k + 1; j < n; j++)
                row[j] -= factor * pivot_row[j];
            b[i] -= factor * b[k];
        }
    }
    for (int32_t i = n; i-- > 0;) {
        const double *row = a + (int64_t)i * n;
        double sum = b[i];
        for (int32_t j = i + 1; j < n; j++)
            sum -= row[j] * b[j];
        b[i] = sum / row[i];
        if (!isfinite(b[i]))
            return false;
    }
    return true;
}
