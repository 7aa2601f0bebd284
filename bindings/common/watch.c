/* SPDX-License-Identifier: MIT */
/* Progress and interruption. */
#define _POSIX_C_SOURCE 200809L
#include "common/watch.h"

#include <signal.h>
#include <stdio.h>
#include <time.h>
#include <unistd.h>

static volatile sig_atomic_t interrupted;

static void on_interrupt(int signal_number)
{
    (void)signal_number;
    interrupted = 1;
}

void watch_signals(void)
{
    struct sigaction action = {.sa_handler = on_interrupt, .sa_flags = (int)SA_RESETHAND};
    sigaction(SIGINT, &action, NULL);
    sigaction(SIGTERM, &action, NULL);
}

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

int32_t progress_step(void *user, double fraction)
{
    enum { WIDTH = 40 };
    static const char done[] = "########################################";
    static const char left[] = "........................................";
    progress *p = user;
    const double time = now();
    if (p->begin == 0)
        p->begin = time;
    if (p->quiet || time < p->begin + 1 || time < p->drawn + 0.1 || !isatty(STDERR_FILENO))
        return interrupted;
    const int full = fraction < 0 ? 0 : fraction > 1 ? WIDTH : (int)(fraction * WIDTH);
    fprintf(stderr, "\r[%.*s%.*s] %3.0f %%", full, done, WIDTH - full, left, 100 * fraction);
    if (fraction > 0.01 && fraction < 1)
        fprintf(stderr, ", %.0f s left  ", (time - p->begin) * (1 - fraction) / fraction);
    p->drawn = time;
    return interrupted;
}

void progress_end(progress *p)
{
    if (p->drawn > 0)
        fputs("\r\033[K", stderr);
    p->drawn = 0;
}
