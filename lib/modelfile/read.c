/* SPDX-License-Identifier: MIT */
/* A model file as a whole: its sections, in the order in which their parts get ids. */
#include <truckride/modelfile.h>

#include <string.h>

#include "files/slurp.h"
#include "modelfile/reader.h"
#include "modelfile/suggest.h"

typedef struct section {
    const char *key, *what; /* what: one of them */
    trk_make make;
    bool mirrored; /* its parts may have a mirror image */
} section;

/* What is referred to comes first: in this order, whatever that of the file. */
static const section sections[] = {
    {"curves", "curve", trk_make_curve, false},
    {"laws", "law", trk_make_law, false},
    {"materials", "material", trk_make_material, false},
    {"sections", "section", trk_make_section, false},
    {"bodies", "body", trk_make_body, true},
    {"roads", "road", trk_make_road, true},
    {"frames", "frame", trk_make_frame, false},
    {"axles", "axle", trk_make_axle, false},
    {"beams", "beam", trk_make_beam, true},
    {"masses", "mass", trk_make_mass, true},
    {"mounts", "mount", trk_make_mount, true},
    {"links", "link", trk_make_link, true},
    {"anti_roll_bars", "anti-roll bar", trk_make_bar, false},
    {"ports", "port", trk_make_port, true},
    {"sensors", "sensor", trk_make_sensor, true},
};
enum { SECTIONS = sizeof sections / sizeof *sections };

static const trk_subject file_subject = {"the", "model file"};

/* Both halves of a mirrored part, or the part. */
static trk_status make_part(trk_reader *reader, const section *s, const trk_node *part)
{
    const trk_node *mirror = part->kind == TRK_NODE_GROUP ? trk_node_find(part, "mirror") : NULL;
    bool mirrored = false;
    trk_status status = TRK_OK;
    if (mirror && s->mirrored)
        status = trk_reader_truth(reader, mirror, (trk_subject){s->what, part->key}, &mirrored);
    reader->side = mirrored ? TRK_SIDE_LEFT : TRK_SIDE_NONE;
    if (status == TRK_OK)
        status = s->make(reader, part);
    reader->side = TRK_SIDE_RIGHT;
    if (status == TRK_OK && mirrored)
        status = s->make(reader, part);
    reader->side = TRK_SIDE_NONE;
    return status;
}

static trk_status make_section(trk_reader *reader, const section *s)
{
    const trk_node *parts = trk_node_find(reader->tree.nodes, s->key);
    if (!parts)
        return TRK_OK;
    if (parts->kind != TRK_NODE_GROUP)
        return trk_reader_fail_kind(reader, parts, file_subject, "a group {...} of named parts");
    TRK_EACH(part, parts)
    {
        if (!*part->key)
            return trk_reader_fail(reader, part->key_place, TRK_E_NAME, "a %s needs a name",
                                   s->what);
        trk_status status = make_part(reader, s, part);
        if (status)
            return status;
    }
    return TRK_OK;
}

/* The version comes first: what another one has is not for this reader to judge. */
static trk_status check_version(const trk_reader *reader)
{
    const trk_node *root = reader->tree.nodes;
    if (root->kind != TRK_NODE_GROUP)
        return trk_reader_fail(reader, root->place, TRK_E_SYNTAX,
                               "the model file is %s, expected a group {...}", trk_node_word(root));
    const trk_node *version = trk_node_find(root, "truckride_model");
    if (!version)
        return trk_reader_fail(reader, root->place, TRK_E_SYNTAX,
                               "the model file has no '\"truckride_model\": 1'");
    double number = 0;
    trk_status status = trk_reader_number(reader, version, file_subject, TRK_ANY, &number);
    if (status == TRK_OK && number != 1)
        status = trk_reader_fail(reader, version->place, TRK_E_UNSUPPORTED,
                                 "the model file is of version %g, this library reads version 1",
                                 number);
    return status;
}

static trk_status check_notes(const trk_reader *reader, const trk_node *notes)
{
    if (!notes || notes->kind == TRK_NODE_TEXT)
        return TRK_OK;
    if (notes->kind != TRK_NODE_LIST)
        return trk_reader_fail_kind(reader, notes, file_subject, "a text or a list of texts");
    TRK_EACH(line, notes)
    if (line->kind != TRK_NODE_TEXT)
        return trk_reader_fail_kind(reader, line, (trk_subject){"the", "notes"}, "a text");
    return TRK_OK;
}

