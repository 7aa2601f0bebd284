/* SPDX-License-Identifier: MIT */
/* A whole regular file in memory, as large as the file system says it is. */
#define _POSIX_C_SOURCE 200809L
#include "files/slurp.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

static trk_status fail(trk_context *context, const char *path, int error)
{
    char reason[256] = "";
    trk_locale locale;
    trk_locale_enter(&locale);
    strerror_r(error, reason, sizeof reason);
    trk_locale_leave(&locale);
    return trk_fail(context, TRK_E_FILE, "%s: cannot be read (%s)", path, reason);
}

static trk_status read_file(trk_context *context, const char *path, FILE *file, char **out_bytes,
                            size_t *out_size)
{
    struct stat about;
    if (fstat(fileno(file), &about) != 0)
        return fail(context, path, errno);
    if (!S_ISREG(about.st_mode))
        return trk_fail(context, TRK_E_FILE, "%s: cannot be read (it is no regular file)", path);
    char *bytes = trk_new(context, (int64_t)about.st_size, 1);
    if (!bytes)
        return TRK_E_MEMORY;
    errno = 0;
    *out_size = fread(bytes, 1, (size_t)about.st_size, file);
    if (ferror(file)) {
        trk_free(context, bytes);
        return fail(context, path, errno ? errno : EIO);
    }
    *out_bytes = bytes;
    return TRK_OK;
}

trk_status trk_slurp(trk_context *context, const char *path, char **out_bytes, size_t *out_size)
{
    *out_bytes = NULL;
    *out_size = 0;
    FILE *file = fopen(path, "rb");
    if (!file)
        return fail(context, path, errno);
    trk_status status = read_file(context, path, file, out_bytes, out_size);
    fclose(file);
    return status;
}
