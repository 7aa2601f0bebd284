/* SPDX-License-Identifier: MIT */
/* What the force curve of a stop must be, and its energy. */
#include "law/stop_curve.h"

#include "curve/curve.h"

/* Lowest value of a piece between a and b, measured from its origin. */
static double lowest(const trk_piece *p, double a, double b)
{
    double places[4] = {a, b, a, a}, low = INFINITY;
    /* Stationary points, c1 + 2 c2 t + 3 c3 t^2 = 0, without cancellation. */
    double root = p->c2 * p->c2 - 3 * p->c1 * p->c3;
    if (root >= 0) {
        double q = -(p->c2 + copysign(sqrt(root), p->c2));
        places[2] = q / (3 * p->c3);
        places[3] = p->c1 / q;
    }
    for (int k = 0; k < 4; k++) {
        double t = places[k];
        if (t >= a && t <= b)
            low = fmin(low, p->c0 + t * (p->c1 + t * (p->c2 + t * p->c3)));
    }
    return low;
}

trk_status trk_stop_curve_check(trk_context *context, const trk_law_ops *ops, const char *name,
                                const char *field, const trk_curve *curve)
{
    if (!curve)
        return TRK_OK;
    double most = 0, zero = trk_curve_value(curve, 0);
    for (int32_t k = 0; k < curve->count; k++)
        most = fmax(most, fabs(curve->y[k]));
    if (!(fabs(zero) <= 1e-9 * most))
        return trk_fail(context, TRK_E_RANGE, "%s '%s': %s is %g at 0; 0 is needed", ops->word,
                        name, field, zero);
    for (int32_t k = trk_curve_locate(curve, 0, 0); k <= curve->count; k++) {
        const trk_piece *p = &curve->pieces[k];
        double upper = k < curve->count ? p->upper : fmax(p->lower, 0);
        double low = lowest(p, fmax(0, p->lower) - p->origin, upper - p->origin);
        if (low < -1e-9 * most)
            return trk_fail(context, TRK_E_RANGE,
                            "%s '%s': %s falls to %g between %g and %g; values >= 0 are needed",
                            ops->word, name, field, low, fmax(0, p->lower), upper);
    }
    if (curve->pieces[curve->count].c1 < 0)
        return trk_fail(context, TRK_E_RANGE,
                        "%s '%s': %s falls beyond its last point, slope %g; it must not", ops->word,
                        name, field, curve->pieces[curve->count].c1);
    return TRK_OK;
}

double trk_stop_curve_area(const trk_curve *curve, double x)
{
    double sum = 0, from = 0;
    int32_t k = trk_curve_locate(curve, 0, 0);
    while (from < x) {
        const trk_piece *p = &curve->pieces[k++];
        double to = fmin(x, p->upper), a = from - p->origin, b = to - p->origin;
        double at_a = a * (p->c0 + a * (p->c1 / 2 + a * (p->c2 / 3 + a * p->c3 / 4)));
        double at_b = b * (p->c0 + b * (p->c1 / 2 + b * (p->c2 / 3 + b * p->c3 / 4)));
        sum += at_b - at_a;
        from = to;
    }
    return sum;
}
