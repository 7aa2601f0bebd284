/* SPDX-License-Identifier: MIT */
/* Edit distance with exchanges of neighbours (optimal string alignment). */
#include "modelfile/suggest.h"

#include <stdint.h>
#include <string.h>

#include "base/base.h"

enum { LONGEST = 63 };

static size_t least(size_t a, size_t b)
{
    return a < b ? a : b;
}

static size_t distance(const char *a, size_t rows, const char *b, size_t columns)
{
    size_t line[3][LONGEST + 1], *older = line[0], *old = line[1], *now = line[2];
    for (size_t j = 0; j <= columns; j++)
        old[j] = j;
    for (size_t i = 1; i <= rows; i++) {
        now[0] = i;
        for (size_t j = 1; j <= columns; j++) {
            now[j] = least(old[j - 1] + (a[i - 1] != b[j - 1]), least(old[j], now[j - 1]) + 1);
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                now[j] = least(now[j], older[j - 2] + 1);
        }
        size_t *free_line = older;
        older = old;
        old = now;
        now = free_line;
    }
    return old[columns];
}

void trk_suggest(trk_suggestion *suggestion, const char *word, const char *candidate)
{
    const size_t rows = strlen(word), columns = strlen(candidate);
    if (rows > LONGEST || columns > LONGEST)
        return;
    const size_t d = distance(word, rows, candidate, columns);
    if (d <= (rows > columns ? rows : columns) / 3 &&
        (!suggestion->best || d < suggestion->distance)) {
        suggestion->best = candidate;
        suggestion->distance = d;
    }
}

const char *trk_suggestion_tail(const trk_suggestion *suggestion, char out[TRK_SUGGESTION_ROOM])
{
    out[0] = '\0';
    if (suggestion->best)
        trk_format(out, TRK_SUGGESTION_ROOM, "; did you mean '%s'?", suggestion->best);
    return out;
}
