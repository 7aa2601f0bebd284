/* SPDX-License-Identifier: MIT */
/*
 * One interface to symmetric positive definite systems S x = b, dense or sparse.
 *
 * Assembly never asks which backend it has: it names the entries it will write,
 * gets a slot for each, and adds into values[slot].
 *
 *     trk_solver_create(context, backend, n, count, rows, columns, slots, &solver);
 *     trk_solver_clear(solver);
 *     double *values = trk_solver_values(solver);
 *     for (...) values[slots[k]] += ...;
 *     trk_solver_factorize(solver, &bad);
 *     trk_solver_solve(solver, right_hand_side);
 *
 * Only the lower triangle is stored: entry (i, j) and entry (j, i) are the same slot,
 * and must be added once.
 */
#ifndef TRK_LINALG_SOLVER_H
#define TRK_LINALG_SOLVER_H

#include "linalg/pattern.h"

typedef struct trk_solver trk_solver;

/*
 * Create a solver of n unknowns for the entries (rows[k], columns[k]), k < count
 * (0-based, either triangle, repeats allowed; the diagonal is always there).
 * out_slots receives the place of each entry in trk_solver_values(), length count.
 * AUTO takes dense for small n, sparse above; dense if the build has no CHOLMOD.
 * TRK_E_UNSUPPORTED: sparse asked for, but the build has no CHOLMOD.
 * TRK_E_RANGE: n < 1, count < 0, or an index outside 0..n-1.
 */
trk_status trk_solver_create(trk_context *context, trk_backend backend, int32_t n, int64_t count,
                             const int32_t *rows, const int32_t *columns, int64_t *out_slots,
                             trk_solver **out_solver);
void trk_solver_destroy(trk_solver *solver);

/* Backend in use, never AUTO. */
trk_backend trk_solver_backend(const trk_solver *solver);

/* Values being assembled, all entries; factorize() leaves them as they are. */
double *trk_solver_values(trk_solver *solver);
void trk_solver_clear(trk_solver *solver);

/*
 * Cholesky factorization (LINALG.1) of the current values. TRK_E_SINGULAR (no message
 * recorded: the caller knows the names) when not positive definite or not finite;
 * out_bad then receives the 0-based unknown at whose pivot it stopped, else -1. A pivot
 * counts as zero up to n * epsilon times its diagonal entry (LINALG.2).
 * TRK_E_MEMORY: sparse only, where CHOLMOD takes scratch memory past the context.
 */
trk_status trk_solver_factorize(trk_solver *solver, int32_t *out_bad);

/*
 * x := S^-1 x with the last factorization. Allocates nothing.
 * TRK_E_ARGUMENT: the last factorization failed, or there was none.
 */
trk_status trk_solver_solve(trk_solver *solver, double *x);

/* Where the values stand; owned by the solver. */
const trk_pattern *trk_solver_pattern(const trk_solver *solver);

/*
 * Negative eigenvalues of the current values, which need not be definite, by Sylvester's law of
 * inertia (LINALG.6). scale: positive, length n, the sizes of the diagonal entries before what
 * made the matrix indefinite was subtracted. The factorization may be trusted while eps *out_growth
 * stays below the relative size of a change that matters. The last factorization of the solver
 * is lost. TRK_E_SINGULAR (no message recorded): a pivot is zero.
 */
trk_status trk_solver_count_negative(trk_solver *solver, const double *scale, int32_t *out_count,
                                     double *out_growth);

/* Entries of the factor, a measure of the cost of solve(). */
int64_t trk_solver_factor_entries(const trk_solver *solver);

#endif
