/* SPDX-License-Identifier: MIT */
/*
 * Newton correction d of the forces g of the non-linear links,
 *
 *     (I + T D) d = m,  m = law - g                                   (NEWMARK.7)
 *
 * With T = S^2, S diagonal, it is d = m - S u with a symmetric matrix whose eigenvalues are
 * at least 1, so that it needs no pivots, and D d comes with it (NEWMARK.22):
 *
 *     (I + S D S) u = S D m,   D d = S^-1 u
 */
#include "newmark/newmark.h"

#include "linalg/small.h"

#include <math.h>
#include <string.h>

/* y := D x */
static void couple(const trk_newmark *stepper, const double *restrict x, double *restrict y)
{
    int32_t p = stepper->p;
    for (int32_t j = 0; j < p; j++) {
        const double *row = stepper->coupling + (int64_t)j * p;
        double sum = 0;
        for (int32_t k = 0; k < p; k++)
            sum += row[k] * x[k];
        y[j] = sum;
    }
}

/* Upper triangle of A = U^T diag(d) U in place, U with a unit diagonal, 1 / d on the diagonal. */
static void factorize(int32_t n, double *a)
{
    for (int32_t k = 0; k < n; k++) {
        const double *restrict pivot = a + (int64_t)k * n;
        double reciprocal = 1 / pivot[k];
        for (int32_t i = k + 1; i < n; i++) {
            double *restrict row = a + (int64_t)i * n;
            double factor = pivot[i] * reciprocal;
            for (int32_t j = i; j < n; j++)
                row[j] -= factor * pivot[j];
        }
        a[(int64_t)k * n + k] = reciprocal;
    }
}

/* x := A^-1 x by those factors; the rows above the diagonal are still those of diag(d) U. */
static void substitute(int32_t n, const double *a, double *restrict x)
{
    for (int32_t k = 0; k < n; k++) {
        const double *row = a + (int64_t)k * n;
        double y = x[k] * row[k];
        for (int32_t i = k + 1; i < n; i++)
            x[i] -= row[i] * y;
    }
    for (int32_t k = n; k-- > 0;) {
        const double *row = a + (int64_t)k * n;
        double sum = x[k];
        for (int32_t i = k + 1; i < n; i++)
            sum -= row[i] * x[i];
        x[k] = sum * row[k];
    }
}

/* All slopes >= 0: trial := d, pull := D d. */
static void solve_rising(trk_newmark *stepper)
{
    int32_t p = stepper->p;
    double *u = stepper->trial, *pull = stepper->pull, *root = stepper->root;
    couple(stepper, stepper->mismatch, u);
    for (int32_t j = 0; j < p; j++) {
        root[j] = sqrt(stepper->slope[j]);
        pull[j] = u[j];
        u[j] *= root[j];
    }
    for (int32_t j = 0; j < p; j++) {
        const double *restrict d = stepper->coupling + (int64_t)j * p;
        double *restrict row = stepper->jacobian + (int64_t)j * p;
        for (int32_t k = j; k < p; k++)
            row[k] = root[j] * d[k] * root[k];
        row[j] += 1;
    }
    factorize(p, stepper->jacobian);
    substitute(p, stepper->jacobian, u);
    bool is_level = false;
    for (int32_t j = 0; j < p; j++) {
        is_level |= root[j] == 0;
        pull[j] = u[j] / root[j];
        u[j] = stepper->mismatch[j] - root[j] * u[j];
    }
    if (is_level) /* u says nothing there */
        couple(stepper, stepper->trial, pull);
}

/* Some slope < 0. false: no correction. */
static bool solve_any(trk_newmark *stepper)
{
    int32_t p = stepper->p;
    for (int32_t j = 0; j < p; j++)
        for (int32_t k = 0; k < p; k++)
            stepper->jacobian[(int64_t)j * p + k] =
                stepper->slope[j] * stepper->coupling[(int64_t)j * p + k] + (j == k);
    memcpy(stepper->trial, stepper->mismatch, (size_t)p * sizeof *stepper->trial);
    if (!trk_small_solve(p, stepper->jacobian, stepper->trial))
        return false;
    couple(stepper, stepper->trial, stepper->pull);
    return true;
}

static double start_of(const trk_newmark *stepper)
{
    double sum = 0;
    for (int32_t j = 0; j < stepper->p; j++)
        sum += stepper->pull[j] * stepper->mismatch[j];
    return sum;
}

double trk_newmark_find_direction(trk_newmark *stepper)
{
    bool is_rising = true;
    for (int32_t j = 0; j < stepper->p; j++)
        is_rising &= stepper->slope[j] >= 0;
    if (!is_rising && solve_any(stepper) && start_of(stepper) >= 0)
        return start_of(stepper);
    for (int32_t j = 0; j < stepper->p; j++) /* a law that falls counts as level */
        stepper->slope[j] = stepper->slope[j] > 0 ? stepper->slope[j] : 0;
    solve_rising(stepper);
    return start_of(stepper);
}
