/* SPDX-License-Identifier: MIT */
/* Labels out of files: any bytes become UTF-8, names become unique. */
#include "files/text.h"

#include <string.h>

/* Length of the UTF-8 sequence at p, 0 if it is none (RFC 3629). */
static int sequence(const unsigned char *p, const unsigned char *end)
{
    const int length = *p < 0x80 ? 1 : *p < 0xc2 ? 0 : *p < 0xe0 ? 2 : *p < 0xf0 ? 3 : 4;
    if (*p > 0xf4 || length == 0 || end - p < length)
        return 0;
    for (int k = 1; k < length; k++)
        if (p[k] < 0x80 || p[k] > 0xbf)
            return 0;
    const bool bad = (*p == 0xe0 && p[1] < 0xa0) || (*p == 0xed && p[1] > 0x9f) ||
                     (*p == 0xf0 && p[1] < 0x90) || (*p == 0xf4 && p[1] > 0x8f);
    return bad ? 0 : length;
}

bool trk_is_utf8(trk_slice slice)
{
    const unsigned char *p = (const unsigned char *)slice.begin,
                        *end = (const unsigned char *)slice.end;
    for (int length; p < end; p += length)
        if ((length = sequence(p, end)) == 0)
            return false;
    return true;
}

void trk_label_copy(trk_slice slice, bool quoted, char *out, size_t size)
{
    const unsigned char *p = (const unsigned char *)slice.begin,
                        *end = (const unsigned char *)slice.end;
    const bool utf8 = trk_is_utf8(slice);
    size_t used = 0;
    while (p < end) {
        const int length = utf8 ? sequence(p, end) : 1;
        const int bytes = utf8 || *p < 0x80 ? length : 2;
        if (used + (size_t)bytes >= size)
            break;
        if (*p < ' ' || *p == 0x7f) {
            out[used++] = ' ';
        } else if (length == bytes) {
            memcpy(out + used, p, (size_t)length);
            used += (size_t)length;
        } else {
            out[used++] = (char)(0xc0 | *p >> 6);
            out[used++] = (char)(0x80 | (*p & 0x3f));
        }
        p += quoted && *p == '"' && p + 1 < end && p[1] == '"' ? 2 : length;
    }
    out[used] = '\0';
}

/* A channel not labelled yet has its number for a name, which the file may give to another. */
static trk_status step_aside(trk_series *series, int32_t channel)
{
    char text[16];
    trk_format(text, sizeof text, "\001%d", (int)channel); /* trk_label_copy() never makes this */
    return trk_series_label(series, channel, text, "");
}

trk_status trk_label(trk_series *series, int32_t channel, const char *name, const char *unit,
                     int32_t number)
{
    char base[TRK_LABEL], text[TRK_LABEL + 16];
    if (*name)
        trk_format(base, sizeof base, "%s", name);
    else
        trk_format(base, sizeof base, "column %d", (int)number);
    trk_format(text, sizeof text, "%s", base);
    for (int32_t suffix = number;; suffix++) {
        const int32_t holder = trk_series_find(series, text);
        trk_status status = holder > channel ? step_aside(series, holder) : TRK_OK;
        if (status)
            return status;
        if (holder == 0 || holder >= channel)
            return trk_series_label(series, channel, text, unit);
        trk_format(text, sizeof text, "%s (%d)", base, (int)suffix);
    }
}
