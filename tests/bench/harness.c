/* SPDX-License-Identifier: MIT */
/* Clock, contenders, rows as a table and as JSON. */
#define _POSIX_C_SOURCE 200809L
#include "bench.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

static double read_clock(clockid_t clock)
{
    struct timespec t;
    clock_gettime(clock, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

double bench_now(void)
{
    return read_clock(CLOCK_MONOTONIC);
}

double bench_cpu(void)
{
    return read_clock(CLOCK_THREAD_CPUTIME_ID);
}

void bench_race(const bench *b, bench_contender *contenders, int count)
{
    for (int k = 0; k < count; k++)
        contenders[k].best = INFINITY;
    for (int round = 0; round < b->rounds; round++)
        for (int k = 0; k < count; k++)
            contenders[k].best =
                fmin(contenders[k].best, contenders[k].run(contenders[k].argument));
}

/* [s] of so many repetitions. */
static double time_block(void (*run)(void *argument), void *argument, int64_t count)
{
    double start = bench_cpu();
    for (int64_t k = 0; k < count; k++)
        run(argument);
    return bench_cpu() - start;
}

double bench_repeat(void (*run)(void *argument), void *argument)
{
    int64_t count = 1;
    while (time_block(run, argument, count) < 2e-4)
        count *= 2;
    double best = INFINITY, end = bench_cpu() + 0.02;
    do
        best = fmin(best, time_block(run, argument, count));
    while (bench_cpu() < end);
    return best / (double)count;
}

void bench_must(const bench *b, trk_status status)
{
    if (status == TRK_OK)
        return;
    fprintf(stderr, "bench %s: %s: %s\n", b->subject, trk_status_text(status),
            trk_context_message(b->context));
    exit(1);
}

double *bench_zeros(int64_t count)
{
    size_t bytes = ((size_t)count * sizeof(double) + 63) / 64 * 64;
    double *block = aligned_alloc(64, bytes);
    if (!block) {
        fprintf(stderr, "bench: no memory for %lld numbers\n", (long long)count);
        exit(1);
    }
    memset(block, 0, bytes);
    return block;
}

double bench_error(int64_t rows, int columns, const double *x, const double *wanted)
{
    double worst = 0;
    for (int i = 0; i < columns; i++) {
        double peak = 0, off = 0;
        for (int64_t k = i; k < rows * columns; k += columns) {
            peak = fmax(peak, fabs(wanted[k]));
            double difference = fabs(x[k] - wanted[k]);
            off = difference <= off ? off : difference; /* keeps NaN */
        }
        double relative = peak > 0 ? off / peak : off;
        worst = relative <= worst ? worst : relative;
    }
    return worst;
}

static void print_row(const bench *b, const bench_row *r)
{
    char ratio[48] = "", each[40] = "", error[16] = "";
    if (r->of)
        snprintf(ratio, sizeof ratio, "%#.3g x %s", r->ratio, r->of);
    if (r->element)
        snprintf(each, sizeof each, "%.3g ns/%s", r->each, r->element);
    if (r->bound != 0)
        snprintf(error, sizeof error, "%.2g", r->error);
    printf("%-11s %-44s ", b->subject, r->name);
    if (r->unit)
        printf("%10.4g %-9s", r->value, r->unit);
    else
        printf("%20s", "");
    printf(" %-33s %-16s %-8s %s\n", ratio, each, error, r->note ? r->note : "");
    fflush(stdout);
}

/* Names and notes are ours and need no escapes; JSON has no infinity. */
static void json_number(const bench *b, const char *key, double value)
{
    if (isfinite(value))
        fprintf(b->json, ", \"%s\": %.6g", key, value);
    else
        fprintf(b->json, ", \"%s\": null", key);
}

static void json_text(const bench *b, const char *key, const char *text)
{
    fprintf(b->json, ", \"%s\": \"%s\"", key, text);
}

static void json_row(const bench *b, const bench_row *r)
{
    fprintf(b->json, "%s\n  {\"subject\": \"%s\", \"name\": \"%s\"", b->rows ? "," : "", b->subject,
            r->name);
    if (r->unit) {
        json_number(b, "value", r->value);
        json_text(b, "unit", r->unit);
    }
    if (r->of) {
        json_number(b, "ratio", r->ratio);
        json_text(b, "of", r->of);
    }
    if (r->element) {
        json_number(b, "each", r->each);
        json_text(b, "element", r->element);
    }
    if (r->bound != 0) {
        json_number(b, "error", r->error);
        json_number(b, "bound", r->bound);
    }
    if (r->note)
        json_text(b, "note", r->note);
    fprintf(b->json, "}");
}

void bench_report(bench *b, bench_row row)
{
    print_row(b, &row);
    if (b->json)
        json_row(b, &row);
    b->rows++;
    if (row.bound != 0 && !(row.error <= row.bound)) {
        fprintf(stderr, "bench %s: %s: error %g, expected at most %g\n", b->subject, row.name,
                row.error, row.bound);
        b->bad++;
    }
}
