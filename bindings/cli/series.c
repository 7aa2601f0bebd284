/* SPDX-License-Identifier: MIT */
/* Channels as CSV, JSON, MAT and RPC III. */
#include "series.h"
#include "common/stream.h"
#include "common/text.h"
#include "output.h"

#include <errno.h>
#include <string.h>

static int32_t format_of(const char *path)
{
    static const char *const suffixes[] = {".csv", ".json", ".mat", ".rpc", NULL};
    const int place = path ? text_index(suffixes, text_suffix(path)) : 0;
    return place < 0 ? SERIES_CSV : SERIES_CSV + place;
}

/* An output_writer whose user is the series. */
static void put_json(FILE *file, const void *user)
{
    const trk_series *series = user;
    fputs("{\n  \"start\": ", file);
    exact_number(file, trk_series_start(series), "null");
    fputs(",\n  \"rate\": ", file);
    exact_number(file, trk_series_rate(series), "null");
    fputs(",\n  \"channels\": [", file);
    for (int32_t c = 1; c <= trk_series_channels(series); c++) {
        const double *data = trk_series_data(series, c);
        fputs(c > 1 ? ",\n    {\"name\": " : "\n    {\"name\": ", file);
        json_text(file, trk_series_name(series, c));
        fputs(", \"unit\": ", file);
        json_text(file, trk_series_unit(series, c));
        fputs(", \"data\": [", file);
        for (int64_t k = 0; k < trk_series_samples(series); k++) {
            fputs(k ? "," : "", file);
            exact_number(file, data[k], "null");
        }
        fputs("]}", file);
    }
    fputs("\n  ]\n}\n", file);
}

static trk_status write_file(session *s, const trk_series *series, int32_t format, const char *path)
{
    switch (format) {
    case SERIES_MAT: return trk_series_write_mat(s->context, series, path);
    case SERIES_RPC: return trk_series_write_rpc(s->context, series, path, NULL);
    default: return trk_series_write_csv(s->context, series, path, 1);
    }
}

/* The library writes to a path. */
static int write_stdout(session *s, const trk_series *series, int32_t format)
{
    char path[4096];
    if (!stream_temporary(path, sizeof path))
        return session_error(s, "a temporary file cannot be made (%s)", strerror(errno));
    const trk_status status = write_file(s, series, format, path);
    if (status != TRK_OK) {
        remove(path);
        return session_fail(s, status);
    }
    if (!stream_to_stdout(path))
        return session_error(s, "standard output cannot be written (%s)", strerror(errno));
    return EXIT_DONE;
}

int series_write(session *s, const trk_series *series, int32_t format)
{
    const char *path = s->shared->out;
    if (format == SERIES_AUTO)
        format = format_of(path);
    if (format == SERIES_JSON)
        return output_write(s, path, put_json, series);
    if (!path || strcmp(path, "-") == 0)
        return write_stdout(s, series, format);
    const trk_status status = write_file(s, series, format, path);
    return status == TRK_OK ? EXIT_DONE : session_fail(s, status);
}
