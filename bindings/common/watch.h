/* SPDX-License-Identifier: MIT */
/* Long work: the progress bar of a terminal, and the end on Ctrl-C. */
#ifndef TRUCKRIDE_COMMON_WATCH_H
#define TRUCKRIDE_COMMON_WATCH_H

#include <stdbool.h>
#include <stdint.h>

/* From now on the first Ctrl-C (or SIGTERM) asks for the end of the work, the second ends it. */
void watch_signals(void);

/* A bar on standard error, if that is a terminal, for work of more than a second. */
typedef struct progress {
    bool quiet;
    double begin, drawn; /* [s] */
} progress;

/* A trk_progress whose user is a progress that began as {.quiet = ...}. Non-zero on Ctrl-C. */
int32_t progress_step(void *user, double fraction);

/* Take the bar away. */
void progress_end(progress *p);

#endif
