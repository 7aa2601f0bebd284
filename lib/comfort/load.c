/* SPDX-License-Identifier: MIT */
/* Loads of tires and axles on the road (COMFORT.11, COMFORT.12). */
#include "comfort/check.h"
#include "comfort/sum.h"

#include <math.h>
#include <truckride/comfort.h>

trk_status trk_axle_load(trk_context *context, int32_t tires, int64_t count,
                         const double *const *force, double static_load, double *out_load)
{
    static const char what[] = "trk_axle_load";
    TRK_REQUIRE(context, context, "trk_axle_load");
    TRK_REQUIRE(context, force, "trk_axle_load");
    TRK_REQUIRE(context, out_load, "trk_axle_load");
    if (tires < 1)
        return trk_fail(context, TRK_E_RANGE, "%s: tires is %d, expected >= 1", what, (int)tires);
    trk_status status =
        trk_comfort_check_value(context, what, "static_load", static_load, -TRK_COMFORT_LARGEST);
    for (int32_t k = 0; status == TRK_OK && k < tires; k++) {
        TRK_REQUIRE(context, force[k], "trk_axle_load");
        status = trk_comfort_check_samples(context, what, "force", 0, count, force[k]);
    }
    if (status != TRK_OK)
        return status;
    for (int64_t i = 0; i < count; i++) {
        double load = static_load;
        for (int32_t k = 0; k < tires; k++)
            load -= force[k][i];
        out_load[i] = load;
    }
    return TRK_OK;
}

trk_status trk_load_measure(trk_context *context, int64_t count, const double *load,
                            trk_load_numbers *out_numbers)
{
    static const char what[] = "trk_load_measure";
    TRK_REQUIRE(context, context, "trk_load_measure");
    TRK_REQUIRE(context, load, "trk_load_measure");
    TRK_REQUIRE(context, out_numbers, "trk_load_measure");
    trk_status status = trk_comfort_check_result(context, what, out_numbers);
    if (status == TRK_OK)
        status = trk_comfort_check_samples(context, what, "load", 1, count, load);
    if (status != TRK_OK)
        return status;
    trk_load_numbers n = {.struct_size = sizeof n, .maximum = load[0], .minimum = load[0]};
    trk_sum sum = {0, 0}, square = {0, 0};
    int64_t lifted = 0;
    for (int64_t i = 0; i < count; i++) {
        trk_sum_add(&sum, load[i]);
        n.maximum = fmax(n.maximum, load[i]);
        n.minimum = fmin(n.minimum, load[i]);
        lifted += load[i] <= 0;
    }
    n.mean = trk_sum_value(&sum) / (double)count;
    if (!(n.mean > 0))
        return trk_fail(context, TRK_E_RANGE,
                        "%s: the mean load is %g N, expected > 0: is the static load missing?",
                        what, n.mean);
    for (int64_t i = 0; i < count; i++)
        trk_sum_add(&square, (load[i] - n.mean) * (load[i] - n.mean));
    n.deviation = sqrt(trk_sum_value(&square) / (double)count);
    n.dynamic_load_coefficient = n.deviation / n.mean;
    n.impact_factor = n.maximum / n.mean;
    n.lift_off = (double)lifted / (double)count;
    return trk_write_options(out_numbers, &n, sizeof n);
}
