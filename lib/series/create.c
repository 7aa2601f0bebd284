/* SPDX-License-Identifier: MIT */
/* Life of a series. */
#include "series/series.h"

#include <math.h>

static trk_status check(trk_context *context, int32_t channels, int64_t samples, double sample_rate,
                        double start)
{
    if (channels < 1)
        return trk_fail(context, TRK_E_RANGE, "series: %d channels, expected at least 1",
                        (int)channels);
    if (samples < 1)
        return trk_fail(context, TRK_E_RANGE, "series: %lld samples, expected at least 1",
                        (long long)samples);
    if (!isfinite(sample_rate) || sample_rate <= 0.0)
        return trk_fail(context, TRK_E_RANGE,
                        "series: sample_rate is %g Hz, expected a finite value > 0", sample_rate);
    if (!isfinite(start))
        return trk_fail(context, TRK_E_RANGE, "series: start is %g s, expected a finite value",
                        start);
    return TRK_OK;
}

static trk_status fill(trk_context *context, trk_series *series)
{
    const size_t line = 8; /* samples in a cache line */
    int64_t lines = (series->samples - 1) / (int64_t)line + 1;
    series->channel = trk_new(context, series->channels, sizeof *series->channel);
    series->block =
        trk_new(context, lines, line * sizeof *series->block * (size_t)series->channels);
    if (!series->channel || !series->block)
        return TRK_E_MEMORY;
    for (int32_t k = 0; k < series->channels; k++) {
        trk_channel *c = &series->channel[k];
        char number[16];
        trk_format(number, sizeof number, "%d", (int)k + 1);
        c->name = trk_copy_text(context, number);
        c->unit = trk_copy_text(context, "");
        c->data = series->block + k * lines * (int64_t)line;
        if (!c->name || !c->unit)
            return TRK_E_MEMORY;
    }
    return TRK_OK;
}

trk_status trk_series_create(trk_context *context, int32_t channels, int64_t samples,
                             double sample_rate, double start, trk_series **out_series)
{
    TRK_REQUIRE(context, out_series, "trk_series_create");
    *out_series = NULL;
    if (!context)
        return TRK_E_ARGUMENT;
    trk_status status = check(context, channels, samples, sample_rate, start);
    if (status)
        return status;
    trk_series *series = trk_new(context, 1, sizeof *series);
    if (!series)
        return TRK_E_MEMORY;
    *series = (trk_series){context, channels, samples, sample_rate, start, NULL, NULL};
    status = fill(context, series);
    if (status) {
        trk_series_destroy(series);
        return status;
    }
    *out_series = series;
    return TRK_OK;
}

trk_status trk_series_create_like(trk_context *context, const trk_series *series, int64_t samples,
                                  double sample_rate, trk_series **out_series)
{
    *out_series = NULL;
    trk_series *other;
    trk_status status =
        trk_series_create(context, series->channels, samples, sample_rate, series->start, &other);
    if (status)
        return status;
    for (int32_t k = 0; k < series->channels; k++) {
        trk_channel *c = &other->channel[k];
        trk_free(context, c->name);
        trk_free(context, c->unit);
        c->name = trk_copy_text(context, series->channel[k].name);
        c->unit = trk_copy_text(context, series->channel[k].unit);
        if (!c->name || !c->unit) {
            trk_series_destroy(other);
            return TRK_E_MEMORY;
        }
    }
    *out_series = other;
    return TRK_OK;
}

void trk_series_destroy(trk_series *series)
{
    if (!series)
        return;
    trk_context *context = series->context;
    for (int32_t k = 0; series->channel && k < series->channels; k++) {
        trk_free(context, series->channel[k].unit);
        trk_free(context, series->channel[k].name);
    }
    trk_free(context, series->channel);
    trk_free(context, series->block);
    trk_free(context, series);
}
