/* SPDX-License-Identifier: MIT */
/* The journal: finished cases in a file, line by line. */
#define _POSIX_C_SOURCE 200809L
#include "study/line.h"

#include <errno.h>
#include <fcntl.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* A file on its way into a study. */
typedef struct reader {
    trk_study *study;
    const char *path;
    FILE *file;
    char *line;
    int64_t room;
    double *values;
    int64_t number;   /* of the line, from 1                          */
    int64_t damaged;  /* number of the first damaged line, 0: none     */
    int64_t good_end; /* [byte] end of the last good line             */
} reader;

static trk_status fail_file(const trk_study *study, const char *path, const char *what, int error)
{
    char reason[256] = "";
    strerror_r(error, reason, sizeof reason);
    return trk_fail(study->context, TRK_E_FILE, "%s: cannot be %s (%s)", path, what, reason);
}

/*
 * Next line without its line feed. false at the end. *out_whole: it ended with a line
 * feed, has no 0 in it and fits; what does not is skipped, but in the first line that is
 * the end: /dev/zero has no other.
 */
static bool next_line(reader *r, bool *out_whole, int64_t *out_length)
{
    int64_t length = 0;
    bool clean = true;
    int c;
    while ((c = getc(r->file)) != EOF && c != '\n') {
        if (length < r->room - 1)
            r->line[length] = (char)c;
        clean = clean && c != 0;
        length++;
        if (r->number == 0 && length >= r->room)
            break;
    }
    const bool fits = length < r->room;
    r->line[fits ? length : 0] = 0;
    *out_whole = c == '\n' && clean && fits;
    *out_length = length + (c == '\n');
    r->number++;
    return *out_length > 0;
}

/* A file that breaks off within its first line, while a run began, is as good as empty. */
static bool is_begun_header(const reader *r, int64_t length)
{
    char *own = r->line + r->room; /* the second half of the buffer */
    return trk_line_header(r->study, own) > length && memcmp(own, r->line, (size_t)length) == 0;
}

static trk_status read_header(reader *r, bool *out_empty)
{
    bool whole;
    int64_t length;
    *out_empty = !next_line(r, &whole, &length);
    if (*out_empty)
        return TRK_OK;
    if (!whole) {
        *out_empty = length < r->room && is_begun_header(r, length);
        return *out_empty ? TRK_OK
                          : trk_fail(r->study->context, TRK_E_SYNTAX,
                                     "%s:1: this is no journal of a study", r->path);
    }
    r->good_end = length;
    switch (trk_line_read_header(r->study, r->line)) {
    case TRK_LINE_GOOD: return TRK_OK;
    case TRK_LINE_FOREIGN:
        return trk_fail(r->study->context, TRK_E_ARGUMENT,
                        "%s: this is the journal of another study, or of this study with other "
                        "options, parameters, roads, outputs or library version",
                        r->path);
    default:
        return trk_fail(r->study->context, TRK_E_SYNTAX, "%s:1: this is no journal of a study",
                        r->path);
    }
}

static trk_status take_case(reader *r, int64_t number, trk_status outcome)
{
    trk_study *study = r->study;
    if (!study->state[number]) {
        trk_study_store(study, number, outcome, r->values);
        return r->file == study->journal.file ? TRK_OK : trk_journal_append(study, number);
    }
    if (trk_study_agrees(study, number, outcome, r->values))
        return TRK_OK;
    return trk_fail(study->context, TRK_E_SYNTAX,
                    "%s:%lld: case %lld has another result here than it had before", r->path,
                    (long long)r->number, (long long)number);
}

