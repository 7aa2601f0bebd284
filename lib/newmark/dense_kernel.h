/* SPDX-License-Identifier: MIT */
/*
 * Body of the dense step, included once for each instruction set with KERNEL set to the name
 * of the function. Its vectors are as wide as the registers, its sums stay in them.
 */
#include "newmark/dense.h"

#if defined(__SSE2__)
#include <immintrin.h>
#endif

#if defined(__AVX512DQ__)
enum { WIDTH = 8, GROUP = 7 };
#elif defined(__AVX2__)
enum { WIDTH = 4, GROUP = 6 };
#else
enum { WIDTH = 2, GROUP = 4 };
#endif

/* GROUP: vectors of rows that are summed at once, twice as many sums as that fit the registers. */
typedef double lanes __attribute__((vector_size(8 * WIDTH), may_alias));
typedef int64_t lane_mask __attribute__((vector_size(8 * WIDTH), may_alias));

#define INLINE static inline __attribute__((always_inline))

enum {
    PARTS = TRK_DENSE_LANES / WIDTH, /* vectors in a block */
    TABLES = TRK_DENSE_TABLE_BLOCKS * PARTS,
    ROWS = (TRK_DENSE_STATE_BLOCKS + TRK_DENSE_TABLE_BLOCKS) * PARTS
};

INLINE lanes spread(double x)
{
    return (lanes){0} + x;
}

INLINE lanes absolute(lanes x)
{
    return (lanes)((lane_mask)x & INT64_MAX);
}

INLINE lanes larger(lanes a, lanes b)
{
    lane_mask m = a > b;
    return (lanes)(((lane_mask)a & m) | ((lane_mask)b & ~m));
}

/* Is any lane of a comparison true? */
INLINE bool any(lane_mask m)
{
#if defined(__AVX512DQ__)
    return _mm512_movepi64_mask((__m512i)m) != 0;
#elif defined(__AVX2__)
    return _mm256_movemask_pd((__m256d)m) != 0;
#elif defined(__SSE2__)
    return _mm_movemask_pd((__m128d)m) != 0;
#else
    return m[0] | m[1];
#endif
}

INLINE double largest_lane(lanes x)
{
    double largest = x[0];
    for (int k = 1; k < WIDTH; k++)
        largest = largest > x[k] ? largest : x[k];
    return largest;
}

INLINE const lanes *at(const double *array, int64_t block)
{
    return (const lanes *)array + block;
}

/* out := D x for `count` columns of `blocks` blocks; two chains of additions. */
INLINE void multiply(const double *matrix, const double *x, int32_t count, lanes *out,
                     const int blocks)
{
    lanes even[TABLES] = {{0}}, odd[TABLES] = {{0}};
    int32_t k = 0;
    for (; k + 1 < count; k += 2)
        for (int b = 0; b < blocks; b++) {
            even[b] += *at(matrix, k * blocks + b) * x[k];
            odd[b] += *at(matrix, (k + 1) * blocks + b) * x[k + 1];
        }
    if (k < count)
        for (int b = 0; b < blocks; b++)
            even[b] += *at(matrix, k * blocks + b) * x[k];
    for (int b = 0; b < blocks; b++)
        out[b] = even[b] + odd[b];
}

/* (NEWMARK.2), (NEWMARK.3) with a1 = 0. */
INLINE void predict(const trk_dense_step *s, const trk_dense_states *st, const int nb)
{
    for (int b = 0; b < nb; b++) {
        lanes v = *at(st->v, b), a = *at(st->a, b);
        ((lanes *)st->out_q)[b] = *at(st->q, b) + s->h * v + s->q_predict * a;
        ((lanes *)st->out_v)[b] = v + s->v_predict * a;
    }
}

