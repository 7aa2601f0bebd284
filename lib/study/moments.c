/* SPDX-License-Identifier: MIT */
/*
 * Mean and variance in one pass. Samples are summed in blocks counted from the first one, so
 * that the result does not depend on the pieces in which they come, and less the first sample,
 * so that a large mean does not drown the variance. Blocks are joined as by T. F. Chan,
 * G. H. Golub, R. J. LeVeque, Amer. Statist. 37 (1983) 242-247.
 */
#include "study/reduce.h"

#include <math.h>
#include <string.h>

enum { PARTS = 8 }; /* independent sums: less rounding, and additions need not wait */

void trk_moments_reset(trk_moments *moments)
{
    moments->held = 0;
    moments->count = 0;
    moments->offset = moments->mean = moments->squares = 0;
    moments->minimum = INFINITY;
    moments->maximum = -INFINITY;
}

static double total(const double *part)
{
    return ((part[0] + part[1]) + (part[2] + part[3])) +
           ((part[4] + part[5]) + (part[6] + part[7]));
}

static void join_block(trk_moments *m)
{
    const int32_t n = m->held;
    double part[PARTS] = {0}, square[PARTS] = {0};
    if (m->count == 0)
        m->offset = m->block[0];
    for (int32_t i = 0; i < n; i++)
        part[i % PARTS] += m->block[i] - m->offset;
    const double mean = total(part) / n;
    for (int32_t i = 0; i < n; i++) {
        const double x = m->block[i], d = (x - m->offset) - mean;
        square[i % PARTS] += d * d;
        m->minimum = x >= m->minimum ? m->minimum : x;
        m->maximum = x <= m->maximum ? m->maximum : x;
    }
    const double before = (double)m->count, after = before + n, step = mean - m->mean;
    m->mean += step * (n / after);
    m->squares += total(square) + step * step * (before * n / after);
    m->count += n;
    m->held = 0;
}

void trk_moments_push(trk_moments *moments, int64_t count, const double *x)
{
    while (count > 0) {
        const int64_t room = TRK_MOMENT_BLOCK - moments->held;
        const int64_t taken = count < room ? count : room;
        memcpy(moments->block + moments->held, x, (size_t)taken * sizeof *x);
        moments->held += (int32_t)taken;
        x += taken;
        count -= taken;
        if (moments->held == TRK_MOMENT_BLOCK)
            join_block(moments);
    }
}

void trk_moments_finish(trk_moments *moments)
{
    if (moments->held > 0)
        join_block(moments);
    moments->mean += moments->offset;
    if (isnan(moments->mean)) /* comparisons lose a NaN, sums do not */
        moments->minimum = moments->maximum = moments->mean;
}
