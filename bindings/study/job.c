/* SPDX-License-Identifier: MIT */
/* Command line, and the life of a job. */
#define _POSIX_C_SOURCE 200809L
#include "job.h"

#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static volatile sig_atomic_t interrupted;

static void on_interrupt(int signal_number)
{
    (void)signal_number;
    interrupted = 1;
}

bool job_interrupted(void)
{
    return interrupted != 0;
}

int job_usage(const job *j, const char *message, const char *text)
{
    fprintf(stderr, "%s: %s '%s' (see %s --help)\n", j->program, message, text, j->program);
    return JOB_USAGE;
}

int job_complain(const job *j, trk_status status)
{
    const char *message = j->context ? trk_context_message(j->context) : "";
    fprintf(stderr, "%s: %s\n", j->program, *message ? message : trk_status_text(status));
    return JOB_FAILED;
}

/* A whole text file of less than 64 kB, without a 0; NULL with errno set. */
static char *read_text(const char *path)
{
    enum { ROOM = 1 << 16 };
    FILE *file = fopen(path, "rb");
    char *text = file ? malloc(ROOM) : NULL;
    if (text) {
        errno = 0;
        const size_t size = fread(text, 1, ROOM, file);
        if (ferror(file) || size == ROOM || memchr(text, 0, size)) {
            errno = errno ? errno : size == ROOM ? EFBIG : EILSEQ;
            free(text);
            text = NULL;
        } else {
            text[size] = 0;
        }
    }
    if (file)
        fclose(file);
    return text;
}

static int add_word(job *j, const char *word)
{
    if (j->words == JOB_MOST_WORDS)
        return job_usage(j, "too many words, from", word);
    j->word[j->words++] = word;
    return JOB_DONE;
}

/* Lines of a file: an option and, behind a blank, its value; # begins a comment. */
static int add_file(job *j, const char *path)
{
    if (j->files == (int)(sizeof j->file_text / sizeof *j->file_text))
        return job_usage(j, "too many files, from", path);
    char *text = read_text(path);
    if (!text) {
        fprintf(stderr, "%s: %s: %s\n", j->program, path, strerror(errno));
        return JOB_FAILED;
    }
    j->file_text[j->files++] = text;
    int code = JOB_DONE;
    char *place, *line = strtok_r(text, "\r\n", &place);
    for (; line && code == JOB_DONE; line = strtok_r(NULL, "\r\n", &place)) {
        line += strspn(line, " \t");
        size_t length = strlen(line);
        while (length > 0 && strchr(" \t", line[length - 1]))
            line[--length] = 0;
        if (!*line || *line == '#')
            continue;
        char *value = line + strcspn(line, " \t");
        if (*value) {
            *value++ = 0;
            value += strspn(value, " \t");
        }
        code = add_word(j, line);
        if (code == JOB_DONE && *value)
            code = add_word(j, value);
    }
    return code;
}

static int collect_words(job *j, int argc, char **argv)
{
    int code = JOB_DONE;
    for (int k = 1; k < argc && code == JOB_DONE; k++)
        code = argv[k][0] == '@' ? add_file(j, argv[k] + 1) : add_word(j, argv[k]);
    return code;
}

static bool whole_number(const char *text, int64_t *out)
{
    char *end;
    errno = 0;
    *out = strtoll(text, &end, 10);
    return end != text && !*end && !errno;
}

static bool real_number(const char *text, double *out)
{
    char *end;
    *out = strtod(text, &end);
    return end != text && !*end;
}

static bool one_of(const char *text, const char *const *names, int32_t first, int32_t *out)
{
    for (int32_t k = 0; names[k]; k++)
        if (strcmp(names[k], text) == 0) {
            *out = first + k;
            return true;
        }
    return false;
}

static bool small_number(const char *text, int32_t *out)
{
    int64_t number;
    if (!whole_number(text, &number) || number < 0 || number > INT32_MAX)
        return false;
    *out = (int32_t)number;
    return true;
}

static bool read_shard(const char *text, trk_study_run_options *run)
{
    char copy[64];
    if (strlen(text) >= sizeof copy)
        return false;
    strcpy(copy, text);
    char *bar = strchr(copy, '/');
    if (!bar)
        return false;
    *bar = 0;
    return small_number(copy, &run->shard) && small_number(bar + 1, &run->shards) &&
           run->shard >= 1 && run->shard <= run->shards;
}

static const char *expected_by(const char *name)
{
    static const char *const list[][2] = {
        {"--vehicle", "thesis_quarter, reference_front, reference_rear, reference_half or "
                      "reference_truck"},
        {"--variant", "linear, thesis or nonlinear"},
        {"--design", "lhs, monte_carlo or factorial"},
        {"--duration", "a number"},
        {"--settle", "a number"},
        {"--step", "a number"},
        {"--overlap", "a number"},
        {"--shard", "I/N with 1 <= I <= N"},
        {"--threads", "a whole number from 1 to 65536"},
        {"--chunk", "a whole number from 0 to 2147483647"}};
    for (size_t k = 0; k < sizeof list / sizeof *list; k++)
        if (strcmp(list[k][0], name) == 0)
            return list[k][1];
    return "a whole number";
}

