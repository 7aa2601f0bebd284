/* SPDX-License-Identifier: MIT */
/* Lookup and evaluation (CURVE.1, CURVE.2). */
#include "curve/curve.h"

static bool holds(const trk_piece *p, double x)
{
    return x >= p->lower && x < p->upper;
}

int32_t trk_curve_locate(const trk_curve *curve, double x, int32_t hint)
{
    if (isnan(x))
        return 1;
    if (hint > 0 && holds(&curve->pieces[hint - 1], x))
        return hint - 1;
    if (hint < curve->count && holds(&curve->pieces[hint + 1], x))
        return hint + 1;
    int32_t low = 0, high = curve->count; /* the piece is the number of points <= x */
    while (low < high) {
        int32_t middle = low + (high - low) / 2;
        if (curve->x[middle] <= x)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

double trk_curve_value(const trk_curve *curve, double x)
{
    int32_t hint = 0;
    double value = NAN, slope;
    if (curve)
        trk_curve_point(curve, x, &hint, &value, &slope);
    return value;
}

double trk_curve_slope(const trk_curve *curve, double x)
{
    int32_t hint = 0;
    double value, slope = NAN;
    if (curve)
        trk_curve_point(curve, x, &hint, &value, &slope);
    return slope;
}

void trk_curve_evaluate(const trk_curve *curve, int64_t count, const double *x, double *out_value,
                        double *out_slope)
{
    int32_t hint = 0;
    for (int64_t k = 0; curve && x && k < count; k++) {
        double value, slope;
        trk_curve_point(curve, x[k], &hint, &value, &slope);
        if (out_value)
            out_value[k] = value;
        if (out_slope)
            out_slope[k] = slope;
    }
}
