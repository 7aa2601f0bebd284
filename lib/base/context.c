/* SPDX-License-Identifier: MIT */
/* Contexts and their messages. */
#define _DEFAULT_SOURCE /* madvise */
#include "base/context.h"

#include <stdlib.h>
#include <string.h>
#if defined(__linux__)
#include <sys/mman.h>
#endif

/* A long run writes its samples faster than 4 KiB pages of fresh memory are handed out. */
static void prefer_huge_pages(void *block, size_t size)
{
#if defined(MADV_HUGEPAGE)
    const uintptr_t huge = 2u << 20;
    uintptr_t first = ((uintptr_t)block + huge - 1) / huge * huge,
              end = ((uintptr_t)block + size) / huge * huge;
    if (block && size >= 2 * huge)
        (void)madvise((void *)first, end - first, MADV_HUGEPAGE); /* advice: may be refused */
#else
    (void)block;
    (void)size;
#endif
}

static void *default_allocate(void *user, void *block, size_t old_size, size_t new_size)
{
    (void)user;
    (void)old_size;
    if (new_size == 0) {
        free(block);
        return NULL;
    }
    void *fresh = realloc(block, new_size);
    prefer_huge_pages(fresh, new_size);
    return fresh;
}

trk_status trk_context_create(trk_allocate allocate, void *user, trk_context **out_context)
{
    if (!out_context)
        return TRK_E_ARGUMENT;
    *out_context = NULL;
    if (!allocate)
        allocate = default_allocate;
    trk_context *context = allocate(user, NULL, 0, sizeof *context);
    if (!context)
        return TRK_E_MEMORY;
    memset(context, 0, sizeof *context);
    context->allocate = allocate;
    context->allocate_user = user;
    *out_context = context;
    return TRK_OK;
}

void trk_context_destroy(trk_context *context)
{
    if (context)
        context->allocate(context->allocate_user, context, sizeof *context, 0);
}

void trk_context_set_log(trk_context *context, trk_log log, void *user)
{
    if (context) {
        context->log = log;
        context->log_user = user;
    }
}

const char *trk_context_message(const trk_context *context)
{
    return context ? context->message : "no context";
}

int64_t trk_context_blocks(const trk_context *context)
{
    return context ? context->blocks : 0;
}

trk_status trk_fail(trk_context *context, trk_status status, const char *format, ...)
{
    if (context) {
        char text[TRK_MESSAGE_SIZE]; /* the last message may be among the arguments */
        va_list arguments;
        va_start(arguments, format);
        trk_format_list(text, sizeof text, format, arguments);
        va_end(arguments);
        memcpy(context->message, text, sizeof text);
    }
    return status;
}

trk_status trk_fail_within(trk_context *context, trk_status status, const char *format, ...)
{
    if (context) {
        char inner[TRK_MESSAGE_SIZE], where[TRK_MESSAGE_SIZE / 2];
        memcpy(inner, context->message, sizeof inner);
        va_list arguments;
        va_start(arguments, format);
        trk_format_list(where, sizeof where, format, arguments);
        va_end(arguments);
        /* Cut where the buffer ends: the place is in front, so it is never what is lost. */
        size_t used = strlen(where);
        memcpy(context->message, where, used);
        trk_format(context->message + used, sizeof context->message - used, ": %s", inner);
    }
    return status;
}

void trk_note(trk_context *context, const char *format, ...)
{
    if (!context || !context->log)
        return;
    char text[TRK_MESSAGE_SIZE];
    va_list arguments;
    va_start(arguments, format);
    trk_format_list(text, sizeof text, format, arguments);
    va_end(arguments);
    context->log(context->log_user, text);
}