static trk_status check_keys(const trk_reader *reader)
{
    static const char *const others[] = {"truckride_model", "name", "notes", "$schema"};
    enum { OTHERS = sizeof others / sizeof *others };
    TRK_EACH(value, reader->tree.nodes)
    {
        trk_suggestion suggestion = {NULL, 0};
        char tail[TRK_SUGGESTION_ROOM];
        bool known = false;
        for (int k = 0; k < OTHERS + SECTIONS; k++) {
            const char *key = k < OTHERS ? others[k] : sections[k - OTHERS].key;
            known = known || strcmp(value->key, key) == 0;
            trk_suggest(&suggestion, value->key, key);
        }
        if (!known)
            return trk_reader_fail(reader, value->key_place, TRK_E_SYNTAX,
                                   "unknown key '%.80s' in the model file%s", value->key,
                                   trk_suggestion_tail(&suggestion, tail));
    }
    return TRK_OK;
}

/* Name and notes, and nothing that no section knows. */
static trk_status read_head(trk_reader *reader, const char **out_name)
{
    const trk_node *root = reader->tree.nodes, *name;
    const char *schema = NULL;
    *out_name = NULL;
    trk_status status = check_version(reader);
    if (status == TRK_OK)
        status = check_keys(reader);
    if (status == TRK_OK)
        status = trk_reader_text(reader, trk_node_find(root, "$schema"), file_subject, &schema);
    if (status == TRK_OK)
        status = check_notes(reader, trk_node_find(root, "notes"));
    name = status == TRK_OK ? trk_node_find(root, "name") : NULL;
    if (status == TRK_OK && !name)
        status = trk_reader_fail(reader, root->place, TRK_E_SYNTAX, "the model file has no 'name'");
    return status == TRK_OK ? trk_reader_text(reader, name, file_subject, out_name) : status;
}

static trk_status read_tree(trk_reader *reader)
{
    const char *name;
    trk_status status = read_head(reader, &name);
    if (status == TRK_OK)
        status = trk_spec_create(reader->context, name, &reader->spec);
    for (int k = 0; status == TRK_OK && k < SECTIONS; k++)
        status = make_section(reader, &sections[k]);
    return status;
}

static void clear(trk_reader *reader)
{
    trk_context *context = reader->context;
    for (int64_t k = 0; k < reader->curve_count; k++)
        trk_curve_destroy(reader->curves[k]);
    for (int64_t k = 0; k < reader->law_count; k++)
        trk_law_destroy(reader->laws[k]);
    trk_free(context, reader->curves);
    trk_free(context, reader->laws);
    trk_names_clear(context, &reader->curve_names);
    trk_names_clear(context, &reader->law_names);
    trk_tree_clear(&reader->tree);
}

static trk_status parse(trk_context *context, const char *text, size_t length, const char *source,
                        const char *folder, trk_spec **out_spec)
{
    trk_reader reader = {.context = context, .source = source, .folder = folder};
    trk_status status = trk_tree_parse(context, source, text, length, &reader.tree);
    if (status == TRK_OK)
        status = read_tree(&reader);
    if (status == TRK_OK)
        *out_spec = reader.spec;
    else
        trk_spec_destroy(reader.spec);
    clear(&reader);
    return status;
}

trk_status trk_model_file_parse(trk_context *context, const char *text, size_t length,
                                const char *source, const char *folder, trk_spec **out_spec)
{
    TRK_REQUIRE(context, out_spec, "trk_model_file_parse");
    *out_spec = NULL;
    TRK_REQUIRE(context, context, "trk_model_file_parse");
    if (!text && length > 0)
        return trk_fail(context, TRK_E_ARGUMENT, "trk_model_file_parse: text is NULL");
    TRK_REQUIRE(context, source, "trk_model_file_parse");
    return parse(context, text ? text : "", length, source, folder, out_spec);
}

/* Folder of a path: what stands before its last slash, "." if there is none. */
static char *folder_of(trk_context *context, const char *path)
{
    const char *slash = strrchr(path, '/');
    char *folder = trk_copy_text(context, slash ? path : ".");
    if (folder && slash)
        folder[slash == path ? 1 : slash - path] = '\0';
    return folder;
}

trk_status trk_model_file_read(trk_context *context, const char *path, trk_spec **out_spec)
{
    TRK_REQUIRE(context, out_spec, "trk_model_file_read");
    *out_spec = NULL;
    TRK_REQUIRE(context, context, "trk_model_file_read");
    TRK_REQUIRE(context, path, "trk_model_file_read");
    char *text = NULL, *folder = folder_of(context, path);
    size_t length = 0;
    trk_status status =
        folder ? trk_slurp_small(context, path, TRK_TREE_SIZE, &text, &length) : TRK_E_MEMORY;
    if (status == TRK_OK)
        status = parse(context, text, length, path, folder, out_spec);
    trk_free(context, text);
    trk_free(context, folder);
    return status;
}
