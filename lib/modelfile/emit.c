/* SPDX-License-Identifier: MIT */
/* Brackets, keys and numbers of JSON. */
#include "modelfile/emit.h"

#include <stdio.h>
#include <string.h>

#include "base/number.h"
#include "files/text.h"

enum { LINES = 2, WIDTH = 90, INDENT = 2 }; /* LINES: depth down to which each value has a line */

static void put(trk_emit *emit, const char *bytes, size_t size)
{
    for (size_t k = 0; emit->text && k < size; k++)
        if (emit->length + k + 1 < emit->capacity)
            emit->text[emit->length + k] = bytes[k];
    if (emit->sink)
        trk_sink_put(emit->sink, bytes, size);
    emit->length += size;
    emit->line += size;
}

static void put_text(trk_emit *emit, const char *text)
{
    put(emit, text, strlen(text));
}

static void break_line(trk_emit *emit, int32_t depth)
{
    put_text(emit, "\n");
    emit->line = 0;
    for (int32_t k = 0; k < INDENT * depth; k++)
        put_text(emit, " ");
}

static void put_quoted(trk_emit *emit, const char *text)
{
    if (!trk_is_utf8((trk_slice){text, text + strlen(text)})) {
        emit->bad = emit->bad ? emit->bad : text;
        return;
    }
    put_text(emit, "\"");
    for (; *text; text++) {
        char code[8];
        if (*text == '"' || *text == '\\')
            put_text(emit, "\\");
        if ((unsigned char)*text >= ' ') {
            put(emit, text, 1);
        } else {
            snprintf(code, sizeof code, "\\u%04x", (unsigned)*text);
            put_text(emit, code);
        }
    }
    put_text(emit, "\"");
}

/* What stands in front of a value; long lines are broken before keys and brackets. */
static void begin(trk_emit *emit, const char *key, bool bracket)
{
    const bool lines = emit->depth <= LINES;
    const bool full = !emit->first && (key || bracket) && emit->line > WIDTH;
    if (!emit->first)
        put_text(emit, ",");
    if (emit->depth > 0 && (lines || full))
        break_line(emit, lines ? emit->depth : LINES + 1);
    else if (!emit->first)
        put_text(emit, " ");
    emit->first = false;
    if (key) {
        put_quoted(emit, key);
        put_text(emit, ": ");
    }
}

void trk_emit_open(trk_emit *emit, const char *key, char bracket)
{
    begin(emit, key, true);
    put(emit, &bracket, 1);
    emit->depth++;
    emit->first = true;
}

void trk_emit_close(trk_emit *emit, char bracket)
{
    emit->depth--;
    if (emit->depth < LINES && !emit->first)
        break_line(emit, emit->depth);
    put(emit, &bracket, 1);
    emit->first = false;
}

void trk_emit_text(trk_emit *emit, const char *key, const char *text)
{
    begin(emit, key, false);
    put_quoted(emit, text);
}

void trk_emit_truth(trk_emit *emit, const char *key, bool truth)
{
    begin(emit, key, false);
    put_text(emit, truth ? "true" : "false");
}

/* What has at most 15 digits comes back as it was written; no double needs more than 17. */
void trk_emit_number(trk_emit *emit, const char *key, double number)
{
    char digits[32];
    begin(emit, key, false);
    for (int precision = 15; precision <= 17; precision++) {
        double back = 0;
        const int length = snprintf(digits, sizeof digits, "%.*g", precision, number);
        trk_number_read(digits, digits + length, '.', &back);
        if (memcmp(&back, &number, sizeof back) == 0)
            break;
    }
    put_text(emit, digits);
}

void trk_emit_end(trk_emit *emit)
{
    put_text(emit, "\n");
    if (emit->text && emit->capacity > 0)
        emit->text[emit->length < emit->capacity ? emit->length : emit->capacity - 1] = '\0';
}
