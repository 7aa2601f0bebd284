/* SPDX-License-Identifier: MIT */
/* The word that somebody meant. */
#ifndef TRK_MODELFILE_SUGGEST_H
#define TRK_MODELFILE_SUGGEST_H

#include <stddef.h>

/* The nearest candidate so far: begin with zeros, offer all, take `best` (NULL: none is near). */
typedef struct trk_suggestion {
    const char *best;
    size_t distance;
} trk_suggestion;

void trk_suggest(trk_suggestion *suggestion, const char *word, const char *candidate);

/* "; did you mean 'x'?", or nothing. */
enum { TRK_SUGGESTION_ROOM = 96 };
const char *trk_suggestion_tail(const trk_suggestion *suggestion, char out[TRK_SUGGESTION_ROOM]);

#endif
