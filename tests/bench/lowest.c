/* SPDX-License-Identifier: MIT */
/* Lowest modes of a ladder frame beside SciPy's eigsh on the same matrices. */
#define _POSIX_C_SOURCE 200809L
#include "ladder.h"
#include "script.h"

#include "model/model.h"
#include "system/assembly.h"

#include <math.h>
#include <stdlib.h>
#include <unistd.h>

#if defined TRUCKRIDE_WITH_ARPACK && defined TRUCKRIDE_WITH_CHOLMOD && defined TRUCKRIDE_WITH_LAPACK
enum { COUNT = 20 };

typedef struct lowest_run {
    const bench *bench;
    const trk_model *model;
    trk_modes *modes;
} lowest_run;

static double lowest(void *argument)
{
    lowest_run *r = argument;
    trk_modes_destroy(r->modes);
    double start = bench_cpu();
    bench_must(r->bench,
               trk_modes_create_lowest(r->bench->context, r->model, NULL, COUNT, &r->modes));
    return bench_cpu() - start;
}

static bool write_block(FILE *file, const void *block, size_t size, int64_t count)
{
    return fwrite(block, size, (size_t)count, file) == (size_t)count;
}

/*
 * n, COUNT and the number of entries; row starts and columns of the lower triangle by columns; K,
 * M; our lambda: what lowest.py reads.
 */
static bool write_problem(const lowest_run *r, FILE *file)
{
    const trk_model *model = r->model;
    trk_assembly assembly;
    double *tangent = bench_zeros(model->links.count), ignored, lambda[COUNT];
    for (int32_t k = 0; k < model->links.count; k++)
        trk_model_link_tangent(model, k, NULL, NULL, &tangent[k], &ignored);
    for (int k = 0; k < COUNT; k++)
        lambda[k] = pow(2 * 3.14159265358979323846 * trk_modes_frequency(r->modes, k + 1), 2);
    bench_must(r->bench,
               trk_assembly_create(r->bench->context, TRK_BACKEND_SPARSE, model->n, &model->inertia,
                                   model->mass, &model->links, &assembly));
    const trk_pattern *pattern = trk_solver_pattern(assembly.solver);
    const int32_t head[] = {model->n, COUNT, pattern->start[model->n]};
    double *values = trk_solver_values(assembly.solver);
    bool good = write_block(file, head, sizeof *head, 3) &&
                write_block(file, pattern->start, sizeof(int32_t), model->n + 1) &&
                write_block(file, pattern->row, sizeof(int32_t), head[2]);
    trk_assembly_fill(&assembly, 0, tangent);
    good = good && write_block(file, values, sizeof(double), head[2]);
    trk_assembly_fill(&assembly, 1, NULL);
    good = good && write_block(file, values, sizeof(double), head[2]) &&
           write_block(file, lambda, sizeof(double), COUNT);
    trk_assembly_clear(&assembly);
    free(tangent);
    return good;
}

/* SciPy's time and the largest relative difference of a frequency; false: it is not there. */
static bool ask_scipy(const lowest_run *r, script_line *line)
{
    char path[] = "/tmp/truckride-lowest-XXXXXX";
    int descriptor = mkstemp(path);
    FILE *file = descriptor < 0 ? NULL : fdopen(descriptor, "wb");
    if (!file)
        return false;
    bool good = write_problem(r, file);
    good = fclose(file) == 0 && good && script_run(BENCH_PYTHON, "lowest.py", path, 1, line) == 1;
    remove(path);
    return good;
}

static void measure(bench *b, int32_t n)
{
    char name[64], note[64];
    script_line line = {.seconds = 0};
    lowest_run r = {.bench = b, .model = ladder_build(b, n)};
    bench_contender ours = {lowest, &r, INFINITY};
    bench_race(b, &ours, 1);
    bool has_peer = ask_scipy(&r, &line);
    snprintf(name, sizeof name, "ladder of %d: 20 modes", (int)r.model->n);
    snprintf(note, sizeof note, "%.4g Hz to %.4g Hz", trk_modes_frequency(r.modes, 1),
             trk_modes_frequency(r.modes, COUNT));
    bench_report(b, (bench_row){.name = name,
                                .value = 1e3 * ours.best,
                                .unit = "ms",
                                .ratio = has_peer ? ours.best / line.seconds : 0,
                                .of = "SciPy's eigsh",
                                .each = 1e9 * ours.best / r.model->n,
                                .element = "coordinate",
                                .error = line.error,
                                .bound = has_peer ? 1e-4 : 0,
                                .note = has_peer ? note : "SciPy is not installed"});
    trk_modes_destroy(r.modes);
    trk_model_destroy((trk_model *)r.model);
}

void bench_lowest(bench *b)
{
    const int32_t sizes[] = {996, 9996, 30000};
    for (size_t k = 0; k < (b->tiny ? 1 : sizeof sizes / sizeof *sizes); k++)
        measure(b, sizes[k]);
}
#else
void bench_lowest(bench *b)
{
    bench_report(b, (bench_row){.name = "modes", .note = "this build has no ARPACK"});
}
#endif
