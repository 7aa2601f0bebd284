/* SPDX-License-Identifier: MIT */
/* Files being written. */
#define _POSIX_C_SOURCE 200809L
#include "files/sink.h"

#include <errno.h>
#include <string.h>
#include <sys/stat.h>

enum { BUFFER_SIZE = 1 << 16 };

static trk_status fail(trk_context *context, const char *path, int error)
{
    char reason[256] = "";
    trk_locale locale;
    trk_locale_enter(&locale);
    strerror_r(error, reason, sizeof reason);
    trk_locale_leave(&locale);
    return trk_fail(context, TRK_E_FILE, "%s: cannot be written (%s)", path, reason);
}

trk_status trk_sink_open(trk_context *context, const char *path, trk_sink *out_sink)
{
    *out_sink = (trk_sink){context, path, NULL, NULL, 0, 0};
    out_sink->buffer = trk_new(context, BUFFER_SIZE, 1);
    if (!out_sink->buffer)
        return TRK_E_MEMORY;
    out_sink->file = fopen(path, "wb");
    if (!out_sink->file) {
        const int error = errno;
        trk_free(context, out_sink->buffer);
        return fail(context, path, error);
    }
    setvbuf(out_sink->file, NULL, _IONBF, 0);
    return TRK_OK;
}

static void flush(trk_sink *sink)
{
    errno = 0;
    if (sink->error == 0 && fwrite(sink->buffer, 1, sink->used, sink->file) != sink->used)
        sink->error = errno ? errno : EIO;
    sink->used = 0;
}

void trk_sink_put(trk_sink *sink, const void *bytes, size_t size)
{
    const char *from = bytes;
    while (size > 0) {
        if (sink->used == BUFFER_SIZE)
            flush(sink);
        const size_t room = BUFFER_SIZE - sink->used, part = size < room ? size : room;
        memcpy(sink->buffer + sink->used, from, part);
        sink->used += part;
        from += part;
        size -= part;
    }
}

trk_status trk_sink_close(trk_sink *sink, trk_status status)
{
    struct stat about;
    flush(sink);
    /* A device or a pipe stays where it is. */
    const bool regular = fstat(fileno(sink->file), &about) == 0 && S_ISREG(about.st_mode);
    if (fclose(sink->file) != 0 && sink->error == 0)
        sink->error = errno;
    trk_free(sink->context, sink->buffer);
    if ((sink->error || status) && regular)
        remove(sink->path);
    return status || !sink->error ? status : fail(sink->context, sink->path, sink->error);
}
