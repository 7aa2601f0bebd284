/* SPDX-License-Identifier: MIT */
/* Compensated sum: hours of samples lose no digits. */
#ifndef TRK_COMFORT_SUM_H
#define TRK_COMFORT_SUM_H

#include <math.h>

typedef struct trk_sum {
    double high, low;
} trk_sum;

/* A. Neumaier, Z. Angew. Math. Mech. 54 (1974) 39-51. */
static inline void trk_sum_add(trk_sum *sum, double x)
{
    double total = sum->high + x;
    sum->low += fabs(sum->high) >= fabs(x) ? (sum->high - total) + x : (x - total) + sum->high;
    sum->high = total;
}

static inline double trk_sum_value(const trk_sum *sum)
{
    return sum->high + sum->low;
}

#endif
