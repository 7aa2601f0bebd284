/* SPDX-License-Identifier: MIT */
/* SEAT factors (COMFORT.10). */
#include "comfort/check.h"

#include <truckride/comfort.h>

/* Weight and measure in chunks: no copy of the signal. */
static trk_status measure(trk_context *context, trk_weighting weighting, int64_t count,
                          const double *x, double sample_rate, trk_vibration *out)
{
    enum { CHUNK = 512 };
    double y[CHUNK];
    trk_weighting_filter *filter = NULL;
    trk_vibration_meter *meter = NULL;
    trk_status status = trk_weighting_filter_create(context, weighting, sample_rate, &filter);
    if (status == TRK_OK)
        status = trk_vibration_meter_create(context, sample_rate, 1, &meter);
    if (status == TRK_OK)
        trk_weighting_filter_reset(filter, x[0]);
    for (int64_t i = 0; status == TRK_OK && i < count; i += CHUNK) {
        int64_t length = count - i < CHUNK ? count - i : CHUNK;
        status = trk_weighting_filter_process(filter, length, x + i, y);
        if (status == TRK_OK)
            status = trk_vibration_meter_process(meter, length, y);
    }
    out->struct_size = sizeof *out;
    if (status == TRK_OK)
        status = trk_vibration_meter_read(meter, out);
    trk_vibration_meter_destroy(meter);
    trk_weighting_filter_destroy(filter);
    return status;
}

trk_status trk_seat_factor(trk_context *context, trk_weighting weighting, int64_t count,
                           const double *seat, const double *floor, double sample_rate,
                           double *out_rms, double *out_vdv)
{
    static const char what[] = "trk_seat_factor";
    TRK_REQUIRE(context, context, "trk_seat_factor");
    TRK_REQUIRE(context, seat, "trk_seat_factor");
    TRK_REQUIRE(context, floor, "trk_seat_factor");
    trk_status status = trk_comfort_check_samples(context, what, "seat", 1, count, seat);
    if (status == TRK_OK)
        status = trk_comfort_check_samples(context, what, "floor", 1, count, floor);
    trk_vibration above, below;
    if (status == TRK_OK)
        status = measure(context, weighting, count, seat, sample_rate, &above);
    if (status == TRK_OK)
        status = measure(context, weighting, count, floor, sample_rate, &below);
    if (status != TRK_OK)
        return status;
    if (!(below.vdv > 0))
        return trk_fail(context, TRK_E_RANGE, "%s: the floor does not vibrate", what);
    if (out_rms)
        *out_rms = above.rms / below.rms;
    if (out_vdv)
        *out_vdv = above.vdv / below.vdv;
    return TRK_OK;
}
