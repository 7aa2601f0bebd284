/* SPDX-License-Identifier: MIT */
/* Stack allocation: what was taken last can be given back alone, all the rest on leaving. */
#include "batch/arena.h"

#include <string.h>

static size_t padded(size_t size)
{
    return (size + 63) / 64 * 64;
}

static void give_back(trk_arena *arena, char *block, size_t size)
{
    if (arena->parent)
        trk_free(arena->parent, block);
    else if (block && block + padded(size) == arena->block + arena->used)
        arena->used -= padded(size);
}

static void *allocate(void *user, void *block, size_t old_size, size_t new_size)
{
    trk_arena *arena = user;
    if (new_size == 0) {
        give_back(arena, block, old_size);
        return NULL;
    }
    size_t room = padded(new_size);
    void *taken;
    if (arena->parent)
        taken = trk_new(arena->parent, (int64_t)room, 1);
    else
        taken = room <= arena->size - arena->used ? arena->block + arena->used : NULL;
    if (!taken)
        return NULL;
    arena->used += room;
    if (block) {
        memcpy(taken, block, old_size < new_size ? old_size : new_size);
        give_back(arena, block, old_size);
    }
    return taken;
}

trk_status trk_arena_enter(trk_arena *arena)
{
    return trk_context_create(allocate, arena, &arena->context);
}

void trk_arena_leave(trk_arena *arena)
{
    trk_context_destroy(arena->context);
    arena->context = NULL;
    if (!arena->parent)
        arena->used = 0;
}
