/* SPDX-License-Identifier: MIT */
/* Series as MTS RPC III time histories (FILES.3). */
#include "base/number.h"
#include "files/bytes.h"
#include "files/rpc.h"
#include "files/sink.h"

#include <float.h>
#include <math.h>
#include <string.h>

enum { GENERAL_KEYS = 20, KEYS_OF_CHANNEL = 6, MOST_CHANNELS = 128, RECORDS_OF_BLOCK = 4 };

typedef struct writer {
    trk_context *context;
    const trk_series *series;
    const char *path;
    trk_rpc_options options;
    char *header; /* blocks of 512 bytes */
    int64_t blocks, records, groups;
    double *scale; /* of each channel, as a reader will find it */
} writer;

void trk_rpc_options_init(trk_rpc_options *options, size_t struct_size)
{
    const trk_rpc_options defaults = {sizeof defaults, TRK_RPC_FLOATING_POINT, 0, 0, 0};
    trk_write_defaults(options, struct_size, &defaults, sizeof defaults);
}

static trk_status check(const writer *w)
{
    const trk_rpc_options *o = &w->options;
    if (o->type != TRK_RPC_FLOATING_POINT && o->type != TRK_RPC_SHORT_INTEGER)
        return trk_fail(w->context, TRK_E_RANGE, "%s: type is %d, expected a trk_rpc_type", w->path,
                        (int)o->type);
    if (o->big_endian < 0 || o->big_endian > 1 || o->drive < 0 || o->drive > 1 || o->reserved)
        return trk_fail(w->context, TRK_E_RANGE,
                        "%s: big_endian %d, drive %d, reserved %d: expected 0 or 1, and reserved 0",
                        w->path, (int)o->big_endian, (int)o->drive, (int)o->reserved);
    if (trk_series_channels(w->series) > MOST_CHANNELS)
        return trk_fail(w->context, TRK_E_RANGE, "%s: %d channels, the format has at most %d",
                        w->path, (int)trk_series_channels(w->series), (int)MOST_CHANNELS);
    if (trk_series_samples(w->series) > INT32_MAX - TRK_RPC_GROUP)
        return trk_fail(w->context, TRK_E_RANGE, "%s: %lld samples, the format has at most 2^31",
                        w->path, (long long)trk_series_samples(w->series));
    return TRK_OK;
}

/* UTF-8 as ISO 8859-1, which is all that readers of this format know. */
static void put_latin(const char *text, char *out, size_t room)
{
    size_t used = 0;
    for (const unsigned char *p = (const unsigned char *)text; *p && used + 1 < room; p++) {
        if (*p < 0x80)
            out[used++] = (char)*p;
        else if ((*p & 0xfe) == 0xc2 && (p[1] & 0xc0) == 0x80)
            out[used++] = (char)(*p << 6 | (p[1] & 0x3f)); /* p[1] is skipped below */
        else if (*p >= 0xc0) /* first byte of a letter beyond, its others are skipped, too */
            out[used++] = '?';
    }
    out[used] = '\0';
}

static void put_record(writer *w, const char *keyword, const char *value)
{
    char *record = w->header + w->records++ * TRK_RPC_RECORD;
    put_latin(keyword, record, TRK_RPC_KEYWORD);
    put_latin(value, record + TRK_RPC_KEYWORD, TRK_RPC_RECORD - TRK_RPC_KEYWORD);
}

static void put_count(writer *w, const char *keyword, int64_t value)
{
    char text[32];
    trk_format(text, sizeof text, "%lld", (long long)value);
    put_record(w, keyword, text);
}

static void put_general(writer *w)
{
    const int64_t samples = trk_series_samples(w->series);
    char step[32];
    trk_format(step, sizeof step, "%.16E", 1 / trk_series_rate(w->series));
    put_record(w, "FORMAT",
               w->options.big_endian ? "BINARY_IEEE_BIG_END" : "BINARY_IEEE_LITTLE_END");
    put_count(w, "NUM_HEADER_BLOCKS", w->blocks);
    const int64_t count = w->records++; /* NUM_PARAMS, known at the end */
    put_record(w, "FILE_TYPE", "TIME_HISTORY");
    put_record(w, "TIME_TYPE", w->options.drive ? "DRIVE" : "RESPONSE");
    put_record(w, "DATA_TYPE",
               w->options.type == TRK_RPC_SHORT_INTEGER ? "SHORT_INTEGER" : "FLOATING_POINT");
    put_record(w, "DELTA_T", step);
    put_count(w, "CHANNELS", trk_series_channels(w->series));
    put_count(w, "PTS_PER_FRAME", TRK_RPC_FRAME);
    put_count(w, "PTS_PER_GROUP", TRK_RPC_GROUP);
    put_count(w, "FRAMES", (samples - 1) / TRK_RPC_FRAME + 1);
    put_count(w, "HALF_FRAMES", 0);
    put_count(w, "REPEATS", 1);
    put_count(w, "INT_FULL_SCALE", TRK_RPC_FULL_SCALE);
    put_count(w, "BYPASS_FILTER", 0);
    put_count(w, "PARTITIONS", 1);
    put_count(w, "PART.CHAN_1", 1);
    put_count(w, "PART.NCHAN_1", trk_series_channels(w->series));
    put_record(w, "OPERATION", "libtruckride");
    put_count(w, "TRUCKRIDE_SAMPLES", samples);
    const int64_t records = w->records;
    w->records = count;
    put_count(w, "NUM_PARAMS", records + KEYS_OF_CHANNEL * trk_series_channels(w->series));
    w->records = records;
}

