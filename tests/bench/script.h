/* SPDX-License-Identifier: MIT */
/* Scripts in other languages, beside the benchmark's sources. */
#ifndef TRK_TESTS_BENCH_SCRIPT_H
#define TRK_TESTS_BENCH_SCRIPT_H

#include "bench.h"

typedef struct script_line {
    char name[64];
    double seconds, error;
} script_line;

/*
 * Run peers/<script> with one argument; it prints lines "name;seconds;error". Returns how many
 * were read into lines, -1 if interpreter ("" when configuring found none) or script failed.
 */
int script_run(const char *interpreter, const char *script, const char *argument, int capacity,
               script_line *lines);

#endif
