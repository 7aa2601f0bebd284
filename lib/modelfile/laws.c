/* SPDX-License-Identifier: MIT */
/* Laws of a model file: {"leaf": {...}} by name or where they act. */
#include <string.h>

#include "modelfile/reader.h"
#include "modelfile/suggest.h"

static const trk_law_form *find_form(const char *key)
{
    for (int k = 0; k < TRK_LAW_FORMS; k++)
        if (strcmp(trk_law_forms[k].key, key) == 0)
            return &trk_law_forms[k];
    return NULL;
}

static trk_status refuse_form(const trk_reader *reader, const trk_node *kind, trk_subject subject)
{
    trk_suggestion suggestion = {NULL, 0};
    char tail[TRK_SUGGESTION_ROOM];
    for (int k = 0; k < TRK_LAW_FORMS; k++)
        trk_suggest(&suggestion, kind->key, trk_law_forms[k].key);
    return trk_reader_fail(reader, kind->key_place, TRK_E_SYNTAX,
                           "there is no law '%.80s' for %s '%.80s'; there are tire, stops, leaf, "
                           "friction, air_spring and seal%s",
                           kind->key, subject.what, subject.name,
                           trk_suggestion_tail(&suggestion, tail));
}

/* The one value of the group that is not its name. */
static trk_status find_kind(const trk_reader *reader, const trk_node *group, trk_subject subject,
                            const trk_node **out_kind)
{
    *out_kind = NULL;
    TRK_EACH(value, group)
    {
        if (strcmp(value->key, "name") == 0)
            continue;
        if (!find_form(value->key))
            return refuse_form(reader, value, subject);
        if (*out_kind)
            return trk_reader_fail(reader, value->key_place, TRK_E_SYNTAX,
                                   "%s '%.80s' has two laws, '%s' and '%s'; expected one",
                                   subject.what, subject.name, (*out_kind)->key, value->key);
        *out_kind = value;
    }
    if (*out_kind)
        return TRK_OK;
    return trk_reader_fail(reader, group->key_place, TRK_E_SYNTAX,
                           "%s '%.80s' has no law; there are tire, stops, leaf, friction, "
                           "air_spring and seal",
                           subject.what, subject.name);
}

/* A law from its group, kept by the reader. */
static trk_status create_law(trk_reader *reader, const trk_node *group, trk_subject subject)
{
    const trk_node *kind;
    const char *name = subject.name;
    trk_law_options options;
    if (group->kind != TRK_NODE_GROUP)
        return trk_reader_fail_kind(reader, group, subject, "a group {...} with a law");
    trk_status status = find_kind(reader, group, subject, &kind);
    if (status == TRK_OK)
        status = trk_reader_text(reader, trk_node_find(group, "name"), subject, &name);
    if (status)
        return status;
    const trk_law_form *form = find_form(kind->key);
    form->init(&options);
    status =
        trk_reader_group(reader, kind, (trk_subject){"law", subject.name}, form->entries, &options);
    if (status == TRK_OK)
        status = trk_grow(reader->context, (void **)&reader->laws, &reader->law_capacity,
                          reader->law_count + 1, sizeof *reader->laws);
    if (status)
        return status;
    status = form->create(reader->context, name, &options, &reader->laws[reader->law_count]);
    reader->law_count += status == TRK_OK;
    return trk_reader_pass(reader, kind->key_place, status);
}

trk_status trk_make_law(trk_reader *reader, const trk_node *part)
{
    trk_status status = create_law(reader, part, (trk_subject){"law", part->key});
    if (status)
        return status;
    return trk_names_add(reader->context, &reader->law_names, "law", part->key);
}

trk_status trk_reader_law(trk_reader *reader, const trk_node *value, trk_subject subject,
                          const trk_law **out_law)
{
    if (value->kind != TRK_NODE_TEXT) {
        trk_status status = create_law(reader, value, subject);
        if (status == TRK_OK)
            *out_law = reader->laws[reader->law_count - 1];
        return status;
    }
    trk_suggestion suggestion = {NULL, 0};
    char tail[TRK_SUGGESTION_ROOM];
    const int32_t id = trk_names_find(&reader->law_names, value->text);
    for (int32_t k = 1; id == 0 && k <= reader->law_names.count; k++)
        trk_suggest(&suggestion, value->text, trk_names_text(&reader->law_names, k));
    if (id == 0)
        return trk_reader_fail(reader, value->place, TRK_E_NAME,
                               "there is no law '%.80s', which %s '%.80s' names%s", value->text,
                               subject.what, subject.name, trk_suggestion_tail(&suggestion, tail));
    *out_law = reader->laws[id - 1];
    return TRK_OK;
}
