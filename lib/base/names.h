/* SPDX-License-Identifier: MIT */
/* Ordered list of unique names with ids 1, 2, ...: the parts of a spec or of a model. */
#ifndef TRK_BASE_NAMES_H
#define TRK_BASE_NAMES_H

#include "base/base.h"

typedef struct trk_names {
    char **text; /* text[id - 1]                                        */
    int32_t count;
    int64_t capacity; /* of text                                             */
    int32_t *bucket;  /* open addressing: id, or 0 for an empty place         */
    int32_t buckets;  /* a power of two, more than twice count; 0 when empty */
} trk_names;

/* Append a name; `what` is the kind of part in messages. TRK_E_NAME: empty or taken. */
trk_status trk_names_add(trk_context *context, trk_names *names, const char *what,
                         const char *name);

/* Take away the last names, so that `count` are left. */
void trk_names_shorten(trk_context *context, trk_names *names, int32_t count);

/* Id of a name, 0 if absent; text of an id, NULL if absent. */
int32_t trk_names_find(const trk_names *names, const char *name);
const char *trk_names_text(const trk_names *names, int32_t id);

/* Fill an empty list with the names of another; on failure it is left empty. */
trk_status trk_names_copy(trk_context *context, const trk_names *from, trk_names *to);
void trk_names_clear(trk_context *context, trk_names *names);

#endif
