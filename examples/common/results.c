/* SPDX-License-Identifier: MIT */
/* Failures end an example; results go into files. */
#include "common/common.h"

#include <stdarg.h>
#include <stdlib.h>

void check(trk_context *context, trk_status status)
{
    if (status == TRK_OK)
        return;
    fprintf(stderr, "%s: %s\n", trk_status_text(status), trk_context_message(context));
    exit(1);
}

void *allocate(size_t size)
{
    void *block = malloc(size);
    if (!block) {
        perror("malloc");
        exit(1);
    }
    return block;
}

FILE *open_result(const char *directory, const char *name)
{
    char path[4096];
    snprintf(path, sizeof path, "%s/%s", directory, name);
    FILE *file = fopen(path, "w");
    if (!file) {
        perror(path);
        exit(1);
    }
    return file;
}

void print_both(FILE *file, const char *format, ...)
{
    va_list arguments, again;
    va_start(arguments, format);
    va_copy(again, arguments);
    vfprintf(stdout, format, arguments);
    vfprintf(file, format, again);
    va_end(again);
    va_end(arguments);
}