/* An option with a value that is no part of the study's description. */
static bool read_option(job *j, const char *name, const char *value, bool *out_known)
{
    static const char *const vehicles[] = {"thesis_quarter", "reference_front", "reference_rear",
                                           "reference_half", "reference_truck", NULL};
    static const char *const variants[] = {"linear", "thesis", "nonlinear", NULL};
    static const char *const designs[] = {"factorial", "lhs", "monte_carlo", NULL};
    *out_known = true;
    if (strcmp(name, "--vehicle") == 0)
        return one_of(value, vehicles, TRK_VEHICLE_THESIS_QUARTER, &j->vehicle);
    if (strcmp(name, "--variant") == 0)
        return one_of(value, variants, TRK_VARIANT_LINEAR, &j->variant);
    if (strcmp(name, "--design") == 0)
        return one_of(value, designs, TRK_DESIGN_FACTORIAL, &j->study_options.design);
    if (strcmp(name, "--cases") == 0)
        return whole_number(value, &j->study_options.points);
    if (strcmp(name, "--seed") == 0)
        return whole_number(value, &j->study_options.seed);
    if (strcmp(name, "--duration") == 0)
        return real_number(value, &j->study_options.duration);
    if (strcmp(name, "--settle") == 0)
        return real_number(value, &j->study_options.settle);
    if (strcmp(name, "--step") == 0)
        return real_number(value, &j->newmark.step);
    if (strcmp(name, "--segment") == 0)
        return whole_number(value, &j->spectrum.segment_length);
    if (strcmp(name, "--overlap") == 0)
        return real_number(value, &j->spectrum.overlap);
    if (strcmp(name, "--threads") == 0)
        return small_number(value, &j->run.threads);
    if (strcmp(name, "--chunk") == 0)
        return small_number(value, &j->run.chunk);
    if (strcmp(name, "--shard") == 0)
        return read_shard(value, &j->run);
    const char **path = strcmp(name, "--journal") == 0 ? &j->journal
                        : strcmp(name, "--csv") == 0   ? &j->csv
                                                       : NULL;
    *out_known = path != NULL;
    if (path)
        *path = path == &j->csv && strcmp(value, "-") == 0 ? "/dev/stdout" : value;
    return path != NULL;
}

static bool describes(const char *name)
{
    return strcmp(name, "--road") == 0 || strcmp(name, "--vary") == 0 ||
           strcmp(name, "--output") == 0;
}

static bool read_switch(job *j, const char *word)
{
    bool *on = strcmp(word, "--quiet") == 0  ? &j->quiet
               : strcmp(word, "--list") == 0 ? &j->list
               : strcmp(word, "--help") == 0 ? &j->help
                                             : NULL;
    if (on)
        *on = true;
    return on != NULL;
}

static int read_pair(job *j, const char *word, const char *value)
{
    bool known;
    if (!value || strncmp(value, "--", 2) == 0)
        return job_usage(j, "unknown option, or one without its value:", word);
    if (describes(word) || read_option(j, word, value, &known))
        return JOB_DONE;
    if (!known)
        return job_usage(j, "unknown option", word);
    fprintf(stderr, "%s: %s expects %s, not '%s' (see %s --help)\n", j->program, word,
            expected_by(word), value, j->program);
    return JOB_USAGE;
}

static int read_words(job *j)
{
    for (int k = 0; k < j->words; k++) {
        const char *word = j->word[k];
        if (strcmp(word, "merge") == 0 && k == 0) {
            j->merge = true;
        } else if (strncmp(word, "--", 2) != 0) {
            if (!j->merge)
                return job_usage(j, "unexpected word", word);
            j->input[j->inputs++] = word;
        } else if (!read_switch(j, word)) {
            const int code = read_pair(j, word, k + 1 < j->words ? j->word[k + 1] : NULL);
            if (code != JOB_DONE)
                return code;
            k++;
        }
    }
    return JOB_DONE;
}

static bool same_file(const char *a, const char *b)
{
    struct stat first, second;
    return strcmp(a, b) == 0 || (stat(a, &first) == 0 && stat(b, &second) == 0 &&
                                 first.st_dev == second.st_dev && first.st_ino == second.st_ino);
}

/* Before hours of work: may the table be written, and not over a journal? */
static int check_table(const job *j)
{
    if (!j->csv)
        return JOB_DONE;
    bool journal = j->journal && same_file(j->csv, j->journal);
    for (int k = 0; k < j->inputs; k++)
        journal = journal || same_file(j->csv, j->input[k]);
    if (journal)
        return job_usage(j, "the table would overwrite a journal:", j->csv);
    struct stat about;
    bool writable = access(j->csv, W_OK) == 0;
    if (writable && stat(j->csv, &about) == 0 && S_ISDIR(about.st_mode)) {
        writable = false;
        errno = EISDIR;
    } else if (!writable && errno == ENOENT) {
        const char *slash = strrchr(j->csv, '/');
        char *folder = slash ? strndup(j->csv, (size_t)(slash - j->csv) + 1) : NULL;
        writable = *j->csv && access(folder ? folder : ".", W_OK) == 0;
        free(folder);
    }
    if (writable)
        return JOB_DONE;
    fprintf(stderr, "%s: %s: cannot be written (%s)\n", j->program, j->csv, strerror(errno));
    return JOB_FAILED;
}