/* Rows first .. first + count - 1 of a_free and x_free, out of `rows`. */
INLINE void free_rows(const trk_dense_step *s, const trk_dense_states *st, lanes *out,
                      const int first, const int count, const int rows)
{
    lanes sum[GROUP] = {{0}}, other[GROUP] = {{0}};
    for (int32_t c = 0; c < s->columns; c++)
        for (int b = 0; b < count; b++)
            sum[b] += *at(s->from_drive, c * rows + first + b) * s->drive[c];
    for (int32_t j = 0; j < s->n; j++)
        for (int b = 0; b < count; b++) {
            sum[b] += *at(s->from_q, j * rows + first + b) * st->out_q[j];
            other[b] += *at(s->from_v, j * rows + first + b) * st->out_v[j];
        }
    for (int b = 0; b < count; b++)
        out[first + b] = sum[b] + other[b];
}

INLINE void free_motion(const trk_dense_step *s, const trk_dense_states *st, lanes *out,
                        const int rows)
{
    const int whole = rows / GROUP * GROUP;
    for (int first = 0; first < whole; first += GROUP)
        free_rows(s, st, out, first, GROUP, rows);
    if (whole < rows)
        free_rows(s, st, out, whole, rows - whole, rows);
}

/* Table values and slopes at x; the pieces are fetched first if some x has left its own. */
INLINE void evaluate_tables(trk_dense_step *s, const lanes *x, lanes *value, lanes *slope,
                            const int pb)
{
    const trk_dense_pieces *p = &s->pieces;
    for (int b = 0; b < pb; b++)
        if (any((x[b] < *at(p->lower, b)) | (x[b] >= *at(p->upper, b)))) {
            for (int k = 0; k < pb; k++)
                ((lanes *)s->scratch)[k] = x[k];
            trk_dense_fetch_pieces(s, s->scratch);
            break;
        }
    for (int b = 0; b < pb; b++) {
        lanes t = x[b] - *at(p->origin, b), c3 = *at(p->c3, b), c2 = *at(p->c2, b);
        value[b] = *at(p->c0, b) + t * (*at(p->c1, b) + t * (c2 + t * c3));
        slope[b] = *at(p->c1, b) + t * (2 * c2 + t * (3 * c3));
    }
}

/*
 * (I + T D) dg = mismatch by sweeps that take the diagonal exactly. T D is small: a damper
 * changes its own velocity within a step only a little, that of its neighbours less.
 */
INLINE void correct_forces(trk_dense_step *s, const lanes *mismatch, const lanes *t, lanes *dg,
                           const int pb)
{
    enum { SWEEPS = 2 };
    lanes inverse[TABLES], coupled[TABLES];
    for (int b = 0; b < pb; b++) {
        inverse[b] = 1 / (1 + t[b] * *at(s->diagonal, b));
        dg[b] = mismatch[b] * inverse[b];
    }
    for (int sweep = 0; sweep < SWEEPS; sweep++) {
        for (int b = 0; b < pb; b++)
            ((lanes *)s->scratch)[b] = dg[b];
        multiply(s->coupling, s->scratch, s->tables, coupled, pb);
        for (int b = 0; b < pb; b++)
            dg[b] += (mismatch[b] - dg[b] - t[b] * coupled[b]) * inverse[b];
    }
}

