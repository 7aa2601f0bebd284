/* SPDX-License-Identifier: MIT */
/* Matrix exponential of the standard quarter car (ROUGHNESS.2). */
#include "roughness/golden.h"

#include <math.h>
#include <string.h>

enum { N = 5 }; /* four states, and the slope as a constant fifth */

static void multiply(double a[N][N], double b[N][N], double out[N][N])
{
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++) {
            out[i][j] = 0;
            for (int k = 0; k < N; k++)
                out[i][j] += a[i][k] * b[k][j];
        }
}

/* out = exp(a), for a small enough that a fixed number of halvings brings its norm below 1/2. */
static void exponential(double a[N][N], double out[N][N])
{
    enum { HALVINGS = 8, TERMS = 16 };
    double term[N][N] = {{0}}, next[N][N];
    memset(out, 0, sizeof(double[N][N]));
    for (int i = 0; i < N; i++)
        term[i][i] = out[i][i] = 1;
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++)
            a[i][j] = ldexp(a[i][j], -HALVINGS);
    for (int k = 1; k <= TERMS; k++) {
        multiply(term, a, next);
        for (int i = 0; i < N; i++)
            for (int j = 0; j < N; j++) {
                term[i][j] = next[i][j] / k;
                out[i][j] += term[i][j];
            }
    }
    for (int k = 0; k < HALVINGS; k++) {
        multiply(out, out, next);
        memcpy(out, next, sizeof next);
    }
}

void trk_golden_create(double spacing, trk_golden_step *out_step)
{
    const double kt = TRK_GOLDEN_TIRE, ks = TRK_GOLDEN_SPRING, c = TRK_GOLDEN_DAMPER;
    const double m = TRK_GOLDEN_MASS, h = spacing / TRK_GOLDEN_SPEED;
    double a[N][N] = {
        {0, h, 0, 0, 0},
        {-ks * h, -c * h, ks * h, c * h, 0},
        {0, 0, 0, h, 0},
        {ks / m * h, c / m * h, -(kt + ks) / m * h, -c / m * h, kt / m * h},
    };
    double e[N][N];
    exponential(a, e);
    for (int i = 0; i < 4; i++) {
        memcpy(out_step->transition[i], e[i], 4 * sizeof(double));
        out_step->input[i] = e[i][4];
    }
}
