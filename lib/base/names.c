/* SPDX-License-Identifier: MIT */
/* Hashed list of names. */
#include "base/names.h"

#include <string.h>

/* FNV-1a, 32 bit. */
static uint32_t hash(const char *text)
{
    uint32_t h = 2166136261u;
    for (; *text; text++)
        h = (h ^ (unsigned char)*text) * 16777619u;
    return h;
}

/* Place of the name, or the empty place where it belongs. */
static uint32_t place_of(const trk_names *names, const char *name)
{
    uint32_t mask = (uint32_t)names->buckets - 1;
    uint32_t place = hash(name) & mask;
    while (names->bucket[place] && strcmp(names->text[names->bucket[place] - 1], name) != 0)
        place = (place + 1) & mask;
    return place;
}

static trk_status rehash(trk_context *context, trk_names *names)
{
    int32_t buckets = names->buckets ? 2 * names->buckets : 16;
    int32_t *bucket = trk_new(context, buckets, sizeof *bucket);
    if (!bucket)
        return TRK_E_MEMORY;
    trk_free(context, names->bucket);
    names->bucket = bucket;
    names->buckets = buckets;
    for (int32_t id = 1; id <= names->count; id++)
        bucket[place_of(names, names->text[id - 1])] = id;
    return TRK_OK;
}

trk_status trk_names_add(trk_context *context, trk_names *names, const char *what, const char *name)
{
    if (!name || !*name)
        return trk_fail(context, TRK_E_NAME, "a %s needs a name", what);
    if (trk_names_find(names, name))
        return trk_fail(context, TRK_E_NAME, "%s name '%s' is already used", what, name);
    trk_status status = trk_grow(context, (void **)&names->text, &names->capacity,
                                 (int64_t)names->count + 1, sizeof *names->text);
    if (status == TRK_OK && 2 * (names->count + 1) >= names->buckets)
        status = rehash(context, names);
    if (status != TRK_OK)
        return status;
    char *copy = trk_copy_text(context, name);
    if (!copy)
        return TRK_E_MEMORY;
    names->bucket[place_of(names, name)] = names->count + 1;
    names->text[names->count++] = copy;
    return TRK_OK;
}

/* The last name stands at the end of every chain of places that it is in: no chain breaks. */
void trk_names_shorten(trk_context *context, trk_names *names, int32_t count)
{
    while (names->count > count) {
        char *text = names->text[names->count - 1];
        names->bucket[place_of(names, text)] = 0;
        names->count--;
        trk_free(context, text);
    }
}

int32_t trk_names_find(const trk_names *names, const char *name)
{
    return name && names->buckets ? names->bucket[place_of(names, name)] : 0;
}

const char *trk_names_text(const trk_names *names, int32_t id)
{
    return id >= 1 && id <= names->count ? names->text[id - 1] : NULL;
}

trk_status trk_names_copy(trk_context *context, const trk_names *from, trk_names *to)
{
    for (int32_t id = 1; id <= from->count; id++) {
        trk_status status = trk_names_add(context, to, "part", from->text[id - 1]);
        if (status != TRK_OK) {
            trk_names_clear(context, to);
            return status;
        }
    }
    return TRK_OK;
}

void trk_names_clear(trk_context *context, trk_names *names)
{
    for (int32_t id = 1; id <= names->count; id++)
        trk_free(context, names->text[id - 1]);
    trk_free(context, names->text);
    trk_free(context, names->bucket);
    memset(names, 0, sizeof *names);
}
