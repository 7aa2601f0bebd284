/* SPDX-License-Identifier: MIT */
/* Steps of a search for the lowest modes: shift, Lanczos, Rayleigh-Ritz (LINEAR.20, LINEAR.22). */
#include "linear/search.h"

#include "base/random.h"
#include "linalg/eigen.h"
#include "linear/ritz.h"

#include <math.h>
#include <string.h>

enum { MOST_SHIFTS = 11, GUESS_SEED = 2, FEW_MODES = 10 };

/* M, and how large K may be beside it. */
static void measure(trk_search *s)
{
    const trk_pattern *pattern = trk_solver_pattern(s->assembly.solver);
    const double *values = trk_solver_values(s->assembly.solver);
    trk_assembly_fill(&s->assembly, 1, NULL);
    memcpy(s->mass, values, (size_t)pattern->start[s->rows->n] * sizeof *values);
    trk_assembly_fill(&s->assembly, 0, s->rows->tangent);
    for (int32_t i = 0; i < s->rows->n; i++) {
        int32_t at = pattern->start[i];
        s->stiffest = fmax(s->stiffest, fabs(values[at]) / s->mass[at]);
    }
}

trk_status trk_search_factorize(trk_search *s)
{
    int32_t bad;
    return trk_assembly_factorize(&s->assembly, s->sigma, s->rows->tangent, &bad);
}

/*
 * The least shift at which S is safely positive definite: rounding of K stays below it. An
 * unstable working point has negative lambda and needs more.
 */
trk_status trk_search_choose_shift(trk_search *s)
{
    measure(s);
    trk_status status = TRK_E_SINGULAR;
    s->sigma = s->stiffest > 0 ? 1e-13 * s->stiffest : 1;
    for (int k = 0; k < MOST_SHIFTS && status == TRK_E_SINGULAR; k++) {
        if (k > 0)
            s->sigma *= 30;
        status = trk_search_factorize(s);
    }
    if (status == TRK_E_SINGULAR)
        return trk_fail(s->context, TRK_E_CONVERGENCE,
                        "%s: modes: stiffness and %g times the mass are not positive definite; the "
                        "working point is far from stable",
                        s->rows->name, s->sigma);
    const trk_pattern *pattern = trk_solver_pattern(s->assembly.solver);
    for (int32_t i = 0; status == TRK_OK && i < s->rows->n; i++)
        s->scale[i] = trk_solver_values(s->assembly.solver)[pattern->start[i]];
    return status;
}

/* `more` modes beside those found, then the lowest of all, as good as the rows let them be. */
trk_status trk_search_extend(trk_search *s, int32_t more)
{
    const trk_pencil pencil = {s->assembly.solver, s->mass, s->sigma};
    trk_status status =
        trk_eigen_lowest(s->context, &pencil, s->count, s->phi, more, s->lambda + s->count,
                         s->phi + (int64_t)s->count * s->rows->n);
    if (status != TRK_OK)
        return status;
    s->count += more;
    status = trk_ritz(s->context, s->rows, s->count, s->phi, s->lambda);
    if (s->count > s->wanted + TRK_SEARCH_SPARE)
        s->count = s->wanted + TRK_SEARCH_SPARE;
    return status;
}

/* Rayleigh quotient of a random vector after two inverse iterations: about the lowest lambda. */
static trk_status guess_lowest(trk_search *s, double *out)
{
    trk_status status = TRK_OK;
    for (int32_t i = 0; i < s->rows->n; i++)
        s->phi[i] = 2 * trk_random_uniform(GUESS_SEED, (uint64_t)i, 0) - 1;
    for (int k = 0; status == TRK_OK && k < 2; k++) {
        trk_pattern_multiply(trk_solver_pattern(s->assembly.solver), s->mass, s->phi, s->work);
        memcpy(s->phi, s->work, (size_t)s->rows->n * sizeof(double));
        status = trk_solver_solve(s->assembly.solver, s->phi);
    }
    return status == TRK_OK ? trk_ritz(s->context, s->rows, 1, s->phi, out) : status;
}

/*
 * Where bodies are free, 1 / (lambda + sigma) of rigid motion dwarfs that of all else, whose
 * modes rounding then spoils: a few of these tell how much larger sigma may be.
 */
trk_status trk_search_raise_shift(trk_search *s)
{
    double lowest;
    trk_status status = guess_lowest(s, &lowest);
    int32_t most = s->wanted + TRK_SEARCH_SPARE;
    for (int32_t few = FEW_MODES; status == TRK_OK && lowest <= s->sigma; few *= 2) {
        int32_t count = few < most ? few : most;
        s->count = 0;
        status = trk_search_extend(s, count);
        if (status == TRK_OK)
            lowest = s->lambda[count - 1];
        if (count == most)
            break;
    }
    s->count = 0;
    if (status != TRK_OK || 1e-3 * lowest <= s->sigma)
        return status;
    s->sigma = 1e-3 * lowest;
    return trk_search_factorize(s);
}
