/* SPDX-License-Identifier: MIT */
/* Describing function of a law. */
#include "linear/cycle.h"

#include <truckride/linear.h>

#include <math.h>

trk_status trk_law_describe(trk_context *context, const trk_law *law, double mean, double amplitude,
                            double frequency, double *out_stiffness, double *out_damping)
{
    TRK_REQUIRE(context, context, "trk_law_describe");
    TRK_REQUIRE(context, law, "trk_law_describe");
    const double omega = 6.283185307179586476925286766559 * frequency;
    if (!isfinite(mean) || !(amplitude > 0 && isfinite(amplitude)) ||
        !(omega > 0 && isfinite(omega)))
        return trk_fail(context, TRK_E_RANGE,
                        "trk_law_describe: mean is %g, amplitude %g and frequency %g Hz; finite "
                        "numbers, the last two > 0, are needed",
                        mean, amplitude, frequency);
    trk_parts parts;
    if (!trk_cycle_average(law, &(trk_swing){mean, amplitude, amplitude * omega}, &parts))
        return trk_fail(context, TRK_E_RANGE,
                        "trk_law_describe: an amplitude of %g about %g leaves what '%s' can do",
                        amplitude, mean, trk_law_name(law));
    if (out_stiffness)
        *out_stiffness = 2 * parts.in_phase / amplitude;
    if (out_damping)
        *out_damping = 2 * parts.quadrature / (amplitude * omega);
    return TRK_OK;
}
