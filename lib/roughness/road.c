/* SPDX-License-Identifier: MIT */
/* Gain of the standard car, and the IRI that a road of a given PSD has (ROUGHNESS.5, 6). */
#include "roughness/golden.h"

#include <complex.h>
#include <math.h>
#include <truckride/roughness.h>

static const double pi = 3.14159265358979323846;

/* Wavenumbers [1/m] of the integral: the car filters out 1e-14 and less of what lies beyond. */
static const double slowest = 1e-6, fastest = 1e7;

double trk_iri_gain(double wavenumber)
{
    if (!(wavenumber >= 0 && isfinite(wavenumber)))
        return NAN;
    if (wavenumber > fastest) { /* the tire's stiffness over the inertia */
        double angular = 2 * pi * TRK_GOLDEN_SPEED * wavenumber;
        return TRK_GOLDEN_TIRE / TRK_GOLDEN_MASS / angular / angular;
    }
    double complex s = 2 * pi * wavenumber * TRK_GOLDEN_SPEED * I;
    double complex joint = TRK_GOLDEN_DAMPER * s + TRK_GOLDEN_SPRING;
    double complex sprung = s * s + joint;
    double complex unsprung = TRK_GOLDEN_MASS * s * s + joint + TRK_GOLDEN_TIRE;
    /* z_s = joint z_u / sprung, and the difference z_u - z_s = s^2 z_u / sprung */
    return cabs(s * s * TRK_GOLDEN_TIRE / (sprung * unsprung - joint * joint));
}

/* Squared gain times n^(3 - waviness): the integrand of (ROUGHNESS.6) over ln n. */
static double integrand(double log_n, double waviness)
{
    double n = exp(log_n), gain = trk_iri_gain(n);
    return gain * gain * pow(n, 3 - waviness);
}

static double integrate(double waviness, double low, double high)
{
    low = fmax(low, slowest);
    high = fmin(high, fastest);
    if (!(high > low))
        return 0;
    enum { INTERVALS = 4000 }; /* Simpson's rule; even */
    double start = log(low), h = (log(high) - start) / INTERVALS, sum = 0;
    for (int k = 0; k <= INTERVALS; k++) {
        int weight = k == 0 || k == INTERVALS ? 1 : k % 2 ? 4 : 2;
        sum += weight * integrand(start + k * h, waviness);
    }
    return sum * h / 3;
}

trk_status trk_iri_of_road(trk_context *context, double unevenness, double waviness, double low,
                           double high, double *out_iri)
{
    static const char what[] = "trk_iri_of_road";
    TRK_REQUIRE(context, context, "trk_iri_of_road");
    TRK_REQUIRE(context, out_iri, "trk_iri_of_road");
    if (!(unevenness >= 0 && unevenness <= 1e75))
        return trk_fail(context, TRK_E_RANGE, "%s: unevenness is %g m^3, expected 0 to 1e75", what,
                        unevenness);
    if (!(waviness >= 1 && waviness <= 4))
        return trk_fail(context, TRK_E_RANGE, "%s: waviness is %g, expected 1 to 4", what,
                        waviness);
    if (!(low >= 0 && high > low && isfinite(low)))
        return trk_fail(context, TRK_E_RANGE, "%s: band is %g to %g 1/m, expected 0 <= low < high",
                        what, low, high);
    /* (2 pi n)^2 G(n), n = exp(log n): the factor n of d n is in the integrand */
    double variance =
        4 * pi * pi * unevenness * pow(0.1, waviness) * integrate(waviness, low, high);
    *out_iri = sqrt(2 / pi * variance);
    return TRK_OK;
}
