/* SPDX-License-Identifier: MIT */
/* Tables of results: columns with units, for people (aligned), CSV and JSON. */
#ifndef TRUCKRIDE_CLI_TABLE_H
#define TRUCKRIDE_CLI_TABLE_H

#include "session.h"

#include <stddef.h>

/* In place of decimals: six significant digits; text. */
enum { TABLE_GENERAL = -1, TABLE_TEXT = -2 };

typedef struct table_column {
    char *name, *unit;
    int decimals; /* for people; files have all digits */
} table_column;

/* A table; its cells are added row by row. */
typedef struct table {
    const char *name; /* "modes", borrowed */
    table_column *column;
    int columns;
    double *number; /* cells, row-major; of a text its index */
    size_t cells, room;
    char **text;
    size_t texts, text_room;
} table;

table *table_create(const char *name);
void table_destroy(table *t);
void table_column_add(table *t, const char *name, const char *unit, int decimals);
void table_number(table *t, double value);
void table_text(table *t, const char *text);
size_t table_rows(const table *t);

/* Write tables in one of the formats, which is not FORMAT_AUTO. */
void tables_write(FILE *file, int32_t format, int count, table *const *tables, bool colour);

/* A string of JSON. */
void json_text(FILE *file, const char *text);

/* A number that reads back as it was: NAN is `nothing`. */
void exact_number(FILE *file, double value, const char *nothing);

#endif
