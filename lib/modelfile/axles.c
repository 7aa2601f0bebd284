/* SPDX-License-Identifier: MIT */
/*
 * Axles: a body, and on both sides its roads, tires, springs, dampers and bump stops, named as those of
 * the ready-made vehicles: "front_axle", "front_left", "front_left_tire", "front_left_spring".
 */
#include <string.h>

#include "modelfile/reader.h"

typedef struct axle {
    const trk_node *group;
    trk_subject subject;
    int32_t body;
    double x, z; /* [m] of its centre */
} axle;

static const char *const side_word[2] = {"left", "right"};

/* Body of the axle. */
static trk_status add_body(trk_reader *reader, axle *a)
{
    char name[TRK_NAME_ROOM];
    trk_body_options body;
    trk_body_options_init(&body, sizeof body);
    body.freedoms = TRK_FREE_Z | TRK_FREE_ROLL;
    trk_status status = trk_reader_group(reader, a->group, a->subject, trk_axle_entries, &body);
    const trk_node *roll = trk_node_find(a->group, "roll_inertia"),
                   *inertia = trk_node_find(a->group, "inertia");
    if (status == TRK_OK)
        status =
            trk_reader_number(reader, trk_node_find(a->group, "x"), a->subject, TRK_ANY, &a->x);
    if (status == TRK_OK)
        status =
            trk_reader_number(reader, trk_node_find(a->group, "z"), a->subject, TRK_ANY, &a->z);
    if (status == TRK_OK && roll && inertia)
        status = trk_reader_fail(
            reader, roll->key_place, TRK_E_SYNTAX,
            "axle '%.80s' has 'inertia' and 'roll_inertia', expected one of them", a->subject.name);
    if (status == TRK_OK)
        status = trk_reader_number(reader, roll, a->subject, TRK_NOT_NEGATIVE, &body.inertia[0]);
    if (status)
        return status;
    body.cg[0] = a->x;
    body.cg[2] = a->z;
    trk_format(name, sizeof name, "%s_axle", a->group->key);
    return trk_reader_pass(reader, a->group->key_place,
                           trk_spec_add_body(reader->spec, name, &body, &a->body));
}

/* Place of a wheel part on the left: that of the axle but for what the group says. */
static trk_status read_place(trk_reader *reader, const axle *a, const trk_node *group,
                             const trk_node *y, double *point)
{
    point[0] = a->x;
    point[2] = a->z;
    trk_status status = trk_reader_number(reader, y, a->subject, TRK_POSITIVE, &point[1]);
    if (status == TRK_OK)
        status =
            trk_reader_number(reader, trk_node_find(group, "x"), a->subject, TRK_ANY, &point[0]);
    if (status == TRK_OK)
        status =
            trk_reader_number(reader, trk_node_find(group, "z"), a->subject, TRK_ANY, &point[2]);
    return status;
}

static trk_status add_link(trk_reader *reader, const trk_node *group, const char *name,
                           trk_link_options *link, const double *point)
{
    memcpy(link->from_point, point, sizeof link->from_point);
    memcpy(link->to_point, point, sizeof link->to_point);
    return trk_reader_pass(reader, group->key_place,
                           trk_spec_add_link(reader->spec, name, link, NULL));
}

/* One tire on its road; number: from 1, 0 if it is the only one of its side. */
static trk_status add_tire(trk_reader *reader, const axle *a, const trk_node *tires,
                           const trk_node *y, int side, int number, trk_link_options link)
{
    char road[TRK_NAME_ROOM], name[TRK_NAME_ROOM + 8];
    double point[3];
    trk_status status = read_place(reader, a, tires, y, point);
    if (status)
        return status;
    point[1] = side == 0 ? point[1] : -point[1];
    if (number)
        trk_format(road, sizeof road, "%s_%s_%d", a->group->key, side_word[side], number);
    else
        trk_format(road, sizeof road, "%s_%s", a->group->key, side_word[side]);
    trk_format(name, sizeof name, "%s_tire", road);
    status = trk_spec_add_road(reader->spec, road, point[0], point[1], &link.from_road);
    if (status)
        return trk_reader_pass(reader, tires->key_place, status);
    link.to_body = a->body;
    return add_link(reader, tires, name, &link, point);
}

static trk_status add_tires(trk_reader *reader, const axle *a, int side)
{
    const trk_node *tires = trk_node_find(a->group, "tires");
    trk_link_options link;
    trk_link_options_init(&link, sizeof link);
    if (!tires)
        return TRK_OK;
    trk_status status = trk_reader_group(
        reader, tires, (trk_subject){"tires of axle", a->group->key}, trk_wheel_entries, &link);
    if (status)
        return status;
    const trk_node *y = trk_node_find(tires, "y");
    if (y->kind != TRK_NODE_LIST)
        return add_tire(reader, a, tires, y, side, 0, link);
    int number = 1;
    TRK_EACH(one, y)
    {
        status = add_tire(reader, a, tires, one, side, number++, link);
        if (status)
            return status;
    }
    return number > 1
               ? TRK_OK
               : trk_reader_fail(reader, y->place, TRK_E_SYNTAX,
                                 "'y' of tires of axle '%.80s' is an empty list", a->group->key);
}

