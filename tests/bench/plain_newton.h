/* SPDX-License-Identifier: MIT */
/*
 * What an engineer writes in an afternoon, and writes well: Newmark's method with Newton
 * on all accelerations. Matrices and curves are extracted beforehand; a step assembles
 * the lower triangle of the tangent, factors it by Cholesky and allocates nothing. Same
 * extrapolated start and tolerance as the stepper. Roads act on linear links only; no loads.
 */
#ifndef TRK_TESTS_PLAIN_NEWTON_H
#define TRK_TESTS_PLAIN_NEWTON_H

#include <stdbool.h>
#include <truckride/newmark.h>

typedef struct plain_newton plain_newton;

/* At rest, in balance with a road at t = 0. NULL: no memory, too many coordinates, or a curve on
 * a road. options NULL for the defaults. */
plain_newton *plain_newton_create(const trk_model *model, const trk_newmark_options *options,
                                  const double *height, const double *velocity);
void plain_newton_destroy(plain_newton *f);

/* Road at the end of the step. false: no convergence. */
bool plain_newton_step(plain_newton *f, const double *height, const double *velocity);
const double *plain_newton_q(const plain_newton *f);

/* Newton iterations so far. */
long long plain_newton_iterations(const plain_newton *f);

#endif
