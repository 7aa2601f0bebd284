/* SPDX-License-Identifier: MIT */
/* A walk through JSON text that keeps line and column. */
#ifndef TRK_MODELFILE_SCAN_H
#define TRK_MODELFILE_SCAN_H

#include "modelfile/tree.h"

typedef struct trk_scan {
    const char *at, *end;
    const char *line_begin;
    int32_t line;
} trk_scan;

trk_scan trk_scan_begin(const char *text, size_t length);
trk_place trk_scan_place(const trk_scan *scan);

/* Behind blanks, commas and colons. */
void trk_scan_blanks(trk_scan *scan);

/* Behind the token that begins here: a quoted text, a bracket or another sign, a word or number. */
void trk_scan_token(trk_scan *scan);

/*
 * Whether a text may go to the parser: no byte order mark, no zero bytes, not deeper than TRK_TREE_DEPTH.
 * *out_values is not less than the number of values it holds. NULL if it may, else what is wrong at *out_place.
 */
const char *trk_scan_admit(const char *text, size_t length, int64_t *out_values,
                           trk_place *out_place);

/* Place of what a parser complains about, having read `position` bytes: where that token begins, or
 * inside of it. */
trk_place trk_scan_blame(const char *text, size_t length, size_t position, bool inside);

#endif
