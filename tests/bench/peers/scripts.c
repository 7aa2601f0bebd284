/* SPDX-License-Identifier: MIT */
/*
 * Integrators of interpreted languages on the same truck: the problem and its reference
 * solution go to a file as JSON, the scripts beside this file print a line for each method.
 */
#define _XOPEN_SOURCE 700 /* mkstemp, P_tmpdir */
#include "../script.h"
#include "peers.h"

#include <math.h>
#include <stdlib.h>
#include <unistd.h>

enum { MOST_LINES = 16 };

static void write_array(FILE *file, const char *key, int rows, int columns, const double *x)
{
    fprintf(file, "\"%s\": [", key);
    for (int i = 0; i < rows; i++) {
        fprintf(file, "%s[", i ? ", " : "");
        for (int j = 0; j < columns; j++)
            fprintf(file, "%s%.17g", j ? ", " : "", x[i * columns + j]);
        fprintf(file, "]");
    }
    fprintf(file, "],\n");
}

/* M times columns of a problem, which hold M^-1 of what the equations of motion say; row-major. */
static void write_product(FILE *file, const char *key, const problem *p, double sign,
                          const problem_vector *columns, int count)
{
    double mass[PROBLEM_MAX * PROBLEM_MAX], out[PROBLEM_MAX * PROBLEM_MAX] = {0};
    trk_model_get_mass(p->rig->model, mass);
    for (int i = 0; i < p->n; i++)
        for (int j = 0; j < count; j++)
            for (int k = 0; k < p->n; k++)
                out[i * count + j] += sign * mass[i * p->n + k] * ((const double *)&columns[j])[k];
    write_array(file, key, p->n, count, out);
}

/* Damper curves as piecewise cubics about their left break, highest power first. */
static void write_tables(FILE *file, const problem *p)
{
    const double far = 100; /* [m/s], instead of infinity */
    fprintf(file, "\"tables\": [");
    for (int k = 0; k < p->tables; k++) {
        const problem_table *t = &p->table[k];
        fprintf(file, "%s{\"breaks\": [%.17g", k ? ", " : "", t->x[0] - far);
        for (int j = 0; j < t->points; j++)
            fprintf(file, ", %.17g", t->x[j]);
        fprintf(file, ", %.17g], \"pieces\": [", t->x[t->points - 1] + far);
        for (int j = 0; j <= t->points; j++)
            fprintf(file, "%s[%.17g, %.17g, %.17g, %.17g]", j ? ", " : "", t->c[j][3], t->c[j][2],
                    t->c[j][1], t->c[j][0] - (j == 0 ? far * t->c[j][1] : 0));
        fprintf(file, "]}");
    }
    fprintf(file, "],\n");
}

static bool write_problem(FILE *file, const problem *p, const double *wanted, double target)
{
    double rows[PROBLEM_TABLES * PROBLEM_MAX];
    for (int k = 0; k < p->tables; k++)
        for (int i = 0; i < p->n; i++)
            rows[k * p->n + i] = p->rate_of[i][k];
    fprintf(file, "{\n\"n\": %d,\n", p->n);
    write_product(file, "stiffness", p, -1, p->linear, p->n);
    write_product(file, "damping", p, -1, p->linear + p->n, p->n);
    write_product(file, "of_height", p, 1, &p->of_height, 1);
    write_product(file, "of_rate", p, 1, &p->of_rate, 1);
    write_array(file, "rows", p->tables, p->n, rows);
    write_tables(file, p);
    write_array(file, "q", (int)p->samples + 1, p->n, wanted);
    double mass[PROBLEM_MAX * PROBLEM_MAX];
    trk_model_get_mass(p->rig->model, mass);
    write_array(file, "mass", p->n, p->n, mass);
    fprintf(file,
            "\"sample\": %.17g, \"frequency\": %.17g, \"growth\": %.17g, \"amplitude\": %.17g,\n"
            "\"target\": %.17g}\n",
            PROBLEM_SAMPLE, p->frequency, p->growth, p->amplitude, target);
    return fclose(file) == 0;
}

static void run_script(bench *b, const problem *p, const char *language, const char *interpreter,
                       const char *script, const char *file, double ours, double target)
{
    char name[96];
    script_line lines[MOST_LINES];
    double milliseconds = 1e3 * PROBLEM_SAMPLE * (double)p->samples;
    int count = script_run(interpreter, script, file, MOST_LINES, lines);
    if (count <= 0)
        bench_report(b, (bench_row){.name = language, .note = "not installed"});
    for (int k = 0; k < count; k++) {
        snprintf(name, sizeof name, "%s: %.63s", language, lines[k].name);
        bench_report(b, (bench_row){.name = name,
                                    .value = 1e9 * lines[k].seconds / milliseconds,
                                    .unit = "ns/ms",
                                    .ratio = lines[k].seconds / ours,
                                    .of = "trk_newmark, 1 ms",
                                    .error = lines[k].error,
                                    .bound = 1.001 * target});
    }
}

void bench_scripts(bench *b)
{
    char path[] = P_tmpdir "/truckride-bench-XXXXXX";
    rig r;
    rig_create(b, TRK_VEHICLE_REFERENCE_TRUCK, TRK_VARIANT_THESIS_DAMPERS, RIG_ALL_SENSORS,
               b->tiny ? 0.2 : 2, &r);
    problem *p = problem_create(&r);
    int64_t count = (p->samples + 1) * p->n;
    double *wanted = bench_zeros(count), *q = bench_zeros(count), ours = INFINITY;
    peer_rk4(p, 1e-3 / 32, wanted);
    for (int round = 0; round < 10; round++)
        ours = fmin(ours, peer_newmark(p, 1e-3, q));
    double target = bench_error(p->samples + 1, p->n, q, wanted);
    int descriptor = mkstemp(path);
    FILE *file = descriptor >= 0 ? fdopen(descriptor, "w") : NULL;
    if (!file || !write_problem(file, p, wanted, target)) {
        perror(path);
        exit(1);
    }
    run_script(b, p, "SciPy", BENCH_PYTHON, "truck.py", path, ours, target);
    run_script(b, p, "Octave", BENCH_OCTAVE, "truck.m", path, ours, target);
    unlink(path);
    free(wanted);
    free(q);
    problem_destroy(p);
    rig_destroy(&r);
}
