/* SPDX-License-Identifier: MIT */
/* Lines and slices of a text. */
#include "files/text.h"

#include <string.h>

trk_text trk_text_of(trk_context *context, const char *name, const void *bytes, size_t size)
{
    static const char nothing[1] = "";
    const char *begin = size ? bytes : nothing;
    trk_text text = {context, name, begin, begin + size, begin, 0};
    return text;
}

bool trk_text_line(trk_text *text, trk_slice *out_line)
{
    if (text->at == text->end)
        return false;
    const char *feed = memchr(text->at, '\n', (size_t)(text->end - text->at));
    text->line_begin = text->at;
    text->line++;
    out_line->begin = text->at;
    out_line->end = feed ? feed : text->end;
    text->at = feed ? feed + 1 : text->end;
    if (out_line->end > out_line->begin && out_line->end[-1] == '\r')
        out_line->end--;
    return true;
}

const char *trk_excerpt(trk_slice slice, char out[TRK_EXCERPT])
{
    const size_t room = TRK_EXCERPT - 6, length = (size_t)(slice.end - slice.begin);
    size_t used = 0;
    out[used++] = '\'';
    for (size_t k = 0; k < length && k < room; k++)
        out[used++] = slice.begin[k] >= ' ' && slice.begin[k] <= '~' ? slice.begin[k] : '?';
    memcpy(out + used, length > room ? "...'" : "'", length > room ? 5 : 2);
    return out;
}

trk_status trk_text_fail(const trk_text *text, trk_slice at, const char *what, const char *expected)
{
    char excerpt[TRK_EXCERPT];
    return trk_fail(text->context, TRK_E_SYNTAX, "%s:%lld:%lld: %s%s%s", text->name,
                    (long long)text->line, (long long)(at.begin - text->line_begin) + 1, what,
                    expected ? trk_excerpt(at, excerpt) : "", expected ? expected : "");
}

trk_slice trk_trim(trk_slice slice)
{
    while (slice.begin < slice.end && (*slice.begin == ' ' || *slice.begin == '\t'))
        slice.begin++;
    while (slice.begin < slice.end && (slice.end[-1] == ' ' || slice.end[-1] == '\t'))
        slice.end--;
    return slice;
}

static char lower(char c)
{
    return c >= 'A' && c <= 'Z' ? (char)(c - 'A' + 'a') : c;
}

bool trk_slice_begins(trk_slice slice, const char *word)
{
    for (; *word; word++, slice.begin++)
        if (slice.begin == slice.end || lower(*slice.begin) != lower(*word))
            return false;
    return true;
}

bool trk_slice_is(trk_slice slice, const char *word)
{
    return (size_t)(slice.end - slice.begin) == strlen(word) && trk_slice_begins(slice, word);
}
