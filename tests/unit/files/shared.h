/* SPDX-License-Identifier: MIT */
/* Measured files beside the project, and parsing of literal texts. */
#ifndef TRK_TESTS_FILES_SHARED_H
#define TRK_TESTS_FILES_SHARED_H

#include "support.h"

/*
 * Bytes of a file of shared/data beside the project, which __FILE__ of the caller names (tests run
 * in the build directory); `below` is the caller's own path in the project. NULL: not there.
 */
static inline char *shared_file(const char *source, const char *below, const char *name,
                                size_t *out_size)
{
    char path[4096];
    snprintf(path, sizeof path, "%.*s../shared/data/%s", (int)(strlen(source) - strlen(below)),
             source, name);
    FILE *file = fopen(path, "rb");
    if (!file) {
        print_message("skipped: %s is not there\n", name);
        return NULL;
    }
    fseek(file, 0, SEEK_END);
    *out_size = (size_t)ftell(file);
    rewind(file);
    char *bytes = malloc(*out_size + 1);
    assert_int_equal(fread(bytes, 1, *out_size, file), *out_size);
    fclose(file);
    return bytes;
}

#endif
