/* SPDX-License-Identifier: MIT */
/* ERD road profiles (FILES.2). */
#include "base/number.h"
#include "files/bytes.h"
#include "files/slurp.h"
#include "files/text.h"
#include "files/unit.h"

#include <math.h>
#include <string.h>
#include <truckride/files.h>

enum { KEY_INT16 = 0, KEY_FLOAT = 1, KEY_TEXT = 5, COLUMN = 8, MOST_CHANNELS = 4096 };

typedef struct erd {
    trk_text text;
    int64_t channels, samples, key; /* samples < 1: as many as there are */
    double step, start;
    trk_slice names, units, x_unit, gain, offset; /* behind their keywords */
} erd;

/* Next value of a comma list; TRK_E_SYNTAX with the place. */
static trk_status next_value(erd *e, trk_slice *list, const char *what, double *out_value)
{
    const char *comma = memchr(list->begin, ',', (size_t)(list->end - list->begin));
    const trk_slice value = trk_trim((trk_slice){list->begin, comma ? comma : list->end});
    list->begin = comma ? comma + 1 : list->end;
    if (trk_number_read(value.begin, value.end, '.', out_value) == value.end &&
        *out_value > -1e15 && *out_value < 1e15)
        return TRK_OK;
    char expected[80];
    trk_format(expected, sizeof expected, "%s: expected a number, not ", what);
    return trk_text_fail(&e->text, value, expected, "");
}

/* channels, samples, records, bytes of a record, key, step, key option */
static trk_status read_counts(erd *e)
{
    static const char *const what[] = {"number of channels", "number of samples",
                                       "number of records",  "bytes of a record",
                                       "data key",           "step"};
    trk_slice line;
    double value[6];
    if (!trk_text_line(&e->text, &line))
        return trk_fail(e->text.context, TRK_E_SYNTAX, "%s:2:1: the file ends, expected counts",
                        e->text.name);
    for (int k = 0; k < 6; k++) {
        trk_status status = next_value(e, &line, what[k], &value[k]);
        if (status)
            return status;
    }
    e->channels = (int64_t)value[0];
    e->samples = (int64_t)value[1];
    e->key = (int64_t)value[4];
    e->step = value[5];
    if (!(value[0] >= 1 && value[0] <= MOST_CHANNELS))
        return trk_fail(e->text.context, TRK_E_SYNTAX, "%s:2:1: %g channels, expected 1 to %d",
                        e->text.name, value[0], (int)MOST_CHANNELS);
    if (!(e->step > 0))
        return trk_fail(e->text.context, TRK_E_SYNTAX,
                        "%s:2:1: the step is %g, expected more than 0", e->text.name, e->step);
    if (e->key != KEY_TEXT && e->key != KEY_INT16 && e->key != KEY_FLOAT)
        return trk_fail(e->text.context, TRK_E_UNSUPPORTED,
                        "%s:2:1: the data key is %g, expected 0 (int16), 1 (float32) or 5 (text)",
                        e->text.name, value[4]);
    return TRK_OK;
}

static trk_status read_keywords(erd *e)
{
    trk_slice line;
    while (trk_text_line(&e->text, &line)) {
        if (trk_slice_is(trk_trim(line), "END"))
            return TRK_OK;
        const trk_slice rest = {line.end - line.begin > COLUMN ? line.begin + COLUMN : line.end,
                                line.end};
        if (trk_slice_begins(line, "SHORTNAM"))
            e->names = rest;
        else if (trk_slice_begins(line, "UNITSNAM"))
            e->units = rest;
        else if (trk_slice_begins(line, "XUNITS"))
            e->x_unit = trk_trim(rest);
        else if (trk_slice_begins(line, "GAIN    "))
            e->gain = rest;
        else if (trk_slice_begins(line, "OFFSET  "))
            e->offset = rest;
    }
    return trk_fail(e->text.context, TRK_E_SYNTAX, "%s:%lld:1: the file ends, expected a line END",
                    e->text.name, (long long)e->text.line + 1);
}

