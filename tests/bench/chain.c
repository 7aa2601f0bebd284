/* SPDX-License-Identifier: MIT */
/* Cost of a step against the number of coordinates, dense and sparse; time per factor entry. */
#include "chain.h"
#include "ladder.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_DENSE = 1000, FRAME_COLUMNS = 6, LADDER = 0 };

typedef struct chain_run {
    const bench *bench;
    trk_newmark *stepper; /* NULL: this backend is not measured */
    double *q;
    int32_t steps;
} chain_run;

static double run(void *argument)
{
    chain_run *r = argument;
    if (!r->stepper)
        return NAN;
    bench_must(r->bench, trk_newmark_set_state(r->stepper, 0, NULL, NULL, NULL, NULL, NULL));
    double start = bench_cpu();
    for (int32_t k = 1; k <= r->steps; k++) {
        double height = 0.01 * sin(0.05 * k), velocity = 0.5 * cos(0.05 * k);
        bench_must(r->bench, trk_newmark_step(r->stepper, &height, &velocity, NULL));
    }
    double seconds = bench_cpu() - start;
    trk_newmark_get_state(r->stepper, r->q, NULL, NULL);
    return seconds;
}

static chain_run start(const bench *b, const trk_model *model, trk_backend backend, int32_t steps)
{
    chain_run r = {.bench = b, .steps = steps};
    trk_newmark_options options;
    trk_newmark_options_init(&options, sizeof options);
    options.backend = backend;
    r.q = bench_zeros(trk_model_count(model, TRK_PART_COORDINATE));
    if (backend != TRK_BACKEND_SPARSE || trk_has_feature(TRK_FEATURE_CHOLMOD))
        bench_must(b, trk_newmark_create(b->context, model, &options, &r.stepper));
    return r;
}

static void finish(chain_run *r)
{
    trk_newmark_destroy(r->stepper);
    free(r->q);
}

/* other: [ns] of the other backend; 0: not measured, then `smaller` is the cost of a coordinate
 * of the last size where both were. */
static void report(bench *b, const char *shape, int32_t n, const chain_run *r, double ns,
                   double other, double smaller, double error)
{
    char name[64], note[64];
    trk_newmark_statistics s = {.struct_size = sizeof s};
    bench_must(b, trk_newmark_get_statistics(r->stepper, &s));
    bool dense = s.backend == TRK_BACKEND_DENSE;
    snprintf(name, sizeof name, "%s of %d: %s", shape, (int)n, dense ? "dense" : "sparse");
    snprintf(note, sizeof note, "nnz(L) = %lld, %.3g ns a coordinate", (long long)s.factor_entries,
             ns / n);
    bench_row row = {.name = name,
                     .value = ns,
                     .unit = "ns/step",
                     .each = ns / (double)s.factor_entries,
                     .element = "nnz(L)",
                     .note = note};
    if (other > 0) {
        row.ratio = ns / other;
        row.of = dense ? "sparse" : "dense";
        row.error = error;
        row.bound = 1e-8;
    } else if (smaller > 0) {
        row.ratio = ns / n / smaller;
        row.of = "coordinate of last above";
    }
    bench_report(b, row);
}

static trk_model *build(const bench *b, int32_t n, int32_t columns)
{
    return columns == LADDER ? ladder_build(b, n) : chain_build(b, n, columns);
}

/* Returns whether sparse was faster; *coordinate is the cost of one, sparse [ns]. */
static bool measure(bench *b, const char *shape, int32_t n, int32_t columns, double *coordinate)
{
    trk_model *model = build(b, n, columns);
    int32_t steps = b->tiny ? 20 : n < 200 ? 20000 : 4000000 / n;
    chain_run sparse = start(b, model, TRK_BACKEND_SPARSE, steps), dense = {0};
    if (n <= MOST_DENSE)
        dense = start(b, model, TRK_BACKEND_DENSE, n < 200 ? steps : steps / 10 + 1);
    if (sparse.stepper && dense.stepper)
        dense.steps = sparse.steps = dense.steps; /* the same motion */
    bench_contender turns[] = {{run, &dense, 0}, {run, &sparse, 0}};
    bench_race(b, turns, 2);
    double dense_ns = dense.stepper ? 1e9 * turns[0].best / dense.steps : 0,
           sparse_ns = sparse.stepper ? 1e9 * turns[1].best / sparse.steps : 0;
    double error = dense.stepper && sparse.stepper ? bench_error(n, 1, sparse.q, dense.q) : 0;
    if (dense.stepper)
        report(b, shape, n, &dense, dense_ns, sparse_ns, 0, error);
    if (sparse.stepper)
        report(b, shape, n, &sparse, sparse_ns, dense_ns, *coordinate, error);
    if (dense.stepper)
        *coordinate = sparse_ns / n;
    finish(&dense);
    finish(&sparse);
    trk_model_destroy(model);
    return dense_ns > 0 && sparse_ns > 0 && sparse_ns < dense_ns;
}

/* Least size at which the library itself takes the sparse solver. */
static int32_t find_switch(const bench *b)
{
    for (int32_t n = 4;; n++) {
        trk_newmark_statistics s = {.struct_size = sizeof s};
        trk_model *model = chain_build(b, n, 1);
        chain_run r = start(b, model, TRK_BACKEND_AUTO, 0);
        bench_must(b, trk_newmark_get_statistics(r.stepper, &s));
        finish(&r);
        trk_model_destroy(model);
        if (s.backend == TRK_BACKEND_SPARSE || n == MOST_DENSE)
            return n;
    }
}

static void measure_sizes(bench *b, const char *shape, int32_t columns, const int32_t *sizes,
                          int count)
{
    char name[64];
    int32_t crossing = 0;
    double coordinate = 0;
    for (int k = 0; k < count; k++)
        if (measure(b, shape, sizes[k], columns, &coordinate) && !crossing)
            crossing = sizes[k];
    snprintf(name, sizeof name, "%s: least size with sparse faster", shape);
    if (crossing) {
        int32_t automatic = find_switch(b);
        bench_report(b, (bench_row){name, crossing, "unknowns", (double)crossing / automatic,
                                    "where AUTO switches"});
    }
}

void bench_chain(bench *b)
{
    static const int32_t chain[] = {12, 20, 28, 32, 36, 48, 64, 100, 300, 1000, 3000, 10000, 30000},
                         frame[] = {12, 24, 36, 48, 72, 96, 150, 300, 1200, 6000, 30000},
                         ladder[] = {24, 36, 48, 96, 300, 996, 3000, 9996, 30000};
    int32_t tiny = 4;
    measure_sizes(b, "chain", 1, chain, b->tiny ? tiny : (int)(sizeof chain / sizeof *chain));
    measure_sizes(b, "frame", FRAME_COLUMNS, frame,
                  b->tiny ? tiny : (int)(sizeof frame / sizeof *frame));
    measure_sizes(b, "ladder", LADDER, ladder,
                  b->tiny ? tiny : (int)(sizeof ladder / sizeof *ladder));
}
