/* SPDX-License-Identifier: MIT */
/* The rows of an OpenCRG file, text or binary (CRG.2). */
#include "base/number.h"
#include "crg/crg.h"
#include "files/bytes.h"

#include <math.h>
#include <string.h>

enum { RECORD = 80 };

static int64_t round_up(int64_t bytes)
{
    return (bytes + RECORD - 1) / RECORD * RECORD;
}

/* Rows that REFERENCE_LINE_END_U promises, 0 if it is not given. */
static trk_status count_rows(const trk_crg_reader *r, int64_t *out_rows)
{
    *out_rows = 0;
    if (!r->given[TRK_CRG_END_U])
        return TRK_OK;
    const double length = r->value[TRK_CRG_END_U] - r->value[TRK_CRG_START_U];
    const double rows = nearbyint(length / r->value[TRK_CRG_INCREMENT]) + 1;
    if (!(rows >= 2 && rows < 1e15))
        return trk_fail(
            r->context, TRK_E_SYNTAX,
            "%s: the reference line goes from %g to %g m by %g m, expected at least 2 rows",
            r->text.name, r->value[TRK_CRG_START_U], r->value[TRK_CRG_END_U],
            r->value[TRK_CRG_INCREMENT]);
    *out_rows = (int64_t)rows;
    return TRK_OK;
}

/* A field of text: NaN if it begins with *, 0 if it says that it is not used. */
static bool read_field(trk_slice field, double *out)
{
    field = trk_trim(field);
    *out = NAN;
    if (trk_slice_begins(field, "**unused") || trk_slice_begins(field, "*unused"))
        *out = 0;
    if (trk_slice_begins(field, "*") || trk_slice_is(field, "nan"))
        return true;
    return field.begin < field.end &&
           trk_number_read(field.begin, field.end, '.', out) == field.end && isfinite(*out);
}

/* One row of text over one or more records. `line` holds the first. */
static trk_status read_text_row(trk_crg_reader *r, trk_slice line, double *out)
{
    const int64_t per_record = RECORD / r->field;
    for (int64_t k = 0; k < r->columns; k++) {
        if (k > 0 && k % per_record == 0 && !trk_text_line(&r->text, &line))
            return trk_fail(r->context, TRK_E_SYNTAX,
                            "%s:%lld:1: the data end within a row, after %lld of %lld numbers",
                            r->text.name, (long long)r->text.line + 1, (long long)k,
                            (long long)r->columns);
        const int64_t from = k % per_record * r->field, length = line.end - line.begin;
        const char *begin = line.begin + (from < length ? from : length);
        const char *end = from + r->field < length ? begin + r->field : line.end;
        if (!read_field((trk_slice){begin, end}, &out[k]))
            return trk_text_fail(&r->text, (trk_slice){begin, end}, "expected a number, not ", "");
        if (k + 1 == r->columns && from + r->field > length && line.end == r->text.end)
            return trk_text_fail(&r->text, (trk_slice){begin, end},
                                 "the data end within a number, ", "");
        if ((k + 1) % per_record == 0 || k + 1 == r->columns) {
            const trk_slice rest = trk_trim((trk_slice){end, line.end});
            if (rest.begin < rest.end)
                return trk_text_fail(&r->text, rest, "expected the end of the record, not ", "");
        }
    }
    return TRK_OK;
}

static bool next_row(trk_text *text, trk_slice *out_line)
{
    while (trk_text_line(text, out_line)) {
        const trk_slice line = trk_trim(*out_line);
        if (line.begin < line.end)
            return true;
    }
    return false;
}

static trk_status read_text(trk_crg_reader *r, int64_t expected, double **data, int64_t *out_rows)
{
    int64_t capacity = 0, rows = 0;
    trk_slice line = {NULL, NULL};
    for (; next_row(&r->text, &line); rows++) {
        if (expected && rows == expected)
            return trk_fail(r->context, TRK_E_SYNTAX,
                            "%s:%lld:1: here is row %lld, but the reference line has %lld",
                            r->text.name, (long long)r->text.line, (long long)rows + 1,
                            (long long)expected);
        /* A row needs a byte of the file for each of its numbers. */
        trk_status status = r->columns > r->text.end - line.begin
                                ? trk_text_fail(&r->text, line, "the data end within a row", NULL)
                                : trk_grow(r->context, (void **)data, &capacity,
                                           (rows + 1) * r->columns, sizeof **data);
        if (status == TRK_OK)
            status = read_text_row(r, line, *data + rows * r->columns);
        if (status)
            return status;
    }
    *out_rows = rows;
    if (rows < 2 || rows < expected)
        return trk_fail(r->context, TRK_E_SYNTAX,
                        "%s:%lld:1: the data end after %lld rows, expected %lld", r->text.name,
                        (long long)r->text.line + 1, (long long)rows,
                        (long long)(expected ? expected : 2));
    return TRK_OK;
}

/*
 * Rows in so many bytes. The last record is filled up to 80 bytes, and an editor may have added a
 * line end. Any other size means that the header is wrong or that something has changed line ends
 * within the data, which then are worthless.
 */