/* Entry of a channel from 0 in a list of columns of 8. */
static void copy_column(trk_slice list, int64_t channel, char *out)
{
    const int64_t length = list.end - list.begin, from = COLUMN * channel;
    trk_slice entry = {list.end, list.end};
    if (from < length) {
        entry.begin = list.begin + from;
        entry.end = from + COLUMN < length ? entry.begin + COLUMN : list.end;
    }
    trk_label_copy(trk_trim(entry), false, out, TRK_LABEL);
}

/* Value of a channel in a list of numbers, or that given. */
static double listed(trk_slice list, int64_t channel, double otherwise)
{
    double value = otherwise;
    for (int64_t k = 0; k <= channel; k++) {
        while (list.begin < list.end && strchr(" ,\t", *list.begin) && *list.begin)
            list.begin++;
        list.begin = trk_number_read(list.begin, list.end, '.', &value);
        if (!list.begin || !isfinite(value))
            return otherwise;
    }
    return value;
}

/* Next number of free-format text. NULL at the end; a message if there is something else. */
static trk_status next_number(erd *e, trk_slice *rest, double *out_value, bool *out_end)
{
    for (;;) {
        while (rest->begin < rest->end &&
               (*rest->begin == ' ' || *rest->begin == '\t' || *rest->begin == ','))
            rest->begin++;
        if (rest->begin < rest->end)
            break;
        *out_end = !trk_text_line(&e->text, rest);
        if (*out_end)
            return TRK_OK;
    }
    const char *end = rest->begin;
    while (end < rest->end && *end != ' ' && *end != '\t' && *end != ',')
        end++;
    const trk_slice word = {rest->begin, end};
    rest->begin = end;
    *out_end = trk_slice_is(word, "\032"); /* the end of a file to DOS */
    if (*out_end)
        return TRK_OK;
    if (trk_number_read(word.begin, end, '.', out_value) == end && isfinite(*out_value))
        return TRK_OK;
    return trk_text_fail(&e->text, word, "expected a number, not ", "");
}

static trk_status fail_short(const erd *e, int64_t got, const char *unit)
{
    return trk_fail(e->text.context, TRK_E_SYNTAX,
                    "%s: the data end after %lld %s, expected %lld samples of %lld channels",
                    e->text.name, (long long)got, unit, (long long)e->samples,
                    (long long)e->channels);
}

/* Values in the order of the file: sample by sample. */
static trk_status read_text(erd *e, double **values, int64_t *out_count)
{
    int64_t capacity = 0, count = 0;
    const int64_t wanted = e->samples > 0 && e->samples < INT64_MAX / MOST_CHANNELS
                               ? e->samples * e->channels
                               : INT64_MAX;
    trk_slice rest = {NULL, NULL};
    bool end = false;
    for (;;) {
        double value = 0;
        trk_status status = next_number(e, &rest, &value, &end);
        if (status == TRK_OK && !end && count == wanted)
            return trk_fail(
                e->text.context, TRK_E_SYNTAX,
                "%s:%lld:1: more numbers than %lld samples of %lld channels; is there a "
                "decimal comma?",
                e->text.name, (long long)e->text.line, (long long)e->samples,
                (long long)e->channels);
        if (status == TRK_OK && !end)
            status =
                trk_grow(e->text.context, (void **)values, &capacity, count + 1, sizeof **values);
        if (status)
            return status;
        if (end)
            break;
        (*values)[count++] = value;
    }
    if (count < wanted && (wanted < INT64_MAX || count % e->channels != 0))
        return fail_short(e, count, "numbers");
    *out_count = count;
    return TRK_OK;
}

static trk_status read_binary(erd *e, double **values, int64_t *out_count)
{
    const int size = e->key == KEY_INT16 ? 2 : 4;
    const int64_t bytes = e->text.end - e->text.at, there = bytes / size / e->channels;
    if (e->samples > there || there < 1)
        return fail_short(e, bytes, "bytes");
    e->samples = e->samples > 0 ? e->samples : there;
    *out_count = e->samples * e->channels;
    *values = trk_new(e->text.context, *out_count, sizeof **values);
    if (!*values)
        return TRK_E_MEMORY;
    for (int64_t k = 0; k < *out_count; k++) {
        const char *at = e->text.at + k * size;
        double *x = &(*values)[k];
        const int64_t channel = k % e->channels;
        *x = size == 2 ? trk_bytes_int16(at, false) : trk_bytes_float(at, false);
        if (!isfinite(*x))
            return trk_fail(e->text.context, TRK_E_SYNTAX,
                            "%s: sample %lld of channel %lld is not finite", e->text.name,
                            (long long)(k / e->channels), (long long)channel + 1);
    }
    return TRK_OK;
}

