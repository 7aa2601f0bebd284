/* SPDX-License-Identifier: MIT */
/* A JSON text as a tree whose values and keys know their lines and columns. */
#ifndef TRK_MODELFILE_TREE_H
#define TRK_MODELFILE_TREE_H

#include "base/base.h"

typedef enum trk_node_kind {
    TRK_NODE_NULL,
    TRK_NODE_TRUTH,
    TRK_NODE_NUMBER,
    TRK_NODE_TEXT,
    TRK_NODE_LIST,
    TRK_NODE_GROUP
} trk_node_kind;

/* Line and column from 1; columns count bytes. */
typedef struct trk_place {
    int32_t line, column;
} trk_place;

/* A value; its descendants follow it in the order of the text. */
typedef struct trk_node {
    const char *key;     /* of a value in a group, else NULL              */
    const char *text;    /* of a text                                     */
    double number;       /* of a number; 1 or 0 for true and false        */
    trk_place place;     /* of the value                                  */
    trk_place key_place; /* of the key; of the value if there is none     */
    int32_t span;        /* number of nodes from this to its last descendant */
    int32_t kind;        /* trk_node_kind                                 */
} trk_node;

/* Every value directly inside of a list or group. */
#define TRK_EACH(child, node)                                                                      \
    for (const trk_node *child = (node) + 1; child < (node) + (node)->span; child += child->span)

typedef struct trk_tree {
    trk_context *context;
    const char *source; /* for messages   */
    trk_node *nodes;    /* [0]: the whole */
    char *texts;
} trk_tree;

/* Limits of a text, for those who nest a million brackets. */
enum { TRK_TREE_DEPTH = 32, TRK_TREE_SIZE = 1 << 26 };

/* TRK_E_SYNTAX, TRK_E_MEMORY, TRK_E_UNSUPPORTED; *out_tree is to be cleared in any case. */
trk_status trk_tree_parse(trk_context *context, const char *source, const char *text, size_t length,
                          trk_tree *out_tree);
void trk_tree_clear(trk_tree *tree);

/* Number of values directly inside; the one with that key, or NULL. */
int32_t trk_node_count(const trk_node *node);
const trk_node *trk_node_find(const trk_node *node, const char *key);

/* "a number", "a list". */
const char *trk_node_word(const trk_node *node);

#endif