static trk_status size_binary(const trk_crg_reader *r, int64_t row, int64_t *rows)
{
    int64_t bytes = r->text.end - r->text.at;
    const char *end = r->text.end;
    for (int k = 0; k < 2 && bytes % RECORD != 0 && bytes % row != 0; k++)
        if (end > r->text.at && (end[-1] == '\n' || end[-1] == '\r')) {
            end--;
            bytes--;
        }
    if (*rows == 0 && (bytes % RECORD == 0 || bytes % row == 0))
        *rows = bytes / row;
    const bool fits = *rows >= 2 && *rows <= bytes / row &&
                      (bytes == *rows * row || bytes == round_up(*rows * row));
    if (fits)
        return TRK_OK;
    return trk_fail(r->context, TRK_E_SYNTAX,
                    "%s: byte %lld: %lld bytes of data follow, expected %lld rows of %lld bytes%s",
                    r->text.name, (long long)(r->text.at - r->begin), (long long)bytes,
                    (long long)*rows, (long long)row,
                    bytes / row >= *rows && *rows > 1 ? "; line ends may have been converted" : "");
}

static trk_status read_binary(trk_crg_reader *r, int64_t rows, double **data, int64_t *out_rows)
{
    const int64_t packed = r->columns * r->field, row = r->padded ? round_up(packed) : packed;
    trk_status status = size_binary(r, row, &rows);
    if (status)
        return status;
    *data = trk_new(r->context, rows, (size_t)r->columns * sizeof **data);
    if (!*data)
        return TRK_E_MEMORY;
    for (int64_t i = 0; i < rows; i++)
        for (int64_t k = 0; k < r->columns; k++) {
            const char *at = r->text.at + i * row + k * r->field;
            double *x = &(*data)[i * r->columns + k];
            *x = r->field == 4 ? trk_bytes_float(at, true) : trk_bytes_double(at, true);
            if (isinf(*x))
                return trk_fail(r->context, TRK_E_SYNTAX,
                                "%s: byte %lld: number %lld of row %lld is infinite", r->text.name,
                                (long long)(at - r->begin), (long long)k + 1, (long long)i + 1);
        }
    *out_rows = rows;
    return TRK_OK;
}

/* Where the header does not tell the number of rows, the filling of the last record looks like
 * rows of NaN. */
static int64_t drop_filling(const trk_crg_reader *r, const double *data, int64_t rows)
{
    const int64_t row = r->columns * r->field;
    for (int64_t dropped = row; rows > 2 && dropped < RECORD; dropped += row) {
        for (int64_t k = 0; k < r->columns; k++)
            if (!isnan(data[(rows - 1) * r->columns + k]))
                return rows;
        rows--;
    }
    return rows;
}

/* Columns of the data into the grid, the slope and the banking. */
static trk_status distribute(trk_crg_reader *r, const double *data, int64_t rows)
{
    trk_crg *crg = r->crg;
    crg->rows = rows;
    crg->grid = trk_new(r->context, rows, (size_t)crg->columns * sizeof *crg->grid);
    if (!crg->grid)
        return TRK_E_MEMORY;
    for (int64_t i = 0; i < rows; i++)
        for (int64_t k = 0; k < crg->columns; k++)
            crg->grid[i * crg->columns + k] = data[i * r->columns + r->place[k]];
    for (int64_t c = 0; c < r->columns; c++) {
        const bool slope = r->column[c].kind == TRK_CRG_SLOPE;
        if (!slope && r->column[c].kind != TRK_CRG_BANKING)
            continue;
        double **target = slope ? &r->slope : &r->bank;
        if (*target)
            return trk_fail(r->context, TRK_E_SYNTAX, "%s:%lld:1: a second column of %s",
                            r->text.name, (long long)r->column[c].line,
                            slope ? "slope" : "banking");
        *target = trk_new(r->context, rows, sizeof **target);
        if (!*target)
            return TRK_E_MEMORY;
        for (int64_t i = 0; i < rows; i++) {
            const double x = data[i * r->columns + c];
            if (isnan(x) && i > 0)
                return trk_fail(r->context, TRK_E_SYNTAX, "%s: the %s of row %lld is missing",
                                r->text.name, slope ? "slope" : "banking", (long long)i + 1);
            (*target)[i] = isnan(x) ? 0 : x; /* the first may say that it is not used */
        }
    }
    return TRK_OK;
}

trk_status trk_crg_read_data(trk_crg_reader *r)
{
    double *data = NULL;
    int64_t expected, rows = 0;
    trk_status status = count_rows(r, &expected);
    if (status == TRK_OK)
        status = r->ascii ? read_text(r, expected, &data, &rows)
                          : read_binary(r, expected, &data, &rows);
    if (status == TRK_OK && !r->ascii && !r->padded && expected == 0)
        rows = drop_filling(r, data, rows);
    if (status == TRK_OK)
        status = distribute(r, data, rows);
    trk_free(r->context, data);
    return status;
}
