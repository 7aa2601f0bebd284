/* SPDX-License-Identifier: MIT */
/* Fields of CSV, and which separator they have. */
#include "files/table.h"

#include <string.h>

static bool is_blank(char c)
{
    return c == ' ' || c == '\t';
}

/* Behind the line end at text->at. */
static void end_line(trk_text *text)
{
    if (text->at < text->end && *text->at == '\r')
        text->at++;
    if (text->at < text->end && *text->at == '\n')
        text->at++;
    text->line_begin = text->at;
    text->line++;
}

static bool at_end_of_line(const trk_text *text)
{
    return text->at == text->end || *text->at == '\n' ||
           (*text->at == '\r' && (text->at + 1 == text->end || text->at[1] == '\n'));
}

bool trk_field_line(trk_text *text)
{
    while (text->at < text->end) {
        trk_text ahead = *text;
        trk_slice line = {NULL, NULL};
        trk_text_line(&ahead, &line);
        line = trk_trim(line);
        if (line.begin < line.end && *line.begin != '#')
            return true;
        *text = ahead;
        text->line_begin = text->at;
    }
    return false;
}

static trk_status read_quoted(trk_text *text, trk_csv_field *field)
{
    const trk_slice quote = {text->at, text->at};
    const trk_text begin = *text;
    text->at++;
    field->text.begin = text->at;
    for (; text->at < text->end; text->at++) {
        if (*text->at == '\n') {
            text->line++;
            text->line_begin = text->at + 1;
        }
        if (*text->at != '"')
            continue;
        if (text->at + 1 == text->end || text->at[1] != '"') {
            field->text.end = text->at++;
            return TRK_OK;
        }
        text->at++;
    }
    return trk_text_fail(&begin, quote, "this quote is not closed", NULL);
}

trk_status trk_field_next(trk_text *text, char separator, trk_csv_field *out_field)
{
    *out_field = (trk_csv_field){{text->at, text->at}, false, false};
    while (text->at < text->end && *text->at != separator && is_blank(*text->at))
        text->at++;
    if (separator == ' ') /* runs of blanks and tabs, those in front of the first field too */
        while (text->at < text->end && is_blank(*text->at))
            text->at++;
    if (text->at < text->end && *text->at == '"') {
        out_field->quoted = true;
        trk_status status = read_quoted(text, out_field);
        if (status)
            return status;
    } else {
        out_field->text.begin = text->at;
        while (!at_end_of_line(text) && *text->at != separator &&
               !(separator == ' ' && is_blank(*text->at)))
            text->at++;
        out_field->text.end = text->at;
        out_field->text = trk_trim(out_field->text);
    }
    while (text->at < text->end && *text->at != separator && is_blank(*text->at))
        text->at++;
    if (separator == ' ')
        while (text->at < text->end && is_blank(*text->at))
            text->at++;
    if (at_end_of_line(text)) {
        out_field->last = true;
        end_line(text);
        return TRK_OK;
    }
    if (separator == ' ')
        return TRK_OK;
    if (*text->at != separator) {
        const trk_slice here = {text->at, text->end};
        return trk_text_fail(text, here, "expected a separator behind the quoted field, not ", "");
    }
    text->at++;
    return TRK_OK;
}

/* Fields of the next line, 0 at the end or in a line that cannot be read. */
static int64_t count_fields(trk_text *text, char separator)
{
    trk_csv_field field = {{NULL, NULL}, false, false};
    int64_t count = 0;
    if (!trk_field_line(text))
        return 0;
    for (; !field.last; count++)
        if (trk_field_next(text, separator, &field))
            return 0;
    return count;
}

char trk_table_sniff(trk_text text)
{
    static const char candidates[] = "\t;, ";
    text.context = NULL; /* a wrong guess leaves no message */
    for (const char *c = candidates; *c; c++) {
        trk_text ahead = text;
        const int64_t first = count_fields(&ahead, *c), second = count_fields(&ahead, *c);
        if (first > 1 && (second == first || second == 0))
            return *c;
    }
    /* No two lines agree: what splits the first one, so that the message is about the second. */
    for (const char *c = candidates; *c; c++) {
        trk_text ahead = text;
        if (count_fields(&ahead, *c) > 1)
            return *c;
    }
    return ',';
}
