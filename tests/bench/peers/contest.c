/* SPDX-License-Identifier: MIT */
/*
 * Integrators at matched accuracy: of each the fastest setting whose error is at most that of
 * Newmark's method at 1 ms, over the truck's sweep.
 */
#include "peers.h"

#include <math.h>
#include <stdlib.h>

enum { MOST_SETTINGS = 12 };

/* From loose to tight; 0 ends the list. */
#define STEPS                                                                                      \
    {                                                                                              \
        10e-3, 7.5e-3, 6e-3, 5e-3, 3.75e-3, 10e-3 / 3, 3e-3, 2.5e-3, 2e-3, 1.5e-3, 1e-3, 0.5e-3    \
    }
#define TOLERANCES                                                                                 \
    {                                                                                              \
        1e-2, 3e-3, 1e-3, 3e-4, 1e-4, 1e-5, 1e-6, 1e-7                                             \
    }

typedef struct contender {
    const char *name;
    peer_solver solve; /* NULL: not installed */
    bool by_step;
    double setting[MOST_SETTINGS];
    problem *problem;
    double *q;
    double chosen, error;
} contender;

#ifdef BENCH_WITH_SUNDIALS
#define SUNDIALS(solver) solver
#else
#define SUNDIALS(solver) NULL
#endif
#ifdef BENCH_WITH_GSL
#define GSL(solver) solver
#else
#define GSL(solver) NULL
#endif

static const contender all[] = {
    {"trk_newmark, 1 ms", peer_newmark, true, {1e-3}, 0, 0, 0, 0},
    {"trk_rungekutta, 1 ms", peer_rungekutta, true, {1e-3}, 0, 0, 0, 0},
    {"trk_rungekutta", peer_rungekutta, true, STEPS, 0, 0, 0, 0},
    {"plain Newton", peer_plain, true, {1e-3}, 0, 0, 0, 0},
    {"velocity Verlet", peer_verlet, true, STEPS, 0, 0, 0, 0},
    {"RK4", peer_rk4, true, STEPS, 0, 0, 0, 0},
    {"RK4, 1 ms", peer_rk4, true, {1e-3}, 0, 0, 0, 0},
    {"Dormand-Prince 5(4)", peer_dopri5, false, TOLERANCES, 0, 0, 0, 0},
    {"CVODE Adams", SUNDIALS(peer_cvode_adams), false, TOLERANCES, 0, 0, 0, 0},
    {"CVODE BDF", SUNDIALS(peer_cvode_bdf), false, TOLERANCES, 0, 0, 0, 0},
    {"ARKODE ERK 5", SUNDIALS(peer_arkode_erk), false, TOLERANCES, 0, 0, 0, 0},
    {"ARKODE DIRK 5", SUNDIALS(peer_arkode_dirk), false, TOLERANCES, 0, 0, 0, 0},
    {"GSL rk8pd", GSL(peer_gsl_rk8pd), false, TOLERANCES, 0, 0, 0, 0},
    {"GSL msadams", GSL(peer_gsl_msadams), false, TOLERANCES, 0, 0, 0, 0},
};
enum { CONTENDERS = sizeof all / sizeof *all };

static double run(void *argument)
{
    contender *c = argument;
    return c->problem && c->chosen > 0 ? c->solve(c->problem, c->chosen, c->q) : NAN;
}

static double error_of(const contender *c, const double *wanted)
{
    return bench_error(c->problem->samples + 1, c->problem->n, c->q, wanted);
}

/* The fastest setting accurate enough; of a single setting, that one. */
static void choose(contender *c, const double *wanted, double target)
{
    double best = INFINITY;
    bool single = c->setting[1] == 0;
    for (int k = 0; k < MOST_SETTINGS && c->setting[k] > 0; k++) {
        double seconds = c->solve(c->problem, c->setting[k], c->q);
        double error = error_of(c, wanted);
        if (isnan(seconds) || !(single || error <= target) || seconds >= best)
            continue;
        best = seconds;
        c->chosen = c->setting[k];
        c->error = error;
    }
}

