/* SPDX-License-Identifier: MIT */
/* Series as MATLAB level 5 files, uncompressed, little-endian (FILES.4). */
#include "base/names.h"
#include "files/bytes.h"
#include "files/sink.h"

#include <string.h>
#include <truckride/files.h>

enum {
    TYPE_INT8 = 1,
    TYPE_INT32 = 5,
    TYPE_UINT32 = 6,
    TYPE_DOUBLE = 9,
    TYPE_MATRIX = 14,
    TYPE_UTF8 = 16,
    CLASS_CELL = 1,
    CLASS_CHAR = 4,
    CLASS_DOUBLE = 6,
    NAME_ROOM = 64 /* MATLAB's names have at most 63 letters */
};

static int64_t padded(int64_t bytes)
{
    return (bytes + 7) / 8 * 8;
}

static void put_uint32(trk_sink *sink, uint32_t value)
{
    char bytes[4];
    trk_bytes_put(bytes, 4, false, value);
    trk_sink_put(sink, bytes, 4);
}

static void put_tag(trk_sink *sink, uint32_t type, int64_t bytes)
{
    put_uint32(sink, type);
    put_uint32(sink, (uint32_t)bytes);
}

static void put_padding(trk_sink *sink, int64_t bytes)
{
    static const char zeros[8] = {0};
    trk_sink_put(sink, zeros, (size_t)(padded(bytes) - bytes));
}

/* Size of flags, dimensions and name with their tags; up to 4 letters share the tag's 8 bytes. */
static int64_t head_size(const char *name)
{
    const int64_t length = (int64_t)strlen(name);
    return 16 + 16 + (length > 0 && length <= 4 ? 8 : 8 + padded(length));
}

static void put_head(trk_sink *sink, uint32_t class, int64_t rows, int64_t columns,
                     const char *name, int64_t data_bytes)
{
    const size_t length = strlen(name);
    put_tag(sink, TYPE_MATRIX, head_size(name) + data_bytes);
    put_tag(sink, TYPE_UINT32, 8);
    put_uint32(sink, class);
    put_uint32(sink, 0);
    put_tag(sink, TYPE_INT32, 8);
    put_uint32(sink, (uint32_t)rows);
    put_uint32(sink, (uint32_t)columns);
    if (length > 0 && length <= 4)
        put_uint32(sink, (uint32_t)(length << 16 | TYPE_INT8));
    else
        put_tag(sink, TYPE_INT8, (int64_t)length);
    trk_sink_put(sink, name, length);
    if (length > 0 && length <= 4)
        trk_sink_put(sink, "\0\0\0", 4 - length);
    else
        put_padding(sink, (int64_t)length);
}

static void put_double(trk_sink *sink, double value)
{
    char bytes[8];
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    trk_bytes_put(bytes, 8, false, bits);
    trk_sink_put(sink, bytes, 8);
}

static void put_vector_head(trk_sink *sink, const char *name, int64_t samples)
{
    put_head(sink, CLASS_DOUBLE, samples, 1, name, 8 + 8 * samples);
    put_tag(sink, TYPE_DOUBLE, 8 * samples);
}

/* Letters of UTF-8 text: its bytes but those that go on with a letter. */
static int64_t count_letters(const char *text)
{
    int64_t count = 0;
    for (; *text; text++)
        count += ((unsigned char)*text & 0xc0) != 0x80;
    return count;
}

static int64_t text_size(const char *text) /* behind the tag of its matrix */
{
    return head_size("") + 8 + padded((int64_t)strlen(text));
}

/* UTF-8: SciPy decodes 16-bit units wrongly, Octave refuses those marked as UTF-16. */
static void put_text(trk_sink *sink, const char *text)
{
    const int64_t letters = count_letters(text), bytes = (int64_t)strlen(text);
    put_head(sink, CLASS_CHAR, letters > 0, letters, "", 8 + padded(bytes));
    put_tag(sink, TYPE_UTF8, bytes);
    trk_sink_put(sink, text, (size_t)bytes);
    put_padding(sink, bytes);
}

typedef const char *(*label)(const trk_series *series, int32_t channel);

/* Cell array of a label of each channel. */
static void put_labels(trk_sink *sink, const char *name, const trk_series *series, label of)
{
    const int32_t channels = trk_series_channels(series);
    int64_t bytes = 0;
    for (int32_t c = 1; c <= channels; c++)
        bytes += 8 + text_size(of(series, c));
    put_head(sink, CLASS_CELL, channels, 1, name, bytes);
    for (int32_t c = 1; c <= channels; c++)
        put_text(sink, of(series, c));
}

