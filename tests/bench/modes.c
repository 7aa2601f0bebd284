/* SPDX-License-Identifier: MIT */
/* Modes of the 13-DOF truck beside bare LAPACK calls on the finished matrices. */
#include "rig.h"

#ifdef TRUCKRIDE_WITH_LAPACK
#include "linalg/lapack.h"

#include <math.h>
#include <string.h>

enum { MOST = RIG_COORDINATES, STATES = 2 * MOST, WORK = 4096 };

typedef struct modes_run {
    const rig *rig;
    int32_t n, m; /* m = 2 n */
    double mass[MOST * MOST], damping[MOST * MOST], stiffness[MOST * MOST];
    double state[STATES * STATES]; /* of y' = state y, column-major */
    double lambda[MOST], re[STATES], im[STATES];
} modes_run;

static void undamped(void *argument)
{
    const rig *r = ((modes_run *)argument)->rig;
    trk_modes *modes;
    bench_must(r->bench, trk_modes_create_undamped(r->bench->context, r->model, NULL, &modes));
    trk_modes_destroy(modes);
}

static void damped(void *argument)
{
    const rig *r = ((modes_run *)argument)->rig;
    trk_modes *modes;
    bench_must(r->bench, trk_modes_create_damped(r->bench->context, r->model, NULL, NULL, &modes));
    trk_modes_destroy(modes);
}

static void lapack_undamped(void *argument)
{
    modes_run *r = argument;
    double k[MOST * MOST], m[MOST * MOST], work[WORK];
    int32_t one = 1, size = WORK, integers[STATES * 8], integer_size = STATES * 8, info;
    memcpy(k, r->stiffness, sizeof k);
    memcpy(m, r->mass, sizeof m);
    dsygvd_(&one, "V", "L", &r->n, k, &r->n, m, &r->n, r->lambda, work, &size, integers,
            &integer_size, &info, 1, 1);
}

static void lapack_damped(void *argument)
{
    modes_run *r = argument;
    double a[STATES * STATES], vectors[STATES * STATES], none, work[WORK];
    int32_t one = 1, size = WORK, info;
    memcpy(a, r->state, sizeof a);
    dgeev_("N", "V", &r->m, a, &r->m, r->re, r->im, &none, &one, vectors, &r->m, work, &size, &info,
           1, 1);
}

/* The mass matrix of the truck is diagonal. */
static void set_state_matrix(modes_run *r)
{
    int n = r->n;
    for (int i = 0; i < n; i++) {
        r->state[(n + i) * r->m + i] = 1;
        for (int j = 0; j < n; j++) {
            r->state[j * r->m + n + i] = -r->stiffness[i * n + j] / r->mass[i * n + i];
            r->state[(n + j) * r->m + n + i] = -r->damping[i * n + j] / r->mass[i * n + i];
        }
    }
}

/* Largest relative difference of a natural frequency; the peers' order may differ. */
static double frequency_error(const trk_modes *modes, int32_t count, const double *size)
{
    double worst = 0;
    for (int32_t k = 1; k <= trk_modes_count(modes); k++) {
        double wanted = 2 * 3.14159265358979323846 * trk_modes_frequency(modes, k), off = INFINITY;
        for (int32_t j = 0; j < count; j++)
            off = fmin(off, fabs(size[j] - wanted) / wanted);
        worst = fmax(worst, off);
    }
    return worst;
}

static void report(bench *b, const char *name, double seconds, double peer, double error)
{
    bench_report(b, (bench_row){.name = name,
                                .value = 1e6 * seconds,
                                .unit = "us",
                                .ratio = seconds / peer,
                                .of = "LAPACK alone",
                                .error = error,
                                .bound = 1e-9});
}

void bench_modes(bench *b)
{
    rig g;
    modes_run r = {.rig = &g};
    double size[STATES], best[4] = {INFINITY, INFINITY, INFINITY, INFINITY};
    void (*const run[])(void *) = {undamped, lapack_undamped, damped, lapack_damped};
    trk_modes *modes;
    rig_create(b, TRK_VEHICLE_REFERENCE_TRUCK, TRK_VARIANT_THESIS_DAMPERS, RIG_ALL_SENSORS, 1, &g);
    r.n = g.n;
    r.m = 2 * g.n;
    trk_model_get_mass(g.model, r.mass);
    trk_model_get_tangent(g.model, NULL, NULL, r.damping, r.stiffness);
    set_state_matrix(&r);
    for (int round = 0; round < b->rounds; round++)
        for (int k = 0; k < 4; k++)
            best[k] = fmin(best[k], bench_repeat(run[k], &r));
    for (int k = 0; k < r.n; k++)
        size[k] = sqrt(r.lambda[k]);
    undamped(&r);
    bench_must(b, trk_modes_create_undamped(b->context, g.model, NULL, &modes));
    report(b, "truck: trk_modes_create_undamped", best[0], best[1],
           frequency_error(modes, r.n, size));
    trk_modes_destroy(modes);
    for (int k = 0; k < r.m; k++)
        size[k] = hypot(r.re[k], r.im[k]);
    bench_must(b, trk_modes_create_damped(b->context, g.model, NULL, NULL, &modes));
    report(b, "truck: trk_modes_create_damped", best[2], best[3],
           frequency_error(modes, r.m, size));
    trk_modes_destroy(modes);
    rig_destroy(&g);
}
#else
void bench_modes(bench *b)
{
    bench_report(b, (bench_row){.name = "modes", .note = "this build has no LAPACK"});
}
#endif
