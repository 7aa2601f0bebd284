/* SPDX-License-Identifier: MIT */
/* The forces of the curves in one step: x = x_free - K g, g = G(x) (NEWMARK.19, NEWMARK.20). */
#ifndef TRK_NEWMARK_KERNEL_FORCES_H
#define TRK_NEWMARK_KERNEL_FORCES_H

#include "newmark/kernel_tables.h"

enum { SWEEPS = 8 };

/* One linearisation of the curves. */
typedef struct point {
    lanes x[ROWS], value[ROWS], slope[ROWS], inverse[ROWS];
    lanes at[ROWS];   /* x + K value                                   */
    lanes left[ROWS]; /* bound of what sweeps left of the linear system */
} point;

/* The guess of the rates: a quintic through the last six. */
INLINE void guess(const trk_fast *s, point *p, const int pb)
{
    for (int b = 0; b < pb; b++) {
        lanes older = 15 * (get(s->past[1], b) + get(s->past[3], b)) + get(s->past[5], b);
        older = 20 * get(s->past[2], b) + 6 * get(s->past[4], b) - older;
        p->x[b] = 6 * get(s->past[0], b) + older;
    }
}

INLINE void linearise(trk_fast *s, const lanes *e_rest, point *p, const int pb)
{
    evaluate(s, p->x, e_rest, p->value, p->slope, pb);
    for (int b = 0; b < pb; b++) {
        put(s->work_rows, b, p->value[b]);
        p->inverse[b] = 1 / (1 + p->slope[b] * get(s->diagonal, b));
    }
    multiply_rows(s->coupling, s->work_rows, s->rows, p->at, pb, pb);
    for (int b = 0; b < pb; b++)
        p->at[b] += p->x[b];
}

/* Is what the last increment left of the linear system small enough for the forces? */
INLINE bool is_solved(const trk_fast *s, point *p, const lanes *last, const int pb)
{
    lanes size = spread(0);
    lane_mask off = (lane_mask){0};
    for (int b = 0; b < pb; b++)
        size = larger(absolute(p->slope[b] * last[b]), size);
    size = largest(size);
    for (int b = 0; b < pb; b++) {
        p->left[b] = get(s->reach, b) * size;
        off |= ~(lane_mask)(absolute(p->slope[b]) * p->left[b] <= spread(s->limit / 4));
    }
    return !any(off);
}

/*
 * (I + K S) dx = residual by sweeps that take the diagonal exactly, until what is left is below
 * a quarter of the limit (NEWMARK.19).
 */
INLINE bool solve_rates(trk_fast *s, point *p, const lanes *residual, lanes *dx, const int pb)
{
    lanes last[ROWS], coupled[ROWS];
    for (int b = 0; b < pb; b++)
        last[b] = dx[b] = p->inverse[b] * residual[b];
    for (int sweep = 0; !is_solved(s, p, last, pb); sweep++) {
        if (sweep == SWEEPS)
            return false;
        for (int b = 0; b < pb; b++)
            put(s->work_rows, b, p->slope[b] * dx[b]);
        multiply_rows(s->coupling, s->work_rows, s->rows, coupled, pb, pb);
        for (int b = 0; b < pb; b++) {
            last[b] = p->inverse[b] * (residual[b] - dx[b] - coupled[b]);
            dx[b] += last[b];
        }
    }
    return true;
}

/* Is the quadratic rest of the curves below half the limit (NEWMARK.19)? */
INLINE bool is_straight(const trk_fast *s, const point *p, const lanes *dx, const int pb)
{
    lane_mask off = (lane_mask){0};
    for (int b = 0; b < pb; b++) {
        lanes way = absolute(dx[b]) + p->left[b];
        off |= ~(lane_mask)(get(s->curvature, b) * way * way <= spread(s->limit));
    }
    return !any(off);
}

/*
 * Add to g what the cubics of one layer of damper curves have beyond the tangent, if no rate left
 * its piece and that is small enough to end with (NEWMARK.20).
 */
INLINE bool add_bend(const trk_fast *s, const point *p, const lanes *dx, lanes *g, const int pb)
{
    const trk_fast_layer *l = s->layer;
    lanes rest[ROWS];
    lane_mask off = (lane_mask){0};
    if (s->layers != 1 || s->springs != 0)
        return false;
    for (int b = 0; b < pb; b++) {
        lanes x = p->x[b] + dx[b], t = p->x[b] - get(l->origin, b);
        rest[b] = dx[b] * dx[b] * (get(l->c2, b) + get(l->c3, b) * (3 * t + dx[b]));
        off |= (x < get(l->lower, b)) | (x >= get(l->upper, b)) |
               ~(lane_mask)(absolute(rest[b]) * s->whole_row <= spread(s->limit / 2));
    }
    if (any(off))
        return false;
    for (int b = 0; b < pb; b++)
        g[b] += rest[b];
    return true;
}

/* Forces of the curves and rates; returns the number of corrections or -1. */
INLINE int32_t solve_forces(trk_fast *s, const lanes *x_free, const lanes *e_rest, point *p,
                            lanes *g, lanes *dx, const int pb)
{
    lanes residual[ROWS];
    for (int32_t corrections = 1;; corrections++) {
        for (int b = 0; b < pb; b++)
            residual[b] = x_free[b] - p->at[b];
        if (!solve_rates(s, p, residual, dx, pb))
            return -1;
        for (int b = 0; b < pb; b++)
            g[b] = p->value[b] + p->slope[b] * dx[b];
        if (is_straight(s, p, dx, pb) || add_bend(s, p, dx, g, pb))
            return corrections;
        if (corrections == s->most_corrections)
            return -1;
        for (int b = 0; b < pb; b++)
            p->x[b] += dx[b];
        linearise(s, e_rest, p, pb);
        lane_mask off = (lane_mask){0};
        for (int b = 0; b < pb; b++) {
            dx[b] = spread(0);
            off |= ~(lane_mask)(absolute(p->value[b] - g[b]) <= spread(s->limit / 2));
        }
        if (!any(off))
            return corrections;
    }
}

#endif
