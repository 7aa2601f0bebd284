/* SPDX-License-Identifier: MIT */
/* Places in JSON text. */
#include "modelfile/scan.h"

#include <string.h>

trk_scan trk_scan_begin(const char *text, size_t length)
{
    return (trk_scan){text, text + length, text, 1};
}

trk_place trk_scan_place(const trk_scan *scan)
{
    return (trk_place){scan->line, (int32_t)(scan->at - scan->line_begin) + 1};
}

/* Go to a place further on. */
static void go(trk_scan *scan, const char *to)
{
    for (; scan->at < to; scan->at++)
        if (*scan->at == '\n') {
            scan->line++;
            scan->line_begin = scan->at + 1;
        }
}

void trk_scan_blanks(trk_scan *scan)
{
    const char *to = scan->at;
    while (to < scan->end && strchr(" \t\r\n,:", *to) && *to)
        to++;
    go(scan, to);
}

static bool in_word(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' ||
           c == '-' || c == '+';
}

void trk_scan_token(trk_scan *scan)
{
    const char *to = scan->at;
    if (to == scan->end)
        return;
    if (*to == '"') {
        for (to++; to < scan->end && *to != '"'; to++)
            if (*to == '\\' && to + 1 < scan->end)
                to++;
        to += to < scan->end;
    } else if (in_word(*to)) {
        while (to < scan->end && in_word(*to))
            to++;
    } else {
        to++;
    }
    go(scan, to);
}

const char *trk_scan_admit(const char *text, size_t length, int64_t *out_values,
                           trk_place *out_place)
{
    trk_scan scan = trk_scan_begin(text, length);
    int64_t depth = 0;
    *out_values = 1;
    *out_place = trk_scan_place(&scan);
    if (length > TRK_TREE_SIZE)
        return "the text has more than 64 MiB";
    if (length >= 3 && memcmp(text, "\357\273\277", 3) == 0)
        return "the text begins with a byte order mark; save it as UTF-8 without one";
    const char *zero = memchr(text, 0, length);
    if (zero) {
        go(&scan, zero);
        *out_place = trk_scan_place(&scan);
        return "there is a zero byte; JSON is text in UTF-8";
    }
    for (; scan.at < scan.end; trk_scan_token(&scan)) {
        *out_values += *scan.at == '[' || *scan.at == '{' || *scan.at == ',';
        depth += (*scan.at == '[' || *scan.at == '{') - (*scan.at == ']' || *scan.at == '}');
        *out_place = trk_scan_place(&scan);
        if (depth > TRK_TREE_DEPTH)
            return "brackets are nested more than 32 deep";
    }
    return NULL;
}

trk_place trk_scan_blame(const char *text, size_t length, size_t position, bool inside)
{
    trk_scan scan = trk_scan_begin(text, length), token = scan;
    const char *to = text + (position < length ? position : length);
    if (inside) {
        go(&scan, to);
        return trk_scan_place(&scan);
    }
    for (trk_scan_blanks(&scan); scan.at < to; trk_scan_blanks(&scan)) {
        token = scan;
        trk_scan_token(&scan);
    }
    return trk_scan_place(&token);
}
