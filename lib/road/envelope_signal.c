/* SPDX-License-Identifier: MIT */
/* Signal of what a tire passes on of a profile. */
#include "road/envelope.h"

static trk_status check(trk_context *context, double start, double spacing, int64_t count,
                        double radius, double length)
{
    const struct {
        const char *name;
        double value, least;
    } fields[] = {{"start", start, -1e12},
                  {"spacing", spacing, 1e-12},
                  {"radius", radius, 0},
                  {"length", length, 0}};
    for (size_t k = 0; k < sizeof fields / sizeof *fields; k++)
        if (!(fields[k].value >= fields[k].least && fields[k].value <= 1e12))
            return trk_fail(context, TRK_E_RANGE, "envelope: %s is %g m, expected %g to 1e12",
                            fields[k].name, fields[k].value, fields[k].least);
    if (radius == 0 && length == 0)
        return trk_fail(context, TRK_E_RANGE,
                        "envelope: radius and length are 0, expected one of them > 0");
    if (count < 2)
        return trk_fail(context, TRK_E_RANGE, "envelope: %lld samples, expected at least 2",
                        (long long)count);
    return TRK_OK;
}

/* Heights and slopes into `sample`: heights, slopes and room for the profile itself. */
static trk_status filter(trk_context *context, double spacing, int64_t count, double radius,
                         double length, double *sample)
{
    double *height = sample, *slope = sample + count, *profile = sample + 2 * count;
    if (radius == 0)
        return trk_envelope_average(context, count, spacing, profile, length, height, slope);
    trk_status status = trk_envelope_rigid_band(context, count, spacing, profile, radius, height,
                                                length > 0 ? NULL : slope);
    if (status != TRK_OK || length == 0)
        return status;
    return trk_envelope_average(context, count, spacing, height, length, profile, slope);
}

trk_status trk_envelope_signal(trk_context *context, const trk_signal *profile, double start,
                               double spacing, int64_t count, double radius, double length,
                               trk_signal **out_signal)
{
    TRK_REQUIRE(context, out_signal, "trk_envelope_signal");
    *out_signal = NULL;
    TRK_REQUIRE(context, context, "trk_envelope_signal");
    TRK_REQUIRE(context, profile, "trk_envelope_signal");
    trk_status status = check(context, start, spacing, count, radius, length);
    if (status != TRK_OK)
        return status;
    double *sample = trk_new(context, count, 3 * sizeof *sample);
    if (!sample)
        return TRK_E_MEMORY;
    const double *filtered = radius > 0 && length > 0 ? sample + 2 * count : sample;
    trk_signal_evaluate(profile, count, start, spacing, sample + 2 * count, NULL);
    status = filter(context, spacing, count, radius, length, sample);
    if (status == TRK_OK)
        status = trk_signal_create_samples(context, count, start, spacing, filtered, sample + count,
                                           out_signal);
    trk_free(context, sample);
    return status;
}
