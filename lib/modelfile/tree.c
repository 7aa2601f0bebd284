/* SPDX-License-Identifier: MIT */
/* JSON by jansson, and where in the text each of its values stands. */
#include "modelfile/tree.h"

#include <string.h>

#include "modelfile/scan.h"

void trk_tree_clear(trk_tree *tree)
{
    trk_free(tree->context, tree->nodes);
    trk_free(tree->context, tree->texts);
    tree->nodes = NULL;
    tree->texts = NULL;
}

int32_t trk_node_count(const trk_node *node)
{
    int32_t count = 0;
    TRK_EACH(child, node)
    count++;
    return count;
}

const trk_node *trk_node_find(const trk_node *node, const char *key)
{
    TRK_EACH(child, node)
    if (child->key && strcmp(child->key, key) == 0)
        return child;
    return NULL;
}

const char *trk_node_word(const trk_node *node)
{
    static const char *const words[] = {"null",   "true or false", "a number",
                                        "a text", "a list",        "a group {...}"};
    return words[node->kind];
}

#ifdef TRUCKRIDE_WITH_JSON
#include <jansson.h>

#include "base/number.h"

/* Fills the nodes from jansson's tree while walking along in the text. */
typedef struct filler {
    trk_scan scan;
    trk_node *next;
    char *text;
} filler;

static const char *keep(filler *f, const char *text, size_t length)
{
    char *copy = f->text;
    memcpy(copy, text, length);
    f->text += length + 1; /* the pool is zeroed */
    return copy;
}

static void fill(filler *f, const json_t *value, const char *key, trk_place key_place);

/* jansson keeps the order in which keys were read. */
static void fill_group(filler *f, const json_t *value)
{
    const char *key;
    json_t *member;
    json_object_foreach((json_t *)value, key, member)
    {
        trk_scan_blanks(&f->scan);
        const trk_place place = trk_scan_place(&f->scan);
        trk_scan_token(&f->scan);
        fill(f, member, keep(f, key, strlen(key)), place);
    }
}

static void fill_list(filler *f, const json_t *value)
{
    for (size_t k = 0; k < json_array_size(value); k++)
        fill(f, json_array_get(value, k), NULL, (trk_place){0, 0});
}

static void fill(filler *f, const json_t *value, const char *key, trk_place key_place)
{
    trk_node *node = f->next++;
    trk_scan_blanks(&f->scan);
    const char *token = f->scan.at;
    node->place = trk_scan_place(&f->scan);
    node->key = key;
    node->key_place = key ? key_place : node->place;
    trk_scan_token(&f->scan);
    switch (json_typeof(value)) {
    case JSON_OBJECT:
        node->kind = TRK_NODE_GROUP;
        fill_group(f, value);
        break;
    case JSON_ARRAY:
        node->kind = TRK_NODE_LIST;
        fill_list(f, value);
        break;
    case JSON_STRING:
        node->kind = TRK_NODE_TEXT;
        node->text = keep(f, json_string_value(value), json_string_length(value));
        break;
    case JSON_INTEGER:
    case JSON_REAL:
        node->kind = TRK_NODE_NUMBER;
        trk_number_read(token, f->scan.at, '.', &node->number); /* correctly rounded (BASE.1) */
        break;
    case JSON_TRUE:
    case JSON_FALSE:
        node->kind = TRK_NODE_TRUTH;
        node->number = json_is_true(value);
        break;
    case JSON_NULL: node->kind = TRK_NODE_NULL; break;
    }
    if (node->kind >= TRK_NODE_LIST) {
        trk_scan_blanks(&f->scan);
        trk_scan_token(&f->scan); /* the closing bracket */
    }
    node->span = (int32_t)(f->next - node);
}

static bool begins(const char *text, const char *word)
{
    return strncmp(text, word, strlen(word)) == 0;
}

/* jansson has read to the end of the token, or to the byte, that it does not like. */
static trk_status refuse(const trk_tree *tree, const char *text, size_t length,
                         const json_error_t *error)
{
    const enum json_error_code code = json_error_code(error);
    if (code == json_error_out_of_memory)
        return trk_fail(tree->context, TRK_E_MEMORY, "%s: out of memory", tree->source);
    const bool inside =
        code == json_error_invalid_utf8 || code == json_error_premature_end_of_input ||
        begins(error->text, "unexpected newline") || begins(error->text, "control character");
    size_t position = error->position > 0 ? (size_t)error->position : 0;
    const bool escape = begins(error->text, "invalid escape");
    while (escape && position > 0 && text[position] != '\\')
        position--;
    const trk_place place = trk_scan_blame(text, length, position, inside || escape);
    return trk_fail(tree->context, TRK_E_SYNTAX, "%s:%d:%d: %s", tree->source, (int)place.line,
                    (int)place.column, error->text);
}

static trk_status build(trk_tree *tree, const char *text, size_t length, int64_t values,
                        const json_t *json)
{
    tree->nodes = trk_new(tree->context, values, sizeof *tree->nodes);
    tree->texts = trk_new(tree->context, (int64_t)length + 1, 1);
    if (!tree->nodes || !tree->texts)
        return TRK_E_MEMORY;
    filler f = {trk_scan_begin(text, length), tree->nodes, tree->texts};
    fill(&f, json, NULL, (trk_place){0, 0});
    return TRK_OK;
}

trk_status trk_tree_parse(trk_context *context, const char *source, const char *text, size_t length,
                          trk_tree *out_tree)
{
    json_error_t error;
    int64_t values;
    trk_place place;
    *out_tree = (trk_tree){context, source, NULL, NULL};
    const char *wrong = trk_scan_admit(text, length, &values, &place);
    if (wrong)
        return trk_fail(context, TRK_E_SYNTAX, "%s:%d:%d: %s", source, (int)place.line,
                        (int)place.column, wrong);
    json_t *json =
        json_loadb(text, length, JSON_REJECT_DUPLICATES | JSON_DECODE_INT_AS_REAL, &error);
    if (!json)
        return refuse(out_tree, text, length, &error);
    trk_status status = build(out_tree, text, length, values, json);
    json_decref(json);
    return status;
}

#else

trk_status trk_tree_parse(trk_context *context, const char *source, const char *text, size_t length,
                          trk_tree *out_tree)
{
    (void)text;
    (void)length;
    *out_tree = (trk_tree){context, source, NULL, NULL};
    return trk_fail(context, TRK_E_UNSUPPORTED,
                    "%s: this build has no jansson and reads no model files", source);
}

#endif