static trk_status read_cases(reader *r)
{
    trk_context *context = r->study->context;
    bool whole;
    int64_t length, end = r->good_end;
    trk_status status = TRK_OK;
    while (status == TRK_OK && next_line(r, &whole, &length)) {
        int64_t number;
        trk_status outcome;
        trk_line_kind kind = TRK_LINE_DAMAGED;
        end += length;
        if (whole)
            kind = trk_line_read_case(r->study, r->line, &number, &outcome, r->values);
        if (kind == TRK_LINE_DAMAGED) {
            r->damaged = r->damaged ? r->damaged : r->number;
            continue;
        }
        if (r->damaged)
            return trk_fail(context, TRK_E_SYNTAX,
                            "%s:%lld: the line is damaged, but good ones follow; delete it, and "
                            "its case will be run again",
                            r->path, (long long)r->damaged);
        if (kind == TRK_LINE_FOREIGN)
            return trk_fail(context, TRK_E_ARGUMENT,
                            "%s:%lld: there is case %lld, but the study ends with case %lld",
                            r->path, (long long)r->number, (long long)number,
                            (long long)trk_study_cases(r->study) - 1);
        r->good_end = end;
        status = take_case(r, number, outcome);
    }
    return status;
}

/* Read a whole journal. *out_end: end of its good lines, 0 if not even the first is whole. */
static trk_status read_journal(trk_study *study, const char *path, FILE *file, int64_t *out_end)
{
    reader r = {.study = study, .path = path, .file = file, .room = trk_line_room(study)};
    *out_end = 0;
    r.line = trk_new(study->context, 2 * r.room, 1);
    r.values = trk_new(study->context, trk_study_outputs(study), sizeof *r.values);
    trk_status status = r.line && r.values ? TRK_OK : TRK_E_MEMORY;
    bool empty = false;
    trk_locale locale;
    trk_locale_enter(&locale);
    errno = 0;
    if (status == TRK_OK)
        status = read_header(&r, &empty);
    if (status == TRK_OK && !empty)
        status = read_cases(&r);
    if (status == TRK_OK && ferror(file))
        status = fail_file(study, path, "read", errno ? errno : EIO);
    trk_locale_leave(&locale);
    if (status == TRK_OK && r.damaged)
        trk_note(study->context,
                 "%s: damaged from line %lld on, as by an interrupted run; the "
                 "cases there count as not finished",
                 path, (long long)r.damaged);
    *out_end = r.good_end;
    trk_free(study->context, r.line);
    trk_free(study->context, r.values);
    return status;
}

trk_status trk_study_load(trk_study *study, const char *path)
{
    static const char what[] = "trk_study_load";
    TRK_REQUIRE(NULL, study, "trk_study_load");
    TRK_REQUIRE(study->context, path, "trk_study_load");
    trk_status status = trk_study_prepare(study, what);
    if (status != TRK_OK)
        return status;
    FILE *file = fopen(path, "rb");
    if (!file)
        return fail_file(study, path, "read", errno);
    int64_t end;
    status = read_journal(study, path, file, &end);
    fclose(file);
    const trk_status flushed = trk_journal_flush(study);
    return status == TRK_OK ? flushed : status;
}

static trk_status write_line(trk_study *study, int64_t length)
{
    trk_journal *journal = &study->journal;
    if (journal->broken)
        return trk_fail(study->context, TRK_E_FILE, "%s: an earlier line could not be written",
                        journal->path);
    errno = 0;
    if (fwrite(journal->line, 1, (size_t)length, journal->file) == (size_t)length)
        return TRK_OK;
    journal->broken = true;
    return fail_file(study, journal->path, "written", errno ? errno : EIO);
}

trk_status trk_journal_append(trk_study *study, int64_t number)
{
    if (!study->journal.file)
        return TRK_OK;
    trk_locale locale;
    trk_locale_enter(&locale);
    const int64_t length = trk_line_case(study, number, study->journal.line);
    trk_locale_leave(&locale);
    return write_line(study, length);
}

trk_status trk_journal_flush(trk_study *study)
{
    trk_journal *journal = &study->journal;
    errno = 0;
    if (!journal->file || journal->broken || fflush(journal->file) == 0)
        return TRK_OK;
    journal->broken = true;
    return fail_file(study, journal->path, "written", errno ? errno : EIO);
}

