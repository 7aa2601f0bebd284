/* SPDX-License-Identifier: MIT */
/* Points of a curve from two columns of a CSV table beside the model file. */
#include <string.h>

#include "files/slurp.h"
#include "files/table.h"
#include "files/unit.h"
#include "modelfile/points.h"
#include "modelfile/suggest.h"

/* Column of a table from 0, by its number from 1 or its name. */
static trk_status find_column(const trk_reader *reader, const trk_table *table,
                              const trk_node *value, trk_subject subject, int32_t fallback,
                              int32_t *out_column)
{
    char name[TRK_LABEL], unit[TRK_LABEL], tail[TRK_SUGGESTION_ROOM];
    trk_suggestion suggestion = {NULL, 0};
    *out_column = fallback;
    if (!value)
        return TRK_OK;
    if (value->kind == TRK_NODE_NUMBER) {
        for (*out_column = 0; *out_column < table->columns; ++*out_column)
            if (value->number == *out_column + 1)
                return TRK_OK;
        return trk_reader_fail(reader, value->place, TRK_E_RANGE,
                               "'%s' of %s '%.80s' is column %g, %s has columns 1 to %d",
                               value->key, subject.what, subject.name, value->number, table->name,
                               (int)table->columns);
    }
    if (value->kind != TRK_NODE_TEXT)
        return trk_reader_fail_kind(reader, value, subject, "the name or number of a column");
    for (*out_column = 0; *out_column < table->columns; ++*out_column) {
        trk_table_label(table, *out_column, name, unit);
        if (strcmp(name, value->text) == 0)
            return TRK_OK;
        if (!suggestion.best)
            trk_suggest(&suggestion, value->text, name); /* `name` stays if it is near */
        if (suggestion.best)
            break;
    }
    return trk_reader_fail(reader, value->place, TRK_E_NAME,
                           "%s has no column '%.80s', which %s '%.80s' names%s", table->name,
                           value->text, subject.what, subject.name,
                           trk_suggestion_tail(&suggestion, tail));
}

/* Factor of a column to SI, by its unit. */
static double factor_of(const trk_table *table, int32_t column)
{
    char name[TRK_LABEL], unit[TRK_LABEL];
    const char *si;
    trk_table_label(table, column, name, unit);
    const double factor = trk_unit_factor(unit, &si);
    return factor == 0 ? 1 : factor;
}

static trk_status take_columns(trk_reader *reader, const trk_table *table, const trk_node *group,
                               trk_subject subject, trk_points *p)
{
    const trk_node *csv = trk_node_find(group, "csv");
    int32_t x, y;
    trk_status status = find_column(reader, table, trk_node_find(group, "x"), subject, 0, &x);
    if (status == TRK_OK)
        status = find_column(reader, table, trk_node_find(group, "y"), subject, 1, &y);
    if (status == TRK_OK)
        status = trk_points_take(reader, p, table->rows);
    if (status)
        return status;
    const double x_factor = factor_of(table, x), y_factor = factor_of(table, y);
    for (int64_t k = 0; k < p->count; k++) {
        p->x[k] = x_factor * table->values[k * table->columns + x];
        p->y[k] = y_factor * table->values[k * table->columns + y];
        if (k > 0 && (p->x[k] == p->x[k - 1] || (p->x[k] > p->x[k - 1]) != (p->x[1] > p->x[0])))
            return trk_reader_fail(reader, csv->place, TRK_E_RANGE,
                                   "%s:%lld: column %d goes from %g to %g, expected one way up or "
                                   "down",
                                   table->name, (long long)trk_table_line(table, k), (int)x + 1,
                                   p->x[k - 1], p->x[k]);
    }
    return TRK_OK;
}

/* Path of a table: relative to the folder of the model file. */
static trk_status find_table(const trk_reader *reader, const trk_node *csv, trk_subject subject,
                             char **out_path)
{
    const char *name = NULL;
    trk_status status = trk_reader_text(reader, csv, subject, &name);
    if (status)
        return status;
    if (!reader->folder)
        return trk_reader_fail(reader, csv->place, TRK_E_FILE,
                               "%s '%.80s' is in '%.80s', but this model file has no folder",
                               subject.what, subject.name, name);
    if (!*name || *name == '/')
        return trk_reader_fail(reader, csv->place, TRK_E_FILE,
                               "'csv' of %s '%.80s' is '%.80s', expected a path relative to the "
                               "folder of the model file",
                               subject.what, subject.name, name);
    const size_t room = strlen(reader->folder) + strlen(name) + 2;
    *out_path = trk_new(reader->context, (int64_t)room, 1);
    if (!*out_path)
        return TRK_E_MEMORY;
    const bool here = strcmp(reader->folder, ".") == 0;
    trk_format(*out_path, room, "%s%s%s", here ? "" : reader->folder, here ? "" : "/", name);
    return TRK_OK;
}

static trk_status read_table(trk_reader *reader, const char *path, const trk_node *group,
                             trk_subject subject, trk_points *p)
{
    trk_csv_options options;
    trk_csv_options_init(&options, sizeof options);
    bool comma = false;
    trk_table table;
    char *bytes = NULL;
    size_t size = 0;
    trk_status status =
        trk_reader_truth(reader, trk_node_find(group, "decimal_comma"), subject, &comma);
    if (status)
        return status;
    options.decimal_comma = comma;
    status = trk_table_begin(reader->context, path, &options, &table);
    if (status == TRK_OK)
        status = trk_slurp_small(reader->context, path, TRK_TREE_SIZE, &bytes, &size);
    if (status == TRK_OK)
        status = trk_table_parse(&table, bytes, size);
    status = trk_reader_pass(reader, trk_node_find(group, "csv")->place, status);
    if (status == TRK_OK)
        status = take_columns(reader, &table, group, subject, p);
    trk_table_clear(&table);
    trk_free(reader->context, bytes);
    return status;
}

trk_status trk_points_from_csv(trk_reader *reader, const trk_node *csv, const trk_node *group,
                               trk_subject subject, trk_points *p)
{
    char *path = NULL;
    trk_status status = find_table(reader, csv, subject, &path);
    if (status)
        return status;
    status = read_table(reader, path, group, subject, p);
    trk_free(reader->context, path);
    return status;
}
