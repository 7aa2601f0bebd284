/* SPDX-License-Identifier: MIT */
/* Text in memory with its place: slices, lines, excerpts for messages, labels in UTF-8. */
#ifndef TRK_FILES_TEXT_H
#define TRK_FILES_TEXT_H

#include "base/base.h"
#include <truckride/series.h>

/* Part of a text; not terminated. */
typedef struct trk_slice {
    const char *begin, *end;
} trk_slice;

/* Lines of a text, each ended by LF, CR LF or the end of the text. */
typedef struct trk_text {
    trk_context *context;
    const char *name;       /* for messages             */
    const char *at, *end;   /* of what is not read yet  */
    const char *line_begin; /* of the line read last    */
    int64_t line;           /* its number from 1        */
} trk_text;

trk_text trk_text_of(trk_context *context, const char *name, const void *bytes, size_t size);

/* Next line without its end; false when there is none. */
bool trk_text_line(trk_text *text, trk_slice *out_line);

enum { TRK_EXCERPT = 40 };
/* The beginning of a slice as printable ASCII in quotes, and "..." if it is longer. */
const char *trk_excerpt(trk_slice slice, char out[TRK_EXCERPT]);

/* "name:line:column: what 'excerpt'"; column from the place of the slice in the line. */
trk_status trk_text_fail(const trk_text *text, trk_slice at, const char *what,
                         const char *expected);

/* Without blanks and tabs at both ends. */
trk_slice trk_trim(trk_slice slice);

/* Equal but for the case of ASCII letters. */
bool trk_slice_is(trk_slice slice, const char *word);
bool trk_slice_begins(trk_slice slice, const char *word);

/* Whether the bytes are UTF-8 (RFC 3629). */
bool trk_is_utf8(trk_slice slice);

/*
 * Copy as a label of at most size - 1 bytes: UTF-8 as it is if the slice is, else ISO 8859-1
 * converted; doubled quotes made single if it was quoted; control characters become blanks.
 */
void trk_label_copy(trk_slice slice, bool quoted, char *out, size_t size);

enum { TRK_LABEL = 256 }; /* bytes of a name or unit with its end */

/*
 * trk_series_label(), channels to be labelled in order. A name that is taken gets " (number)"
 * behind it, an empty one becomes "column number"; number is that of the column in the file.
 */
trk_status trk_label(trk_series *series, int32_t channel, const char *name, const char *unit,
                     int32_t number);

#endif
