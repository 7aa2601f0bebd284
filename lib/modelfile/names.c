/* SPDX-License-Identifier: MIT */
/* Names of parts in a model file: of mirrored parts, and references to others. */
#include <string.h>

#include "modelfile/reader.h"
#include "modelfile/suggest.h"

static const char *side_word(const trk_reader *reader)
{
    return reader->side == TRK_SIDE_LEFT ? "left" : "right";
}

const char *trk_reader_reference(const trk_reader *reader, const char *name,
                                 char out[TRK_NAME_ROOM])
{
    const char *star = reader->side == TRK_SIDE_NONE ? NULL : strchr(name, '*');
    if (!star)
        return name;
    trk_format(out, TRK_NAME_ROOM, "%.*s%s%s", (int)(star - name), name, side_word(reader),
               star + 1);
    return out;
}

const char *trk_reader_name(const trk_reader *reader, const char *name, char out[TRK_NAME_ROOM])
{
    if (reader->side == TRK_SIDE_NONE || strchr(name, '*'))
        return trk_reader_reference(reader, name, out);
    trk_format(out, TRK_NAME_ROOM, "%s_%s", name, side_word(reader));
    return out;
}

static const char *word_of(trk_part part)
{
    return part == TRK_PART_BODY ? "body" : part == TRK_PART_ROAD ? "road" : "link";
}

trk_status trk_reader_find(const trk_reader *reader, const trk_node *value, trk_subject subject,
                           trk_part part, int32_t *out_id)
{
    char room[TRK_NAME_ROOM];
    trk_suggestion suggestion = {NULL, 0};
    char tail[TRK_SUGGESTION_ROOM];
    if (value->kind != TRK_NODE_TEXT)
        return trk_reader_fail_kind(reader, value, subject, "a name");
    const char *name = trk_reader_reference(reader, value->text, room);
    *out_id = trk_spec_find(reader->spec, part, name);
    if (*out_id)
        return TRK_OK;
    for (int32_t id = 1; id <= trk_spec_count(reader->spec, part); id++)
        trk_suggest(&suggestion, name, trk_spec_part_name(reader->spec, part, id));
    return trk_reader_fail(reader, value->place, TRK_E_NAME,
                           "there is no %s '%.80s', which %s '%.80s' names%s", word_of(part), name,
                           subject.what, subject.name, trk_suggestion_tail(&suggestion, tail));
}

/* Node of a frame next to a point. */
static trk_status find_node(const trk_reader *reader, const trk_node *frame, trk_subject subject,
                            const double *point, int32_t *out_body)
{
    char pattern[TRK_NAME_ROOM + 4];
    trk_format(pattern, sizeof pattern, "%.200s.*", frame->text);
    const trk_node *frames = trk_node_find(reader->tree.nodes, "frames");
    trk_suggestion suggestion = {NULL, 0};
    char tail[TRK_SUGGESTION_ROOM];
    if (frames && frames->kind == TRK_NODE_GROUP) {
        if (trk_node_find(frames, frame->text))
            return trk_reader_pass(reader, frame->place,
                                   trk_spec_nearest_body(reader->spec, pattern, point, out_body));
        TRK_EACH(other, frames)
        trk_suggest(&suggestion, frame->text, other->key);
    }
    return trk_reader_fail(reader, frame->place, TRK_E_NAME,
                           "there is no frame '%.80s', which %s '%.80s' names%s", frame->text,
                           subject.what, subject.name, trk_suggestion_tail(&suggestion, tail));
}

trk_status trk_reader_body(const trk_reader *reader, const trk_node *body, const trk_node *frame,
                           trk_subject subject, const double *point, int32_t *out_body)
{
    if (body && frame)
        return trk_reader_fail(reader, frame->key_place, TRK_E_SYNTAX,
                               "%s '%.80s' has a body and a frame, expected one of them",
                               subject.what, subject.name);
    if (body)
        return trk_reader_find(reader, body, subject, TRK_PART_BODY, out_body);
    if (frame && frame->kind != TRK_NODE_TEXT)
        return trk_reader_fail_kind(reader, frame, subject, "a name");
    return frame ? find_node(reader, frame, subject, point, out_body) : TRK_OK;
}