static void report(bench *b, const contender *c, double seconds, double ours, double bound)
{
    char note[96];
    double milliseconds = 1e3 * PROBLEM_SAMPLE * (double)c->problem->samples;
    if (c->by_step)
        snprintf(note, sizeof note, "step %.3g ms", 1e3 * c->chosen);
    else
        snprintf(note, sizeof note, "relative tolerance %.0e, %.2f right-hand sides a ms",
                 c->chosen, (double)c->problem->evaluations / milliseconds / b->rounds);
    bench_report(b, (bench_row){.name = c->name,
                                .value = 1e9 * seconds / milliseconds,
                                .unit = "ns/ms",
                                .ratio = seconds / ours,
                                .of = all[0].name,
                                .error = c->error,
                                .bound = bound,
                                .note = note});
}

/* Run the chosen settings in turn and report; all[0] is what the others are compared with. */
static void race(bench *b, contender *contenders, double target)
{
    bench_contender turns[CONTENDERS];
    for (int k = 0; k < CONTENDERS; k++) {
        turns[k] = (bench_contender){run, &contenders[k], 0};
        if (contenders[k].problem)
            contenders[k].problem->evaluations = 0;
    }
    bench_race(b, turns, CONTENDERS);
    for (int k = 0; k < CONTENDERS; k++) {
        const contender *c = &contenders[k];
        if (!c->solve)
            bench_report(b, (bench_row){.name = c->name, .note = "not installed"});
        else if (!(c->chosen > 0))
            bench_report(b, (bench_row){.name = c->name, .note = "no setting is as accurate"});
        else /* the plain loop stops at the same tolerance, so its error differs in rounding */
            report(b, c, turns[k].best, turns[0].best, 1.001 * target);
    }
}

typedef struct evaluation {
    problem *problem;
    double t, y[2 * PROBLEM_MAX], out[2 * PROBLEM_MAX];
} evaluation;

static void evaluate_all(void *argument)
{
    evaluation *e = argument;
    for (int k = 0; k < 1000; k++, e->t += 1e-6)
        problem_derivative(e->problem, e->t, e->y, e->out);
}

static void evaluate_road(void *argument)
{
    evaluation *e = argument;
    for (int k = 0; k < 1000; k++, e->t += 1e-6)
        problem_road(e->problem, e->t, &e->out[0], &e->out[1]);
}

static void report_problem(bench *b, const rig *r, double reference_error)
{
    evaluation e = {.problem = problem_create(r)};
    double whole = bench_repeat(evaluate_all, &e), road = bench_repeat(evaluate_road, &e);
    problem_destroy(e.problem);
    bench_report(b, (bench_row){"right-hand side of the peers", 1e6 * whole, "ns", road / whole,
                                "of it the sweep"});
    bench_report(b, (bench_row){.name = "reference, RK4 with 1/32 ms",
                                .error = reference_error,
                                .bound = 1e-8,
                                .note = "change from 1/16 ms"});
}

void bench_peers(bench *b)
{
    contender contenders[CONTENDERS];
    rig r;
    rig_create(b, TRK_VEHICLE_REFERENCE_TRUCK, TRK_VARIANT_THESIS_DAMPERS, RIG_ALL_SENSORS,
               b->full || b->tiny ? b->seconds : b->seconds / 8, &r);
    problem *p = problem_create(&r);
    int64_t count = (p->samples + 1) * p->n;
    double *wanted = bench_zeros(count), *coarser = bench_zeros(count), target = 0;
    peer_rk4(p, 1e-3 / 16, coarser);
    peer_rk4(p, 1e-3 / 32, wanted);
    report_problem(b, &r, bench_error(p->samples + 1, p->n, coarser, wanted));
    for (int k = 0; k < CONTENDERS; k++) {
        contender *c = &contenders[k];
        *c = all[k];
        if (!c->solve)
            continue;
        c->problem = problem_create(&r);
        c->q = bench_zeros(count);
        choose(c, wanted, target);
        if (k == 0)
            target = c->error;
    }
    race(b, contenders, target);
    for (int k = 0; k < CONTENDERS; k++) {
        free(contenders[k].q);
        problem_destroy(contenders[k].problem);
    }
    free(wanted);
    free(coarser);
    problem_destroy(p);
    rig_destroy(&r);
}
