/* SPDX-License-Identifier: MIT */
/* CSV tables (FILES.1). Memory grows with the numbers that were read, not with counts. */
#include "files/table.h"

#include <math.h>
#include <string.h>

#include "base/number.h"

enum { MOST_COLUMNS = 4096 };

void trk_csv_options_init(trk_csv_options *options, size_t struct_size)
{
    const trk_csv_options defaults = {sizeof defaults, 0, 0, 0.01};
    trk_write_defaults(options, struct_size, &defaults, sizeof defaults);
}

trk_status trk_table_begin(trk_context *context, const char *name, const trk_csv_options *options,
                           trk_table *out_table)
{
    *out_table = (trk_table){.context = context, .name = name};
    trk_csv_options *o = &out_table->options;
    trk_csv_options_init(o, sizeof *o);
    trk_status status = trk_read_options(context, "trk_csv_options", options, o, sizeof *o);
    if (status)
        return status;
    if (o->separator &&
        (o->separator < 0 || o->separator > 127 || !strchr(",;\t ", (char)o->separator)))
        return trk_fail(context, TRK_E_RANGE,
                        "%s: separator is %d, expected 0, a comma, a semicolon, a tab or a blank",
                        name, (int)o->separator);
    if (o->decimal_comma < 0 || o->decimal_comma > 1)
        return trk_fail(context, TRK_E_RANGE, "%s: decimal_comma is %d, expected 0 or 1", name,
                        (int)o->decimal_comma);
    if (o->decimal_comma && o->separator && o->separator != ';')
        return trk_fail(context, TRK_E_RANGE,
                        "%s: decimal_comma needs ';' between fields, separator is '%c'", name,
                        (int)o->separator);
    if (!(o->spacing_tolerance >= 0 && o->spacing_tolerance <= 0.5))
        return trk_fail(context, TRK_E_RANGE, "%s: spacing_tolerance is %g, expected 0 to 0.5",
                        name, o->spacing_tolerance);
    return TRK_OK;
}

void trk_table_clear(trk_table *table)
{
    trk_free(table->context, table->values);
    trk_free(table->context, table->names);
    trk_free(table->context, table->units);
    table->values = NULL;
    table->names = table->units = NULL;
}

static char point_of(const trk_table *table)
{
    return table->options.decimal_comma ? ',' : '.';
}

static bool is_number(const trk_table *table, const trk_csv_field *field, double *out_value)
{
    return trk_number_read(field->text.begin, field->text.end, point_of(table), out_value) ==
               field->text.end &&
           field->text.begin < field->text.end;
}

static trk_status fail_number(const trk_table *table, const trk_text *text,
                              const trk_csv_field *field)
{
    double value;
    const trk_slice slice = field->text;
    if (slice.begin == slice.end)
        return trk_text_fail(text, slice, "the field is empty, expected a number", NULL);
    if (trk_number_read(slice.begin, slice.end, ',', &value) == slice.end && point_of(table) == '.')
        return trk_text_fail(text, slice, "",
                             " has a decimal comma; expected a point, or the option decimal_comma "
                             "with ';' between fields");
    if (trk_slice_is(slice, "nan") || trk_slice_is(slice, "inf") || trk_slice_is(slice, "-inf"))
        return trk_text_fail(text, slice, "", " is not finite");
    return trk_text_fail(text, slice, "expected a number, not ", "");
}

/* A number with a decimal point or comma: not a name, even where it is not allowed. */
static bool looks_like_number(const trk_csv_field *field)
{
    double value;
    const trk_slice s = field->text;
    return s.begin < s.end && (trk_number_read(s.begin, s.end, '.', &value) == s.end ||
                               trk_number_read(s.begin, s.end, ',', &value) == s.end);
}

static bool is_empty(const trk_csv_field *field)
{
    return field->text.begin == field->text.end;
}

/* One row of fields. */
static trk_status read_labels(trk_table *table, trk_text *text, trk_csv_field **out,
                              int32_t *out_count)
{
    int64_t capacity = 0;
    *out_count = 0;
    do {
        trk_status status =
            trk_grow(table->context, (void **)out, &capacity, *out_count + 1, sizeof **out);
        if (status == TRK_OK)
            status = trk_field_next(text, table->separator, &(*out)[*out_count]);
        if (status)
            return status;
        if (++*out_count > MOST_COLUMNS)
            return trk_fail(table->context, TRK_E_SYNTAX, "%s:%lld:1: more than %d columns",
                            table->name, (long long)text->line, (int)MOST_COLUMNS);
    } while (!(*out)[*out_count - 1].last);
    return TRK_OK;
}

static trk_status fail_count(const trk_table *table, const trk_text *text, trk_slice at,
                             int32_t count)
{
    char what[80];
    trk_format(what, sizeof what, "the row has %s%d fields, expected %d",
               count > table->columns ? "more than " : "",
               (int)(count > table->columns ? table->columns : count), (int)table->columns);
    return trk_text_fail(text, at, what, NULL);
}

static trk_status read_row(trk_table *table, trk_text *text)
{
    trk_status status = trk_grow(table->context, (void **)&table->values, &table->capacity,
                                 (table->rows + 1) * table->columns, sizeof *table->values);
    double *row = table->values + table->rows * table->columns;
    trk_csv_field field = {{text->at, text->at}, false, false};
    int32_t count = 0;
    while (status == TRK_OK && !field.last) {
        trk_text before = *text;
        status = trk_field_next(text, table->separator, &field);
        if (status)
            return status;
        if (field.last && count == table->columns && field.text.begin == field.text.end)
            break;
        if (count == table->columns)
            return fail_count(table, &before, field.text, count + 1);
        if (!is_number(table, &field, &row[count]))
            return field.last && count > 0 && count + 1 < table->columns &&
                           field.text.begin == field.text.end
                       ? fail_count(table, &before, field.text, count)
                       : fail_number(table, &before, &field);
        if (!isfinite(row[count]))
            return trk_text_fail(&before, field.text, "", " is too large for a number");
        if (field.last && ++count < table->columns)
            return fail_count(table, &before, field.text, count);
        count += !field.last;
    }
    table->rows += status == TRK_OK;
    return status;
}