static trk_status find_limits(const writer *w, int32_t channel, double *out_low, double *out_high)
{
    const double *x = trk_series_data(w->series, channel);
    *out_low = *out_high = x[0];
    for (int64_t k = 0; k < trk_series_samples(w->series); k++) {
        if (!(fabs(x[k]) <= (double)FLT_MAX))
            return trk_fail(w->context, TRK_E_RANGE,
                            "%s: sample %lld of channel '%s' is %g, expected a finite value in the "
                            "range of float32",
                            w->path, (long long)k, trk_series_name(w->series, channel), x[k]);
        *out_low = fmin(*out_low, x[k]);
        *out_high = fmax(*out_high, x[k]);
    }
    return TRK_OK;
}

static trk_status put_channel(writer *w, int32_t channel)
{
    double low, high;
    trk_status status = find_limits(w, channel, &low, &high);
    if (status)
        return status;
    const double peak = fmax(-low, high);
    char keyword[TRK_RPC_KEYWORD], text[32];
#define PUT(what, value)                                                                           \
    trk_format(keyword, sizeof keyword, what ".CHAN_%d", (int)channel);                            \
    put_record(w, keyword, value)
    PUT("DESC", trk_series_name(w->series, channel));
    PUT("UNITS", trk_series_unit(w->series, channel));
    /* Peaks too small to be divided are zero to any instrument. */
    trk_format(text, sizeof text, "%.16E", peak > 1e-290 ? peak / TRK_RPC_FULL_SCALE : 1.0);
    trk_number_read(text, text + strlen(text), '.', &w->scale[channel - 1]);
    PUT("SCALE", w->options.type == TRK_RPC_SHORT_INTEGER ? text : "1");
    trk_format(text, sizeof text, "%.9E", high);
    PUT("UPPER_LIMIT", text);
    trk_format(text, sizeof text, "%.9E", low);
    PUT("LOWER_LIMIT", text);
    trk_format(text, sizeof text, "%d", (int)channel);
    PUT("MAP", text);
#undef PUT
    return TRK_OK;
}

/* One group of a channel; beyond the end the last value. */
static void put_group(const writer *w, trk_sink *sink, int64_t group, int32_t channel)
{
    const double *x = trk_series_data(w->series, channel), scale = w->scale[channel - 1];
    const int64_t last = trk_series_samples(w->series) - 1;
    for (int64_t k = group * TRK_RPC_GROUP; k < (group + 1) * TRK_RPC_GROUP; k++) {
        const double value = x[k < last ? k : last];
        char bytes[4];
        if (w->options.type == TRK_RPC_SHORT_INTEGER) {
            const int count = (int)nearbyint(value / scale);
            trk_bytes_put(bytes, 2, w->options.big_endian, (uint64_t)(uint16_t)count);
            trk_sink_put(sink, bytes, 2);
        } else {
            const float number = (float)value;
            uint32_t bits;
            memcpy(&bits, &number, sizeof bits);
            trk_bytes_put(bytes, 4, w->options.big_endian, bits);
            trk_sink_put(sink, bytes, 4);
        }
    }
}

static trk_status write_file(writer *w)
{
    const int32_t channels = trk_series_channels(w->series);
    trk_status status = TRK_OK;
    put_general(w);
    for (int32_t c = 1; status == TRK_OK && c <= channels; c++)
        status = put_channel(w, c);
    trk_sink sink;
    if (status == TRK_OK)
        status = trk_sink_open(w->context, w->path, &sink);
    if (status)
        return status;
    trk_sink_put(&sink, w->header, (size_t)w->blocks * TRK_RPC_BLOCK);
    for (int64_t g = 0; g < w->groups && sink.error == 0; g++)
        for (int32_t c = 1; c <= channels; c++)
            put_group(w, &sink, g, c);
    return trk_sink_close(&sink, TRK_OK);
}

trk_status trk_series_write_rpc(trk_context *context, const trk_series *series, const char *path,
                                const trk_rpc_options *options)
{
    TRK_REQUIRE(context, series, "trk_series_write_rpc");
    TRK_REQUIRE(context, path, "trk_series_write_rpc");
    if (!context)
        return TRK_E_ARGUMENT;
    const int32_t channels = trk_series_channels(series);
    writer w = {.context = context, .series = series, .path = path};
    trk_rpc_options_init(&w.options, sizeof w.options);
    trk_status status =
        trk_read_options(context, "trk_rpc_options", options, &w.options, sizeof w.options);
    if (status == TRK_OK)
        status = check(&w);
    if (status)
        return status;
    w.blocks = (GENERAL_KEYS + KEYS_OF_CHANNEL * channels - 1) / RECORDS_OF_BLOCK + 1;
    w.groups = (trk_series_samples(series) - 1) / TRK_RPC_GROUP + 1;
    w.header = trk_new(context, w.blocks, TRK_RPC_BLOCK);
    w.scale = trk_new(context, channels, sizeof *w.scale);
    status = w.header && w.scale ? write_file(&w) : TRK_E_MEMORY;
    trk_free(context, w.scale);
    trk_free(context, w.header);
    return status;
}
