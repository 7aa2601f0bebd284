/* SPDX-License-Identifier: MIT */
/* The life of a study on the command line. */
#define _POSIX_C_SOURCE 200809L
#include "words.h"
#include "common/stream.h"
#include "common/text.h"
#include "common/vehicle.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

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

static bool same_file(const char *a, const char *b)
{
    struct stat first, second;
    return strcmp(a, b) == 0 || (stat(a, &first) == 0 && stat(b, &second) == 0 &&
                                 first.st_dev == second.st_dev && first.st_ino == second.st_ino);
}

/* Before hours of work: may the table be written, and not over a journal? */
static int check_table(const job *j)
{
    if (!j->csv || strcmp(j->csv, "-") == 0)
        return JOB_DONE;
    bool journal = j->journal && same_file(j->csv, j->journal);
    for (int k = 0; k < j->inputs.count; k++)
        journal = journal || same_file(j->csv, j->inputs.word[k]);
    if (journal)
        return job_usage(j, "the table would overwrite a journal:", j->csv);
    if (stream_writable(j->csv))
        return JOB_DONE;
    fprintf(stderr, "%s: %s: cannot be written (%s)\n", j->program, j->csv, strerror(errno));
    return JOB_FAILED;
}

static int describe(job *j)
{
    int code = j->roads_asked.count == 0 ? job_add_road(j, "sweep") : JOB_DONE;
    for (int k = 0; k < j->roads_asked.count && code == JOB_DONE; k++)
        code = job_add_road(j, j->roads_asked.word[k]);
    for (int k = 0; k < j->vary.count && code == JOB_DONE; k++)
        code = job_add_parameter(j, j->vary.word[k]);
    for (int k = 0; k < j->outputs_asked.count && code == JOB_DONE; k++)
        code = job_add_output(j, j->outputs_asked.word[k]);
    return code;
}

static void set_defaults(job *j)
{
    j->vehicle = "reference_truck";
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

static trk_status read_vehicle(job *j, complaint *wrong)
{
    const int place = text_index(vehicle_names, j->vehicle);
    wrong->text[0] = 0;
    if (place >= 0)
        return trk_vehicle_create_builtin(j->context, TRK_VEHICLE_THESIS_QUARTER + place,
                                          j->variant, &j->spec);
    return vehicle_read(j->context, j->vehicle, wrong, &j->spec);
}

static int make_study(job *j)
{
    complaint wrong;
    trk_model_options compile;
    trk_model_options_init(&compile, sizeof compile);
    compile.gravity = j->gravity ? TRK_STANDARD_GRAVITY : 0;
    trk_status status = trk_context_create(NULL, NULL, &j->context);
    if (status == TRK_OK) {
        trk_context_set_log(j->context, hear, j);
        status = read_vehicle(j, &wrong);
        if (status != TRK_OK && wrong.text[0])
            return fprintf(stderr, "%s: %s\n", j->program, wrong.text), JOB_USAGE;
    }
    if (status == TRK_OK)
        status = trk_model_compile(j->context, j->spec, &compile, &j->model);
    if (status == TRK_OK && j->list)
        return JOB_DONE;
    if (status == TRK_OK)
        status = trk_study_create(j->context, j->spec, &compile, &j->study_options, &j->study);
    if (status == TRK_OK)
        status = trk_study_set_newmark(j->study, &j->newmark);
    if (status == TRK_OK)
        status = trk_study_set_spectrum(j->study, &j->spectrum);
    if (status != TRK_OK)
        return job_complain(j, status);
    watch_signals();
    return describe(j);
}

int job_open(job *j, int argc, char **argv, bool loud)
{
    set_defaults(j);
    int code = job_read_words(j, argc, argv, loud);
    if (code == JOB_DONE && j->subcommand && !j->csv && !j->journal)
        j->csv = "-";
    if (code == JOB_DONE && loud && !j->help && !j->list)
        code = check_table(j);
    j->quiet = j->quiet || !loud;
    j->bar.quiet = j->quiet;
    return code != JOB_DONE || j->help ? code : make_study(j);
}

void job_close(job *j)
{
    trk_study_destroy(j->study);
    for (int k = 0; k < j->roads; k++)
        road_close(&j->road[k]);
    trk_model_destroy(j->model);
    trk_spec_destroy(j->spec);
    trk_context_destroy(j->context);
    for (int k = 0; k < j->files; k++)
        free(j->file_text[k]);
    words_free(&j->operands);
    words_free(&j->inputs);
    words_free(&j->vary);
    words_free(&j->roads_asked);
    words_free(&j->outputs_asked);
}

int32_t job_progress(void *user, double fraction)
{
    job *j = user;
    return progress_step(&j->bar, fraction);
}

/* The table, through a temporary file if it goes to standard output. */
static int write_table(job *j)
{
    char path[4096];
    const bool through = strcmp(j->csv, "-") == 0;
    if (through && !stream_temporary(path, sizeof path)) {
        fprintf(stderr, "%s: a temporary file cannot be made (%s)\n", j->program, strerror(errno));
        return JOB_FAILED;
    }
    trk_status status = trk_study_write_csv(j->study, through ? path : j->csv);
    if (status != TRK_OK) {
        if (through)
            remove(path);
        return job_complain(j, status);
    }
    if (!through || stream_to_stdout(path))
        return JOB_DONE;
    fprintf(stderr, "%s: standard output cannot be written (%s)\n", j->program, strerror(errno));
    return JOB_FAILED;
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
    progress_end(&j->bar);
    status = trk_study_close_journal(j->study);
    if (status != TRK_OK)
        code = job_complain(j, status);
    else if (j->csv && write_table(j) != JOB_DONE)
        code = JOB_FAILED;
    if (!j->quiet)
        fprintf(stderr, "%s: %lld of %lld cases finished, %lld of them failed\n", j->program,
                (long long)finished, (long long)cases, (long long)failed);
    if (code == JOB_DONE && j->merge && finished < cases) {
        fprintf(stderr, "%s: the journals do not hold all cases\n", j->program);
        code = JOB_FAILED;
    }
    return code;
}
