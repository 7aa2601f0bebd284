/* SPDX-License-Identifier: MIT */
/* Before writing; and through a temporary file to standard output, which may be no file itself. */
#define _POSIX_C_SOURCE 200809L
#include "common/stream.h"
#include "common/text.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

bool stream_writable(const char *path)
{
    struct stat about;
    if (access(path, W_OK) == 0) {
        errno = EISDIR;
        return stat(path, &about) != 0 || !S_ISDIR(about.st_mode);
    }
    if (errno != ENOENT || !*path)
        return false;
    char *folder = text_copy(path), *slash = strrchr(folder, '/');
    if (slash)
        slash[1] = 0;
    const bool writable = access(slash ? folder : ".", W_OK) == 0;
    const int reason = errno;
    free(folder);
    errno = reason;
    return writable;
}

bool stream_temporary(char *path, size_t room)
{
    const char *folder = getenv("TMPDIR");
    const int length =
        snprintf(path, room, "%s/truckride-XXXXXX", folder && *folder ? folder : "/tmp");
    if (length < 0 || (size_t)length >= room) {
        errno = ENAMETOOLONG;
        return false;
    }
    const int file = mkstemp(path);
    return file >= 0 && close(file) == 0;
}

bool stream_to_stdout(const char *path)
{
    char buffer[1 << 14];
    FILE *file = fopen(path, "rb");
    unlink(path); /* now, in case a signal ends the copying */
    if (!file)
        return false;
    errno = 0;
    size_t size;
    while ((size = fread(buffer, 1, sizeof buffer, file)) > 0)
        if (fwrite(buffer, 1, size, stdout) < size)
            break;
    const bool done = !ferror(file) && fflush(stdout) == 0 && !ferror(stdout);
    const int reason = errno;
    fclose(file);
    errno = reason;
    return done;
}
