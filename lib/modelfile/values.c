/* SPDX-License-Identifier: MIT */
/* Values of a model file: numbers, points, directions, words. */
#include <math.h>
#include <string.h>

#include "modelfile/reader.h"
#include "modelfile/suggest.h"

trk_status trk_reader_number(const trk_reader *reader, const trk_node *value, trk_subject subject,
                             trk_bound bound, double *out)
{
    static const char *const wanted[] = {"", " >= 0", " > 0"};
    if (!value)
        return TRK_OK;
    if (value->kind != TRK_NODE_NUMBER)
        return trk_reader_fail_kind(reader, value, subject, "a number");
    const double x = value->number;
    if ((bound == TRK_NOT_NEGATIVE && !(x >= 0)) || (bound == TRK_POSITIVE && !(x > 0)))
        return trk_reader_fail(reader, value->place, TRK_E_RANGE,
                               "%s%s%s of %s '%.80s' is %g, expected a number%s",
                               value->key ? "'" : "a number", value->key ? value->key : "",
                               value->key ? "'" : "", subject.what, subject.name, x, wanted[bound]);
    *out = x;
    return TRK_OK;
}

trk_status trk_reader_truth(const trk_reader *reader, const trk_node *value, trk_subject subject,
                            bool *out)
{
    if (!value)
        return TRK_OK;
    if (value->kind != TRK_NODE_TRUTH)
        return trk_reader_fail_kind(reader, value, subject, "true or false");
    *out = value->number != 0;
    return TRK_OK;
}

trk_status trk_reader_text(const trk_reader *reader, const trk_node *value, trk_subject subject,
                           const char **out)
{
    if (!value)
        return TRK_OK;
    if (value->kind != TRK_NODE_TEXT)
        return trk_reader_fail_kind(reader, value, subject, "a text");
    *out = value->text;
    return TRK_OK;
}

static trk_status read_triple(const trk_reader *reader, const trk_node *value, trk_subject subject,
                              trk_bound bound, double *out)
{
    double triple[3];
    int k = 0;
    if (value->kind != TRK_NODE_LIST || trk_node_count(value) != 3)
        return trk_reader_fail_kind(reader, value, subject, "three numbers, [x, y, z]");
    TRK_EACH(child, value)
    {
        trk_status status = trk_reader_number(reader, child, subject, bound, &triple[k++]);
        if (status)
            return status;
    }
    memcpy(out, triple, sizeof triple);
    return TRK_OK;
}

trk_status trk_reader_point(const trk_reader *reader, const trk_node *value, trk_subject subject,
                            double *out)
{
    if (!value)
        return TRK_OK;
    trk_status status = read_triple(reader, value, subject, TRK_ANY, out);
    if (status == TRK_OK && reader->side == TRK_SIDE_RIGHT)
        out[1] = 0 - out[1]; /* never -0 */
    return status;
}

static trk_status read_direction(const trk_reader *reader, const trk_node *value,
                                 trk_subject subject, double *out)
{
    static const char *const axes[] = {"x", "y", "z", "-x", "-y", "-z"};
    if (value->kind == TRK_NODE_LIST)
        return read_triple(reader, value, subject, TRK_ANY, out);
    for (int k = 0; value->kind == TRK_NODE_TEXT && k < 6; k++)
        if (strcmp(value->text, axes[k]) == 0) {
            memset(out, 0, 3 * sizeof *out);
            out[k % 3] = k < 3 ? 1 : -1;
            return TRK_OK;
        }
    if (value->kind == TRK_NODE_TEXT)
        return trk_reader_fail(reader, value->place, TRK_E_SYNTAX,
                               "'%s' of %s '%.80s' is '%.80s', expected \"x\", \"y\", \"z\", "
                               "\"-x\", \"-y\", \"-z\" or three numbers",
                               value->key, subject.what, subject.name, value->text);
    return trk_reader_fail_kind(reader, value, subject, "an axis or three numbers");
}

