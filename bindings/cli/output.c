/* SPDX-License-Identifier: MIT */
/* Opening, checking and closing of what is written. */
#define _POSIX_C_SOURCE 200809L
#include "output.h"
#include "common/stream.h"
#include "common/text.h"

#include <errno.h>
#include <string.h>
#include <sys/stat.h>

static bool is_stream(const char *path)
{
    return !path || strcmp(path, "-") == 0;
}

static int complain(session *s, const char *path)
{
    return session_error(s, "%s: cannot be written (%s)",
                         is_stream(path) ? "standard output" : path, strerror(errno));
}

static FILE *begin(const char *path)
{
    errno = 0;
    return is_stream(path) ? stdout : fopen(path, "w");
}

/* Close, and take back an incomplete file; a device or a pipe stays where it is. */
static int finish(session *s, FILE *file, const char *path)
{
    struct stat about;
    const bool regular = fstat(fileno(file), &about) == 0 && S_ISREG(about.st_mode);
    bool done = fflush(file) == 0 && !ferror(file);
    if (file != stdout)
        done = fclose(file) == 0 && done;
    if (done)
        return EXIT_DONE;
    const int code = complain(s, path);
    if (regular && !is_stream(path))
        remove(path);
    return code;
}

static int32_t format_of(const session *s)
{
    const char *suffix = s->shared->out ? text_suffix(s->shared->out) : "";
    if (s->shared->format != FORMAT_AUTO)
        return s->shared->format;
    return strcmp(suffix, ".csv") == 0    ? FORMAT_CSV
           : strcmp(suffix, ".json") == 0 ? FORMAT_JSON
                                          : FORMAT_TABLE;
}

int output_write(session *s, const char *path, output_writer writer, const void *user)
{
    FILE *file = begin(path);
    if (!file)
        return complain(s, path);
    writer(file, user);
    return finish(s, file, path);
}

typedef struct page {
    int32_t format;
    int count;
    table *const *tables;
} page;

static void write_page(FILE *file, const void *user)
{
    const page *p = user;
    tables_write(file, p->format, p->count, p->tables, may_colour(file));
}

int output_tables(session *s, int count, table *const *tables)
{
    const page p = {format_of(s), count, tables};
    return output_write(s, s->shared->out, write_page, &p);
}

int output_check(session *s, const char *path)
{
    return is_stream(path) || stream_writable(path) ? EXIT_DONE : complain(s, path);
}
