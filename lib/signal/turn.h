/* SPDX-License-Identifier: MIT */
/* Sine and cosine of an angle given in turns: no large-argument reduction, no branch, so
 * that a loop over it runs in vector registers (SIGNAL.5). */
#ifndef TRK_SIGNAL_TURN_H
#define TRK_SIGNAL_TURN_H

#include <float.h>
#include <math.h>

/* Turns modulo one, in -1/2 .. 1/2; 0 where a double no longer resolves a turn. NaN and
 * infinity give NaN. */
static inline double trk_turn_fraction(double turns)
{
#if FLT_EVAL_METHOD == 0
    const double shift = 0x1.8p52; /* adding it rounds to whole turns, in vectors as well */
    double whole = (turns + shift) - shift;
#else
    double whole = rint(turns);
#endif
    double fraction = turns - whole, nothing = turns * 0.0;
    return fabs(turns) < 0x1p51 ? fraction : nothing;
}

/* clang-format off */
/* sin(2 pi r) for |r| <= 1/4, Taylor series; the next term is below 2e-18. */
static inline double trk_turn_sine(double r)
{
    double z = r * r;
    return r * (6.2831853071795862 +
           z * (-41.341702240399762 +
           z * (81.605249276075057 +
           z * (-76.705859753061389 +
           z * (42.058693944897655 +
           z * (-15.09464257682299 +
           z * (3.819952584848282 +
           z * (-0.71812230177850056 +
           z * (0.10422916220813984 +
           z * (-0.012031585942120627 +
           z * 0.0011309237482517963))))))))));
}
/* clang-format on */

/* Sine and cosine of 2 pi r for |r| <= 1/2, absolute error below 1e-15. */
static inline void trk_turn_sincos(double r, double *sine, double *cosine)
{
    double a = fabs(r), b = 0.5 - a;
    *sine = trk_turn_sine(copysign(a < b ? a : b, r));
    *cosine = trk_turn_sine(0.25 - a);
}

#endif