/* Springs, dampers or bump stops between the axle and what it carries. */
static trk_status add_suspension(trk_reader *reader, const axle *a, int side, const char *key,
                                 const char *word)
{
    char name[TRK_NAME_ROOM];
    const trk_node *group = trk_node_find(a->group, key), *frame = trk_node_find(a->group, "frame");
    trk_link_options link;
    double point[3];
    if (!group)
        return TRK_OK;
    trk_link_options_init(&link, sizeof link);
    trk_status status = trk_reader_group(reader, group, a->subject, trk_wheel_entries, &link);
    if (status == TRK_OK)
        status = read_place(reader, a, group, trk_node_find(group, "y"), point);
    if (status)
        return status;
    if (!frame)
        return trk_reader_fail(reader, a->group->key_place, TRK_E_SYNTAX,
                               "axle '%.80s' has '%s', but no 'frame' that they carry",
                               a->group->key, key);
    point[1] = side == 0 ? point[1] : -point[1];
    link.from_body = a->body;
    status = trk_reader_place(reader, frame, a->subject, point, &link.to_body);
    if (status)
        return status;
    trk_format(name, sizeof name, "%s_%s_%s", a->group->key, side_word[side], word);
    return add_link(reader, group, name, &link, point);
}

/* On a frame of beams a bar must hold in the middle: on one rail it would make left and right differ. */
static trk_status check_bar_place(const trk_reader *reader, const axle *a, const trk_node *bar,
                                  const trk_node *frame, int32_t node)
{
    trk_body_options body;
    trk_body_options_init(&body, sizeof body);
    if (!node || trk_spec_find(reader->spec, TRK_PART_BODY, frame->text))
        return TRK_OK; /* the ground, or one body */
    trk_status status = trk_spec_get_body(reader->spec, node, &body);
    return status || body.cg[1] == 0
               ? status
               : trk_reader_fail(reader, bar->key_place, TRK_E_MODEL,
                                 "'anti_roll_bar' of axle '%.80s' would twist one rail of '%.80s' "
                                 "only; a cross member near x = %g with an even 'member_elements' "
                                 "would hold it in the middle",
                                 a->group->key, frame->text, a->x);
}

/* An anti-roll bar: its stiffness, or a group. On a frame of beams it twists the node nearest to the
 * middle of the axle. */
static trk_status add_bar(trk_reader *reader, const axle *a)
{
    char name[TRK_NAME_ROOM];
    const trk_node *bar = trk_node_find(a->group, "anti_roll_bar"),
                   *frame = trk_node_find(a->group, "frame");
    trk_link_options link;
    trk_status status;
    if (!bar)
        return TRK_OK;
    trk_link_options_init(&link, sizeof link);
    link.motion = TRK_MOTION_ROTATION;
    link.direction[0] = 1;
    link.direction[2] = 0;
    if (bar->kind == TRK_NODE_GROUP)
        status =
            trk_reader_group(reader, bar, (trk_subject){"anti-roll bar of axle", a->group->key},
                             trk_axle_bar_entries, &link);
    else
        status = trk_reader_number(reader, bar, a->subject, TRK_NOT_NEGATIVE, &link.stiffness);
    if (status == TRK_OK && !frame)
        status = trk_reader_fail(reader, a->group->key_place, TRK_E_SYNTAX,
                                 "axle '%.80s' has 'anti_roll_bar', but no 'frame' that holds it",
                                 a->group->key);
    const double centre[3] = {a->x, 0, a->z}, origin[3] = {0, 0, 0};
    link.from_body = a->body;
    if (status == TRK_OK)
        status = trk_reader_place(reader, frame, a->subject, centre, &link.to_body);
    if (status == TRK_OK)
        status = check_bar_place(reader, a, bar, frame, link.to_body);
    if (status)
        return status;
    trk_format(name, sizeof name, "%s_anti_roll_bar", a->group->key);
    return add_link(reader, bar, name, &link, origin);
}

trk_status trk_make_axle(trk_reader *reader, const trk_node *part)
{
    axle a = {part, {"axle", part->key}, 0, 0, 0};
    trk_status status = add_body(reader, &a);
    for (int side = 0; status == TRK_OK && side < 2; side++) {
        status = add_tires(reader, &a, side);
        if (status == TRK_OK)
            status = add_suspension(reader, &a, side, "springs", "spring");
        if (status == TRK_OK)
            status = add_suspension(reader, &a, side, "dampers", "damper");
        if (status == TRK_OK)
            status = add_suspension(reader, &a, side, "bump_stops", "bump_stop");
    }
    return status == TRK_OK ? add_bar(reader, &a) : status;
}
