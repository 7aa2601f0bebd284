/* SPDX-License-Identifier: MIT */
/* What truckride-study and truckride-study-mpi share: command line to study. */
#ifndef TRUCKRIDE_STUDY_JOB_H
#define TRUCKRIDE_STUDY_JOB_H

#include <truckride/truckride.h>

#include <stdbool.h>

/* Exit codes. */
enum { JOB_DONE = 0, JOB_FAILED = 1, JOB_USAGE = 2, JOB_INTERRUPTED = 130 };

enum { JOB_MOST_WORDS = 512, JOB_MOST_ROADS = 16 };

typedef struct job {
    const char *program;
    /* Words of the command line, those of @files in place. */
    const char *word[JOB_MOST_WORDS];
    int words;
    char *file_text[8]; /* of the @files, owned */
    int files;
    /* What to do. */
    bool merge, quiet, list, help;
    const char *journal, *csv;
    const char *input[JOB_MOST_WORDS]; /* journals to merge */
    int inputs;
    trk_study_run_options run;
    /* What the study is. */
    trk_vehicle vehicle;
    trk_variant variant;
    trk_study_options study_options;
    trk_newmark_options newmark;
    trk_spectrum_options spectrum;
    trk_context *context;
    trk_spec *spec;
    trk_model *model;
    trk_signal *signal[JOB_MOST_ROADS][2]; /* left and right, or one for both */
    trk_excitation *excitation[JOB_MOST_ROADS];
    int roads;
    trk_study *study;
} job;

/* Read the command line and make the study. JOB_DONE, or the exit code; a reason has been
 * printed if `loud`. Also after a failure end with job_close(). */
int job_open(job *j, int argc, char **argv, bool loud);
void job_close(job *j);

/* Print the failure of a library call; JOB_FAILED. */
int job_complain(const job *j, trk_status status);

/* Print help; or what there is to vary and to measure in the vehicle. */
void job_help(const char *program);
void job_list(const job *j);

/* A trk_progress: a line on a terminal, and the end on Ctrl-C. user is the job. */
int32_t job_progress(void *user, double fraction);
bool job_interrupted(void);

/* Close the journal, write the table, say what came out; the exit code. */
int job_finish(job *j, trk_status status);

/* Add what one option describes to the study (describe.c); JOB_DONE or the exit code. */
int job_add_road(job *j, const char *text);
int job_add_parameter(job *j, const char *text);
int job_add_output(job *j, const char *text);

/* Print "program: message 'text'" and return JOB_USAGE. */
int job_usage(const job *j, const char *message, const char *text);

#endif
