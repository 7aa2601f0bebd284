/* SPDX-License-Identifier: MIT */
/* Sections of an OpenCRG header (CRG.2). */
#include "base/number.h"
#include "crg/crg.h"

#include <math.h>
#include <string.h>

typedef enum section { OUTSIDE, COMMENT, ROAD, COLUMNS, OPTIONS, MODIFIERS, OTHER } section;

/* What becomes of a key that does not stand for a number of trk_crg_key. */
enum { UNSUPPORTED = TRK_CRG_KEYS };

typedef struct key {
    const char *name;
    int place;
    bool whole;
} key;

static const key road_keys[] = {
    {"REFERENCE_LINE_START_U", TRK_CRG_START_U, false},
    {"REFERENCE_LINE_END_U", TRK_CRG_END_U, false},
    {"REFERENCE_LINE_INCREMENT", TRK_CRG_INCREMENT, false},
    {"LONG_SECTION_V_RIGHT", TRK_CRG_V_RIGHT, false},
    {"LONG_SECTION_V_LEFT", TRK_CRG_V_LEFT, false},
    {"LONG_SECTION_V_INCREMENT", TRK_CRG_V_INCREMENT, false},
    {"REFERENCE_LINE_START_S", TRK_CRG_START_S, false},
    {"REFERENCE_LINE_END_S", TRK_CRG_END_S, false},
    {"REFERENCE_LINE_START_B", TRK_CRG_START_B, false},
    {"REFERENCE_LINE_END_B", TRK_CRG_END_B, false},
    {"REFERENCE_LINE_START_Z", TRK_CRG_START_Z, false},
    {"REFERENCE_LINE_END_Z", TRK_CRG_END_Z, false},
    {NULL, 0, false},
};

static const key option_keys[] = {
    {"BORDER_MODE_U", TRK_CRG_BORDER_MODE_U, true},
    {"BORDER_MODE_V", TRK_CRG_BORDER_MODE_V, true},
    {"BORDER_OFFSET_U", TRK_CRG_BORDER_OFFSET_U, false},
    {"BORDER_OFFSET_V", TRK_CRG_BORDER_OFFSET_V, false},
    {"BORDER_SMOOTH_UBEG", UNSUPPORTED, false},
    {"BORDER_SMOOTH_UEND", UNSUPPORTED, false},
    {NULL, 0, false},
};

static const key modifier_keys[] = {
    {"SCALE_Z_GRID", TRK_CRG_SCALE_Z, false},
    {"SCALE_SLOPE", TRK_CRG_SCALE_SLOPE, false},
    {"SCALE_BANKING", TRK_CRG_SCALE_BANKING, false},
    {"GRID_NAN_MODE", TRK_CRG_NAN_MODE, true},
    {"GRID_NAN_OFFSET", TRK_CRG_NAN_OFFSET, false},
    {"SCALE_LENGTH", UNSUPPORTED, false},
    {"SCALE_WIDTH", UNSUPPORTED, false},
    {"REFLINE_OFFSET_Z", UNSUPPORTED, false},
    {"REFPOINT_Z", UNSUPPORTED, false},
    {"REFPOINT_U", UNSUPPORTED, false},
    {"REFPOINT_U_FRACTION", UNSUPPORTED, false},
    {"REFPOINT_U_OFFSET", UNSUPPORTED, false},
    {"REFPOINT_V", UNSUPPORTED, false},
    {"REFPOINT_V_FRACTION", UNSUPPORTED, false},
    {"REFPOINT_V_OFFSET", UNSUPPORTED, false},
    {NULL, 0, false},
};

static trk_slice without_comment(trk_slice line)
{
    const char *mark = memchr(line.begin, '!', (size_t)(line.end - line.begin));
    return trk_trim((trk_slice){line.begin, mark ? mark : line.end});
}

/* The old documents give LONG_SECTION_V_RIGHT twice: the second one means LEFT. */
static int place_of(const trk_crg_reader *r, const key *k)
{
    return k->place == TRK_CRG_V_RIGHT && r->given[TRK_CRG_V_RIGHT] ? TRK_CRG_V_LEFT : k->place;
}

