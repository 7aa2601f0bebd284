/* SPDX-License-Identifier: MIT */
/* $KD_DEFINITION: data format, columns, and the v axis that they form (CRG.2). */
#include "base/number.h"
#include "crg/crg.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_COLUMNS = 1 << 20 };

static trk_status read_format(trk_crg_reader *r, trk_slice format)
{
    static const struct {
        const char *name;
        int32_t field;
        bool ascii, padded;
    } known[] = {{"LRFI", 10, true, false}, {"LDFI", 20, true, false}, {"KRBI", 4, false, false},
                 {"KDBI", 8, false, false}, {"LRBI", 4, false, true},  {"LDBI", 8, false, true}};
    if (r->field)
        return trk_text_fail(&r->text, format, "", " is a second data format");
    for (size_t k = 0; k < sizeof known / sizeof *known; k++)
        if (trk_slice_is(format, known[k].name)) {
            r->field = known[k].field;
            r->ascii = known[k].ascii;
            r->padded = known[k].padded;
            return TRK_OK;
        }
    return trk_text_fail(&r->text, format, "",
                         " is no data format; expected LRFI, LDFI, KRBI or KDBI");
}

/* Behind a word and the blanks in front of it, NULL if it does not stand there. */
static const char *skip_word(const char *at, const char *end, const char *word)
{
    while (at < end && *at == ' ')
        at++;
    return trk_slice_begins((trk_slice){at, end}, word) ? at + strlen(word) : NULL;
}

/* "long section at v = X,m" or "long section N,m" */
static trk_status read_long_section(trk_crg_reader *r, trk_slice line, const char *at,
                                    trk_crg_column *column)
{
    const char *behind = skip_word(at, line.end, "at v");
    column->kind = behind ? TRK_CRG_AT : TRK_CRG_NUMBERED;
    if (behind) {
        behind = skip_word(behind, line.end, "=");
        if (!behind)
            return trk_text_fail(&r->text, line, "expected 'long section at v = number,m', not ",
                                 "");
    }
    at = behind ? behind : at;
    while (at < line.end && *at == ' ')
        at++;
    const char *end = trk_number_read(at, line.end, '.', &column->v);
    const char *comma = end ? skip_word(end, line.end, ",") : NULL;
    if (!comma || !(fabs(column->v) <= 1e12))
        return trk_text_fail(&r->text, (trk_slice){at, line.end},
                             "expected the number of a long section and ',m', not ", "");
    if (!trk_slice_is(trk_trim((trk_slice){comma, line.end}), "m"))
        return trk_text_fail(&r->text, (trk_slice){comma, line.end},
                             "expected the unit m of a long section, not ", "");
    return TRK_OK;
}

trk_status trk_crg_read_column(trk_crg_reader *r, trk_slice line)
{
    if (trk_slice_begins(line, "#:"))
        return read_format(r, trk_trim((trk_slice){line.begin + 2, line.end}));
    if (!trk_slice_begins(line, "D:"))
        return TRK_OK; /* U: is computed, not stored */
    if (r->columns == MOST_COLUMNS)
        return trk_text_fail(&r->text, line, "more than 1048576 columns", NULL);
    trk_status status =
        trk_grow(r->context, (void **)&r->column, &r->capacity, r->columns + 1, sizeof *r->column);
    if (status)
        return status;
    trk_crg_column *column = &r->column[r->columns++];
    *column = (trk_crg_column){TRK_CRG_IGNORED, 0, r->text.line};
    const char *at = skip_word(line.begin + 2, line.end, "long section");
    if (at)
        return read_long_section(r, line, at, column);
    at = skip_word(line.begin + 2, line.end, "reference line");
    if (at && skip_word(at, line.end, "slope"))
        column->kind = TRK_CRG_SLOPE;
    else if (at && skip_word(at, line.end, "banking"))
        column->kind = TRK_CRG_BANKING;
    return TRK_OK;
}

typedef struct placed {
    double v;
    int64_t column;
} placed;

static int by_v(const void *a, const void *b)
{
    const double x = ((const placed *)a)->v, y = ((const placed *)b)->v;
    return (x > y) - (x < y);
}

