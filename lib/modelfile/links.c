/* SPDX-License-Identifier: MIT */
/* Links of a model file: plain ones, anti-roll bars, and mounts of up to three links. */
#include <string.h>

#include "modelfile/reader.h"

/* Mirror image of the direction of a link: of a translation a vector, of a rotation an axial one. */
static void mirror_direction(const trk_reader *reader, trk_link_options *link)
{
    if (reader->side != TRK_SIDE_RIGHT)
        return;
    double *d = link->direction;
    for (int k = 0; k < 3; k++)
        if ((k == 1) == (link->motion == TRK_MOTION_TRANSLATION))
            d[k] = 0 - d[k];
}

static trk_status add_link(trk_reader *reader, const trk_node *part, trk_subject subject,
                           const char *name, trk_link_options *link)
{
    trk_ends ends;
    trk_status status = trk_reader_ends(reader, part, subject, &ends);
    if (status)
        return status;
    link->from_body = ends.body[0];
    link->from_road = ends.road[0];
    link->to_body = ends.body[1];
    if (ends.road[1]) {
        const trk_node *to = trk_node_find(part, "to");
        return trk_reader_fail(reader, to->place, TRK_E_MODEL,
                               "%s '%.80s' runs to a road; let it begin there, and end on a body",
                               subject.what, subject.name);
    }
    memcpy(link->from_point, ends.point[0], sizeof link->from_point);
    memcpy(link->to_point, ends.point[1], sizeof link->to_point);
    mirror_direction(reader, link);
    return trk_reader_pass(reader, part->key_place,
                           trk_spec_add_link(reader->spec, name, link, NULL));
}

trk_status trk_make_link(trk_reader *reader, const trk_node *part)
{
    char room[TRK_NAME_ROOM];
    const trk_subject subject = {"link", part->key};
    trk_link_options link;
    trk_link_options_init(&link, sizeof link);
    trk_status status = trk_reader_group(reader, part, subject, trk_link_entries, &link);
    if (status)
        return status;
    return add_link(reader, part, subject, trk_reader_name(reader, part->key, room), &link);
}

trk_status trk_make_bar(trk_reader *reader, const trk_node *part)
{
    const trk_subject subject = {"anti-roll bar", part->key};
    trk_link_options link;
    trk_link_options_init(&link, sizeof link);
    link.motion = TRK_MOTION_ROTATION;
    memcpy(link.direction, (const double[]){1, 0, 0}, sizeof link.direction);
    trk_status status = trk_reader_group(reader, part, subject, trk_bar_entries, &link);
    return status ? status : add_link(reader, part, subject, part->key, &link);
}

/* One direction of a mount, which may have a place of its own. */
static trk_status add_arm(trk_reader *reader, const trk_node *mount, trk_subject subject,
                          const char *name, const char *arm, int axis)
{
    char full[TRK_NAME_ROOM + 16];
    const trk_node *group = trk_node_find(mount, arm);
    if (!group)
        return TRK_OK;
    trk_link_options link;
    trk_link_options_init(&link, sizeof link);
    trk_status status = trk_reader_group(reader, group, (trk_subject){"mount", subject.name},
                                         trk_arm_entries, &link);
    trk_ends ends;
    if (status == TRK_OK)
        status = trk_reader_ends(reader, mount, subject, &ends);
    if (status == TRK_OK && (ends.road[0] || ends.road[1]))
        status = trk_reader_fail(reader, trk_node_find(mount, ends.road[0] ? "from" : "to")->place,
                                 TRK_E_MODEL, "mount '%.80s': a mount stands between bodies",
                                 subject.name);
    if (status)
        return status;
    memset(link.direction, 0, sizeof link.direction);
    link.direction[axis] = 1;
    link.from_body = ends.body[0];
    link.to_body = ends.body[1];
    const trk_node *own = trk_node_find(group, "point");
    for (int which = 0; status == TRK_OK && which < 2; which++)
        status = trk_reader_point(reader, own, subject, ends.point[which]);
    if (status)
        return status;
    memcpy(link.from_point, ends.point[0], sizeof link.from_point);
    memcpy(link.to_point, ends.point[1], sizeof link.to_point);
    trk_format(full, sizeof full, "%s_%s", name, arm);
    return trk_reader_pass(reader, group->key_place,
                           trk_spec_add_link(reader->spec, full, &link, NULL));
}

trk_status trk_make_mount(trk_reader *reader, const trk_node *part)
{
    static const char *const arms[] = {"longitudinal", "lateral", "vertical"};
    static const int order[] = {2, 0, 1}; /* as the ready-made vehicles have them */
    char room[TRK_NAME_ROOM];
    const trk_subject subject = {"mount", part->key};
    const char *name = trk_reader_name(reader, part->key, room);
    const int32_t before = trk_spec_count(reader->spec, TRK_PART_LINK);
    trk_status status = trk_reader_group(reader, part, subject, trk_mount_entries, NULL);
    for (int k = 0; status == TRK_OK && k < 3; k++)
        status = add_arm(reader, part, subject, name, arms[order[k]], order[k]);
    if (status == TRK_OK && trk_spec_count(reader->spec, TRK_PART_LINK) == before)
        status = trk_reader_fail(reader, part->key_place, TRK_E_SYNTAX,
                                 "mount '%.80s' has none of vertical, longitudinal and lateral",
                                 part->key);
    return status;
}
