/* SPDX-License-Identifier: MIT */
/* Fields, numbers and names of a command line. */
#include "common/text.h"

#include <errno.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

bool say(complaint *about, const char *format, ...)
{
    va_list values;
    va_start(values, format);
    vsnprintf(about->text, sizeof about->text, format, values);
    va_end(values);
    return false;
}

char *text_field(char **rest, char separator)
{
    char *field = *rest;
    if (!field)
        return NULL;
    char *end = strchr(field, separator);
    if (end)
        *end++ = 0;
    *rest = end;
    return field;
}

bool text_number(const char *text, double *out)
{
    char *end;
    *out = text ? strtod(text, &end) : 0;
    return text && end != text && !*end && isfinite(*out);
}

bool text_whole(const char *text, int64_t *out)
{
    char *end;
    errno = 0;
    *out = text ? strtoll(text, &end, 10) : 0;
    return text && end != text && !*end && !errno;
}

bool text_band(char *text, double *low, double *high)
{
    char *dots = text ? strstr(text, "..") : NULL;
    if (!dots)
        return false;
    *dots = 0;
    return text_number(text, low) && text_number(dots + 2, high);
}

int text_index(const char *const *list, const char *name)
{
    for (int k = 0; list[k]; k++)
        if (strcmp(list[k], name) == 0)
            return k;
    return -1;
}

/* Levenshtein distance, of names of less than 64 characters. */
static int distance(const char *a, const char *b)
{
    int row[64];
    const int length = (int)strlen(b);
    if (length > 63 || strlen(a) > 63)
        return 64;
    for (int k = 0; k <= length; k++)
        row[k] = k;
    for (int i = 1; *a; a++, i++) {
        int corner = row[0];
        row[0] = i;
        for (int k = 1; k <= length; k++) {
            const int change = corner + (*a != b[k - 1]);
            const int shift = 1 + (row[k] < row[k - 1] ? row[k] : row[k - 1]);
            corner = row[k];
            row[k] = change < shift ? change : shift;
        }
    }
    return row[length];
}

const char *text_nearest(const char *const *list, const char *name)
{
    const char *nearest = NULL;
    const int length = (int)strlen(name);
    int least = length > 8 ? 4 : length > 3 ? 3 : 2;
    for (; *list; list++) {
        const bool begun = length >= 2 && strncmp(*list, name, (size_t)length) == 0;
        const int d = begun ? 0 : distance(name, *list);
        if (d < least) {
            least = d;
            nearest = *list;
        }
    }
    return nearest;
}

bool text_match(const char *pattern, const char *name)
{
    const char *star = NULL, *retry = NULL;
    while (*name) {
        if (*pattern == '*') {
            star = pattern++;
            retry = name;
        } else if (*pattern == *name) {
            pattern++;
            name++;
        } else if (star) {
            pattern = star + 1;
            name = ++retry;
        } else {
            return false;
        }
    }
    while (*pattern == '*')
        pattern++;
    return !*pattern;
}

bool text_match_any(const char *patterns, const char *name)
{
    char *copy = text_copy(patterns), *rest = copy, *pattern;
    bool found = false;
    while (!found && (pattern = text_field(&rest, ',')))
        found = text_match(pattern, name);
    free(copy);
    return found;
}

const char *text_suffix(const char *path)
{
    const char *slash = strrchr(path, '/'), *dot = strrchr(path, '.');
    return dot && (!slash || dot > slash) ? dot : "";
}

void *need(size_t count, size_t size)
{
    void *block = calloc(count > 0 ? count : 1, size);
    if (!block) {
        fputs("out of memory\n", stderr);
        exit(1);
    }
    return block;
}

void text_print(FILE *file, const char *text)
{
    for (; *text; text++)
        fputc((unsigned char)*text < ' ' || *text == 127 ? '?' : *text, file);
}

char *text_copy(const char *text)
{
    char *copy = need(strlen(text) + 1, 1);
    return strcpy(copy, text);
}
