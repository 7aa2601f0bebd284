/* SPDX-License-Identifier: MIT */
/* Tables: cells, and the aligned form. */
#include "table.h"
#include "common/text.h"
#include "write.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Twice the room of an array when it is full. */
static void *grown(void *block, size_t count, size_t *room, size_t size)
{
    if (count < *room)
        return block;
    *room = *room ? 2 * *room : 64;
    void *larger = need(*room, size);
    if (count > 0)
        memcpy(larger, block, count * size);
    free(block);
    return larger;
}

table *table_create(const char *name)
{
    table *t = need(1, sizeof *t);
    t->name = name;
    return t;
}

void table_destroy(table *t)
{
    if (!t)
        return;
    for (int k = 0; k < t->columns; k++) {
        free(t->column[k].name);
        free(t->column[k].unit);
    }
    for (size_t k = 0; k < t->texts; k++)
        free(t->text[k]);
    free(t->column);
    free(t->number);
    free(t->text);
    free(t);
}

void table_column_add(table *t, const char *name, const char *unit, int decimals)
{
    size_t room = (size_t)t->columns;
    t->column = grown(t->column, room, &room, sizeof *t->column);
    t->column[t->columns++] = (table_column){text_copy(name), text_copy(unit), decimals};
}

void table_number(table *t, double value)
{
    t->number = grown(t->number, t->cells, &t->room, sizeof *t->number);
    t->number[t->cells++] = value;
}

void table_text(table *t, const char *text)
{
    t->text = grown(t->text, t->texts, &t->text_room, sizeof *t->text);
    t->text[t->texts] = text_copy(text);
    table_number(t, (double)t->texts++);
}

size_t table_rows(const table *t)
{
    return t->columns > 0 ? t->cells / (size_t)t->columns : 0;
}

/* A cell as people read it. */
static const char *cell_text(const table *t, size_t row, int column, char *buffer, size_t room)
{
    const int decimals = t->column[column].decimals;
    const double cell = t->number[row * (size_t)t->columns + (size_t)column];
    const double value = cell == 0 ? 0 : cell; /* no -0 */
    if (decimals == TABLE_TEXT)
        return t->text[(size_t)value];
    if (isnan(value))
        return "-";
    if (decimals == TABLE_GENERAL)
        snprintf(buffer, room, "%.6g", value);
    else
        snprintf(buffer, room, "%.*f", decimals, value);
    return buffer;
}

/* Characters, not bytes, of UTF-8. */
static int width_of(const char *text)
{
    int width = 0;
    for (; *text; text++)
        width += (*text & 0xC0) != 0x80;
    return width;
}

/* A cell and the gap behind it, which is owed until something follows: no line ends with blanks. */
static void put_cell(FILE *file, const char *text, int width, bool left, int *owed)
{
    const int gap = width - width_of(text);
    if (*text)
        fprintf(file, "%*s", *owed + (left ? 0 : gap), "");
    text_print(file, text);
    *owed = 2 + (!*text ? *owed + width : left ? gap : 0);
}

static void put_heads(FILE *file, const table *t, const int *width, bool units)
{
    char unit[200];
    int owed = 0;
    for (int c = 0; c < t->columns; c++) {
        const table_column *column = &t->column[c];
        snprintf(unit, sizeof unit, column->unit[0] ? "[%s]" : "%s", column->unit);
        put_cell(file, units ? unit : column->name, width[c], column->decimals == TABLE_TEXT,
                 &owed);
    }
    fputc('\n', file);
}

void table_align(FILE *file, const table *t, bool colour)
{
    char buffer[400];
    int *width = need((size_t)t->columns, sizeof *width);
    for (int c = 0; c < t->columns; c++) {
        const int name = width_of(t->column[c].name), unit = width_of(t->column[c].unit) + 2;
        width[c] = t->column[c].unit[0] && unit > name ? unit : name;
        for (size_t r = 0; r < table_rows(t); r++) {
            const int w = width_of(cell_text(t, r, c, buffer, sizeof buffer));
            width[c] = w > width[c] ? w : width[c];
        }
    }
    bool units = false;
    for (int c = 0; c < t->columns; c++)
        units = units || t->column[c].unit[0];
    fputs(colour ? "\033[1m" : "", file);
    put_heads(file, t, width, false);
    if (units)
        put_heads(file, t, width, true);
    fputs(colour ? "\033[0m" : "", file);
    for (size_t r = 0; r < table_rows(t); r++) {
        int owed = 0;
        for (int c = 0; c < t->columns; c++)
            put_cell(file, cell_text(t, r, c, buffer, sizeof buffer), width[c],
                     t->column[c].decimals == TABLE_TEXT, &owed);
        fputc('\n', file);
    }
    free(width);
}
