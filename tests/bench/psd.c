/* SPDX-License-Identifier: MIT */
/* Welch's PSD of 480,001 samples, the length of a road-simulator run, beside FFTW. */
#include "psd_peer.h"
#include "script.h"

#include <math.h>
#include <stdlib.h>

typedef struct psd_run {
    bench *bench;
    trk_spectrum_options options;
    int64_t count;
    double *x, *density, *peer;
    psd_peer *plan;
} psd_run;

static double run_ours(void *argument)
{
    psd_run *r = argument;
    double start = bench_cpu();
    bench_must(r->bench, trk_psd(r->bench->context, r->count, r->x, 1000, &r->options, r->density));
    return bench_cpu() - start;
}

static double run_peer(void *argument)
{
    psd_run *r = argument;
    if (!r->plan)
        return NAN;
    double start = bench_cpu();
    psd_peer_run(r->plan, r->x, 1000, r->peer);
    return bench_cpu() - start;
}

static void report_scipy(bench *b, const psd_run *r, double seconds)
{
    char argument[64];
    script_line line;
    snprintf(argument, sizeof argument, "%lld %lld %g", (long long)r->count,
             (long long)r->options.segment_length, r->options.overlap);
    if (script_run(BENCH_PYTHON, "welch.py", argument, 1, &line) == 1)
        bench_report(b, (bench_row){"  scipy.signal.welch", 1e3 * line.seconds, "ms",
                                    line.seconds / seconds, "trk_psd"});
    else
        bench_report(b, (bench_row){.name = "  scipy.signal.welch", .note = "not installed"});
}

static void measure(bench *b, psd_run *r)
{
    char name[96];
    int64_t length = trk_psd_length(&r->options, r->count),
            segments = trk_psd_segments(&r->options, r->count);
    int64_t hop = r->options.segment_length -
                  (int64_t)(r->options.overlap * (double)r->options.segment_length);
    r->density = bench_zeros(length);
    r->peer = bench_zeros(length);
    r->plan = psd_peer_create(r->options.segment_length, hop, segments);
    bench_contender turns[] = {{run_ours, r, 0}, {run_peer, r, 0}};
    bench_race(b, turns, 2);
    double n = (double)r->options.segment_length;
    double ns = 1e9 / (double)r->count, flops = 2.5 * n * log2(n) * (double)segments;
    snprintf(name, sizeof name, "trk_psd, %.0f samples a segment, overlap %g", n,
             r->options.overlap);
    bench_row row = {.name = name,
                     .value = 1e3 * turns[0].best,
                     .unit = "ms",
                     .each = ns * turns[0].best,
                     .element = "sample",
                     .note = "FFTW is not installed"};
    if (r->plan) {
        row.ratio = turns[0].best / turns[1].best;
        row.of = "FFTW";
        row.error = bench_error(length, 1, r->density, r->peer);
        row.bound = 1e-10;
        row.note = NULL;
    }
    bench_report(b, row);
    bench_report(b, (bench_row){"  its transforms at FMA peak", flops, "flop",
                                flops / b->peak / turns[0].best, "trk_psd"});
    bench_report(b, (bench_row){"  reading the samples once from DRAM", 8.0 * (double)r->count, "B",
                                8.0 * (double)r->count / b->dram / turns[0].best, "trk_psd"});
    report_scipy(b, r, turns[0].best);
    psd_peer_destroy(r->plan);
    free(r->density);
    free(r->peer);
}

void bench_psd(bench *b)
{
    static const struct {
        int64_t length;
        double overlap;
    } cases[] = {{4096, 0.5}, {8192, 0.9}, {6000, 0.5}};
    psd_run r = {.bench = b, .count = b->tiny ? 20001 : 480001};
    uint64_t state = 1;
    trk_spectrum_options_init(&r.options, sizeof r.options);
    r.x = bench_zeros(r.count);
    for (int64_t k = 0; k < r.count; k++) { /* noise */
        state = state * 6364136223846793005u + 1442695040888963407u;
        r.x[k] = (double)(state >> 11) * 0x1p-53 - 0.5;
    }
    for (int k = 0; k < 3; k++) {
        r.options.segment_length = cases[k].length;
        r.options.overlap = cases[k].overlap;
        measure(b, &r);
    }
    free(r.x);
}
