/* SPDX-License-Identifier: MIT */
/* A file being written: buffered bytes, the first error kept, taken back when incomplete. */
#ifndef TRK_FILES_SINK_H
#define TRK_FILES_SINK_H

#include <stdio.h>

#include "base/base.h"

typedef struct trk_sink {
    trk_context *context;
    const char *path;
    FILE *file;
    char *buffer;
    size_t used;
    int error; /* errno of the first failure, 0 if none */
} trk_sink;

/* TRK_E_FILE, TRK_E_MEMORY: nothing is open then. */
trk_status trk_sink_open(trk_context *context, const char *path, trk_sink *out_sink);

/* Put size bytes; what fails is reported by trk_sink_close(). */
void trk_sink_put(trk_sink *sink, const void *bytes, size_t size);

/* Close; `status` is how the work went. Removes the file unless both went well. */
trk_status trk_sink_close(trk_sink *sink, trk_status status);

#endif