/* "KEY = number" */
static trk_status read_key(trk_crg_reader *r, trk_slice line, const key *keys)
{
    const char *equal = memchr(line.begin, '=', (size_t)(line.end - line.begin));
    if (!equal)
        return trk_text_fail(&r->text, line, "expected 'KEY = value', not ", "");
    const trk_slice name = trk_trim((trk_slice){line.begin, equal});
    const trk_slice value = trk_trim((trk_slice){equal + 1, line.end});
    double number;
    while (keys->name && !trk_slice_is(name, keys->name))
        keys++;
    if (!keys->name)
        return TRK_OK;
    if (trk_number_read(value.begin, value.end, '.', &number) != value.end ||
        !(fabs(number) <= 1e12) || (keys->whole && number != floor(number)))
        return trk_text_fail(
            &r->text, value,
            keys->whole ? "expected a whole number, not " : "expected a number, not ", "");
    if (keys->place == UNSUPPORTED)
        return trk_fail(r->context, TRK_E_UNSUPPORTED,
                        "%s:%lld:1: %s changes heights in a way this library does not know",
                        r->text.name, (long long)r->text.line, keys->name);
    const int place = place_of(r, keys);
    if (r->given[place])
        return trk_text_fail(&r->text, name, "", " is given twice");
    r->given[place] = true;
    r->value[place] = number;
    return TRK_OK;
}

static section open_section(trk_slice line)
{
    static const struct {
        const char *name;
        section opens;
    } known[] = {{"$CT", COMMENT},
                 {"$ROAD_CRG_OPTS", OPTIONS},
                 {"$ROAD_CRG_MODS", MODIFIERS},
                 {"$ROAD_CRG", ROAD},
                 {"$KD_DEFINITION", COLUMNS}};
    const char *end = line.begin;
    while (end < line.end && *end != ' ' && *end != '\t')
        end++;
    for (size_t k = 0; k < sizeof known / sizeof *known; k++)
        if (trk_slice_is((trk_slice){line.begin, end}, known[k].name))
            return known[k].opens;
    return end - line.begin > 1 ? OTHER : OUTSIDE;
}

static trk_status read_line(trk_crg_reader *r, trk_slice line, section in)
{
    switch (in) {
    case ROAD: return read_key(r, line, road_keys);
    case OPTIONS: return read_key(r, line, option_keys);
    case MODIFIERS: return read_key(r, line, modifier_keys);
    case COLUMNS: return trk_crg_read_column(r, line);
    default: return TRK_OK;
    }
}

static trk_status check(const trk_crg_reader *r, bool road)
{
    const char *missing = !road                          ? "section $ROAD_CRG"
                          : !r->given[TRK_CRG_INCREMENT] ? "key REFERENCE_LINE_INCREMENT"
                          : !r->field                    ? "data format #: in $KD_DEFINITION"
                                                         : NULL;
    if (missing)
        return trk_fail(r->context, TRK_E_SYNTAX, "%s:%lld:1: the header ends without %s",
                        r->text.name, (long long)r->text.line, missing);
    if (!(r->value[TRK_CRG_INCREMENT] >= 1e-6))
        return trk_fail(r->context, TRK_E_SYNTAX,
                        "%s: REFERENCE_LINE_INCREMENT is %g m, expected at least 1e-6",
                        r->text.name, r->value[TRK_CRG_INCREMENT]);
    return TRK_OK;
}

trk_status trk_crg_read_header(trk_crg_reader *r)
{
    section in = OUTSIDE;
    bool road = false;
    trk_slice line;
    while (trk_text_line(&r->text, &line)) {
        if (trk_slice_begins(line, "$$$$"))
            return check(r, road);
        if (line.begin < line.end && *line.begin == '$') {
            if (in == OUTSIDE && trk_slice_begins(line, "$ROAD_CRG_FILE"))
                return trk_fail(r->context, TRK_E_UNSUPPORTED,
                                "%s:%lld:1: the road data stand in another file; read that one",
                                r->text.name, (long long)r->text.line);
            in = in == OUTSIDE ? open_section(line) : OUTSIDE;
            road = road || in == ROAD;
            continue;
        }
        if (in == OUTSIDE || in == COMMENT || (line.begin < line.end && *line.begin == '*'))
            continue;
        line = without_comment(line);
        trk_status status = line.begin < line.end ? read_line(r, line, in) : TRK_OK;
        if (status)
            return status;
    }
    return trk_fail(
        r->context, TRK_E_SYNTAX,
        "%s:%lld:1: no OpenCRG file, or only its beginning: expected a line of $$$$ before "
        "the data",
        r->text.name, (long long)r->text.line + 1);
}
