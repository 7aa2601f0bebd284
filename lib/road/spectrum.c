/* SPDX-License-Identifier: MIT */
/* Density and coherence over wavenumber, for calculations in the frequency domain. */
#include "base/plain.h"
#include "road/road.h"

double trk_road_power_law(const trk_road_options *options, double wavenumber)
{
    return options->unevenness * trk_plain_power(wavenumber / 0.1, -options->waviness);
}

static trk_status check(trk_context *context, int64_t count, const double *wavenumber)
{
    if (count < 0)
        return trk_fail(context, TRK_E_RANGE, "road: %lld wavenumbers, expected at least 0",
                        (long long)count);
    for (int64_t k = 0; k < count; k++)
        if (!(isfinite(wavenumber[k]) && wavenumber[k] >= 0))
            return trk_fail(context, TRK_E_RANGE,
                            "road: wavenumber %lld is %g, expected a finite value >= 0",
                            (long long)k + 1, wavenumber[k]);
    return TRK_OK;
}

trk_status trk_road_density(trk_context *context, const trk_road_options *options, int64_t count,
                            const double *wavenumber, double *out_density)
{
    TRK_REQUIRE(context, context, "trk_road_density");
    TRK_REQUIRE(context, wavenumber, "trk_road_density");
    TRK_REQUIRE(context, out_density, "trk_road_density");
    trk_road_options o;
    trk_status status = trk_road_read_options(context, options, &o);
    if (status == TRK_OK)
        status = check(context, count, wavenumber);
    for (int64_t k = 0; status == TRK_OK && k < count; k++) {
        const double n = wavenumber[k], weight = trk_envelope_weight(n, o.contact_length);
        out_density[k] = n < o.low || n > o.high ? 0 : trk_road_power_law(&o, n) * weight * weight;
    }
    return status;
}

trk_status trk_road_coherence(trk_context *context, const trk_road_options *options, int64_t count,
                              const double *wavenumber, double *out_coherence)
{
    TRK_REQUIRE(context, context, "trk_road_coherence");
    TRK_REQUIRE(context, wavenumber, "trk_road_coherence");
    TRK_REQUIRE(context, out_coherence, "trk_road_coherence");
    trk_road_options o;
    trk_status status = trk_road_read_options(context, options, &o);
    if (status == TRK_OK)
        status = check(context, count, wavenumber);
    if (status)
        return status;
    trk_coherence_rule rule;
    trk_coherence_rule_set(&rule, &o);
    for (int64_t k = 0; k < count; k++)
        out_coherence[k] = trk_coherence_of(&rule, wavenumber[k]);
    return TRK_OK;
}
