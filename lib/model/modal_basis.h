/* SPDX-License-Identifier: MIT */
/* Undamped modes of the linear springs of a model: the coordinates of the fast steppers. */
#ifndef TRK_MODEL_MODAL_BASIS_H
#define TRK_MODEL_MODAL_BASIS_H

#include "model/model.h"

/*
 * q = Phi y with Phi^T M Phi = I and Phi^T K0 Phi = diag(lambda) (NEWMARK.14), by one-sided
 * Jacobi rotations of diag(k)^1/2 B L^-T, M = L L^T, which keeps the low modes accurate beside
 * stiff links; no k may be negative. phi: Phi, phi_inverse: Phi^T M, n x n row-major; lambda: n.
 * TRK_E_SINGULAR, no message: M is not positive definite, or the rotations do not end.
 */
trk_status trk_modal_basis(trk_context *context, const trk_model *model, double *phi,
                           double *phi_inverse, double *lambda);

#endif
