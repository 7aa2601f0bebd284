/* SPDX-License-Identifier: MIT */
/* JSON text being written: to memory, to a file, or only counted. */
#ifndef TRK_MODELFILE_EMIT_H
#define TRK_MODELFILE_EMIT_H

#include "files/sink.h"

typedef struct trk_emit {
    char *text; /* NULL: none      */
    size_t capacity;
    trk_sink *sink;  /* NULL: none      */
    size_t length;   /* [byte] so far   */
    size_t line;     /* [byte] of the line so far */
    int32_t depth;   /* of open brackets */
    bool first;      /* in its bracket   */
    const char *bad; /* the first text that is no UTF-8, which JSON cannot say; NULL: none */
} trk_emit;

/* Values; key is NULL in a list. Brackets down to the second level have lines of their own. */
void trk_emit_open(trk_emit *emit, const char *key, char bracket);
void trk_emit_close(trk_emit *emit, char bracket);
void trk_emit_text(trk_emit *emit, const char *key, const char *text);
/* Shortest decimal that reads back as the same double; the caller has entered the C locale. */
void trk_emit_number(trk_emit *emit, const char *key, double number);
void trk_emit_truth(trk_emit *emit, const char *key, bool truth);
void trk_emit_end(trk_emit *emit);

#endif
