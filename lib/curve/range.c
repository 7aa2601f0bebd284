/* SPDX-License-Identifier: MIT */
/* Range of the slope: the derivative of each piece is a parabola (CURVE.6). */
#include "curve/range.h"

#include "curve/curve.h"

void trk_widen_slope_range(double d0, double d1, double m, double *minimum, double *maximum)
{
    double low = fmin(d0, d1), high = fmax(d0, d1);
    double b = (m - d0) + (m - d0) + (m - d1), a = (d0 - m) + (d1 - m);
    double s = -b / (3.0 * a); /* vertex; a = 0 gives no s inside (0, 1) */
    if (s > 0.0 && s < 1.0) {
        double vertex = d0 + b * s;
        low = fmin(low, vertex);
        high = fmax(high, vertex);
    }
    /* Slopes up to three secants cannot change sign (Fritsch and Carlson), but a
     * parabola that touches zero may seem to after rounding. */
    if (d0 >= 0.0 && d1 >= 0.0 && d0 <= 3.0 * m && d1 <= 3.0 * m)
        low = fmax(low, 0.0);
    if (d0 <= 0.0 && d1 <= 0.0 && d0 >= 3.0 * m && d1 >= 3.0 * m)
        high = fmin(high, 0.0);
    *minimum = fmin(*minimum, low);
    *maximum = fmax(*maximum, high);
}

int32_t trk_curve_monotone(const trk_curve *curve)
{
    if (!curve)
        return 0;
    if (curve->slope_minimum >= 0.0)
        return 1;
    return curve->slope_maximum <= 0.0 ? -1 : 0;
}

void trk_curve_slope_range(const trk_curve *curve, double *out_minimum, double *out_maximum)
{
    if (out_minimum)
        *out_minimum = curve ? curve->slope_minimum : NAN;
    if (out_maximum)
        *out_maximum = curve ? curve->slope_maximum : NAN;
}
