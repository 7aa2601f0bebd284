/* SPDX-License-Identifier: MIT */
/*
 * Ends of links and beams: "cab" for short, or {"body": "cab", "point": [x, y, z]}, {"frame": ...},
 * {"road": ...}, {"ground": true}.
 */
#include <string.h>

#include "modelfile/reader.h"

/* A name alone: the ground, a body, or else a frame. */
trk_status trk_reader_place(const trk_reader *reader, const trk_node *end, trk_subject subject,
                            const double *point, int32_t *out_body)
{
    char room[TRK_NAME_ROOM];
    if (end->kind != TRK_NODE_TEXT)
        return trk_reader_fail_kind(reader, end, subject, "a name");
    const char *name = trk_reader_reference(reader, end->text, room);
    const trk_node *frames = trk_node_find(reader->tree.nodes, "frames");
    if (strcmp(name, "ground") == 0)
        return TRK_OK;
    if (!trk_spec_find(reader->spec, TRK_PART_BODY, name) && frames && trk_node_find(frames, name))
        return trk_reader_body(reader, NULL, end, subject, point, out_body);
    return trk_reader_body(reader, end, NULL, subject, point, out_body);
}

/* A group: one of body, frame, road and ground, and perhaps a point. */
static trk_status read_group(const trk_reader *reader, const trk_node *end, trk_subject subject,
                             int which, trk_ends *ends)
{
    static const char *const places[] = {"body", "frame", "road", "ground"};
    const trk_node *place = NULL;
    bool ground = true;
    trk_status status = trk_reader_group((trk_reader *)reader, end, subject, trk_end_entries, NULL);
    if (status)
        return status;
    for (int k = 0; k < 4; k++) {
        const trk_node *found = trk_node_find(end, places[k]);
        if (found && place)
            return trk_reader_fail(reader, found->key_place, TRK_E_SYNTAX,
                                   "'%s' of %s '%.80s' has '%s' and '%s', expected one of them",
                                   end->key, subject.what, subject.name, place->key, found->key);
        place = found ? found : place;
    }
    if (!place)
        return trk_reader_fail(reader, end->place, TRK_E_SYNTAX,
                               "'%s' of %s '%.80s' has no 'body', 'frame', 'road' or 'ground'",
                               end->key, subject.what, subject.name);
    status = trk_reader_point(reader, trk_node_find(end, "point"), subject, ends->point[which]);
    if (status)
        return status;
    if (strcmp(place->key, "road") == 0)
        return trk_reader_find(reader, place, subject, TRK_PART_ROAD, &ends->road[which]);
    if (strcmp(place->key, "ground") == 0) {
        status = trk_reader_truth(reader, place, subject, &ground);
        return status || ground
                   ? status
                   : trk_reader_fail(reader, place->place, TRK_E_SYNTAX,
                                     "'ground' of %s '%.80s' is false, expected true or another "
                                     "place",
                                     subject.what, subject.name);
    }
    const bool body = strcmp(place->key, "body") == 0;
    return trk_reader_body(reader, body ? place : NULL, body ? NULL : place, subject,
                           ends->point[which], &ends->body[which]);
}

trk_status trk_reader_ends(const trk_reader *reader, const trk_node *part, trk_subject subject,
                           trk_ends *out_ends)
{
    double point[3] = {0, 0, 0};
    *out_ends = (trk_ends){{0}, {0}, {{0}}};
    trk_status status = trk_reader_point(reader, trk_node_find(part, "point"), subject, point);
    for (int which = 0; status == TRK_OK && which < 2; which++) {
        const trk_node *end = trk_node_find(part, which == 0 ? "from" : "to");
        memcpy(out_ends->point[which], point, sizeof point);
        if (!end)
            continue;
        if (end->kind == TRK_NODE_TEXT)
            status = trk_reader_place(reader, end, subject, out_ends->point[which],
                                      &out_ends->body[which]);
        else if (end->kind == TRK_NODE_GROUP)
            status = read_group(reader, end, subject, which, out_ends);
        else
            status = trk_reader_fail_kind(reader, end, subject, "a name or a group {...}");
    }
    return status;
}
