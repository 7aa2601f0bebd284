/* SPDX-License-Identifier: MIT */
/*
 * Oracle of the stepper: Newton on all accelerations with the whole tangent matrix, without
 * any thought of speed. Rows and masses come through the public API, forces, tangents and
 * memory of the links one by one from their laws. It iterates until rounding stops it.
 */
#ifndef TRK_TESTS_FULL_NEWTON_H
#define TRK_TESTS_FULL_NEWTON_H

#include <truckride/newmark.h>

typedef struct full_newton full_newton;

full_newton *full_newton_create(const trk_model *model, const trk_newmark_options *options);
void full_newton_destroy(full_newton *f);

/* Static equilibrium, at rest; the acceleration follows. */
void full_newton_start(full_newton *f, const double *height, const double *velocity,
                       const double *load);
void full_newton_step(full_newton *f, const double *height, const double *velocity,
                      const double *load);

/* Each NULL to skip. */
void full_newton_get(const full_newton *f, double *q, double *v, double *a, double *force);

#endif