/* Table forces, from a cubic through the last four; returns corrections or -1. */
INLINE int32_t solve_forces(trk_dense_step *s, const lanes *x_free, lanes *size, const int pb)
{
    lanes g[TABLES], coupled[TABLES], x[TABLES], value[TABLES], slope[TABLES], mismatch[TABLES],
        t[TABLES], dg[TABLES];
    double least = s->tolerance * s->force_scale;
    lanes limit = spread(least > s->floor ? least : s->floor);
    for (int b = 0; b < pb; b++)
        g[b] = 4 * (*at(s->force[0], b) + *at(s->force[2], b)) - 6 * *at(s->force[1], b) -
               *at(s->force[3], b);
    for (int32_t corrections = 0;; corrections++) {
        for (int b = 0; b < pb; b++)
            ((lanes *)s->force[4])[b] = g[b];
        multiply(s->coupling, s->force[4], s->tables, coupled, pb);
        for (int b = 0; b < pb; b++)
            x[b] = x_free[b] - *at(s->kappa, b) * coupled[b];
        evaluate_tables(s, x, value, slope, pb);
        lane_mask off = (lane_mask){0};
        for (int b = 0; b < pb; b++) {
            mismatch[b] = value[b] - g[b];
            off |= ~(lane_mask)(absolute(mismatch[b]) <= limit); /* true for NaN too */
        }
        if (!any(off)) {
            for (int b = 0; b < pb; b++)
                size[b] = absolute(value[b]);
            return corrections;
        }
        if (corrections == s->most_corrections)
            return -1;
        for (int b = 0; b < pb; b++) {
            ((lanes *)s->mismatch)[b] = mismatch[b];
            t[b] = *at(s->kappa, b) * slope[b];
        }
        correct_forces(s, mismatch, t, dg, pb);
        for (int b = 0; b < pb; b++)
            g[b] += dg[b];
    }
}

INLINE int32_t take_step(trk_dense_step *s, const trk_dense_states *st, const int nb, const int pb)
{
    lanes sum[ROWS], force[TABLES], bound = spread(0), finite = spread(0);
    int32_t corrections = 0;
    predict(s, st, nb);
    free_motion(s, st, sum, nb + pb);
    if (pb > 0) {
        corrections = solve_forces(s, sum + nb, force, pb);
        if (corrections < 0)
            return -1;
        for (int32_t k = 0; k < s->tables; k++)
            for (int b = 0; b < nb; b++)
                sum[b] -= *at(s->influence, k * nb + b) * s->force[4][k];
        for (int b = 0; b < pb; b++)
            bound = larger(bound, force[b]);
    }
    for (int b = 0; b < nb; b++) {
        lanes a = sum[b], inertia = absolute(a) * *at(s->force_bound, b);
        ((lanes *)st->out_a)[b] = a;
        ((lanes *)st->out_q)[b] += s->q_factor * a;
        ((lanes *)st->out_v)[b] += s->v_factor * a;
        bound = larger(bound, inertia);
        finite += (*at(st->out_q, b) + *at(st->out_v, b) + a) * 0;
    }
    if (any(finite != 0)) /* infinity and NaN times zero are NaN */
        return -1;
    s->force_scale = largest_lane(bound);
    return corrections;
}

/* The sizes become constants, so that the sums stay in registers. */
int32_t KERNEL(trk_dense_step *step, const trk_dense_states *states)
{
    switch (4 * step->table_blocks + step->state_blocks - 1) {
    case 0: return take_step(step, states, 1 * PARTS, 0 * PARTS);
    case 1: return take_step(step, states, 2 * PARTS, 0 * PARTS);
    case 2: return take_step(step, states, 3 * PARTS, 0 * PARTS);
    case 3: return take_step(step, states, 4 * PARTS, 0 * PARTS);
    case 4: return take_step(step, states, 1 * PARTS, 1 * PARTS);
    case 5: return take_step(step, states, 2 * PARTS, 1 * PARTS);
    case 6: return take_step(step, states, 3 * PARTS, 1 * PARTS);
    case 7: return take_step(step, states, 4 * PARTS, 1 * PARTS);
    case 8: return take_step(step, states, 1 * PARTS, 2 * PARTS);
    case 9: return take_step(step, states, 2 * PARTS, 2 * PARTS);
    case 10: return take_step(step, states, 3 * PARTS, 2 * PARTS);
    case 11: return take_step(step, states, 4 * PARTS, 2 * PARTS);
    case 12: return take_step(step, states, 1 * PARTS, 3 * PARTS);
    case 13: return take_step(step, states, 2 * PARTS, 3 * PARTS);
    case 14: return take_step(step, states, 3 * PARTS, 3 * PARTS);
    default: return take_step(step, states, 4 * PARTS, 3 * PARTS);
    }
}
