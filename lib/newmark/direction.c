/* SPDX-License-Identifier: MIT */
/*
 * Newton correction d of the forces g of the non-linear links,
 *
 *     (I + T D) d = m,  m = law - g                                   (NEWMARK.7)
 *
 * With T = S J S, S >= 0 diagonal and J the signs of the slopes, it is found from a symmetric
 * matrix, and D d with it (NEWMARK.22):
 *
 *     (J + S D S) u = S D m,   d = m - S u,   D d = S^-1 J u
 */
#include "newmark/newmark.h"

#include <math.h>

/* Pivot of a falling law, -1 where it falls little, nearest to zero that is divided by. */
static const double LEAST_PIVOT = -1e-3;

/* Row j of D x. */
static double couple(const trk_newmark *stepper, int32_t j, const double *x)
{
    const double *row = stepper->coupling + (int64_t)j * stepper->p;
    double sum = 0;
    for (int32_t k = 0; k < stepper->p; k++)
        sum += row[k] * x[k];
    return sum;
}

static double sign_of(double slope)
{
    return slope < 0 ? -1 : 1;
}

/* Upper triangle of J + S D S. */
static void fill(const trk_newmark *stepper)
{
    const double *root = stepper->root;
    int32_t p = stepper->p;
    for (int32_t j = 0; j < p; j++) {
        const double *restrict d = stepper->coupling + (int64_t)j * p;
        double *restrict row = stepper->jacobian + (int64_t)j * p;
        for (int32_t k = j; k < p; k++)
            row[k] = root[j] * d[k] * root[k];
        row[j] += sign_of(stepper->slope[j]);
    }
}

/*
 * Upper triangle of A = U^T diag(d) U in place, U with a unit diagonal, 1 / d on the diagonal. The
 * pivots of rising laws are at least 1 as long as those of falling ones are negative; false: one
 * is not.
 */
static bool factorize(int32_t n, double *a)
{
    for (int32_t k = 0; k < n; k++) {
        const double *restrict pivot = a + (int64_t)k * n;
        if (!(pivot[k] > 0 || pivot[k] < LEAST_PIVOT))
            return false;
        double reciprocal = 1 / pivot[k];
        for (int32_t i = k + 1; i < n; i++) {
            double *restrict row = a + (int64_t)i * n;
            double factor = pivot[i] * reciprocal;
            for (int32_t j = i; j < n; j++)
                row[j] -= factor * pivot[j];
        }
        a[(int64_t)k * n + k] = reciprocal;
    }
    return true;
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

/* trial := d, pull := D d. false: the laws fall too steeply. */
static bool solve(trk_newmark *stepper)
{
    int32_t p = stepper->p;
    double *u = stepper->trial, *pull = stepper->pull, *root = stepper->root;
    for (int32_t j = 0; j < p; j++) {
        root[j] = sqrt(fabs(stepper->slope[j]));
        u[j] = root[j] * couple(stepper, j, stepper->mismatch);
    }
    fill(stepper);
    if (!factorize(p, stepper->jacobian))
        return false;
    substitute(p, stepper->jacobian, u);
    for (int32_t j = 0; j < p; j++) {
        pull[j] = sign_of(stepper->slope[j]) * u[j];
        u[j] = stepper->mismatch[j] - root[j] * u[j];
    }
    for (int32_t j = 0; j < p; j++) /* u says nothing of a level law */
        pull[j] = root[j] > 0 ? pull[j] / root[j] : couple(stepper, j, stepper->trial);
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
    if (solve(stepper) && (is_rising || start_of(stepper) >= 0))
        return start_of(stepper);
    for (int32_t j = 0; j < stepper->p; j++) /* a law that falls counts as level */
        stepper->slope[j] = stepper->slope[j] > 0 ? stepper->slope[j] : 0;
    return solve(stepper) ? start_of(stepper) : NAN;
}
