/* SPDX-License-Identifier: MIT */
/* Groups of a model file into options structs, by their tables. */
#include <string.h>

#include "modelfile/reader.h"
#include "modelfile/suggest.h"

trk_status trk_reader_fail(const trk_reader *reader, trk_place place, trk_status status,
                           const char *format, ...)
{
    va_list arguments;
    char text[512];
    va_start(arguments, format);
    trk_format_list(text, sizeof text, format, arguments);
    va_end(arguments);
    return trk_fail(reader->context, status, "%s:%d:%d: %s", reader->source, (int)place.line,
                    (int)place.column, text);
}

trk_status trk_reader_pass(const trk_reader *reader, trk_place place, trk_status status)
{
    if (status == TRK_OK || status == TRK_E_MEMORY)
        return status;
    /* The file asks for what no caller could: it is the vehicle that is wrong, not an argument. */
    return trk_fail_within(reader->context, status == TRK_E_ARGUMENT ? TRK_E_MODEL : status,
                           "%s:%d:%d", reader->source, (int)place.line, (int)place.column);
}

trk_status trk_reader_fail_kind(const trk_reader *reader, const trk_node *value,
                                trk_subject subject, const char *wanted)
{
    if (!value->key)
        return trk_reader_fail(reader, value->place, TRK_E_SYNTAX,
                               "in %s '%.80s' there is %s where %s belongs", subject.what,
                               subject.name, trk_node_word(value), wanted);
    return trk_reader_fail(reader, value->place, TRK_E_SYNTAX,
                           "'%.80s' of %s '%.80s' is %s, expected %s", value->key, subject.what,
                           subject.name, trk_node_word(value), wanted);
}

static const trk_entry *find_entry(const trk_entry *entries, const char *key)
{
    for (; entries->key; entries++)
        if (strcmp(entries->key, key) == 0)
            return entries;
    return NULL;
}

static trk_status refuse_key(const trk_reader *reader, const trk_node *value, trk_subject subject,
                             const trk_entry *entries)
{
    trk_suggestion suggestion = {NULL, 0};
    char known[320] = "";
    for (; entries->key; entries++) {
        const size_t used = strlen(known);
        trk_suggest(&suggestion, value->key, entries->key);
        trk_format(known + used, sizeof known - used, "%s%s", used ? ", " : "", entries->key);
    }
    if (suggestion.best)
        return trk_reader_fail(reader, value->key_place, TRK_E_SYNTAX,
                               "unknown key '%.80s' in %s '%.80s'; did you mean '%s'?", value->key,
                               subject.what, subject.name, suggestion.best);
    return trk_reader_fail(reader, value->key_place, TRK_E_SYNTAX,
                           "unknown key '%.80s' in %s '%.80s', which may have: %s", value->key,
                           subject.what, subject.name, known);
}

trk_status trk_reader_group(trk_reader *reader, const trk_node *group, trk_subject subject,
                            const trk_entry *entries, void *options)
{
    if (group->kind != TRK_NODE_GROUP)
        return trk_reader_fail(reader, group->place, TRK_E_SYNTAX,
                               "%s '%.80s' is %s, expected a group {...}", subject.what,
                               subject.name, trk_node_word(group));
    TRK_EACH(value, group)
    if (!find_entry(entries, value->key))
        return refuse_key(reader, value, subject, entries);
    for (const trk_entry *entry = entries; entry->key; entry++)
        if (entry->required && !trk_node_find(group, entry->key))
            return trk_reader_fail(reader, group->key_place, TRK_E_SYNTAX, "%s '%.80s' has no '%s'",
                                   subject.what, subject.name, entry->key);
    TRK_EACH(value, group)
    {
        const trk_entry *entry = find_entry(entries, value->key);
        if (entry->kind == TRK_ENTRY_APART)
            continue;
        trk_status status =
            trk_reader_value(reader, value, subject, entry, (char *)options + entry->offset);
        if (status)
            return status;
    }
    return TRK_OK;
}
