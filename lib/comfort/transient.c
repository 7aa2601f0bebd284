/* SPDX-License-Identifier: MIT */
/* Frequency and damping of a free oscillation, 96/53/EC annex II (COMFORT.14). */
#include "comfort/check.h"
#include "spectrum/settings.h"

#include <math.h>
#include <truckride/comfort.h>

/* Deviations up to this part of the largest are noise about the level at rest. */
static const double noise = 0.002;

typedef struct peak {
    double time, amplitude; /* in samples; > 0 */
} peak;

/* Vertex of the parabola through the lowest sample and its neighbours. */
static peak refine(const double *x, int64_t i, double rest)
{
    double before = x[i - 1] - x[i], after = x[i + 1] - x[i], curvature = before + after;
    double shift = curvature > 0 ? (before - after) / (2 * curvature) : 0;
    return (peak){(double)i + shift, rest - x[i] + shift * shift * curvature / 2};
}

/*
 * Lowest samples of the stretches below rest, each bounded by stretches above it; the record
 * may begin or end inside one, whose lowest sample counts if it is not the end itself.
 */
static int find_peaks(int64_t count, const double *x, double rest, double threshold, peak *out,
                      int capacity)
{
    int found = 0;
    int64_t lowest = -1;
    for (int64_t i = 0; i < count && found < capacity; i++) {
        double deviation = x[i] - rest;
        if (deviation < -threshold && (lowest < 0 || x[i] < x[lowest]))
            lowest = i;
        bool finished = deviation > threshold || i == count - 1;
        if (finished && lowest >= 0) {
            if (lowest > 0 && lowest < count - 1)
                out[found++] = refine(x, lowest, rest);
            lowest = -1;
        }
    }
    return found;
}

trk_status trk_axle_transient_measure(trk_context *context, int64_t count, const double *travel,
                                      double sample_rate, double rest,
                                      trk_axle_transient *out_transient)
{
    static const char what[] = "trk_axle_transient_measure";
    static const double two_pi = 6.28318530717958647692;
    TRK_REQUIRE(context, context, "trk_axle_transient_measure");
    TRK_REQUIRE(context, travel, "trk_axle_transient_measure");
    TRK_REQUIRE(context, out_transient, "trk_axle_transient_measure");
    trk_status status = trk_comfort_check_result(context, what, out_transient);
    if (status == TRK_OK)
        status = trk_comfort_check_samples(context, what, "travel", 3, count, travel);
    if (status == TRK_OK)
        status = trk_check_rate(context, what, "sample_rate", sample_rate);
    if (status == TRK_OK)
        status = trk_comfort_check_value(context, what, "rest", rest, -TRK_COMFORT_LARGEST);
    if (status != TRK_OK)
        return status;
    double largest = 0;
    for (int64_t i = 0; i < count; i++)
        largest = fmax(largest, fabs(travel[i] - rest));
    peak p[2];
    int found = find_peaks(count, travel, rest, noise * largest, p, 2);
    if (found < 2 || !(p[1].amplitude < p[0].amplitude && p[1].amplitude > 0))
        return trk_fail(context, TRK_E_RANGE,
                        "%s: %d compression peaks, expected two of falling height: the damping is "
                        "too strong, or the record too short or not free",
                        what, found);
    double decrement = log(p[0].amplitude / p[1].amplitude);
    trk_axle_transient t = {.struct_size = sizeof t};
    t.damped_frequency = sample_rate / (p[1].time - p[0].time);
    t.damping_ratio = decrement / hypot(two_pi, decrement);
    t.frequency = t.damped_frequency * hypot(1, decrement / two_pi);
    t.first_time = p[0].time / sample_rate;
    t.first_amplitude = p[0].amplitude;
    t.second_amplitude = p[1].amplitude;
    return trk_write_options(out_transient, &t, sizeof t);
}

int32_t trk_road_friendliness(double frequency, double damping_ratio, double without_dampers)
{
    return (frequency <= 2.0 ? 0 : TRK_UNFRIENDLY_FREQUENCY) |
           (damping_ratio > 0.2 ? 0 : TRK_UNFRIENDLY_DAMPING) |
           (without_dampers <= 0.5 * damping_ratio ? 0 : TRK_UNFRIENDLY_DAMPERS);
}
