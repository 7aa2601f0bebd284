/* SPDX-License-Identifier: MIT */
/*
 * Harness of the benchmark: settings, clock, rows. A subject is a function that measures and
 * reports rows; main.c lists them. Every row compares two things measured in the same run.
 */
#ifndef TRK_TESTS_BENCH_H
#define TRK_TESTS_BENCH_H

#include <stdbool.h>
#include <stdio.h>
#include <truckride/truckride.h>

typedef struct bench {
    trk_context *context;
    double seconds;      /* of the truck's sweep [s]                              */
    int64_t calls;       /* of the stepper in the latency histogram               */
    int rounds;          /* best of so many                                       */
    bool tiny, full;     /* a smoke test; also what takes minutes                 */
    const char *subject; /* being measured                                        */
    FILE *json;          /* NULL: table only                                      */
    int rows, bad;       /* reported so far; of these with an error out of bounds */
    double peak, dram;   /* [flop/s], [B/s] of one core; 0 before machine.c ran   */
} bench;

/* Zero or NULL: the row has no such column. */
typedef struct bench_row {
    const char *name;
    double value; /* of what was measured, in `unit` */
    const char *unit;
    double ratio; /* to the thing called `of`        */
    const char *of;
    double each; /* [ns] per `element`              */
    const char *element;
    double error, bound; /* the bench fails if error > bound */
    const char *note;
} bench_row;

/* Print a row and add it to the JSON file. */
void bench_report(bench *b, bench_row row);

/* Wall clock [s], monotonic; and processor time of this thread [s], which other programs of the
 * machine do not lengthen: the measure of everything that runs in one thread. */
double bench_now(void);
double bench_cpu(void);

/* One of several runs that take turns: they share whatever the machine does meanwhile. */
typedef struct bench_contender {
    double (*run)(void *argument); /* [s] it took; may measure only a part of itself */
    void *argument;
    double best; /* [s] least so far */
} bench_contender;

/* Run all contenders in turn, b->rounds times. */
void bench_race(const bench *b, bench_contender *contenders, int count);

/* Repeat for some 20 ms, in blocks; returns [s] a repetition in the fastest block. */
double bench_repeat(void (*run)(void *argument), void *argument);

/* End the program with the context's message unless the status is TRK_OK. */
void bench_must(const bench *b, trk_status status);

/* Zeroed memory for count doubles, aligned to a cache line; ends the program when there is none. */
double *bench_zeros(int64_t count);

/* Largest |x - wanted| of a column over its largest |wanted|; rows x columns, row-major. */
double bench_error(int64_t rows, int columns, const double *x, const double *wanted);

/* The subjects. */
void bench_machine(bench *b);
void bench_thesis(bench *b);
void bench_truck(bench *b);
void bench_kernels(bench *b);
void bench_peers(bench *b);
void bench_scripts(bench *b);
void bench_chain(bench *b);
void bench_psd(bench *b);
void bench_modes(bench *b);
void bench_lowest(bench *b);
void bench_calibration(bench *b);
void bench_latency(bench *b);
void bench_batch(bench *b);

#endif
