/* SPDX-License-Identifier: MIT */
/* The words of a study's command line. */
#ifndef TRUCKRIDE_STUDY_WORDS_H
#define TRUCKRIDE_STUDY_WORDS_H

#include "job.h"

/* Understand the command line, with @files in place; JOB_DONE or the exit code. */
int job_read_words(job *j, int argc, char **argv, bool loud);

/* Tables of its options, ended by NULL; what a study is. */
extern const argument *const job_tables[];
extern const char job_about[];

#endif
