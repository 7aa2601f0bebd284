/* SPDX-License-Identifier: MIT */
/* MTS RPC III time histories as series (FILES.3). */
#include "base/number.h"
#include "files/bytes.h"
#include "files/rpc.h"
#include "files/slurp.h"
#include "files/unit.h"

#include <math.h>

/* Keyword of a channel, "DESC.CHAN_3". */
static trk_slice find_of_channel(const trk_rpc *rpc, const char *what, int32_t channel)
{
    char keyword[TRK_RPC_KEYWORD];
    trk_format(keyword, sizeof keyword, "%s.CHAN_%d", what, (int)channel);
    return trk_rpc_find(rpc, keyword);
}

/* Engineering units of one count. */
static trk_status read_scale(const trk_rpc *rpc, int32_t channel, double *out_scale)
{
    const trk_slice value = find_of_channel(rpc, "SCALE", channel);
    *out_scale = 1;
    if (rpc->floating)
        return TRK_OK;
    if (!value.begin)
        return trk_fail(rpc->context, TRK_E_SYNTAX, "%s: the header has no SCALE.CHAN_%d",
                        rpc->name, (int)channel);
    char excerpt[TRK_EXCERPT];
    if (trk_number_read(value.begin, value.end, '.', out_scale) == value.end &&
        isfinite(*out_scale * 32768))
        return TRK_OK;
    return trk_fail(rpc->context, TRK_E_SYNTAX,
                    "%s: byte %lld: SCALE.CHAN_%d is %s, expected a number", rpc->name,
                    (long long)(value.begin - rpc->bytes), (int)channel,
                    trk_excerpt(value, excerpt));
}

/* Groups one after the other, in each the channels, in each the points. */
static trk_status read_samples(const trk_rpc *rpc, int32_t channel, double scale, double *out)
{
    const int64_t size = rpc->floating ? 4 : 2, points = rpc->points_per_group;
    const char *data = rpc->bytes + rpc->blocks * TRK_RPC_BLOCK;
    for (int64_t k = 0; k < rpc->samples; k++) {
        const int64_t group = k / points, place = k % points;
        const char *at = data + ((group * rpc->channels + channel - 1) * points + place) * size;
        if (!rpc->floating) {
            out[k] = scale * trk_bytes_int16(at, rpc->big_endian);
            continue;
        }
        out[k] = trk_bytes_float(at, rpc->big_endian);
        if (!isfinite(out[k]))
            return trk_fail(rpc->context, TRK_E_SYNTAX,
                            "%s: byte %lld: sample %lld of channel %d is not finite", rpc->name,
                            (long long)(at - rpc->bytes), (long long)k, (int)channel);
    }
    return TRK_OK;
}

static trk_status fill(const trk_rpc *rpc, trk_series *series)
{
    for (int32_t c = 1; c <= (int32_t)rpc->channels; c++) {
        char name[TRK_LABEL] = "", unit[TRK_LABEL] = "";
        const trk_slice description = find_of_channel(rpc, "DESC", c);
        const trk_slice units = find_of_channel(rpc, "UNITS", c);
        double scale;
        if (description.begin)
            trk_label_copy(description, false, name, sizeof name);
        if (units.begin)
            trk_label_copy(units, false, unit, sizeof unit);
        trk_status status = read_scale(rpc, c, &scale);
        if (status == TRK_OK)
            status = trk_label(series, c, name, unit, c);
        if (status == TRK_OK)
            status = read_samples(rpc, c, scale, trk_series_data_mutable(series, c));
        if (status)
            return status;
    }
    return TRK_OK;
}

static trk_status parse(trk_context *context, const char *name, const void *bytes, size_t size,
                        trk_series **out_series)
{
    trk_rpc rpc = {.context = context, .name = name, .bytes = bytes, .size = (int64_t)size};
    trk_status status = trk_rpc_read_header(&rpc);
    if (status)
        return status;
    trk_series *series;
    status = trk_series_create(context, (int32_t)rpc.channels, rpc.samples,
                               trk_round_rate(1 / rpc.step), 0, &series);
    if (status)
        return status;
    status = fill(&rpc, series);
    if (status) {
        trk_series_destroy(series);
        return status;
    }
    *out_series = series;
    return TRK_OK;
}

trk_status trk_series_parse_rpc(trk_context *context, const char *name, const void *bytes,
                                size_t size, trk_series **out_series)
{
    TRK_REQUIRE(context, out_series, "trk_series_parse_rpc");
    *out_series = NULL;
    if (!context)
        return TRK_E_ARGUMENT;
    TRK_REQUIRE(context, name, "trk_series_parse_rpc");
    TRK_REQUIRE(context, bytes || size == 0, "trk_series_parse_rpc");
    return parse(context, name, bytes, size, out_series);
}

trk_status trk_series_read_rpc(trk_context *context, const char *path, trk_series **out_series)
{
    TRK_REQUIRE(context, out_series, "trk_series_read_rpc");
    *out_series = NULL;
    if (!context)
        return TRK_E_ARGUMENT;
    TRK_REQUIRE(context, path, "trk_series_read_rpc");
    char *bytes;
    size_t size;
    trk_status status = trk_slurp(context, path, &bytes, &size);
    if (status == TRK_OK)
        status = parse(context, path, bytes, size, out_series);
    trk_free(context, bytes);
    return status;
}