/* Sections by number stand at even places that the header gives. */
static trk_status find_even_axis(const trk_crg_reader *r, int64_t count, double *out_first,
                                 double *out_step)
{
    const bool right = r->given[TRK_CRG_V_RIGHT], left = r->given[TRK_CRG_V_LEFT],
               step = r->given[TRK_CRG_V_INCREMENT];
    const double intervals = (double)(count - 1);
    if (!step && !(right && left))
        return trk_fail(r->context, TRK_E_SYNTAX,
                        "%s: long sections have numbers: expected LONG_SECTION_V_INCREMENT, or "
                        "LONG_SECTION_V_RIGHT and _LEFT",
                        r->text.name);
    *out_step = step ? r->value[TRK_CRG_V_INCREMENT]
                     : (r->value[TRK_CRG_V_LEFT] - r->value[TRK_CRG_V_RIGHT]) / intervals;
    *out_first = r->value[TRK_CRG_V_RIGHT]; /* 0 if neither it nor left is given */
    if (left && !right)
        *out_first = r->value[TRK_CRG_V_LEFT] - intervals * *out_step;
    const double end = *out_first + intervals * *out_step;
    if (left && !(fabs(end - r->value[TRK_CRG_V_LEFT]) <= 1e-3 * *out_step))
        return trk_fail(r->context, TRK_E_SYNTAX,
                        "%s: %lld long sections from %g m with increment %g m end at %g m, but "
                        "LONG_SECTION_V_LEFT is %g m",
                        r->text.name, (long long)count, *out_first, *out_step, end,
                        r->value[TRK_CRG_V_LEFT]);
    return TRK_OK;
}

/* Sort the sections; those with numbers must be 1, 2, ... and get their v. */
static trk_status place_sections(trk_crg_reader *r, placed *at, int64_t count)
{
    double first = 0, step = 0;
    const int kind = r->column[at[0].column].kind;
    qsort(at, (size_t)count, sizeof *at, by_v);
    if (kind == TRK_CRG_NUMBERED) {
        trk_status status = find_even_axis(r, count, &first, &step);
        if (status)
            return status;
    }
    for (int64_t k = 0; k < count; k++) {
        const trk_crg_column *column = &r->column[at[k].column];
        if ((int)column->kind != kind)
            return trk_fail(r->context, TRK_E_SYNTAX,
                            "%s:%lld:1: a long section with a number among those with a place",
                            r->text.name, (long long)column->line);
        if (kind == TRK_CRG_NUMBERED && column->v != (double)(k + 1))
            return trk_fail(r->context, TRK_E_SYNTAX,
                            "%s:%lld:1: long section %g, expected the numbers 1 to %lld once each",
                            r->text.name, (long long)column->line, column->v, (long long)count);
        r->crg->v[k] = kind == TRK_CRG_NUMBERED ? first + (double)k * step : at[k].v;
        r->place[k] = at[k].column;
        if (k > 0 && !(r->crg->v[k] - r->crg->v[k - 1] >= 1e-6))
            return trk_fail(r->context, TRK_E_SYNTAX,
                            "%s:%lld:1: long sections at %g and %g m, expected 1e-6 m between them",
                            r->text.name, (long long)column->line, r->crg->v[k - 1], r->crg->v[k]);
    }
    return TRK_OK;
}

/* Steps equal to 1e-3 count as even, as in the C library of ASAM. */
static bool is_even(const double *v, int64_t count)
{
    double least = v[1] - v[0], most = least;
    for (int64_t k = 2; k < count; k++) {
        least = fmin(least, v[k] - v[k - 1]);
        most = fmax(most, v[k] - v[k - 1]);
    }
    return (most - least) / least < 1e-3;
}

trk_status trk_crg_build_axis(trk_crg_reader *r)
{
    trk_crg *crg = r->crg;
    for (int64_t k = 0; k < r->columns; k++)
        crg->columns += r->column[k].kind == TRK_CRG_AT || r->column[k].kind == TRK_CRG_NUMBERED;
    if (crg->columns < 2)
        return trk_fail(r->context, TRK_E_SYNTAX,
                        "%s: %lld long sections in $KD_DEFINITION, expected at least 2",
                        r->text.name, (long long)crg->columns);
    crg->v = trk_new(r->context, crg->columns, sizeof *crg->v);
    r->place = trk_new(r->context, crg->columns, sizeof *r->place);
    placed *at = trk_new(r->context, crg->columns, sizeof *at);
    trk_status status = crg->v && r->place && at ? TRK_OK : TRK_E_MEMORY;
    int64_t count = 0;
    for (int64_t k = 0; status == TRK_OK && k < r->columns; k++)
        if (r->column[k].kind == TRK_CRG_AT || r->column[k].kind == TRK_CRG_NUMBERED)
            at[count++] = (placed){r->column[k].v, k};
    if (status == TRK_OK)
        status = place_sections(r, at, count);
    trk_free(r->context, at);
    if (status)
        return status;
    crg->even = is_even(crg->v, count);
    if (crg->even) {
        const double first = crg->v[0], step = (crg->v[count - 1] - first) / (double)(count - 1);
        for (int64_t k = 1; k + 1 < count; k++)
            crg->v[k] = first + step * (double)k;
    }
    return TRK_OK;
}
