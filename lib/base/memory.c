/* SPDX-License-Identifier: MIT */
/* Aligned, zeroed, counted memory on top of the context's one allocation function. */
#include "base/context.h"

#include <string.h>

enum { ALIGNMENT = 64 };

/* Stands right below every block handed out. */
typedef struct header {
    void *base;        /* what the allocation function returned */
    size_t total_size; /* what it was asked for                 */
} header;

static header *header_of(void *block)
{
    return (header *)((char *)block - sizeof(header));
}

void *trk_new(trk_context *context, int64_t count, size_t element_size)
{
    const size_t overhead = ALIGNMENT + sizeof(header);
    if (count < 0 || (element_size && (uint64_t)count > (PTRDIFF_MAX - overhead) / element_size)) {
        trk_fail(context, TRK_E_MEMORY,
                 "out of memory: %lld elements of %zu bytes exceed the address space",
                 (long long)count, element_size);
        return NULL;
    }
    size_t size = (size_t)count * element_size;
    void *base = context->allocate(context->allocate_user, NULL, 0, size + overhead);
    if (!base) {
        trk_fail(context, TRK_E_MEMORY, "out of memory: %zu bytes were refused", size);
        return NULL;
    }
    uintptr_t first = (uintptr_t)base + sizeof(header);
    char *block = (char *)base + sizeof(header) + (ALIGNMENT - first % ALIGNMENT) % ALIGNMENT;
    *header_of(block) = (header){base, size + overhead};
    memset(block, 0, size);
    context->blocks++;
    return block;
}

void trk_free(trk_context *context, void *block)
{
    if (!block)
        return;
    header h = *header_of(block);
    context->allocate(context->allocate_user, h.base, h.total_size, 0);
    context->blocks--;
}

trk_status trk_grow(trk_context *context, void **block, int64_t *capacity, int64_t count,
                    size_t element_size)
{
    if (count <= *capacity)
        return TRK_OK;
    int64_t wanted = *capacity < 8 ? 8 : 2 * *capacity;
    if (wanted < count)
        wanted = count;
    void *larger = trk_new(context, wanted, element_size);
    if (!larger)
        return TRK_E_MEMORY;
    if (*block)
        memcpy(larger, *block, (size_t)*capacity * element_size);
    trk_free(context, *block);
    *block = larger;
    *capacity = wanted;
    return TRK_OK;
}

char *trk_copy_text(trk_context *context, const char *text)
{
    size_t size = strlen(text) + 1;
    char *copy = trk_new(context, (int64_t)size, 1);
    if (copy)
        memcpy(copy, text, size);
    return copy;
}