static trk_status fill(const erd *e, const double *values, trk_series *series)
{
    for (int32_t c = 1; c <= (int32_t)e->channels; c++) {
        char name[TRK_LABEL], unit[TRK_LABEL];
        const char *si;
        copy_column(e->names, c - 1, name);
        copy_column(e->units, c - 1, unit);
        double factor = trk_unit_factor(unit, &si), offset = 0;
        const bool length = factor != 0 && strcmp(si, "m") == 0;
        factor = length ? factor : 1;
        if (e->key == KEY_INT16) {
            offset = factor * listed(e->offset, c - 1, 0);
            factor *= listed(e->gain, c - 1, 1);
        }
        trk_status status = trk_label(series, c, name, length ? si : unit, c);
        if (status)
            return status;
        double *x = trk_series_data_mutable(series, c);
        for (int64_t k = 0; k < trk_series_samples(series); k++)
            x[k] = offset + factor * values[k * e->channels + c - 1];
    }
    return TRK_OK;
}

static trk_status to_series(erd *e, const double *values, int64_t count, trk_series **out_series)
{
    char unit[TRK_LABEL];
    const char *si;
    trk_label_copy(e->x_unit, false, unit, sizeof unit);
    const double factor = trk_unit_factor(unit, &si);
    const double rate = trk_round_rate(1 / (e->step * (factor == 0 ? 1 : factor)));
    if (count < e->channels)
        return fail_short(e, count, "numbers");
    trk_series *series;
    trk_status status = trk_series_create(e->text.context, (int32_t)e->channels,
                                          count / e->channels, rate, 0, &series);
    if (status)
        return trk_fail_within(e->text.context, status, "%s", e->text.name);
    status = fill(e, values, series);
    if (status) {
        trk_series_destroy(series);
        return status;
    }
    *out_series = series;
    return TRK_OK;
}

static trk_status parse(trk_context *context, const char *name, const void *bytes, size_t size,
                        trk_series **out_series)
{
    erd e = {.text = trk_text_of(context, name, bytes, size)};
    e.names = e.units = e.x_unit = e.gain = e.offset = (trk_slice){name, name};
    trk_slice line = {name, name};
    if (!trk_text_line(&e.text, &line) || !trk_slice_begins(line, "ERDFILEV"))
        return trk_fail(context, TRK_E_SYNTAX, "%s:1:1: no ERD file: expected ERDFILEV2.00", name);
    double *values = NULL;
    int64_t count = 0;
    trk_status status = read_counts(&e);
    if (status == TRK_OK)
        status = read_keywords(&e);
    if (status == TRK_OK)
        status =
            e.key == KEY_TEXT ? read_text(&e, &values, &count) : read_binary(&e, &values, &count);
    if (status == TRK_OK)
        status = to_series(&e, values, count, out_series);
    trk_free(context, values);
    return status;
}

trk_status trk_series_parse_erd(trk_context *context, const char *name, const void *bytes,
                                size_t size, trk_series **out_series)
{
    TRK_REQUIRE(context, out_series, "trk_series_parse_erd");
    *out_series = NULL;
    if (!context)
        return TRK_E_ARGUMENT;
    TRK_REQUIRE(context, name, "trk_series_parse_erd");
    TRK_REQUIRE(context, bytes || size == 0, "trk_series_parse_erd");
    return parse(context, name, bytes, size, out_series);
}

trk_status trk_series_read_erd(trk_context *context, const char *path, trk_series **out_series)
{
    TRK_REQUIRE(context, out_series, "trk_series_read_erd");
    *out_series = NULL;
    if (!context)
        return TRK_E_ARGUMENT;
    TRK_REQUIRE(context, path, "trk_series_read_erd");
    char *bytes;
    size_t size;
    trk_status status = trk_slurp(context, path, &bytes, &size);
    if (status == TRK_OK)
        status = parse(context, path, bytes, size, out_series);
    trk_free(context, bytes);
    return status;
}
