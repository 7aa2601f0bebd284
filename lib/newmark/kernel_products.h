/* SPDX-License-Identifier: MIT */
/* Products of packed matrices, in columns of registers, with vectors in memory. */
#ifndef TRK_NEWMARK_KERNEL_PRODUCTS_H
#define TRK_NEWMARK_KERNEL_PRODUCTS_H

#include "base/lanes.h"
#include "newmark/kernel.h"

/* GROUP: vectors of rows that are summed at once, twice as many sums as that fit the registers. */
enum {
    GROUP = 6,
    MODES = TRK_FAST_MODES / WIDTH,
    ROWS = TRK_FAST_ROWS / WIDTH,
    LENGTH = MODES + ROWS
};

/*
 * out[first ..] := A x, rows of `count` registers of the `blocks` of a column. Few registers: four
 * chains of additions, as the sum is waited for; else two.
 */
INLINE void multiply_group(const double *matrix, const double *x, int32_t columns, lanes *out,
                           const int first, const int count, const int blocks)
{
    const int chains = count <= 2 ? 4 : 2;
    lanes sum[4][GROUP] = {{{0}}};
    int32_t k = 0;
    for (; k + chains <= columns; k += chains)
        for (int c = 0; c < chains; c++)
            for (int b = 0; b < count; b++)
                sum[c][b] += get(matrix, (k + c) * blocks + first + b) * x[k + c];
    for (int c = 0; c < chains - 1; c++)
        if (k + c < columns)
            for (int b = 0; b < count; b++)
                sum[c][b] += get(matrix, (k + c) * blocks + first + b) * x[k + c];
    for (int b = 0; b < count; b++)
        out[first + b] = (sum[0][b] + sum[1][b]) + (sum[2][b] + sum[3][b]);
}

/* out := A x, A in columns of `blocks` registers. */
INLINE void multiply(const double *matrix, const double *x, int32_t columns, lanes *out,
                     const int blocks)
{
    const int whole = blocks / GROUP * GROUP;
    for (int first = 0; first < whole; first += GROUP)
        multiply_group(matrix, x, columns, out, first, GROUP, blocks);
    if (whole < blocks)
        multiply_group(matrix, x, columns, out, whole, blocks - whole, blocks);
}

/* The same for a column a row with curves: for few, loops of constant length, the padding in. */
INLINE void multiply_rows(const double *matrix, const double *x, int32_t rows, lanes *out,
                          const int blocks, const int row_blocks)
{
    if (row_blocks * WIDTH <= 8)
        multiply(matrix, x, row_blocks * WIDTH, out, blocks);
    else
        multiply(matrix, x, rows, out, blocks);
}

/* out += A x for few columns, off the path that a step waits for. */
INLINE void add(const double *matrix, const double *x, int32_t columns, lanes *out,
                const int blocks)
{
    for (int32_t k = 0; k < columns; k++)
        for (int b = 0; b < blocks; b++)
            out[b] += get(matrix, k * blocks + b) * x[k];
}

#endif