static bool is_keyword(const char *name)
{
    static const char *const words[] = {"break",  "case",   "catch",     "classdef", "continue",
                                        "else",   "elseif", "end",       "for",      "function",
                                        "global", "if",     "otherwise", "parfor",   "persistent",
                                        "return", "spmd",   "switch",    "try",      "while"};
    for (size_t k = 0; k < sizeof words / sizeof *words; k++)
        if (strcmp(name, words[k]) == 0)
            return true;
    return false;
}

/* A variable name from a channel's: letters, digits and _, beginning with a letter. */
static void make_valid(const char *name, char out[NAME_ROOM])
{
    size_t used = 0;
    const bool letter = (*name >= 'a' && *name <= 'z') || (*name >= 'A' && *name <= 'Z');
    if (!letter || is_keyword(name))
        out[used++] = 'x';
    for (; *name && used < NAME_ROOM - 1; name++) {
        const unsigned char c = (unsigned char)*name;
        const bool valid =
            (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
        if (valid || (c & 0xc0) != 0x80) /* one _ for all bytes of a letter */
            out[used++] = valid ? (char)c : '_';
    }
    out[used] = '\0';
}

static trk_status add_unique(trk_context *context, trk_names *names, const char *wanted)
{
    char base[NAME_ROOM], name[NAME_ROOM];
    make_valid(wanted, base);
    memcpy(name, base, sizeof name);
    for (int32_t copy = names->count - 2; trk_names_find(names, name); copy++)
        trk_format(name, sizeof name, "%.50s_%d", base, (int)copy);
    return trk_names_add(context, names, "variable", name);
}

/* Names of the variables: first those of our own, then one a channel. */
static trk_status make_names(trk_context *context, const trk_series *series, trk_names *names)
{
    static const char *const own[] = {"time", "channel_names", "channel_units"};
    trk_status status = TRK_OK;
    for (int k = 0; status == TRK_OK && k < 3; k++)
        status = trk_names_add(context, names, "variable", own[k]);
    for (int32_t c = 1; status == TRK_OK && c <= trk_series_channels(series); c++)
        status = add_unique(context, names, trk_series_name(series, c));
    return status;
}

static void put_file(trk_sink *sink, const trk_series *series, const trk_names *names)
{
    const int64_t samples = trk_series_samples(series);
    char head[128];
    memset(head, ' ', 116);
    static const char text[] = "MATLAB 5.0 MAT-file, written by libtruckride";
    memcpy(head, text, sizeof text - 1);
    memset(head + 116, 0, 8);        /* no subsystem data                      */
    memcpy(head + 124, "\0\1IM", 4); /* version 0x0100; IM: little-endian      */
    trk_sink_put(sink, head, sizeof head);
    put_vector_head(sink, "time", samples);
    for (int64_t k = 0; k < samples && sink->error == 0; k++)
        put_double(sink, trk_series_start(series) + (double)k / trk_series_rate(series));
    for (int32_t c = 1; c <= trk_series_channels(series); c++) {
        const double *x = trk_series_data(series, c);
        put_vector_head(sink, trk_names_text(names, c + 3), samples);
        for (int64_t k = 0; k < samples && sink->error == 0; k++)
            put_double(sink, x[k]);
    }
    put_labels(sink, "channel_names", series, trk_series_name);
    put_labels(sink, "channel_units", series, trk_series_unit);
}

trk_status trk_series_write_mat(trk_context *context, const trk_series *series, const char *path)
{
    TRK_REQUIRE(context, series, "trk_series_write_mat");
    TRK_REQUIRE(context, path, "trk_series_write_mat");
    if (!context)
        return TRK_E_ARGUMENT;
    const int64_t most = (INT32_MAX - 1024) / 8;
    if (trk_series_samples(series) > most)
        return trk_fail(context, TRK_E_RANGE,
                        "%s: %lld samples, a variable of the format has at most %lld", path,
                        (long long)trk_series_samples(series), (long long)most);
    trk_names names = {0};
    trk_sink sink;
    trk_status status = make_names(context, series, &names);
    if (status == TRK_OK)
        status = trk_sink_open(context, path, &sink);
    if (status == TRK_OK) {
        put_file(&sink, series, &names);
        status = trk_sink_close(&sink, TRK_OK);
    }
    trk_names_clear(context, &names);
    return status;
}
