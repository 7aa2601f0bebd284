/* SPDX-License-Identifier: MIT */
/* CSV tables as series and signals (FILES.1). */
#include "files/slurp.h"
#include "files/table.h"
#include "files/unit.h"

#include <math.h>
#include <string.h>

/* The axis in SI into the first column of the table. */
static void convert_axis(trk_table *table)
{
    char name[TRK_LABEL], unit[TRK_LABEL];
    const char *si;
    trk_table_label(table, 0, name, unit);
    const double factor = trk_unit_factor(unit, &si);
    const bool wanted = strcmp(si, "s") == 0 || strcmp(si, "m") == 0;
    for (int64_t k = 0; factor != 0 && wanted && k < table->rows; k++)
        table->values[k * table->columns] *= factor;
}

/* Start and rate of an axis that is even within the tolerance. */
static trk_status find_grid(const trk_table *table, double *out_start, double *out_rate)
{
    const double first = table->values[0], last = table->values[(table->rows - 1) * table->columns];
    const double step = (last - first) / (double)(table->rows - 1);
    if (!(step > 0) || !isfinite(step) || !isfinite(1 / step))
        return trk_fail(table->context, TRK_E_RANGE,
                        "%s: the axis begins at %g and ends at %g, expected it to increase",
                        table->name, first, last);
    for (int64_t k = 0; k < table->rows; k++) {
        const double even = first + step * (double)k, got = table->values[k * table->columns];
        if (!(fabs(got - even) <= table->options.spacing_tolerance * step))
            return trk_fail(table->context, TRK_E_RANGE,
                            "%s:%lld:1: the axis is %.9g, even spacing of %.9g would give %.9g; "
                            "expected a difference of at most %g spacings",
                            table->name, (long long)trk_table_line(table, k), got, step, even,
                            table->options.spacing_tolerance);
    }
    *out_start = first;
    *out_rate = trk_round_rate(1 / step);
    return TRK_OK;
}

static trk_status fill(const trk_table *table, trk_series *series)
{
    char name[TRK_LABEL], unit[TRK_LABEL];
    for (int32_t c = 1; c < table->columns; c++) {
        trk_table_label(table, c, name, unit);
        trk_status status = trk_label(series, c, name, unit, c + 1);
        if (status)
            return status;
        double *x = trk_series_data_mutable(series, c);
        for (int64_t k = 0; k < table->rows; k++)
            x[k] = table->values[k * table->columns + c];
    }
    return TRK_OK;
}

static trk_status table_to_series(trk_table *table, trk_series **out_series)
{
    double start = 0, rate = 1;
    convert_axis(table);
    trk_status status = find_grid(table, &start, &rate);
    if (status)
        return status;
    trk_series *series;
    status =
        trk_series_create(table->context, table->columns - 1, table->rows, rate, start, &series);
    if (status)
        return status;
    status = fill(table, series);
    if (status) {
        trk_series_destroy(series);
        return status;
    }
    *out_series = series;
    return TRK_OK;
}

static trk_status table_to_signal(trk_table *table, int32_t column, trk_signal **out_signal)
{
    char name[TRK_LABEL], unit[TRK_LABEL];
    const char *si;
    if (column < 1 || column >= table->columns)
        return trk_fail(table->context, TRK_E_RANGE, "%s: column is %d, expected 1 to %d",
                        table->name, (int)column, (int)table->columns - 1);
    convert_axis(table);
    trk_table_label(table, column, name, unit);
    double factor = trk_unit_factor(unit, &si);
    factor = factor == 0 ? 1 : factor;
    double *x = trk_new(table->context, 2 * table->rows, sizeof *x);
    if (!x)
        return TRK_E_MEMORY;
    for (int64_t k = 0; k < table->rows; k++) {
        x[k] = table->values[k * table->columns];
        x[table->rows + k] = factor * table->values[k * table->columns + column];
    }
    trk_status status =
        trk_signal_create_points(table->context, table->rows, x, x + table->rows, out_signal);
    trk_free(table->context, x);
    return status ? trk_fail_within(table->context, status, "%s", table->name) : TRK_OK;
}

static trk_status parse(trk_context *context, const char *name, const void *bytes, size_t size,
                        const trk_csv_options *options, trk_series **out_series, int32_t column,
                        trk_signal **out_signal)
{
    trk_table table;
    trk_status status = trk_table_begin(context, name, options, &table);
    if (status == TRK_OK)
        status = trk_table_parse(&table, bytes, size);
    if (status == TRK_OK)
        status = out_series ? table_to_series(&table, out_series)
                            : table_to_signal(&table, column, out_signal);
    trk_table_clear(&table);
    return status;
}

trk_status trk_series_parse_csv(trk_context *context, const char *name, const void *bytes,
                                size_t size, const trk_csv_options *options,
                                trk_series **out_series)
{
    TRK_REQUIRE(context, out_series, "trk_series_parse_csv");
    *out_series = NULL;
    if (!context)
        return TRK_E_ARGUMENT;
    TRK_REQUIRE(context, name, "trk_series_parse_csv");
    TRK_REQUIRE(context, bytes || size == 0, "trk_series_parse_csv");
    return parse(context, name, bytes, size, options, out_series, 0, NULL);
}

trk_status trk_signal_parse_csv(trk_context *context, const char *name, const void *bytes,
                                size_t size, const trk_csv_options *options, int32_t column,
                                trk_signal **out_signal)
{
    TRK_REQUIRE(context, out_signal, "trk_signal_parse_csv");
    *out_signal = NULL;
    if (!context)
        return TRK_E_ARGUMENT;
    TRK_REQUIRE(context, name, "trk_signal_parse_csv");
    TRK_REQUIRE(context, bytes || size == 0, "trk_signal_parse_csv");
    return parse(context, name, bytes, size, options, NULL, column, out_signal);
}

trk_status trk_series_read_csv(trk_context *context, const char *path,
                               const trk_csv_options *options, trk_series **out_series)
{
    TRK_REQUIRE(context, out_series, "trk_series_read_csv");
    *out_series = NULL;
    if (!context)
        return TRK_E_ARGUMENT;
    TRK_REQUIRE(context, path, "trk_series_read_csv");
    char *bytes;
    size_t size;
    trk_status status = trk_slurp(context, path, &bytes, &size);
    if (status == TRK_OK)
        status = parse(context, path, bytes, size, options, out_series, 0, NULL);
    trk_free(context, bytes);
    return status;
}

trk_status trk_signal_read_csv(trk_context *context, const char *path,
                               const trk_csv_options *options, int32_t column,
                               trk_signal **out_signal)
{
    TRK_REQUIRE(context, out_signal, "trk_signal_read_csv");
    *out_signal = NULL;
    if (!context)
        return TRK_E_ARGUMENT;
    TRK_REQUIRE(context, path, "trk_signal_read_csv");
    char *bytes;
    size_t size;
    trk_status status = trk_slurp(context, path, &bytes, &size);
    if (status == TRK_OK)
        status = parse(context, path, bytes, size, options, NULL, column, out_signal);
    trk_free(context, bytes);
    return status;
}
