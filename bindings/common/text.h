/* SPDX-License-Identifier: MIT */
/* Words of a command line, taken apart: fields, numbers, names, and complaints about them. */
#ifndef TRUCKRIDE_COMMON_TEXT_H
#define TRUCKRIDE_COMMON_TEXT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

/* What is wrong with a word; "" if nothing is. */
typedef struct complaint {
    char text[512];
} complaint;

/* Say what is wrong; returns false, for "return say(...)". */
#if defined(__GNUC__)
__attribute__((format(printf, 2, 3)))
#endif
bool say(complaint *about, const char *format, ...);

/* The next field of "a:b:c", cut out of the text; NULL at the end. */
char *text_field(char **rest, char separator);

/* A finite number; a whole one; a band "0.8..1.2". True if the whole text is one. */
bool text_number(const char *text, double *out);
bool text_whole(const char *text, int64_t *out);
bool text_band(char *text, double *low, double *high);

/* Place of a name in a list that ends with NULL; -1 if it is not there. */
int text_index(const char *const *list, const char *name);

/* The name of the list that was probably meant; NULL if none is like it. */
const char *text_nearest(const char *const *list, const char *name);

/* True if the name matches; '*' in the pattern stands for any text. */
bool text_match(const char *pattern, const char *name);

/* True if any pattern of "a,b_*,c" matches. */
bool text_match_any(const char *patterns, const char *name);

/* ".csv" of "runs.d/truck.csv"; "" if there is none. */
const char *text_suffix(const char *path);

/* Print a text from a file of others: its control characters, which a terminal would obey, as '?'. */
void text_print(FILE *file, const char *text);

/* Copy; ends the program if there is no memory. */
char *text_copy(const char *text);

/* Zeroed memory; ends the program if there is none. */
void *need(size_t count, size_t size);

#endif
