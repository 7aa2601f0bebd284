/* SPDX-License-Identifier: MIT */
/* Daily exposure to whole-body vibration, Directive 2002/44/EC (COMFORT.9). */
#include "comfort/axis.h"
#include "comfort/check.h"
#include "comfort/sum.h"

#include <math.h>

static const double eight_hours = 8 * 3600;

/* k of the axis, and that there is at least one task. */
static trk_status check_day(trk_context *context, const char *what, trk_axis axis, int32_t count,
                            double *out_multiplier)
{
    trk_status status = trk_axis_check(context, what, axis, TRK_PURPOSE_HEALTH, out_multiplier);
    if (status == TRK_OK && count < 1)
        return trk_fail(context, TRK_E_RANGE, "%s: count is %d tasks, expected >= 1", what,
                        (int)count);
    return status;
}

trk_status trk_daily_a8(trk_context *context, trk_axis axis, int32_t count, const double *rms,
                        const double *duration, double *out_a8)
{
    static const char what[] = "trk_daily_a8";
    TRK_REQUIRE(context, context, "trk_daily_a8");
    TRK_REQUIRE(context, rms, "trk_daily_a8");
    TRK_REQUIRE(context, duration, "trk_daily_a8");
    TRK_REQUIRE(context, out_a8, "trk_daily_a8");
    double multiplier;
    trk_status status = check_day(context, what, axis, count, &multiplier);
    trk_sum sum = {0, 0};
    for (int32_t k = 0; status == TRK_OK && k < count; k++) {
        status = trk_comfort_check_value(context, what, "rms", rms[k], 0);
        if (status == TRK_OK)
            status = trk_comfort_check_value(context, what, "duration", duration[k], 0);
        trk_sum_add(&sum, rms[k] * rms[k] * (duration[k] / eight_hours));
    }
    if (status == TRK_OK)
        *out_a8 = multiplier * sqrt(trk_sum_value(&sum));
    return status;
}

trk_status trk_daily_vdv(trk_context *context, trk_axis axis, int32_t count, const double *vdv,
                         const double *measured, const double *duration, double *out_vdv)
{
    static const char what[] = "trk_daily_vdv";
    TRK_REQUIRE(context, context, "trk_daily_vdv");
    TRK_REQUIRE(context, vdv, "trk_daily_vdv");
    TRK_REQUIRE(context, measured, "trk_daily_vdv");
    TRK_REQUIRE(context, duration, "trk_daily_vdv");
    TRK_REQUIRE(context, out_vdv, "trk_daily_vdv");
    double multiplier;
    trk_status status = check_day(context, what, axis, count, &multiplier);
    double total = 0;
    for (int32_t k = 0; status == TRK_OK && k < count; k++) {
        status = trk_comfort_check_value(context, what, "vdv", vdv[k], 0);
        if (status == TRK_OK)
            status = trk_comfort_check_positive(context, what, "measured", measured[k]);
        if (status == TRK_OK)
            status = trk_comfort_check_value(context, what, "duration", duration[k], 0);
        /* Fourth roots are combined two at a time: fourth powers of 1e75 times a ratio overflow. */
        double dose = vdv[k] * sqrt(sqrt(duration[k])) / sqrt(sqrt(measured[k]));
        total = sqrt(hypot(total * total, dose * dose));
    }
    if (status == TRK_OK && !isfinite(multiplier * total))
        return trk_fail(context, TRK_E_RANGE, "%s: the dose overflows", what);
    if (status == TRK_OK)
        *out_vdv = multiplier * total;
    return status;
}

static trk_exposure compare(double value, double action, double limit)
{
    if (!(value <= limit))
        return TRK_EXPOSURE_ABOVE_LIMIT;
    return value > action ? TRK_EXPOSURE_ABOVE_ACTION : TRK_EXPOSURE_BELOW_ACTION;
}

trk_exposure trk_exposure_of_a8(double a8)
{
    return compare(a8, TRK_EXPOSURE_A8_ACTION, TRK_EXPOSURE_A8_LIMIT);
}

trk_exposure trk_exposure_of_vdv(double vdv)
{
    return compare(vdv, TRK_EXPOSURE_VDV_ACTION, TRK_EXPOSURE_VDV_LIMIT);
}