/* A second row without any number holds units. */
static trk_status read_units(trk_table *table, trk_text *text)
{
    trk_text before = *text;
    if (!trk_field_line(text))
        return TRK_OK;
    trk_status status = read_labels(table, text, &table->units, &table->unit_count);
    bool units = status == TRK_OK && table->unit_count <= table->name_count;
    for (int32_t k = 0; units && k < table->unit_count; k++)
        units = !looks_like_number(&table->units[k]);
    if (units)
        return TRK_OK;
    trk_free(table->context, table->units);
    table->units = NULL;
    table->unit_count = 0;
    *text = before;
    return status;
}

/* Columns of the first row of numbers; a separator at its end does not make one more. */
static trk_status count_columns(trk_table *table, trk_text text)
{
    trk_csv_field *fields = NULL;
    if (!trk_field_line(&text)) {
        table->columns = table->name_count;
        return TRK_OK;
    }
    trk_text row = text;
    trk_status status = read_labels(table, &text, &fields, &table->columns);
    if (status == TRK_OK && table->columns > 1 && is_empty(&fields[table->columns - 1]))
        table->columns--;
    if (status == TRK_OK && table->columns < 2)
        status = trk_text_fail(&row, fields[0].text,
                               "there is one column, expected an axis and at least one more", NULL);
    trk_free(table->context, fields);
    if (status || !table->names)
        return status;
    /* The names count, unless the last is empty. */
    if (!is_empty(&table->names[table->name_count - 1]))
        table->columns = table->name_count;
    else if (table->columns != table->name_count)
        table->columns = table->name_count - 1;
    return TRK_OK;
}

/* Names and units, if the first rows have any, and the number of columns. */
static trk_status read_header(trk_table *table, trk_text *text)
{
    trk_text first = *text;
    trk_status status = read_labels(table, text, &table->names, &table->name_count);
    if (status == TRK_OK && looks_like_number(&table->names[0])) {
        trk_free(table->context, table->names);
        table->names = NULL;
        table->name_count = 0;
        *text = first;
    } else if (status == TRK_OK) {
        status = read_units(table, text);
    }
    if (status == TRK_OK)
        status = count_columns(table, *text);
    if (status == TRK_OK && table->columns < 2)
        return trk_fail(table->context, TRK_E_SYNTAX,
                        "%s:1:1: there is one column, expected an axis and at least one more",
                        table->name);
    return status;
}

trk_status trk_table_parse(trk_table *table, const void *bytes, size_t size)
{
    trk_text text = trk_text_of(table->context, table->name, bytes, size);
    if (size >= 3 && memcmp(bytes, "\357\273\277", 3) == 0)
        text.at = text.line_begin = text.at + 3;
    text.line = 1;
    table->separator = (char)table->options.separator;
    if (!table->separator)
        table->separator = table->options.decimal_comma ? ';' : trk_table_sniff(text);
    if (!trk_field_line(&text))
        return trk_fail(table->context, TRK_E_SYNTAX, "%s: the file has no rows", table->name);
    trk_status status = read_header(table, &text);
    table->body = text;
    while (status == TRK_OK && trk_field_line(&text))
        status = read_row(table, &text);
    if (status == TRK_OK && table->rows < 2)
        return trk_fail(table->context, TRK_E_SYNTAX,
                        "%s:%lld:1: the table ends with %lld rows of numbers, expected at least 2",
                        table->name, (long long)text.line, (long long)table->rows);
    return status;
}

int64_t trk_table_line(const trk_table *table, int64_t row)
{
    trk_text text = table->body;
    trk_csv_field field = {{NULL, NULL}, true, true};
    for (int64_t k = -1; k < row && trk_field_line(&text); k++)
        for (field.last = k < 0; !field.last;)
            if (trk_field_next(&text, table->separator, &field))
                return text.line;
    return text.line;
}

/* Take "[unit]" or "(unit)" off the end of a name. */
static trk_slice split_unit(trk_slice *name)
{
    trk_slice unit = {name->end, name->end};
    if (name->end - name->begin < 2 || (name->end[-1] != ']' && name->end[-1] != ')'))
        return unit;
    const char open = name->end[-1] == ']' ? '[' : '(';
    const char *at = name->end - 1;
    while (at > name->begin && *at != open)
        at--;
    if (*at != open)
        return unit;
    unit = (trk_slice){at + 1, name->end - 1};
    name->end = at;
    *name = trk_trim(*name);
    return trk_trim(unit);
}

void trk_table_label(const trk_table *table, int32_t column, char *out_name, char *out_unit)
{
    *out_name = *out_unit = '\0';
    if (column < table->name_count) {
        const trk_csv_field *field = &table->names[column];
        trk_slice name = field->text, unit = split_unit(&name);
        trk_label_copy(name, field->quoted, out_name, TRK_LABEL);
        trk_label_copy(unit, field->quoted, out_unit, TRK_LABEL);
    }
    if (column < table->unit_count) {
        const trk_csv_field *field = &table->units[column];
        trk_slice rest = field->text, unit = split_unit(&rest);
        trk_label_copy(unit.begin < unit.end ? unit : field->text, field->quoted, out_unit,
                       TRK_LABEL);
    }
}