static int describe(job *j)
{
    int code = JOB_DONE;
    for (int k = j->merge; k + 1 < j->words && code == JOB_DONE; k++) {
        if (!describes(j->word[k]))
            continue;
        const char *text = j->word[k + 1];
        code = j->word[k][2] == 'r'   ? job_add_road(j, text)
               : j->word[k][2] == 'v' ? job_add_parameter(j, text)
                                      : job_add_output(j, text);
        k++;
    }
    return code == JOB_DONE && j->roads == 0 ? job_add_road(j, "sweep") : code;
}

static void set_defaults(job *j)
{
    j->vehicle = TRK_VEHICLE_REFERENCE_TRUCK;
    j->variant = TRK_VARIANT_THESIS_DAMPERS;
    trk_study_run_options_init(&j->run, sizeof j->run);
    trk_study_options_init(&j->study_options, sizeof j->study_options);
    trk_newmark_options_init(&j->newmark, sizeof j->newmark);
    trk_spectrum_options_init(&j->spectrum, sizeof j->spectrum);
}

static void hear(void *user, const char *message)
{
    const job *j = user;
    if (!j->quiet)
        fprintf(stderr, "%s: %s\n", j->program, message);
}

int job_open(job *j, int argc, char **argv, bool loud)
{
    const char *slash = argc > 0 ? strrchr(argv[0], '/') : NULL;
    *j = (job){.program = slash ? slash + 1 : "truckride-study"};
    set_defaults(j);
    int code = collect_words(j, argc, argv);
    if (code == JOB_DONE)
        code = read_words(j);
    if (code == JOB_DONE && loud && !j->help && !j->list)
        code = check_table(j);
    j->quiet = j->quiet || !loud;
    if (code != JOB_DONE || j->help)
        return code;
    trk_status status = trk_context_create(NULL, NULL, &j->context);
    if (status == TRK_OK) {
        trk_context_set_log(j->context, hear, j);
        status = trk_vehicle_create_builtin(j->context, j->vehicle, j->variant, &j->spec);
    }
    if (status == TRK_OK)
        status = trk_model_compile(j->context, j->spec, NULL, &j->model);
    if (status == TRK_OK && j->list)
        return JOB_DONE;
    if (status == TRK_OK)
        status = trk_study_create(j->context, j->spec, NULL, &j->study_options, &j->study);
    if (status == TRK_OK)
        status = trk_study_set_newmark(j->study, &j->newmark);
    if (status == TRK_OK)
        status = trk_study_set_spectrum(j->study, &j->spectrum);
    if (status != TRK_OK)
        return job_complain(j, status);
    struct sigaction action = {.sa_handler = on_interrupt, .sa_flags = (int)SA_RESETHAND};
    sigaction(SIGINT, &action, NULL);
    sigaction(SIGTERM, &action, NULL);
    return describe(j);
}

void job_close(job *j)
{
    trk_study_destroy(j->study);
    for (int k = 0; k < JOB_MOST_ROADS; k++) {
        trk_excitation_destroy(j->excitation[k]);
        trk_signal_destroy(j->signal[k][0]);
        trk_signal_destroy(j->signal[k][1]);
    }
    trk_model_destroy(j->model);
    trk_spec_destroy(j->spec);
    trk_context_destroy(j->context);
    for (int k = 0; k < j->files; k++)
        free(j->file_text[k]);
}

int32_t job_progress(void *user, double fraction)
{
    const job *j = user;
    if (!j->quiet && isatty(STDERR_FILENO))
        fprintf(stderr, "\r%5.1f %%%s", 100 * fraction, fraction >= 1 ? "\n" : "");
    return interrupted;
}

int job_finish(job *j, trk_status status)
{
    int code = status == TRK_OK            ? JOB_DONE
               : status == TRK_E_CANCELLED ? JOB_INTERRUPTED
                                           : job_complain(j, status);
    const int64_t cases = trk_study_cases(j->study), finished = trk_study_finished(j->study);
    int64_t failed = 0, seen = 0;
    for (int64_t k = 0; seen < finished; k++) {
        trk_status outcome;
        if (trk_study_get_outputs(j->study, k, NULL, &outcome) == TRK_OK) {
            seen++;
            failed += outcome != TRK_OK;
        }
    }
    status = trk_study_close_journal(j->study);
    if (status == TRK_OK && j->csv)
        status = trk_study_write_csv(j->study, j->csv);
    if (status != TRK_OK)
        code = job_complain(j, status);
    if (!j->quiet)
        fprintf(stderr, "%s: %lld of %lld cases finished, %lld of them failed\n", j->program,
                (long long)finished, (long long)cases, (long long)failed);
    if (code == JOB_DONE && j->merge && finished < cases) {
        fprintf(stderr, "%s: the journals do not hold all cases\n", j->program);
        code = JOB_FAILED;
    }
    return code;
}
