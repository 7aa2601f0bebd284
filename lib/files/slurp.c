/* SPDX-License-Identifier: MIT */
/* A whole regular file in memory, as large as the file system says it is. */
#define _POSIX_C_SOURCE 200809L
#include "files/slurp.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static trk_status fail(trk_context *context, const char *path, int error)
{
    char reason[256] = "";
    trk_locale locale;
    trk_locale_enter(&locale);
    strerror_r(error, reason, sizeof reason);
    trk_locale_leave(&locale);
    return trk_fail(context, TRK_E_FILE, "%s: cannot be read (%s)", path, reason);
}

static trk_status read_file(trk_context *context, const char *path, FILE *file, int64_t most,
                            char **out_bytes, size_t *out_size)
{
    struct stat about;
    if (fstat(fileno(file), &about) != 0)
        return fail(context, path, errno);
    if (!S_ISREG(about.st_mode))
        return trk_fail(context, TRK_E_FILE, "%s: cannot be read (it is no regular file)", path);
    if ((intmax_t)about.st_size > most)
        return trk_fail(context, TRK_E_FILE,
                        "%s: cannot be read (it has %jd bytes, expected at most %jd)", path,
                        (intmax_t)about.st_size, (intmax_t)most);
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

/* Opening a pipe that nobody writes to must not wait: it is refused like all that is no file. */
static FILE *open_file(const char *path)
{
    const int descriptor = open(path, O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    FILE *file = descriptor < 0 ? NULL : fdopen(descriptor, "rb");
    if (!file && descriptor >= 0)
        close(descriptor);
    return file;
}

trk_status trk_slurp_small(trk_context *context, const char *path, int64_t most, char **out_bytes,
                           size_t *out_size)
{
    *out_bytes = NULL;
    *out_size = 0;
    FILE *file = open_file(path);
    if (!file)
        return fail(context, path, errno);
    trk_status status = read_file(context, path, file, most, out_bytes, out_size);
    fclose(file);
    return status;
}

trk_status trk_slurp(trk_context *context, const char *path, char **out_bytes, size_t *out_size)
{
    return trk_slurp_small(context, path, INT64_MAX, out_bytes, out_size);
}
