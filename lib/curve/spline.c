/* SPDX-License-Identifier: MIT */
/* Slopes of the C2 cubic spline: one tridiagonal system, eliminated without pivoting (CURVE.5). */
#include "curve/slopes.h"

static double spacing(const double *x, int64_t k)
{
    return x ? x[k + 1] - x[k] : 1.0;
}

/* Row of the system at an end: diagonal d + beside e = right. h0, m0 belong to the end. */
typedef struct end_row {
    double diagonal, beside, right;
} end_row;

static end_row row_at_end(trk_interpolation kind, double h0, double h1, double m0, double m1)
{
    if (kind == TRK_INTERPOLATION_NATURAL)
        return (end_row){2.0, 1.0, 3.0 * m0};
    double sum = h0 + h1;
    /* Divided by h0 + h1 throughout, so that all rows are pure numbers times slopes. */
    return (end_row){h1 / sum, 1.0,
                     (h1 / sum) * (h0 / sum + 2.0) * m0 + (h0 / sum) * (h0 / sum) * m1};
}

static void parabola(const double *x, const double *y, double *out_slopes)
{
    double h0 = spacing(x, 0), h1 = spacing(x, 1);
    double m0 = (y[1] - y[0]) / h0, m1 = (y[2] - y[1]) / h1;
    out_slopes[1] = (h1 * m0 + h0 * m1) / (h0 + h1);
    out_slopes[0] = 2.0 * m0 - out_slopes[1];
    out_slopes[2] = 2.0 * m1 - out_slopes[1];
}

/*
 * Forward elimination leaves slope[k] = out_slopes[k] - above[k] * slope[k + 1]. After
 * the first row every pivot is positive for either kind of end: the inner rows are
 * diagonally dominant and a not-a-knot row takes from the next one half its diagonal.
 */
static void eliminate(trk_interpolation kind, int64_t count, const double *x, const double *y,
                      double *above, double *out_slopes)
{
    double h0 = spacing(x, 0), h1 = spacing(x, 1);
    double m0 = (y[1] - y[0]) / h0, m1 = (y[2] - y[1]) / h1;
    end_row first = row_at_end(kind, h0, h1, m0, m1);
    above[0] = first.beside / first.diagonal;
    out_slopes[0] = first.right / first.diagonal;
    for (int64_t k = 1; k < count - 1; k++) {
        h1 = spacing(x, k);
        m1 = (y[k + 1] - y[k]) / h1;
        double before = h1 / (h0 + h1), after = h0 / (h0 + h1);
        double pivot = 2.0 - before * above[k - 1];
        above[k] = after / pivot;
        out_slopes[k] = (3.0 * (before * m0 + after * m1) - before * out_slopes[k - 1]) / pivot;
        h0 = h1;
        m0 = m1;
    }
    int64_t n = count - 1;
    h0 = spacing(x, n - 2);
    m0 = (y[n - 1] - y[n - 2]) / h0;
    end_row last = row_at_end(kind, h1, h0, m1, m0);
    out_slopes[n] = (last.right - last.beside * out_slopes[n - 1]) /
                    (last.diagonal - last.beside * above[n - 1]);
}

trk_status trk_spline_slopes(trk_context *context, trk_interpolation kind, int64_t count,
                             const double *x, const double *y, double *out_slopes)
{
    if (count == 2) {
        out_slopes[0] = out_slopes[1] = (y[1] - y[0]) / spacing(x, 0);
        return TRK_OK;
    }
    if (count == 3 && kind == TRK_INTERPOLATION_NOT_A_KNOT) {
        parabola(x, y, out_slopes);
        return TRK_OK;
    }
    double *above = trk_new(context, count, sizeof *above);
    if (!above)
        return TRK_E_MEMORY;
    eliminate(kind, count, x, y, above, out_slopes);
    for (int64_t k = count - 2; k >= 0; k--)
        out_slopes[k] -= above[k] * out_slopes[k + 1];
    trk_free(context, above);
    return TRK_OK;
}
