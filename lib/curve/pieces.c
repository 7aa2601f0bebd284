/* SPDX-License-Identifier: MIT */
/* From the table to one cubic a piece (CURVE.2). */
#include "curve/pieces.h"

#include "curve/range.h"
#include "curve/slopes.h"

/* Slopes at the points; LINEAR has none. */
static trk_status find_slopes(trk_context *context, const trk_curve *c, double *slopes)
{
    switch (c->interpolation) {
    case TRK_INTERPOLATION_NOT_A_KNOT:
    case TRK_INTERPOLATION_NATURAL:
        return trk_spline_slopes(context, c->interpolation, c->count, c->x, c->y, slopes);
    case TRK_INTERPOLATION_AKIMA: trk_akima_slopes(c->count, c->x, c->y, slopes); return TRK_OK;
    case TRK_INTERPOLATION_PCHIP: trk_pchip_slopes(c->count, c->x, c->y, slopes); return TRK_OK;
    default: return TRK_OK;
    }
}

/* Whether neither value nor slope of the piece can overflow over a width h. */
static bool is_bounded(const trk_piece *p, double h)
{
    double c1 = fabs(p->c1), c2 = fabs(p->c2), c3 = fabs(p->c3);
    return isfinite(fabs(p->c0) + h * (c1 + h * (c2 + h * c3))) &&
           isfinite(c1 + h * (2.0 * c2 + h * (3.0 * c3)));
}

/* Piece between points k - 1 and k from the slopes at them (CURVE.2). */
static trk_status set_inner_piece(trk_curve *c, int32_t k, const double *slopes)
{
    double lower = c->x[k - 1], upper = c->x[k], h = upper - lower;
    double m = (c->y[k] - c->y[k - 1]) / h, d0 = slopes[k - 1], d1 = slopes[k];
    if (c->interpolation == TRK_INTERPOLATION_LINEAR)
        d0 = d1 = m;
    trk_piece *p = &c->pieces[k];
    *p = (trk_piece){lower,
                     upper,
                     lower,
                     c->y[k - 1],
                     d0,
                     ((m - d0) + (m - d0) + (m - d1)) / h,
                     ((d0 - m) + (d1 - m)) / h / h};
    if (!is_bounded(p, h))
        return trk_fail(c->context, TRK_E_RANGE,
                        "curve '%s': slope overflows between points %d and %d (%g at %g, %g at %g)",
                        c->name, (int)k, (int)k + 1, c->y[k - 1], lower, c->y[k], upper);
    trk_widen_slope_range(d0, d1, m, &c->slope_minimum, &c->slope_maximum);
    return TRK_OK;
}

static trk_status join_pieces(trk_curve *c, const double *slopes)
{
    int32_t n = c->count;
    c->slope_minimum = INFINITY;
    c->slope_maximum = -INFINITY;
    for (int32_t k = 1; k < n; k++) {
        trk_status status = set_inner_piece(c, k, slopes);
        if (status)
            return status;
    }
    double first = c->pieces[1].c1;
    double last =
        c->interpolation == TRK_INTERPOLATION_LINEAR ? c->pieces[n - 1].c1 : slopes[n - 1];
    if (c->extrapolation == TRK_EXTRAPOLATION_CLAMP) {
        first = last = 0.0;
        trk_widen_slope_range(0.0, 0.0, 0.0, &c->slope_minimum, &c->slope_maximum);
    }
    c->pieces[0] = (trk_piece){-INFINITY, c->x[0], c->x[0], c->y[0], first, 0.0, 0.0};
    c->pieces[n] = (trk_piece){c->x[n - 1], INFINITY, c->x[n - 1], c->y[n - 1], last, 0.0, 0.0};
    return TRK_OK;
}

trk_status trk_curve_set_pieces(trk_context *context, trk_curve *curve)
{
    curve->pieces = trk_new(context, (int64_t)curve->count + 1, sizeof *curve->pieces);
    double *slopes = trk_new(context, curve->count, sizeof *slopes);
    trk_status status = TRK_E_MEMORY;
    if (curve->pieces && slopes)
        status = find_slopes(context, curve, slopes);
    if (status == TRK_OK)
        status = join_pieces(curve, slopes);
    trk_free(context, slopes);
    return status;
}
