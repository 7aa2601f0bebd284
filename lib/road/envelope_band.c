/* SPDX-License-Identifier: MIT */
/* Rigid tread band: a wheel that rolls over a profile (ROAD.12). */
#include "road/envelope.h"

#include <math.h>

typedef struct band {
    int64_t count;
    double spacing, radius;
    const double *height;
    double *out_height, *out_slope;
} band;

/* What a place of contact makes of the path of the hub. */
typedef struct touch {
    double height, slope; /* height less the radius */
} touch;

/* The wheel above sample k on the cell from sample j on; height -infinity: out of reach. */
static touch stand(const band *b, int64_t k, int64_t j)
{
    const double from = (double)(j - k) * b->spacing, r = b->radius;
    if (from > r || from + b->spacing < -r)
        return (touch){-INFINITY, 0};
    const double low = fmax(from, -r), high = fmin(from + b->spacing, r);
    const double slope = (b->height[j + 1] - b->height[j]) / b->spacing;
    const double flank = r * (slope / hypot(1, slope)), x = fmin(fmax(flank, low), high);
    const double cosine = sqrt((r - x) * (r + x)); /* times r */
    /* cosine - r without the difference; a corner of a wall, x = r, has no finite slope */
    return (touch){b->height[j] + slope * (x - from) - x * (x / (r + cosine)),
                   x == flank ? slope : x / fmax(cosine, 1e-12 * r)};
}

/*
 * Samples first .. last touch cells from .. to. The place of contact moves on as the wheel does: of
 * two circles of one radius, that of the later place rises more steeply wherever both are in
 * reach. So the contact of the middle sample parts those of all before from those of all behind.
 */
static void roll(const band *b, int64_t first, int64_t last, int64_t from, int64_t to)
{
    while (first <= last) {
        const int64_t k = first + (last - first) / 2;
        const double reach = floor(b->radius / b->spacing) + 2;
        const int64_t least = (double)(k - from) > reach ? k - (int64_t)reach : from,
                      most = (double)(to - k) > reach ? k + (int64_t)reach : to;
        touch best = {-INFINITY, 0};
        int64_t cell = from;
        for (int64_t j = least; j <= most; j++) {
            const touch t = stand(b, k, j);
            if (t.height > best.height) {
                best = t;
                cell = j;
            }
        }
        b->out_height[k] = best.height;
        if (b->out_slope)
            b->out_slope[k] = best.slope;
        roll(b, first, k - 1, from, cell);
        first = k + 1;
        from = cell;
    }
}

trk_status trk_envelope_rigid_band(trk_context *context, int64_t count, double spacing,
                                   const double *height, double radius, double *out_height,
                                   double *out_slope)
{
    TRK_REQUIRE(context, context, "trk_envelope_rigid_band");
    TRK_REQUIRE(context, height, "trk_envelope_rigid_band");
    TRK_REQUIRE(context, out_height, "trk_envelope_rigid_band");
    trk_status status = trk_envelope_check_arrays(context, height, out_height, out_slope);
    if (status == TRK_OK)
        status = trk_envelope_check(context, count, spacing, height, "radius", radius);
    if (status != TRK_OK)
        return status;
    const band b = {count, spacing, radius, height, out_height, out_slope};
    if (count > 1) {
        roll(&b, 0, count - 1, 0, count - 2);
    } else {
        out_height[0] = height[0];
        if (out_slope)
            out_slope[0] = 0;
    }
    return TRK_OK;
}
