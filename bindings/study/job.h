/* SPDX-License-Identifier: MIT */
/* What truckride-study and truckride-study-mpi share: command line to study. */
#ifndef TRUCKRIDE_STUDY_JOB_H
#define TRUCKRIDE_STUDY_JOB_H

#include "common/arguments.h"
#include "common/road.h"
#include "common/watch.h"

#include <truckride/truckride.h>

#include <stdbool.h>

enum {
    JOB_DONE = EXIT_DONE,
    JOB_FAILED = EXIT_FAILED,
    JOB_USAGE = EXIT_USAGE,
    JOB_INTERRUPTED = EXIT_INTERRUPTED,
    JOB_MOST_ROADS = 16
};

typedef struct job {
    const char *program;
    bool
        subcommand; /* of truckride: takes the vehicle as its first word, writes to standard output */
    char *file_text[8]; /* of the @files, owned */
    int files;
    words operands;
    /* What to do. */
    bool merge, quiet, list, help, gravity;
    const char *journal, *csv, *shard;
    words inputs; /* journals to merge */
    trk_study_run_options run;
    /* What the study is. */
    const char *vehicle; /* a ready-made one, or MODEL of common/vehicle.h */
    int32_t variant;
    words vary, roads_asked, outputs_asked;
    trk_study_options study_options;
    trk_newmark_options newmark;
    trk_spectrum_options spectrum;
    trk_context *context;
    trk_spec *spec;
    trk_model *model;
    road road[JOB_MOST_ROADS];
    int roads;
    trk_study *study;
    progress bar;
} job;

/* A whole study from the words behind its name; the exit code. */
int job_main(const char *program, bool subcommand, int argc, char **argv);

/* Read the command line of j->program and make the study. JOB_DONE, or the exit code; a reason has
 * been printed if `loud`. Also after a failure end with job_close(). */
int job_open(job *j, int argc, char **argv, bool loud);
void job_close(job *j);

/* Print the failure of a library call; JOB_FAILED. */
int job_complain(const job *j, trk_status status);

/* Print help; or what there is to vary and to measure in the vehicle. */
void job_help(const job *j);
void job_list(const job *j);

/* A trk_progress: a line on a terminal, and the end on Ctrl-C. user is the job. */
int32_t job_progress(void *user, double fraction);

/* Close the journal, write the table, say what came out; the exit code. */
int job_finish(job *j, trk_status status);

/* Add what one option describes to the study (describe.c); JOB_DONE or the exit code. */
int job_add_road(job *j, const char *text);
int job_add_parameter(job *j, const char *text);
int job_add_output(job *j, const char *text);

/* Print "program: message 'text'" and return JOB_USAGE. */
int job_usage(const job *j, const char *message, const char *text);

#endif
