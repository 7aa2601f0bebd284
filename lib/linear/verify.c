/* SPDX-License-Identifier: MIT */
/*
 * The two questions that a Lanczos method leaves open: is none of the lowest modes missing
 * (LINEAR.21), and is each pair a mode (LINEAR.22)?
 */
#include "linear/ritz.h"
#include "linear/search.h"

#include <float.h>
#include <math.h>
#include <string.h>

enum { MOST_ROUNDS = 20, MOST_POLISHES = 5, MOST_GROWTH = 10000 };

/* Of lambda + sigma: between modes, for a count to stand in; of a pair, to be a mode. */
static const double least_gap = 1e-6, residual_limit = 1e-8;

static bool is_gap(const trk_search *s, int32_t above)
{
    double width = s->lambda[above] - s->lambda[above - 1];
    return width > least_gap * (s->lambda[above] + s->sigma) &&
           width > 100 * DBL_EPSILON * s->stiffest;
}

/*
 * Number of modes below a gap: the first one above those wanted. Without one, the last wanted mode
 * belongs to a cluster, of which any members will do: then the gap below the cluster.
 */
static int32_t find_gap(const trk_search *s)
{
    int32_t k = s->wanted;
    while (k < s->count && !is_gap(s, k))
        k++;
    if (k == s->count)
        for (k = s->wanted - 1; k > 0 && !is_gap(s, k);)
            k--;
    return k;
}

/*
 * Eigenvalues below a place in the gap above mode `last`. An unlucky place makes the
 * factorization grow: then it is another one.
 */
static trk_status count_below(trk_search *s, int32_t last, int32_t *out_count)
{
    static const double places[] = {0.5, 0.37, 0.64, 0.25, 0.79};
    double growth = INFINITY, to = s->lambda[last];
    double from = last > 0 ? s->lambda[last - 1] : to - (to + s->sigma) / 2;
    for (size_t k = 0; k < sizeof places / sizeof *places; k++) {
        trk_assembly_fill(&s->assembly, -(from + places[k] * (to - from)), s->rows->tangent);
        trk_status status =
            trk_solver_count_negative(s->assembly.solver, s->scale, out_count, &growth);
        if (status == TRK_OK && growth <= MOST_GROWTH)
            return TRK_OK;
        if (status != TRK_OK && status != TRK_E_SINGULAR)
            return status;
    }
    return trk_fail(s->context, TRK_E_CONVERGENCE,
                    "%s: modes: the count of eigenvalues is not to be trusted, growth %g",
                    s->rows->name, growth);
}

/* Search until the count agrees; ends with S factorized. */
trk_status trk_search_complete(trk_search *s)
{
    int32_t last = 0, below = 0;
    trk_status status = trk_search_choose_shift(s);
    if (status == TRK_OK)
        status = trk_search_raise_shift(s);
    if (status == TRK_OK)
        status = trk_search_extend(s, s->wanted + TRK_SEARCH_SPARE);
    for (int round = 0; status == TRK_OK && round < MOST_ROUNDS; round++) {
        last = find_gap(s);
        status = count_below(s, last, &below);
        if (status == TRK_OK)
            status = trk_search_factorize(s);
        if (status == TRK_OK && below == last)
            return TRK_OK;
        if (below < last)
            break;
        if (status == TRK_OK)
            status = trk_search_extend(s, below - last < s->wanted ? below - last : s->wanted);
    }
    return status != TRK_OK
               ? status
               : trk_fail(s->context, TRK_E_CONVERGENCE,
                          "%s: modes: %d modes were found up to %g Hz, where there are %d",
                          s->rows->name, (int)last,
                          sqrt(fmax(s->lambda[last], 0)) / 6.283185307179586, (int)below);
}

/* y := S^-1 M phi; in norms of M, its distance from phi / (lambda + sigma) times lambda + sigma. */
static trk_status find_residual(trk_search *s, int32_t mode, double *y, double *out)
{
    const trk_pattern *pattern = trk_solver_pattern(s->assembly.solver);
    const double *phi = s->phi + (int64_t)mode * s->rows->n;
    double *rest = s->work, *product = rest + s->rows->n, size = s->lambda[mode] + s->sigma,
           sum = 0;
    trk_pattern_multiply(pattern, s->mass, phi, y);
    trk_status status = trk_solver_solve(s->assembly.solver, y);
    if (status != TRK_OK)
        return status;
    for (int32_t i = 0; i < s->rows->n; i++)
        rest[i] = size * y[i] - phi[i];
    trk_pattern_multiply(pattern, s->mass, rest, product);
    for (int32_t i = 0; i < s->rows->n; i++)
        sum += rest[i] * product[i];
    *out = sqrt(fmax(sum, 0));
    return TRK_OK;
}

/*
 * One inverse iteration of all modes found, whose results are at hand when the residuals are:
 * where those are too large, the Ritz vectors of the results are better.
 */
trk_status trk_search_polish(trk_search *s)
{
    double worst = 0;
    int32_t bad = 0;
    for (int round = 0; round < MOST_POLISHES; round++) {
        worst = 0;
        for (int32_t k = 0; k < s->count; k++) {
            double residual, size = s->lambda[k] + s->sigma;
            trk_status status = find_residual(s, k, s->next + (int64_t)k * s->rows->n, &residual);
            if (status != TRK_OK)
                return status;
            residual -= 64 * DBL_EPSILON * s->stiffest / size;
            if (k < s->wanted && !(residual <= worst)) {
                worst = residual;
                bad = k;
            }
        }
        if (worst <= residual_limit)
            return TRK_OK;
        memcpy(s->phi, s->next, (size_t)s->count * (size_t)s->rows->n * sizeof(double));
        trk_status status = trk_ritz(s->context, s->rows, s->count, s->phi, s->lambda);
        if (status != TRK_OK)
            return status;
    }
    return trk_fail(s->context, TRK_E_CONVERGENCE, "%s: modes: mode %d has a residual of %g",
                    s->rows->name, (int)bad + 1, worst);
}