/* Opened for reading and appending, locked against other processes. */
static trk_status open_file(trk_study *study, const char *path, FILE **out_file)
{
    *out_file = NULL;
    const int descriptor = open(path, O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (descriptor < 0)
        return fail_file(study, path, "opened", errno);
    struct stat about;
    if (fstat(descriptor, &about) != 0 || !S_ISREG(about.st_mode)) {
        close(descriptor);
        return trk_fail(study->context, TRK_E_FILE, "%s: a journal must be a regular file", path);
    }
    /* Some network file systems know no locks; they give other errors. */
    struct flock lock = {.l_type = F_WRLCK, .l_whence = SEEK_SET};
    if (fcntl(descriptor, F_SETLK, &lock) != 0 && (errno == EAGAIN || errno == EACCES)) {
        close(descriptor);
        return trk_fail(study->context, TRK_E_FILE, "%s: another process is using this journal",
                        path);
    }
    *out_file = fdopen(descriptor, "r+b");
    if (*out_file)
        return TRK_OK;
    const int error = errno;
    close(descriptor);
    return fail_file(study, path, "opened", error);
}

/* Cut off what is damaged and bring the file to what the study knows. `held` cases were there. */
static trk_status begin(trk_study *study, int64_t end, int64_t held)
{
    trk_journal *journal = &study->journal;
    if (fflush(journal->file) != 0 || ftruncate(fileno(journal->file), (off_t)end) != 0 ||
        fseeko(journal->file, 0, SEEK_END) != 0)
        return fail_file(study, journal->path, "written", errno);
    trk_status status = TRK_OK;
    if (end == 0)
        status = write_line(study, trk_line_header(study, journal->line));
    /* Cases that were finished before and are not in the file: which, is not known. */
    for (int64_t k = 0; held < study->finished && status == TRK_OK && k < trk_study_cases(study);
         k++)
        if (study->state[k])
            status = trk_journal_append(study, k);
    return status == TRK_OK ? trk_journal_flush(study) : status;
}

trk_status trk_study_open_journal(trk_study *study, const char *path)
{
    static const char what[] = "trk_study_open_journal";
    TRK_REQUIRE(NULL, study, "trk_study_open_journal");
    trk_context *context = study->context;
    TRK_REQUIRE(context, path, "trk_study_open_journal");
    trk_journal *journal = &study->journal;
    if (journal->file)
        return trk_fail(context, TRK_E_ARGUMENT, "%s: the journal %s is open", what, journal->path);
    trk_status status = trk_study_prepare(study, what);
    if (status != TRK_OK)
        return status;
    const int64_t before = study->finished;
    int64_t end = 0;
    journal->broken = false;
    journal->path = trk_copy_text(context, path);
    journal->line = trk_new(context, trk_line_room(study), 1);
    status = journal->path && journal->line ? open_file(study, path, &journal->file) : TRK_E_MEMORY;
    if (status == TRK_OK)
        status = read_journal(study, path, journal->file, &end);
    if (status == TRK_OK) /* without earlier results the file holds all of them */
        status = begin(study, end, before == 0 ? study->finished : 0);
    if (status != TRK_OK) {
        if (journal->file)
            fclose(journal->file);
        trk_free(context, journal->path);
        trk_free(context, journal->line);
        *journal = (trk_journal){0};
    }
    return status;
}

trk_status trk_study_close_journal(trk_study *study)
{
    TRK_REQUIRE(NULL, study, "trk_study_close_journal");
    trk_journal *journal = &study->journal;
    trk_status status = trk_journal_flush(study);
    errno = 0;
    if (journal->file && fclose(journal->file) != 0 && status == TRK_OK && !journal->broken)
        status = fail_file(study, journal->path, "written", errno ? errno : EIO);
    trk_free(study->context, journal->path);
    trk_free(study->context, journal->line);
    *journal = (trk_journal){0};
    return status;
}
