/* SPDX-License-Identifier: MIT */
/* The problem for SUNDIALS: vectors, solvers and callbacks that CVODE and ARKODE share. */
#ifndef TRK_TESTS_BENCH_SUNDIALS_COMMON_H
#define TRK_TESTS_BENCH_SUNDIALS_COMMON_H

#include "problem.h"

#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>
#include <sundials/sundials_linearsolver.h>
#include <sundials/sundials_nonlinearsolver.h>

typedef struct sundials {
    SUNContext context;
    N_Vector y; /* zero at first */
    SUNMatrix matrix;
    SUNLinearSolver solver;
    SUNNonlinearSolver fixed_point;
} sundials;

bool sundials_open(sundials *s, const problem *p);
void sundials_close(sundials *s);

/* q of the current y. */
void sundials_read(const sundials *s, const problem *p, double *out_q);

/* The problem is the user data. */
int sundials_right_side(realtype t, N_Vector y, N_Vector out, void *user);
int sundials_jacobian(realtype t, N_Vector y, N_Vector fy, SUNMatrix out, void *user, N_Vector a,
                      N_Vector b, N_Vector c);

#endif
