/* SPDX-License-Identifier: MIT */
/*
 * Body of the modal step (RUNGEKUTTA.7), included once for each instruction set with KERNEL set
 * to the name of the function. Its vectors are as wide as the registers, its sums stay in them.
 */
#include "rungekutta/modal.h"

#if defined(__SSE2__)
#include <immintrin.h>
#endif

#if defined(__AVX512DQ__)
enum { WIDTH = 8 };
#elif defined(__AVX2__)
enum { WIDTH = 4 };
#else
enum { WIDTH = 2 };
#endif

typedef double lanes __attribute__((vector_size(8 * WIDTH), may_alias));
typedef int64_t lane_mask __attribute__((vector_size(8 * WIDTH), may_alias));

#define INLINE static inline __attribute__((always_inline))

enum {
    PARTS = TRK_EXPLICIT_LANES / WIDTH, /* vectors in a block */
    STATES = TRK_EXPLICIT_STATE_BLOCKS * PARTS,
    TABLES = TRK_EXPLICIT_TABLE_BLOCKS * PARTS,
    CHAINS = 4,
    GROUP =
        WIDTH == 8 ? 6 : 3 /* vectors of rows that are summed at once, CHAINS times: registers */
};

static const lanes zero = {0};

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

INLINE const lanes *at(const double *array, int64_t block)
{
    return (const lanes *)array + block;
}

/* out[b] += the rows first + b of a matrix of `rows` vectors a column, times x, in four chains. */
INLINE void add_rows(const double *matrix, const double *x, int32_t columns, lanes *out,
                     const int first, const int count, const int rows)
{
    lanes sum[CHAINS][GROUP];
    int32_t k = 0;
    for (int b = 0; b < count; b++)
        sum[0][b] = sum[1][b] = sum[2][b] = sum[3][b] = zero;
    for (; k + CHAINS <= columns; k += CHAINS)
        for (int c = 0; c < CHAINS; c++)
            for (int b = 0; b < count; b++)
                sum[c][b] += *at(matrix, (k + c) * rows + first + b) * x[k + c];
    for (; k < columns; k++)
        for (int b = 0; b < count; b++)
            sum[0][b] += *at(matrix, k * rows + first + b) * x[k];
    for (int b = 0; b < count; b++)
        out[first + b] += (sum[0][b] + sum[1][b]) + (sum[2][b] + sum[3][b]);
}

INLINE void add_product(const double *matrix, const double *x, int32_t columns, lanes *out,
                        const int rows)
{
    const int whole = rows / GROUP * GROUP;
    for (int first = 0; first < whole; first += GROUP)
        add_rows(matrix, x, columns, out, first, GROUP, rows);
    if (whole < rows)
        add_rows(matrix, x, columns, out, whole, rows - whole, rows);
}

INLINE void store(const lanes *x, double *out, const int count)
{
    for (int b = 0; b < count; b++)
        ((lanes *)out)[b] = x[b];
}

/* Forces of all tables at x; the pieces are fetched first if some x has left its own. */
INLINE void evaluate_tables(trk_explicit_step *s, const lanes *x, const int pb)
{
    const trk_explicit_pieces *p = &s->pieces;
    for (int b = 0; b < pb; b++)
        if (any(~((x[b] >= *at(p->lower, b)) & (x[b] < *at(p->upper, b))))) {
            store(x, s->scratch_x, pb);
            trk_explicit_fetch_pieces(s, s->scratch_x);
            break;
        }
    for (int b = 0; b < pb; b++) {
        lanes t = x[b] - *at(p->origin, b);
        ((lanes *)s->scratch_g)[b] =
            *at(p->c0, b) + t * (*at(p->c1, b) + t * (*at(p->c2, b) + t * *at(p->c3, b)));
    }
}

/* a = F - kappa q - C v - Z g; when: 0 at mid-step, 1 at its end. */
INLINE void accelerate(trk_explicit_step *s, const lanes *q, const lanes *v, const lanes *drive,
                       int when, lanes *a, const int nb, const int pb)
{
    lanes sum[STATES + TABLES], pull[STATES];
    for (int b = 0; b < nb; b++)
        sum[b] = pull[b] = zero;
    for (int b = 0; b < pb; b++)
        sum[nb + b] = *at(s->shift[when], b);
    store(v, s->scratch_v, nb);
    add_product(s->from_v, s->scratch_v, s->n, sum, nb + pb);
    if (pb > 0) {
        if (s->springs > 0) {
            store(q, s->scratch_q, nb);
            add_product(s->from_q, s->scratch_q, s->n, sum + nb, pb);
        }
        evaluate_tables(s, sum + nb, pb);
        add_product(s->influence, s->scratch_g, s->tables, pull, nb);
    }
    for (int b = 0; b < nb; b++)
        a[b] = drive[b] - *at(s->kappa, b) * q[b] - sum[b] - pull[b];
}

INLINE bool take_step(trk_explicit_step *s, const trk_explicit_states *st, const int nb,
                      const int pb)
{
    const double h = s->h;
    lanes drive[2][STATES], q[STATES], v[STATES], a[STATES], q_sum[STATES], v_sum[STATES],
        finite = {0};
    for (int when = 0; when < 2; when++) {
        for (int b = 0; b < nb; b++)
            drive[when][b] = *at(s->weight, b);
        add_product(s->from_drive, s->drive[when], s->columns, drive[when], nb);
    }
    for (int b = 0; b < nb; b++) {
        v[b] = q_sum[b] = *at(st->v, b);
        a[b] = v_sum[b] = *at(st->a, b);
    }
    for (int stage = 0; stage < 3; stage++) { /* at h / 2, h / 2, h */
        const double part = stage < 2 ? h / 2 : h, weight = stage < 2 ? 2 : 1;
        for (int b = 0; b < nb; b++) {
            q[b] = *at(st->q, b) + part * v[b];
            v[b] = *at(st->v, b) + part * a[b];
        }
        accelerate(s, q, v, drive[stage / 2], stage / 2, a, nb, pb);
        for (int b = 0; b < nb; b++) {
            q_sum[b] += weight * v[b];
            v_sum[b] += weight * a[b];
        }
    }
    for (int b = 0; b < nb; b++) {
        q[b] = *at(st->q, b) + h / 6 * q_sum[b];
        v[b] = *at(st->v, b) + h / 6 * v_sum[b];
    }
    accelerate(s, q, v, drive[1], 1, a, nb, pb);
    store(q, st->out_q, nb);
    store(v, st->out_v, nb);
    store(a, st->out_a, nb);
    for (int b = 0; b < nb; b++)
        finite += (q[b] + v[b] + a[b]) * 0;
    return !any(finite != 0); /* infinity and NaN times zero are NaN */
}

/* The sizes become constants, so that the sums stay in registers. */
bool KERNEL(trk_explicit_step *step, const trk_explicit_states *states)
{
    switch (10 * step->table_blocks + step->state_blocks) {
    case 1: return take_step(step, states, 1 * PARTS, 0 * PARTS);
    case 2: return take_step(step, states, 2 * PARTS, 0 * PARTS);
    case 4: return take_step(step, states, 4 * PARTS, 0 * PARTS);
    case 11: return take_step(step, states, 1 * PARTS, 1 * PARTS);
    case 12: return take_step(step, states, 2 * PARTS, 1 * PARTS);
    case 14: return take_step(step, states, 4 * PARTS, 1 * PARTS);
    case 31: return take_step(step, states, 1 * PARTS, 3 * PARTS);
    case 32: return take_step(step, states, 2 * PARTS, 3 * PARTS);
    default: return take_step(step, states, 4 * PARTS, 3 * PARTS);
    }
}
