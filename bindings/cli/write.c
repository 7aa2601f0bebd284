/* SPDX-License-Identifier: MIT */
/* Tables as CSV (RFC 4180, lines end with a line feed) and JSON. */
#include "write.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

void exact_number(FILE *file, double value, const char *nothing)
{
    char text[40];
    if (!isfinite(value)) {
        fputs(nothing, file);
        return;
    }
    value = value == 0 ? 0 : value; /* no -0 */
    for (int digits = 15; digits <= 17; digits++) {
        snprintf(text, sizeof text, "%.*g", digits, value);
        if (strtod(text, NULL) == value)
            break;
    }
    fputs(text, file);
}

/* A field of CSV, quoted where it must be. */
static void csv_text(FILE *file, const char *text)
{
    if (!strpbrk(text, ",\"\r\n")) {
        fputs(text, file);
        return;
    }
    fputc('"', file);
    for (; *text; text++) {
        if (*text == '"')
            fputc('"', file);
        fputc(*text, file);
    }
    fputc('"', file);
}

void json_text(FILE *file, const char *text)
{
    fputc('"', file);
    for (; *text; text++) {
        const unsigned char c = (unsigned char)*text;
        if (c == '"' || c == '\\')
            fprintf(file, "\\%c", c);
        else if (c < 32)
            fprintf(file, "\\u%04x", c);
        else
            fputc(c, file);
    }
    fputc('"', file);
}

/* With several tables in one file, the first column names the table. */
static void write_csv(FILE *file, const table *t, bool named)
{
    char head[512];
    if (named)
        fputs("table,", file);
    for (int c = 0; c < t->columns; c++) {
        const table_column *column = &t->column[c];
        snprintf(head, sizeof head, column->unit[0] ? "%s [%s]" : "%s", column->name, column->unit);
        fputs(c ? "," : "", file);
        csv_text(file, head);
    }
    fputc('\n', file);
    for (size_t k = 0; k < t->cells; k++) {
        const int c = (int)(k % (size_t)t->columns);
        if (c == 0 && named)
            fprintf(file, "%s,", t->name);
        if (t->column[c].decimals == TABLE_TEXT)
            csv_text(file, t->text[(size_t)t->number[k]]);
        else
            exact_number(file, t->number[k], isnan(t->number[k]) ? "nan" : "inf");
        fputc(c + 1 == t->columns ? '\n' : ',', file);
    }
}

static void write_rows(FILE *file, const table *t)
{
    for (size_t k = 0; k < t->cells; k++) {
        const int c = (int)(k % (size_t)t->columns);
        fputs(c ? ", " : k ? ",\n    {" : "\n    {", file);
        json_text(file, t->column[c].name);
        fputs(": ", file);
        if (t->column[c].decimals == TABLE_TEXT)
            json_text(file, t->text[(size_t)t->number[k]]);
        else
            exact_number(file, t->number[k], "null");
        fputs(c + 1 == t->columns ? "}" : "", file);
    }
    fputs(t->cells ? "\n  ]" : "]", file);
}

static void write_units(FILE *file, const table *t)
{
    bool first = true;
    for (int c = 0; c < t->columns; c++) {
        if (!t->column[c].unit[0])
            continue;
        fputs(first ? "" : ", ", file);
        json_text(file, t->column[c].name);
        fputs(": ", file);
        json_text(file, t->column[c].unit);
        first = false;
    }
}

/* {"modes": [{...}, ...], "units": {"modes": {...}}} */
static void write_json(FILE *file, int count, table *const *tables)
{
    fputs("{", file);
    for (int k = 0; k < count; k++) {
        fprintf(file, "%s\n  \"%s\": [", k ? "," : "", tables[k]->name);
        write_rows(file, tables[k]);
    }
    fputs(",\n  \"units\": {", file);
    for (int k = 0; k < count; k++) {
        fprintf(file, "%s\n    \"%s\": {", k ? "," : "", tables[k]->name);
        write_units(file, tables[k]);
        fputs("}", file);
    }
    fputs("\n  }\n}\n", file);
}

void tables_write(FILE *file, int32_t format, int count, table *const *tables, bool colour)
{
    if (format == FORMAT_JSON) {
        write_json(file, count, tables);
        return;
    }
    for (int k = 0; k < count; k++) {
        fputs(k ? "\n" : "", file);
        if (format == FORMAT_CSV) {
            write_csv(file, tables[k], count > 1);
        } else {
            if (count > 1)
                fprintf(file, "%s%s%s\n", colour ? "\033[1m" : "", tables[k]->name,
                        colour ? "\033[0m" : "");
            table_align(file, tables[k], colour);
        }
    }
}
