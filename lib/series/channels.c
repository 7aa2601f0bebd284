/* SPDX-License-Identifier: MIT */
/* Labels of the channels, and questions to a series. */
#include "series/series.h"

#include <math.h>
#include <string.h>

static const trk_channel *find_channel(const trk_series *series, int32_t channel)
{
    return series && channel >= 1 && channel <= series->channels ? &series->channel[channel - 1]
                                                                 : NULL;
}

trk_status trk_series_label(trk_series *series, int32_t channel, const char *name, const char *unit)
{
    if (!series)
        return TRK_E_ARGUMENT;
    trk_context *context = series->context;
    TRK_REQUIRE(context, name, "trk_series_label");
    TRK_REQUIRE(context, unit, "trk_series_label");
    if (!find_channel(series, channel))
        return trk_fail(context, TRK_E_ARGUMENT, "series: no channel %d, expected 1 to %d",
                        (int)channel, (int)series->channels);
    if (!*name)
        return trk_fail(context, TRK_E_NAME, "series: the name for channel %d is empty",
                        (int)channel);
    int32_t owner = trk_series_find(series, name);
    if (owner && owner != channel)
        return trk_fail(context, TRK_E_NAME,
                        "series: '%s' for channel %d is the name of channel %d", name, (int)channel,
                        (int)owner);
    char *new_name = trk_copy_text(context, name), *new_unit = trk_copy_text(context, unit);
    if (!new_name || !new_unit) {
        trk_free(context, new_name);
        trk_free(context, new_unit);
        return TRK_E_MEMORY;
    }
    trk_channel *c = &series->channel[channel - 1];
    trk_free(context, c->name);
    trk_free(context, c->unit);
    c->name = new_name;
    c->unit = new_unit;
    return TRK_OK;
}

int32_t trk_series_find(const trk_series *series, const char *name)
{
    for (int32_t k = 0; series && name && k < series->channels; k++)
        if (strcmp(series->channel[k].name, name) == 0)
            return k + 1;
    return 0;
}

int32_t trk_series_channels(const trk_series *series)
{
    return series ? series->channels : 0;
}

int64_t trk_series_samples(const trk_series *series)
{
    return series ? series->samples : 0;
}

double trk_series_rate(const trk_series *series)
{
    return series ? series->sample_rate : NAN;
}

double trk_series_start(const trk_series *series)
{
    return series ? series->start : NAN;
}

const char *trk_series_name(const trk_series *series, int32_t channel)
{
    const trk_channel *c = find_channel(series, channel);
    return c ? c->name : NULL;
}

const char *trk_series_unit(const trk_series *series, int32_t channel)
{
    const trk_channel *c = find_channel(series, channel);
    return c ? c->unit : NULL;
}

const double *trk_series_data(const trk_series *series, int32_t channel)
{
    const trk_channel *c = find_channel(series, channel);
    return c ? c->data : NULL;
}

double *trk_series_data_mutable(trk_series *series, int32_t channel)
{
    const trk_channel *c = find_channel(series, channel);
    return c ? c->data : NULL;
}
