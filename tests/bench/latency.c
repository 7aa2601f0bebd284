/* SPDX-License-Identifier: MIT */
/*
 * Hardware in the loop: single calls of the stepper, timed one by one, against steps inside a run.
 * The two readings of the clock around each call are taken off, by their median.
 */
#include "rig.h"

#include "newmark/newmark.h"

#include <math.h>
#include <stdlib.h>

enum { BINS = 1 << 16 };

/* Bins of 1 ns up to 65 us, of 1 us up to 65 ms; the last holds everything longer. */
typedef struct histogram {
    int64_t fine[BINS], coarse[BINS], count;
    double longest; /* [ns] */
} histogram;

static void add(histogram *h, double seconds)
{
    double ns = 1e9 * seconds;
    int64_t k = ns > 0 ? (int64_t)ns : 0;
    if (k < BINS)
        h->fine[k]++;
    else
        h->coarse[k / 1000 < BINS ? k / 1000 : BINS - 1]++;
    h->count++;
    h->longest = fmax(h->longest, ns);
}

/* [ns] not exceeded by this share of all. */
static double quantile(const histogram *h, double share)
{
    int64_t wanted = (int64_t)ceil(share * (double)h->count), sum = 0;
    for (int k = 0; k < BINS; k++)
        if ((sum += h->fine[k]) >= wanted)
            return k;
    for (int k = 0; k < BINS - 1; k++)
        if ((sum += h->coarse[k]) >= wanted)
            return fmin(1e3 * (k + 1), h->longest);
    return h->longest;
}

/* Steps through the rig's road, again and again; sensors: read them after each step. */
static double drive(const rig *r, trk_newmark *stepper, int64_t calls, bool sensors, histogram *h)
{
    double *values = bench_zeros(r->sensors), begin = bench_cpu();
    for (int64_t done = 0; done < calls; done++) {
        int64_t k = 1 + done % r->steps;
        double start = h ? bench_now() : 0;
        bench_must(r->bench, trk_newmark_step(stepper, r->height + k * r->roads,
                                              r->velocity + k * r->roads, NULL));
        if (sensors)
            trk_newmark_read_sensors(stepper, values);
        if (h)
            add(h, bench_now() - start);
    }
    double seconds = bench_cpu() - begin;
    free(values);
    return seconds;
}

/* All steps of the rig within one call, as trk_simulate() takes them. */
static double drive_inside(const rig *r, trk_newmark *stepper)
{
    int64_t taken;
    double start = bench_cpu();
    bench_must(r->bench, trk_newmark_record(stepper, r->steps, r->height + r->roads,
                                            r->velocity + r->roads, NULL, NULL, &taken));
    return bench_cpu() - start;
}

static double clock_overhead(histogram *h, int64_t calls)
{
    for (int64_t k = 0; k < calls; k++) {
        double start = bench_now();
        add(h, bench_now() - start);
    }
    return quantile(h, 0.5);
}

static void report(bench *b, const char *what, const histogram *h, double overhead, double inside)
{
    static const struct {
        const char *name;
        double share;
    } quantiles[] = {{"p50", 0.5}, {"p99", 0.99}, {"p99.99", 0.9999}, {"slowest", 1}};
    char name[96], note[96];
    snprintf(note, sizeof note, "of %lld calls; %.0f ns of clock taken off", (long long)h->count,
             overhead);
    for (int k = 0; k < 4; k++) {
        double share = quantiles[k].share;
        double ns = (share < 1 ? quantile(h, share) : h->longest) - overhead;
        snprintf(name, sizeof name, "%s, %s", what, quantiles[k].name);
        bench_report(b, (bench_row){.name = name,
                                    .value = ns,
                                    .unit = "ns",
                                    .ratio = ns / inside,
                                    .of = "step inside a run",
                                    .note = note});
    }
}

void bench_latency(bench *b)
{
    rig r;
    rig_create(b, TRK_VEHICLE_REFERENCE_TRUCK, TRK_VARIANT_THESIS_DAMPERS, 20, fmin(b->seconds, 60),
               &r);
    trk_newmark *stepper = rig_stepper(&r, 1e-3);
    histogram *empty = calloc(1, sizeof *empty), *bare = calloc(1, sizeof *bare),
              *whole = calloc(1, sizeof *whole);
    if (!empty || !bare || !whole)
        exit(1);
    double loop = INFINITY, inside = INFINITY, to_ns = 1e9 / (double)r.steps;
    for (int round = 0; round < b->rounds; round++) {
        loop = fmin(loop, to_ns * drive(&r, stepper, r.steps, false, NULL));
        inside = fmin(inside, to_ns * drive_inside(&r, stepper));
    }
    bench_report(b, (bench_row){"loop of single calls, mean", loop, "ns", loop / inside,
                                "step inside a run"});
    double overhead = clock_overhead(empty, b->calls / 10 + 1);
    drive(&r, stepper, b->calls, false, bare);
    drive(&r, stepper, b->calls, true, whole);
    report(b, "one call", bare, overhead, inside);
    report(b, "one call and 20 sensors", whole, overhead, inside);
    double waiting = empty->longest - overhead;
    bench_report(b, (bench_row){"nothing between two clock readings, slowest", waiting, "ns",
                                waiting / inside, "step inside a run"});
    free(empty);
    free(bare);
    free(whole);
    trk_newmark_destroy(stepper);
    rig_destroy(&r);
}