/* One word of several; `what` is what it is of. */
static trk_status read_word(const trk_reader *reader, const trk_node *value, trk_subject subject,
                            const char *what, const trk_word *words, int32_t *out)
{
    char known[160] = "";
    trk_suggestion suggestion = {NULL, 0};
    char tail[TRK_SUGGESTION_ROOM];
    if (value->kind != TRK_NODE_TEXT)
        return trk_reader_fail_kind(reader, value, subject, "a text");
    for (const trk_word *word = words; word->text; word++) {
        if (strcmp(word->text, value->text) == 0) {
            *out = word->value;
            return TRK_OK;
        }
        trk_suggest(&suggestion, value->text, word->text);
        const size_t used = strlen(known);
        trk_format(known + used, sizeof known - used, "%s%s", used ? ", " : "", word->text);
    }
    return trk_reader_fail(reader, value->place, TRK_E_SYNTAX,
                           "'%s' of %s '%.80s' is '%.80s', expected one of %s%s", what,
                           subject.what, subject.name, value->text, known,
                           trk_suggestion_tail(&suggestion, tail));
}

static trk_status read_freedoms(const trk_reader *reader, const trk_node *value,
                                trk_subject subject, int32_t *out)
{
    int32_t freedoms = 0;
    if (value->kind != TRK_NODE_LIST)
        return trk_reader_fail_kind(reader, value, subject, "a list of x, y, z, roll, pitch, yaw");
    TRK_EACH(child, value)
    {
        int32_t one = 0;
        trk_status status = read_word(reader, child, subject, value->key, trk_freedom_words, &one);
        if (status)
            return status;
        if (freedoms & one)
            return trk_reader_fail(reader, child->place, TRK_E_SYNTAX,
                                   "'%s' is twice among the freedoms of %s '%.80s'", child->text,
                                   subject.what, subject.name);
        freedoms |= one;
    }
    *out = freedoms;
    if (freedoms)
        return TRK_OK;
    return trk_reader_fail(reader, value->place, TRK_E_RANGE,
                           "%s '%.80s' has no freedoms, expected one at least", subject.what,
                           subject.name);
}

static trk_status read_whole(const trk_reader *reader, const trk_node *value, trk_subject subject,
                             int32_t *out)
{
    if (value->kind != TRK_NODE_NUMBER)
        return trk_reader_fail_kind(reader, value, subject, "a whole number");
    const double x = value->number;
    if (!(x == floor(x) && fabs(x) <= INT32_MAX))
        return trk_reader_fail(reader, value->place, TRK_E_RANGE,
                               "'%s' of %s '%.80s' is %g, expected a whole number", value->key,
                               subject.what, subject.name, x);
    *out = (int32_t)x;
    return TRK_OK;
}

trk_status trk_reader_value(trk_reader *reader, const trk_node *value, trk_subject subject,
                            const trk_entry *entry, void *field)
{
    switch (entry->kind) {
    case TRK_ENTRY_APART: return TRK_OK;
    case TRK_ENTRY_NUMBER: return trk_reader_number(reader, value, subject, entry->bound, field);
    case TRK_ENTRY_WHOLE: return read_whole(reader, value, subject, field);
    case TRK_ENTRY_TRIPLE: return read_triple(reader, value, subject, entry->bound, field);
    case TRK_ENTRY_POINT: return trk_reader_point(reader, value, subject, field);
    case TRK_ENTRY_DIRECTION: return read_direction(reader, value, subject, field);
    case TRK_ENTRY_WORD: return read_word(reader, value, subject, entry->key, entry->words, field);
    case TRK_ENTRY_FREEDOMS: return read_freedoms(reader, value, subject, field);
    case TRK_ENTRY_CURVE: return trk_reader_curve(reader, value, subject, field);
    case TRK_ENTRY_LAW: return trk_reader_law(reader, value, subject, field);
    case TRK_ENTRY_LINK: return trk_reader_find(reader, value, subject, TRK_PART_LINK, field);
    }
    return TRK_OK;
}
