/* SPDX-License-Identifier: MIT */
/* Dense backend: root-free Cholesky S = L D L^T (LINALG.1), for systems of a few dozen unknowns. */
#include "linalg/backend.h"

#include <math.h>
#include <string.h>

/*
 * The factor is a full square, L on both sides of its diagonal: below the diagonal of
 * column j stands column j of L, above it row j of L, on it 1 / d_j. So the forward and
 * the backward sweep both read contiguously, and neither divides.
 */
typedef struct dense {
    trk_context *context;
    const trk_pattern *pattern;
    double *square; /* n x n, column-major */
} dense;

static void destroy(void *state)
{
    dense *d = state;
    if (!d)
        return;
    trk_free(d->context, d->square);
    trk_free(d->context, d);
}

static trk_status create(trk_context *context, const trk_pattern *pattern, void **out_state)
{
    dense *d = trk_new(context, 1, sizeof *d);
    if (!d)
        return TRK_E_MEMORY;
    d->context = context;
    d->pattern = pattern;
    d->square = trk_new(context, (int64_t)pattern->n * pattern->n, sizeof *d->square);
    if (!d->square) {
        destroy(d);
        return TRK_E_MEMORY;
    }
    *out_state = d;
    return TRK_OK;
}

static void scatter(dense *d, const double *values)
{
    const trk_pattern *p = d->pattern;
    size_t n = (size_t)p->n;
    memset(d->square, 0, n * n * sizeof *d->square);
    for (size_t j = 0; j < n; j++)
        for (int32_t k = p->start[j]; k < p->start[j + 1]; k++)
            d->square[j * n + (size_t)p->row[k]] = values[k];
}

/* Take column j, whose pivot is good, out of the columns right of it and mirror it. */
static void eliminate(double *square, size_t n, size_t j)
{
    double *column = square + j * n;
    double reciprocal = 1.0 / column[j];
    column[j] = reciprocal;
    for (size_t k = j + 1; k < n; k++) {
        double *right = square + k * n;
        double l = column[k] * reciprocal;
        if (l != 0.0)
            for (size_t i = k; i < n; i++)
                right[i] -= l * column[i];
        column[k] = l;
        right[j] = l;
    }
}

static trk_status factorize(void *state, double *values, int32_t *out_bad)
{
    dense *d = state;
    size_t n = (size_t)d->pattern->n;
    double tolerance = trk_pivot_tolerance(d->pattern->n);
    scatter(d, values);
    for (size_t j = 0; j < n; j++) {
        double pivot = d->square[j * n + j];
        double diagonal = values[d->pattern->start[j]];
        if (!(pivot > tolerance * diagonal)) { /* also when it is NaN */
            *out_bad = (int32_t)j;
            return TRK_E_SINGULAR;
        }
        eliminate(d->square, n, j);
    }
    return TRK_OK;
}

static trk_status solve(void *state, double *x)
{
    const dense *d = state;
    size_t n = (size_t)d->pattern->n;
    for (size_t i = 1; i < n; i++) {
        const double *row = d->square + i * n;
        double sum = x[i];
        for (size_t k = 0; k < i; k++)
            sum -= row[k] * x[k];
        x[i] = sum;
    }
    for (size_t i = n; i-- > 0;) {
        const double *column = d->square + i * n;
        double sum = x[i] * column[i];
        /* Downwards, so that the unknown found last enters last and the sums overlap. */
        for (size_t k = n; --k > i;)
            sum -= column[k] * x[k];
        x[i] = sum;
    }
    return TRK_OK;
}

static int64_t factor_entries(const void *state)
{
    const dense *d = state;
    return (int64_t)d->pattern->n * (d->pattern->n + 1) / 2;
}

static trk_status count_negative(void *state, double *values, const double *scale,
                                 int32_t *out_count, double *out_growth)
{
    dense *d = state;
    size_t n = (size_t)d->pattern->n;
    scatter(d, values);
    for (size_t j = 0; j < n; j++) {
        double *column = d->square + j * n;
        double pivot = column[j];
        if (pivot == 0 || !isfinite(pivot))
            return TRK_E_SINGULAR;
        *out_count += pivot < 0;
        *out_growth = fmax(*out_growth, fabs(pivot) / scale[j]);
        for (size_t i = j + 1; i < n; i++)
            *out_growth = fmax(*out_growth, fabs(column[i] / pivot * column[i]) / scale[i]);
        eliminate(d->square, n, j);
    }
    return TRK_OK;
}

const trk_solver_ops trk_dense_ops = {
    .backend = TRK_BACKEND_DENSE,
    .name = "dense",
    .create = create,
    .destroy = destroy,
    .factorize = factorize,
    .solve = solve,
    .factor_entries = factor_entries,
    .count_negative = count_negative,
};
