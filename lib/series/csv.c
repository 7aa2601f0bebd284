/* SPDX-License-Identifier: MIT */
/* CSV (RFC 4180, lines ended by a line feed). */
#define _POSIX_C_SOURCE 200809L
#include "series/series.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

enum { BUFFER_SIZE = 1 << 16, LONGEST_NUMBER = 32 };

typedef struct writer {
    FILE *file;
    char *buffer; /* BUFFER_SIZE bytes */
    size_t used;
    int error; /* errno of the first failure, 0 if none */
} writer;

static void flush(writer *w)
{
    errno = 0;
    if (w->error == 0 && fwrite(w->buffer, 1, w->used, w->file) != w->used)
        w->error = errno ? errno : EIO;
    w->used = 0;
}

static void put(writer *w, char c)
{
    if (w->used == BUFFER_SIZE)
        flush(w);
    w->buffer[w->used++] = c;
}

static void put_number(writer *w, double number)
{
    if (w->used > BUFFER_SIZE - LONGEST_NUMBER)
        flush(w);
    w->used += (size_t)snprintf(w->buffer + w->used, LONGEST_NUMBER, "%.9g", number);
}

/* Text of a field, its quotes doubled. */
static void put_text(writer *w, const char *text)
{
    for (; *text; text++) {
        if (*text == '"')
            put(w, '"');
        put(w, *text);
    }
}

/* name [unit], quoted where a reader would take it apart otherwise */
static void put_label(writer *w, const char *name, const char *unit)
{
    const char *special = ",\"\r\n";
    bool quoted = strpbrk(name, special) || strpbrk(unit, special);
    if (quoted)
        put(w, '"');
    put_text(w, name);
    if (*unit) {
        put_text(w, " [");
        put_text(w, unit);
        put(w, ']');
    }
    if (quoted)
        put(w, '"');
}

static void write_all(writer *w, const trk_series *series, int64_t every)
{
    put_label(w, "time", "s");
    for (int32_t c = 0; c < series->channels; c++) {
        put(w, ',');
        put_label(w, series->channel[c].name, series->channel[c].unit);
    }
    put(w, '\n');
    for (int64_t k = 0; k < series->samples && w->error == 0;) {
        put_number(w, series->start + (double)k / series->sample_rate);
        for (int32_t c = 0; c < series->channels; c++) {
            put(w, ',');
            put_number(w, series->channel[c].data[k]);
        }
        put(w, '\n');
        k = every < series->samples - k ? k + every : series->samples;
    }
    flush(w);
}

/* Close, and take back an incomplete file; a device or a pipe stays where it is. */
static void finish(writer *w, const char *path)
{
    struct stat about;
    bool regular = fstat(fileno(w->file), &about) == 0 && S_ISREG(about.st_mode);
    if (fclose(w->file) != 0 && w->error == 0)
        w->error = errno;
    if (w->error != 0 && regular)
        remove(path);
}

trk_status trk_series_write_csv(trk_context *context, const trk_series *series, const char *path,
                                int64_t every)
{
    TRK_REQUIRE(context, series, "trk_series_write_csv");
    TRK_REQUIRE(context, path, "trk_series_write_csv");
    if (!context)
        return TRK_E_ARGUMENT;
    if (every < 1)
        return trk_fail(context, TRK_E_RANGE, "%s: every is %lld, expected at least 1", path,
                        (long long)every);
    writer w = {NULL, trk_new(context, BUFFER_SIZE, 1), 0, 0};
    if (!w.buffer)
        return TRK_E_MEMORY;
    trk_locale locale; /* for the numbers, and for the system's reason below */
    trk_locale_enter(&locale);
    w.file = fopen(path, "wb");
    if (w.file) {
        setvbuf(w.file, NULL, _IONBF, 0);
        write_all(&w, series, every);
        finish(&w, path);
    } else {
        w.error = errno;
    }
    trk_status status = TRK_OK;
    if (w.error) {
        char reason[256] = "";
        strerror_r(w.error, reason, sizeof reason);
        status = trk_fail(context, TRK_E_FILE, "%s: cannot be written (%s)", path, reason);
    }
    trk_locale_leave(&locale);
    trk_free(context, w.buffer);
    return status;
}
