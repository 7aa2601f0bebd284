/* SPDX-License-Identifier: MIT */
/* Readers of recordings by kind. */
#include "common/recording.h"
#include "common/text.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void *read_standard_input(size_t *out_size)
{
    char *bytes = NULL;
    size_t room = 0;
    *out_size = 0;
    do {
        room = room ? 2 * room : 1 << 16;
        char *larger = realloc(bytes, room);
        if (!larger) {
            free(bytes);
            return NULL;
        }
        bytes = larger;
        *out_size += fread(bytes + *out_size, 1, room - *out_size, stdin);
    } while (*out_size == room);
    if (!ferror(stdin))
        return bytes;
    free(bytes);
    return NULL;
}

/* The kind that a suffix tells. */
static const char *kind_of(const char *path)
{
    static const char *const suffixes[][2] = {
        {".erd", "erd"}, {".rpc", "rpc"}, {".rsp", "rpc"}, {".drv", "rpc"}, {".tim", "rpc"}};
    for (size_t k = 0; k < sizeof suffixes / sizeof *suffixes; k++)
        if (strcmp(suffixes[k][0], text_suffix(path)) == 0)
            return suffixes[k][1];
    return "csv";
}

static trk_status parse(trk_context *context, const char *kind, trk_series **out_series)
{
    static const char name[] = "<stdin>";
    size_t size = 0;
    void *bytes = read_standard_input(&size);
    if (!bytes)
        return TRK_E_FILE;
    trk_status status = strcmp(kind, "erd") == 0
                            ? trk_series_parse_erd(context, name, bytes, size, out_series)
                        : strcmp(kind, "rpc") == 0
                            ? trk_series_parse_rpc(context, name, bytes, size, out_series)
                            : trk_series_parse_csv(context, name, bytes, size, NULL, out_series);
    free(bytes);
    return status;
}

trk_status recording_read(trk_context *context, const char *path, const char *kind,
                          trk_series **out_series)
{
    *out_series = NULL;
    kind = kind ? kind : kind_of(path);
    trk_status status = strcmp(path, "-") == 0     ? parse(context, kind, out_series)
                        : strcmp(kind, "erd") == 0 ? trk_series_read_erd(context, path, out_series)
                        : strcmp(kind, "rpc") == 0
                            ? trk_series_read_rpc(context, path, out_series)
                            : trk_series_read_csv(context, path, NULL, out_series);
    if (status == TRK_OK)
        status = trk_series_to_si(*out_series);
    if (status != TRK_OK) {
        trk_series_destroy(*out_series);
        *out_series = NULL;
    }
    return status;
}
