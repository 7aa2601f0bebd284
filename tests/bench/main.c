/* SPDX-License-Identifier: MIT */
/* The benchmark: one command, one table. docs/benchmarks.md explains its rows. */
#include "bench.h"

#include <stdlib.h>
#include <string.h>

static const struct {
    const char *name;
    void (*run)(bench *b);
} subjects[] = {
    {"machine", bench_machine},       {"thesis", bench_thesis},
    {"truck", bench_truck},           {"kernels", bench_kernels},
    {"peers", bench_peers},           {"scripts", bench_scripts},
    {"chain", bench_chain},           {"psd", bench_psd},
    {"modes", bench_modes},           {"lowest", bench_lowest},
    {"calibrate", bench_calibration}, {"latency", bench_latency},
    {"batch", bench_batch},
};
enum { SUBJECTS = sizeof subjects / sizeof *subjects };

static void usage(void)
{
    fprintf(stderr,
            "usage: truckride_bench [--json FILE] [--seconds S] [--calls N] [--rounds R] [--tiny] "
            "[--full] [SUBJECT...]\nsubjects:");
    for (int k = 0; k < SUBJECTS; k++)
        fprintf(stderr, " %s", subjects[k].name);
    fprintf(stderr, "\n");
    exit(2);
}

static int find_subject(const char *name)
{
    for (int k = 0; k < SUBJECTS; k++)
        if (strcmp(name, subjects[k].name) == 0)
            return k;
    usage();
    return -1;
}

static double positive(const char *text)
{
    char *end;
    double value = text ? strtod(text, &end) : 0;
    if (!(value > 0) || *end)
        usage();
    return value;
}

/* Settings from the command line; chosen[k]: subject k is named there. Returns how many are. */
static int parse(bench *b, char **argument, bool *chosen, const char **json)
{
    int count = 0;
    for (; *argument; argument++) {
        const char *a = *argument;
        if (strcmp(a, "--tiny") == 0) {
            b->tiny = true;
            b->seconds = 2;
            b->calls = 2000;
            b->rounds = 1;
        } else if (strcmp(a, "--full") == 0)
            b->full = true;
        else if (strcmp(a, "--json") == 0 && argument[1])
            *json = *++argument;
        else if (strcmp(a, "--seconds") == 0)
            b->seconds = positive(*++argument);
        else if (strcmp(a, "--calls") == 0)
            b->calls = (int64_t)positive(*++argument);
        else if (strcmp(a, "--rounds") == 0)
            b->rounds = (int)positive(*++argument);
        else {
            chosen[find_subject(a)] = true;
            count++;
        }
    }
    return count;
}

int main(int argc, char **argv)
{
    (void)argc;
    bench b = {.seconds = 480, .calls = 10000000, .rounds = 3};
    bool chosen[SUBJECTS] = {false};
    const char *json = NULL;
    int count = parse(&b, argv + 1, chosen, &json);
    if (json && !(b.json = fopen(json, "w"))) {
        perror(json);
        return 2;
    }
    if (trk_context_create(NULL, NULL, &b.context) != TRK_OK)
        return 1;
    if (b.json)
        fprintf(b.json, "{\"seconds\": %g, \"rounds\": %d, \"rows\": [", b.seconds, b.rounds);
    printf("%-11s %-44s %10s %-9s %-33s %-16s %-8s %s\n", "subject", "row", "value", "unit",
           "ratio", "each", "error", "note");
    for (int k = 0; k < SUBJECTS; k++)
        if (!count || chosen[k] || k == 0) { /* the machine is what others are compared with */
            b.subject = subjects[k].name;
            subjects[k].run(&b);
        }
    if (b.json) {
        fprintf(b.json, "\n]}\n");
        if (fclose(b.json) != 0)
            b.bad++;
    }
    trk_context_destroy(b.context);
    return b.bad ? 1 : 0;
}
