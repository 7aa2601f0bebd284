/* SPDX-License-Identifier: MIT */
/* A CSV table in memory (FILES.1). */
#ifndef TRK_FILES_TABLE_H
#define TRK_FILES_TABLE_H

#include "files/text.h"
#include <truckride/files.h>

typedef struct trk_csv_field {
    trk_slice text; /* without its quotes */
    bool quoted, last;
} trk_csv_field;

typedef struct trk_table {
    trk_context *context;
    const char *name; /* of the file                                       */
    trk_csv_options options;
    int32_t columns;
    int64_t rows, capacity;       /* capacity: of values                               */
    double *values;               /* rows x columns                                    */
    trk_csv_field *names, *units; /* NULL: none                                        */
    int32_t name_count, unit_count;
    trk_text body; /* the rows, in the bytes                            */
    char separator;
} trk_table;

/* Options checked, table empty. */
trk_status trk_table_begin(trk_context *context, const char *name, const trk_csv_options *options,
                           trk_table *out_table);

/* Fill the table; its fields point into bytes. */
trk_status trk_table_parse(trk_table *table, const void *bytes, size_t size);
/* Number of the line in which a row from 0 begins. */
int64_t trk_table_line(const trk_table *table, int64_t row);
void trk_table_clear(trk_table *table);

/* Name and unit of a column from 0, each in TRK_LABEL bytes; "" where there is none. */
void trk_table_label(const trk_table *table, int32_t column, char *out_name, char *out_unit);

/* Separator of a text that has none given: that which splits its first two lines alike. */
char trk_table_sniff(trk_text text);

/* Next field of the line that text stands in. Quoted fields may hold line ends. TRK_E_SYNTAX. */
trk_status trk_field_next(trk_text *text, char separator, trk_csv_field *out_field);

/* To the next line that is neither empty nor a comment; false at the end. */
bool trk_field_line(trk_text *text);

#endif
