/* SPDX-License-Identifier: MIT */
/* The allocator of the fuzzers, and their checks. */
#include "fuzz.h"

#include <stdio.h>
#include <stdlib.h>

static size_t limit, used;

void fuzz_check(int holds, const char *what)
{
    if (!holds) {
        fprintf(stderr, "fuzz: %s\n", what);
        abort();
    }
}

static void *allocate(void *user, void *block, size_t old_size, size_t new_size)
{
    (void)user;
    used += new_size - (block ? old_size : 0);
    fuzz_check(used <= limit, "more memory than the bytes justify");
    if (new_size == 0) {
        free(block);
        return NULL;
    }
    return realloc(block, new_size);
}

trk_context *fuzz_begin(size_t size)
{
    trk_context *context;
    used = 0;
    limit = 20000 + 64 * size;
    fuzz_check(trk_context_create(allocate, NULL, &context) == TRK_OK, "no context");
    return context;
}

void fuzz_end(trk_context *context)
{
    fuzz_check(trk_context_blocks(context) == 0, "memory leaked");
    trk_context_destroy(context);
}
