/* SPDX-License-Identifier: MIT */
/* Logarithm, exponential and power. */
#include "base/plain.h"

#include <math.h>

/* ln 2 in two parts; multiples of the first up to 2^20 are exact. */
static const double ln2_high = 0x1.62e42fee00000p-1, ln2_low = 0x1.a39ef35793c76p-33;

double trk_plain_log(double x)
{
    int exponent;
    double m = frexp(x, &exponent);
    if (m < 0.70710678118654752) {
        m *= 2;
        exponent--;
    }
    /* ln m = 2 artanh s, s = (m - 1) / (m + 1), |s| < 0.172: 11 terms reach 1e-18 */
    const double s = (m - 1) / (m + 1), s2 = s * s;
    double sum = 0;
    for (int k = 11; k >= 1; k--)
        sum = s2 * (sum + 1.0 / (2 * k + 1));
    return exponent * ln2_high + (exponent * ln2_low + (2 * s + 2 * s * sum));
}

double trk_plain_exp(double x)
{
    if (!(x < 710))
        return x + INFINITY; /* NaN stays NaN */
    if (x < -746)
        return 0;
    const double k = floor(x / (ln2_high + ln2_low) + 0.5);
    const double r = (x - k * ln2_high) - k * ln2_low; /* |r| < 0.347 */
    double sum = 1;
    for (int n = 15; n >= 1; n--)
        sum = 1 + sum * r / n;
    return ldexp(sum, (int)k);
}

double trk_plain_power(double x, double power)
{
    if (power == 1)
        return x;
    if (power == -1)
        return 1 / x;
    if (x == 0)
        return power > 0 ? 0 : INFINITY;
    return trk_plain_exp(power * trk_plain_log(x));
}
