/* SPDX-License-Identifier: MIT */
/* Beams of a model file, by their stiffness or by a section of a material. */
#include <string.h>

#include "modelfile/reader.h"
#include "modelfile/suggest.h"

/* A group by the name of one of a section of the file, or the group itself. */
static trk_status find_named(const trk_reader *reader, const trk_node *value, const char *key,
                             const char *what, trk_subject subject, const trk_node **out)
{
    trk_suggestion suggestion = {NULL, 0};
    char tail[TRK_SUGGESTION_ROOM];
    *out = value;
    if (value->kind == TRK_NODE_GROUP)
        return TRK_OK;
    if (value->kind != TRK_NODE_TEXT)
        return trk_reader_fail_kind(reader, value, subject, "a name or a group {...}");
    const trk_node *all = trk_node_find(reader->tree.nodes, key);
    *out = all ? trk_node_find(all, value->text) : NULL;
    if (*out)
        return TRK_OK;
    if (all)
        TRK_EACH(one, all)
    trk_suggest(&suggestion, value->text, one->key);
    return trk_reader_fail(reader, value->place, TRK_E_NAME,
                           "there is no %s '%.80s', which %s '%.80s' names%s", what, value->text,
                           subject.what, subject.name, trk_suggestion_tail(&suggestion, tail));
}

static trk_status read_material(trk_reader *reader, const trk_node *value, trk_subject subject,
                                trk_material *out)
{
    const trk_node *group;
    trk_status status = find_named(reader, value, "materials", "material", subject, &group);
    return status ? status
                  : trk_reader_group(reader, group, (trk_subject){"material", group->key},
                                     trk_material_entries, out);
}

trk_status trk_make_material(trk_reader *reader, const trk_node *part)
{
    trk_material material;
    return trk_reader_group(reader, part, (trk_subject){"material", part->key},
                            trk_material_entries, &material);
}

/* Forms in the order of trk_profile_forms. */
static trk_status fill_options(trk_context *context, int form, const trk_material *m,
                               const trk_profile *p, trk_beam_options *out)
{
    switch (form) {
    case 0:
        return trk_beam_options_channel(context, m->young, m->shear, m->density, p->height,
                                        p->width, p->web, p->flange, out);
    case 1:
        return trk_beam_options_box(context, m->young, m->shear, m->density, p->height, p->width,
                                    p->web, p->flange, out);
    case 2:
        return trk_beam_options_rectangle(context, m->young, m->shear, m->density, p->height,
                                          p->width, out);
    default:
        return trk_beam_options_tube(context, m->young, m->shear, m->density, p->outer, p->wall,
                                     out);
    }
}

/* Stiffness and mass of a section: one of four forms, of a material. */
static trk_status read_section(trk_reader *reader, const trk_node *group, trk_beam_options *out)
{
    const trk_subject subject = {"section", group->key};
    const trk_node *shape = NULL;
    int form = 0;
    trk_material material;
    trk_profile profile = {0};
    trk_status status = trk_reader_group(reader, group, subject, trk_section_entries, NULL);
    for (int k = 0; status == TRK_OK && k < TRK_PROFILE_FORMS; k++) {
        const trk_node *found = trk_node_find(group, trk_profile_forms[k].key);
        if (found && shape)
            status = trk_reader_fail(reader, found->key_place, TRK_E_SYNTAX,
                                     "section '%.80s' is '%s' and '%s', expected one of them",
                                     group->key, shape->key, found->key);
        shape = found ? found : shape;
        form = found ? k : form;
    }
    if (status == TRK_OK && !shape)
        status = trk_reader_fail(reader, group->key_place, TRK_E_SYNTAX,
                                 "section '%.80s' is none of channel, box, rectangle and tube",
                                 group->key);
    if (status == TRK_OK)
        status = trk_reader_group(reader, shape, (trk_subject){shape->key, group->key},
                                  trk_profile_forms[form].entries, &profile);
    if (status == TRK_OK)
        status = read_material(reader, trk_node_find(group, "material"), subject, &material);
    if (status)
        return status;
    return trk_reader_pass(reader, shape->key_place,
                           fill_options(reader->context, form, &material, &profile, out));
}

trk_status trk_make_section(trk_reader *reader, const trk_node *part)
{
    trk_beam_options beam;
    trk_beam_options_init(&beam, sizeof beam);
    return read_section(reader, part, &beam);
}

trk_status trk_reader_beam(trk_reader *reader, const trk_node *group, trk_subject subject,
                           const trk_entry *entries, trk_beam_options *out_options)
{
    const trk_node *section = trk_node_find(group, "section"), *found = NULL;
    trk_status status = TRK_OK;
    trk_beam_options_init(out_options, sizeof *out_options);
    if (group->kind == TRK_NODE_GROUP && section) {
        status = find_named(reader, section, "sections", "section", subject, &found);
        if (status == TRK_OK)
            status = read_section(reader, found, out_options);
    }
    return status ? status : trk_reader_group(reader, group, subject, entries, out_options);
}

trk_status trk_make_beam(trk_reader *reader, const trk_node *part)
{
    char room[TRK_NAME_ROOM];
    const trk_subject subject = {"beam", part->key};
    trk_beam_options beam;
    trk_ends ends;
    trk_status status = trk_reader_beam(reader, part, subject, trk_beam_entries, &beam);
    if (status == TRK_OK)
        status = trk_reader_ends(reader, part, subject, &ends);
    if (status)
        return status;
    for (int k = 0; k < 2; k++)
        if (!ends.body[k])
            return trk_reader_fail(reader, trk_node_find(part, k ? "to" : "from")->place,
                                   TRK_E_MODEL, "beam '%.80s' ends on no body", part->key);
    beam.from_body = ends.body[0];
    beam.to_body = ends.body[1];
    memcpy(beam.from_point, ends.point[0], sizeof beam.from_point);
    memcpy(beam.to_point, ends.point[1], sizeof beam.to_point);
    if (reader->side == TRK_SIDE_RIGHT)
        beam.up[1] = 0 - beam.up[1];
    status = trk_spec_add_beam(reader->spec, trk_reader_name(reader, part->key, room), &beam, NULL);
    return trk_reader_pass(reader, part->key_place, status);
}
