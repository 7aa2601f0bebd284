/* SPDX-License-Identifier: MIT */
/* The analogue frequency weightings (COMFORT.1). */
#include "comfort/weighting.h"

#include <math.h>

static const double root_half = 0.70710678118654752440;

static const trk_weighting_parameters table[] = {
    [TRK_WEIGHTING_WK] = {"Wk", 0.4, 100, 12.5, 12.5, 0.63, 2.37, 0.91, 3.35, 0.91, 1},
    [TRK_WEIGHTING_WD] = {"Wd", 0.4, 100, 2, 2, 0.63, 0, 0, 0, 0, 1},
    [TRK_WEIGHTING_WC] = {"Wc", 0.4, 100, 8, 8, 0.63, 0, 0, 0, 0, 1},
    [TRK_WEIGHTING_WE] = {"We", 0.4, 100, 1, 1, 0.63, 0, 0, 0, 0, 1},
    [TRK_WEIGHTING_WJ] = {"Wj", 0.4, 100, 0, 0, 0, 3.75, 0.91, 5.32, 0.91, 1},
    [TRK_WEIGHTING_WF] = {"Wf", 0.08, 0.63, 0, 0.25, 0.86, 0.0625, 0.8, 0.1, 0.8, 1},
    [TRK_WEIGHTING_WB] = {"Wb", 0.4, 100, 16, 16, 0.55, 2.5, 0.9, 4, 0.95, 1.024},
    [TRK_WEIGHTING_BAND] = {"band", 0.4, 100, 0, 0, 0, 0, 0, 0, 0, 1},
    [TRK_WEIGHTING_BAND_LOW] = {"low band", 0.08, 0.63, 0, 0, 0, 0, 0, 0, 0, 1},
};

const trk_weighting_parameters *trk_weighting_find(trk_weighting weighting)
{
    return weighting >= TRK_WEIGHTING_WK && weighting <= TRK_WEIGHTING_BAND_LOW ? &table[weighting]
                                                                                : NULL;
}

trk_status trk_weighting_check(trk_context *context, const char *what, trk_weighting weighting,
                               const trk_weighting_parameters **out)
{
    *out = trk_weighting_find(weighting);
    if (*out)
        return TRK_OK;
    return trk_fail(context, TRK_E_ARGUMENT, "%s: weighting is %d, expected %d to %d", what,
                    (int)weighting, TRK_WEIGHTING_WK, TRK_WEIGHTING_BAND_LOW);
}

/* r^2 - 1 + r / (i Q) with r = corner / f: the quadratic over -(f / corner)^2, so that it falls
 * away at high frequencies instead of overflowing. */
static double complex above(double corner, double q, double f)
{
    double r = corner / f;
    return 1 - r * r - I * r / q;
}

/* 1 - r^2 + i r / Q with r = f / corner. */
static double complex below(double corner, double q, double f)
{
    double r = f / corner;
    return 1 - r * r + I * r / q;
}

double complex trk_weighting_analogue(const trk_weighting_parameters *p, double f)
{
    if (f <
        1e-100 * p->f1) /* the square of the ratio would overflow; the weighting is 0 to 1e-200 */
        return 0;
    if (f > 1e100 * p->f2)
        return 0;
    double complex h = p->gain / (above(p->f1, root_half, f) * below(p->f2, root_half, f));
    if (p->f3 > 0)
        h *= 1 + I * f / p->f3;
    if (p->f4 > 0)
        h /= below(p->f4, p->q4, f);
    if (p->f5 > 0) /* both quadratics over f^2: their factor (f5 / f6)^2 is in it */
        h *= above(p->f5, p->q5, f) / above(p->f6, p->q6, f);
    return h;
}

const char *trk_weighting_name(trk_weighting weighting)
{
    const trk_weighting_parameters *p = trk_weighting_find(weighting);
    return p ? p->name : NULL;
}

double trk_weighting_factor(trk_weighting weighting, double frequency)
{
    const trk_weighting_parameters *p = trk_weighting_find(weighting);
    if (!p || !(frequency >= 0 && isfinite(frequency)))
        return NAN;
    return cabs(trk_weighting_analogue(p, frequency));
}

trk_status trk_weighting_response(trk_context *context, trk_weighting weighting, int64_t count,
                                  const double *frequency, double *out_response)
{
    static const char what[] = "trk_weighting_response";
    TRK_REQUIRE(context, context, "trk_weighting_response");
    TRK_REQUIRE(context, frequency, "trk_weighting_response");
    TRK_REQUIRE(context, out_response, "trk_weighting_response");
    const trk_weighting_parameters *p;
    trk_status status = trk_weighting_check(context, what, weighting, &p);
    if (status != TRK_OK)
        return status;
    if (count < 0)
        return trk_fail(context, TRK_E_RANGE, "%s: count is %lld, expected >= 0", what,
                        (long long)count);
    for (int64_t k = 0; k < count; k++)
        if (!(frequency[k] >= 0 && isfinite(frequency[k])))
            return trk_fail(context, TRK_E_RANGE,
                            "%s: frequency[%lld] is %g Hz, expected >= 0 and finite", what,
                            (long long)k, frequency[k]);
    for (int64_t k = 0; k < count; k++) {
        double complex h = trk_weighting_analogue(p, frequency[k]);
        out_response[2 * k] = creal(h);
        out_response[2 * k + 1] = cimag(h);
    }
    return TRK_OK;
}
