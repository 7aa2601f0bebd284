/* SPDX-License-Identifier: MIT */
#include "sundials_common.h"

#include <string.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

bool sundials_open(sundials *s, const problem *p)
{
    *s = (sundials){0};
    if (SUNContext_Create(NULL, &s->context) != 0)
        return false;
    s->y = N_VNew_Serial(2 * p->n, s->context);
    N_VConst(0, s->y);
    s->matrix = SUNDenseMatrix(2 * p->n, 2 * p->n, s->context);
    s->solver = SUNLinSol_Dense(s->y, s->matrix, s->context);
    s->fixed_point = SUNNonlinSol_FixedPoint(s->y, 0, s->context);
    return s->solver && s->fixed_point;
}

void sundials_close(sundials *s)
{
    SUNNonlinSolFree(s->fixed_point);
    SUNLinSolFree(s->solver);
    SUNMatDestroy(s->matrix);
    N_VDestroy(s->y);
    SUNContext_Free(&s->context);
}

void sundials_read(const sundials *s, const problem *p, double *out_q)
{
    memcpy(out_q, NV_DATA_S(s->y), (size_t)p->n * sizeof *out_q);
}

int sundials_right_side(realtype t, N_Vector y, N_Vector out, void *user)
{
    problem_derivative(user, t, NV_DATA_S(y), NV_DATA_S(out));
    return 0;
}

int sundials_jacobian(realtype t, N_Vector y, N_Vector fy, SUNMatrix out, void *user, N_Vector a,
                      N_Vector b, N_Vector c)
{
    (void)t, (void)fy, (void)a, (void)b, (void)c;
    problem_jacobian(user, NV_DATA_S(y), SM_DATA_D(out));
    return 0;
}
