/* SPDX-License-Identifier: MIT */
/* Weightings and factors of the axes, total values, reactions (COMFORT.8). */
#include "comfort/axis.h"
#include "comfort/check.h"

#include <math.h>

/* ISO 2631-1:1997, 7.2.3 and 8.2.2; health 0: the standard has no factor. */
static const struct {
    trk_weighting weighting;
    double comfort, health;
} table[] = {
    [TRK_AXIS_SEAT_X] = {TRK_WEIGHTING_WD, 1, 1.4},
    [TRK_AXIS_SEAT_Y] = {TRK_WEIGHTING_WD, 1, 1.4},
    [TRK_AXIS_SEAT_Z] = {TRK_WEIGHTING_WK, 1, 1},
    [TRK_AXIS_SEAT_ROLL] = {TRK_WEIGHTING_WE, 0.63, 0},
    [TRK_AXIS_SEAT_PITCH] = {TRK_WEIGHTING_WE, 0.4, 0},
    [TRK_AXIS_SEAT_YAW] = {TRK_WEIGHTING_WE, 0.2, 0},
    [TRK_AXIS_BACK_X] = {TRK_WEIGHTING_WC, 0.8, 0},
    [TRK_AXIS_BACK_Y] = {TRK_WEIGHTING_WD, 0.5, 0},
    [TRK_AXIS_BACK_Z] = {TRK_WEIGHTING_WD, 0.4, 0},
    [TRK_AXIS_FEET_X] = {TRK_WEIGHTING_WK, 0.25, 0},
    [TRK_AXIS_FEET_Y] = {TRK_WEIGHTING_WK, 0.25, 0},
    [TRK_AXIS_FEET_Z] = {TRK_WEIGHTING_WK, 0.4, 0},
};

trk_status trk_axis_get(trk_axis axis, trk_purpose purpose, trk_weighting *out_weighting,
                        double *out_multiplier)
{
    if (axis < TRK_AXIS_SEAT_X || axis > TRK_AXIS_FEET_Z)
        return TRK_E_ARGUMENT;
    if (purpose != TRK_PURPOSE_COMFORT && purpose != TRK_PURPOSE_HEALTH)
        return TRK_E_ARGUMENT;
    double multiplier = purpose == TRK_PURPOSE_HEALTH ? table[axis].health : table[axis].comfort;
    if (multiplier == 0)
        return TRK_E_ARGUMENT;
    if (out_weighting)
        *out_weighting = table[axis].weighting;
    if (out_multiplier)
        *out_multiplier = multiplier;
    return TRK_OK;
}

trk_status trk_axis_check(trk_context *context, const char *what, trk_axis axis,
                          trk_purpose purpose, double *out_multiplier)
{
    if (trk_axis_get(axis, purpose, NULL, out_multiplier) == TRK_OK)
        return TRK_OK;
    return trk_fail(context, TRK_E_ARGUMENT,
                    "%s: axis %d has no factor for purpose %d, expected axis %d to %d for comfort "
                    "(%d), %d to %d for health (%d)",
                    what, (int)axis, (int)purpose, TRK_AXIS_SEAT_X, TRK_AXIS_FEET_Z,
                    TRK_PURPOSE_COMFORT, TRK_AXIS_SEAT_X, TRK_AXIS_SEAT_Z, TRK_PURPOSE_HEALTH);
}

trk_status trk_vibration_total(trk_context *context, trk_purpose purpose, int32_t count,
                               const trk_axis *axis, const double *rms, double *out_sum)
{
    static const char what[] = "trk_vibration_total";
    TRK_REQUIRE(context, context, "trk_vibration_total");
    TRK_REQUIRE(context, axis, "trk_vibration_total");
    TRK_REQUIRE(context, rms, "trk_vibration_total");
    TRK_REQUIRE(context, out_sum, "trk_vibration_total");
    if (count < 1)
        return trk_fail(context, TRK_E_RANGE, "%s: count is %d axes, expected >= 1", what,
                        (int)count);
    double sum = 0;
    int32_t seen = 0;
    for (int32_t k = 0; k < count; k++) {
        double multiplier;
        trk_status status = trk_axis_check(context, what, axis[k], purpose, &multiplier);
        if (status == TRK_OK)
            status = trk_comfort_check_value(context, what, "rms", rms[k], 0);
        if (status != TRK_OK)
            return status;
        if (seen & 1 << axis[k])
            return trk_fail(context, TRK_E_ARGUMENT, "%s: axis %d comes twice", what, (int)axis[k]);
        seen |= 1 << axis[k];
        sum += multiplier * rms[k] * (multiplier * rms[k]);
    }
    *out_sum = sqrt(sum);
    return TRK_OK;
}

/* ISO 2631-1:1997, C.2.3; the bands overlap on purpose. */
static const struct {
    double low, high;
    const char *text;
} reaction[] = {
    {0, 0.315, "not uncomfortable"},   {0.315, 0.63, "a little uncomfortable"},
    {0.5, 1, "fairly uncomfortable"},  {0.8, 1.6, "uncomfortable"},
    {1.25, 2.5, "very uncomfortable"}, {2, INFINITY, "extremely uncomfortable"},
};

enum { REACTIONS = sizeof reaction / sizeof *reaction };

int32_t trk_comfort_reactions(double total)
{
    int32_t reactions = 0;
    for (int k = 0; k < REACTIONS; k++)
        if (total >= reaction[k].low && total <= reaction[k].high)
            reactions |= 1 << k;
    return reactions;
}

const char *trk_comfort_text(int32_t wanted)
{
    for (int k = 0; k < REACTIONS; k++)
        if (wanted == 1 << k)
            return reaction[k].text;
    return NULL;
}
