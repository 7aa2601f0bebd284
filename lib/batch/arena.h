/* SPDX-License-Identifier: MIT */
/*
 * A context of a thread's own in memory that another context gave beforehand: its objects can
 * be created and destroyed in that thread without touching the caller's context.
 */
#ifndef TRK_BATCH_ARENA_H
#define TRK_BATCH_ARENA_H

#include "base/base.h"

typedef struct trk_arena {
    trk_context *parent;  /* not NULL: pass requests on to it and only count them */
    char *block;          /* size bytes, 64 byte aligned                          */
    size_t size, used;    /* used: of block, or all that was asked for so far     */
    trk_context *context; /* NULL outside of enter and leave                      */
} trk_arena;

/* A new context in the arena. TRK_E_MEMORY: it does not fit. Leaving it frees what it holds. */
trk_status trk_arena_enter(trk_arena *arena);
void trk_arena_leave(trk_arena *arena);

#endif
