/* SPDX-License-Identifier: MIT */
/* The seam between assembly and the solver backends. */
#include "linalg/solver.h"

#include "linalg/backend.h"

#include <string.h>

/* AUTO is dense up to here. Set by measurement: the table in docs/theory/linalg.md. */
enum { DENSE_UNKNOWNS = 32 };

struct trk_solver {
    trk_context *context;
    const trk_solver_ops *ops;
    void *state; /* of the backend */
    trk_pattern pattern;
    double *values; /* length pattern.start[n] */
    bool factorized;
};

static const trk_solver_ops *const backends[] = {
    &trk_dense_ops,
#ifdef TRUCKRIDE_WITH_CHOLMOD
    &trk_cholmod_ops,
#endif
};

static const trk_solver_ops *find_backend(trk_backend backend)
{
    for (size_t k = 0; k < sizeof backends / sizeof *backends; k++)
        if (backends[k]->backend == backend)
            return backends[k];
    return NULL;
}

static trk_status choose_backend(trk_context *context, trk_backend backend, int32_t n,
                                 const trk_solver_ops **out_ops)
{
    if (backend < TRK_BACKEND_AUTO || backend > TRK_BACKEND_SPARSE)
        return trk_fail(context, TRK_E_ARGUMENT, "solver: backend %d, expected a TRK_BACKEND value",
                        (int)backend);
    bool automatic = backend == TRK_BACKEND_AUTO;
    if (automatic)
        backend = n > DENSE_UNKNOWNS ? TRK_BACKEND_SPARSE : TRK_BACKEND_DENSE;
    *out_ops = find_backend(backend);
    if (!*out_ops && automatic)
        *out_ops = &trk_dense_ops;
    if (!*out_ops)
        return trk_fail(context, TRK_E_UNSUPPORTED,
                        "solver: the sparse backend was asked for, but this build has no CHOLMOD");
    return TRK_OK;
}

trk_status trk_solver_create(trk_context *context, trk_backend backend, int32_t n, int64_t count,
                             const int32_t *rows, const int32_t *columns, int64_t *out_slots,
                             trk_solver **out_solver)
{
    TRK_REQUIRE(context, out_solver, "trk_solver_create");
    *out_solver = NULL;
    TRK_REQUIRE(NULL, context, "trk_solver_create");
    if (n < 1 || count < 0)
        return trk_fail(context, TRK_E_RANGE,
                        "solver: %d unknowns and %lld entries, expected at least 1 and 0", (int)n,
                        (long long)count);
    if (count > 0) {
        TRK_REQUIRE(context, rows, "trk_solver_create");
        TRK_REQUIRE(context, columns, "trk_solver_create");
        TRK_REQUIRE(context, out_slots, "trk_solver_create");
    }
    const trk_solver_ops *ops = NULL;
    trk_status status = choose_backend(context, backend, n, &ops);
    if (status != TRK_OK)
        return status;
    trk_solver *solver = trk_new(context, 1, sizeof *solver);
    if (!solver)
        return TRK_E_MEMORY;
    solver->context = context;
    solver->ops = ops;
    status = trk_pattern_create(context, n, count, rows, columns, out_slots, &solver->pattern);
    if (status == TRK_OK) {
        solver->values = trk_new(context, solver->pattern.start[n], sizeof *solver->values);
        status = solver->values ? TRK_OK : TRK_E_MEMORY;
    }
    if (status == TRK_OK)
        status = ops->create(context, &solver->pattern, &solver->state);
    if (status != TRK_OK) {
        trk_solver_destroy(solver);
        return status;
    }
    *out_solver = solver;
    return TRK_OK;
}

void trk_solver_destroy(trk_solver *solver)
{
    if (!solver)
        return;
    solver->ops->destroy(solver->state);
    trk_pattern_destroy(solver->context, &solver->pattern);
    trk_free(solver->context, solver->values);
    trk_free(solver->context, solver);
}

trk_backend trk_solver_backend(const trk_solver *solver)
{
    return solver->ops->backend;
}

double *trk_solver_values(trk_solver *solver)
{
    return solver->values;
}

void trk_solver_clear(trk_solver *solver)
{
    memset(solver->values, 0, (size_t)solver->pattern.start[solver->pattern.n] * sizeof(double));
}

trk_status trk_solver_factorize(trk_solver *solver, int32_t *out_bad)
{
    *out_bad = -1;
    trk_status status = solver->ops->factorize(solver->state, solver->values, out_bad);
    solver->factorized = status == TRK_OK;
    return status;
}

trk_status trk_solver_solve(trk_solver *solver, double *x)
{
    if (!solver->factorized)
        return trk_fail(
            solver->context, TRK_E_ARGUMENT,
            "solver: solve needs a %s factorization, but the last one failed or never ran",
            solver->ops->name);
    return solver->ops->solve(solver->state, x);
}

const trk_pattern *trk_solver_pattern(const trk_solver *solver)
{
    return &solver->pattern;
}

trk_status trk_solver_count_negative(trk_solver *solver, const double *scale, int32_t *out_count,
                                     double *out_growth)
{
    *out_count = 0;
    *out_growth = 0;
    solver->factorized = false;
    return solver->ops->count_negative(solver->state, solver->values, scale, out_count, out_growth);
}

int64_t trk_solver_factor_entries(const trk_solver *solver)
{
    return solver->ops->factor_entries(solver->state);
}
