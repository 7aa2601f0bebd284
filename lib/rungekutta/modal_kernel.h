/* SPDX-License-Identifier: MIT */
/*
 * Body of the modal steps (RUNGEKUTTA.6), included once for each instruction set with KERNEL set
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
    SUMS = WIDTH == 2 ? 6 : 8, /* registers that a product adds up in, at most  */
    MOST_CHAINS = 4            /* sums of one row: they hide the latency of FMA */
};

static const lanes zero = {0};

/* Bits of the lanes that left their piece, or are no number. */
INLINE uint32_t find_left(lanes x, lanes lower, lanes upper)
{
#if defined(__AVX512DQ__)
    return (uint32_t)(_mm512_cmp_pd_mask((__m512d)x, (__m512d)lower, _CMP_NGE_UQ) |
                      _mm512_cmp_pd_mask((__m512d)x, (__m512d)upper, _CMP_NLT_UQ));
#else
    lane_mask left = ~((x >= lower) & (x < upper));
#if defined(__AVX2__)
    return (uint32_t)_mm256_movemask_pd((__m256d)left);
#elif defined(__SSE2__)
    return (uint32_t)_mm_movemask_pd((__m128d)left);
#else
    return (left[0] & 1) | (left[1] & 2);
#endif
#endif
}

INLINE lanes *at(double *array, int64_t vector)
{
    return (lanes *)array + vector;
}

INLINE const lanes *of(const double *array, int64_t vector)
{
    return (const lanes *)array + vector;
}

/* out[b] := out[b] + rows first + b of a matrix of `rows` vectors a column, times x. */
INLINE void add_rows(const double *matrix, const double *x, int32_t columns, lanes *out,
                     const int first, const int count, const int rows)
{
    const int most = SUMS / count, chains = most < MOST_CHAINS ? most : MOST_CHAINS;
    lanes sum[MOST_CHAINS][SUMS];
    for (int c = 0; c < chains; c++)
        for (int b = 0; b < count; b++)
            sum[c][b] = c == 0 ? out[first + b] : zero;
    int32_t k = 0;
    for (; k + chains <= columns; k += chains)
        for (int c = 0; c < chains; c++)
            for (int b = 0; b < count; b++)
                sum[c][b] += *of(matrix, (k + c) * rows + first + b) * x[k + c];
    for (; k < columns; k++)
        for (int b = 0; b < count; b++)
            sum[0][b] += *of(matrix, k * rows + first + b) * x[k];
    for (int b = 0; b < count; b++) {
        lanes total = sum[0][b];
        for (int c = 1; c < chains; c++)
            total += sum[c][b];
        out[first + b] = total;
    }
}

INLINE void add_product(const double *matrix, const double *x, int32_t columns, lanes *out,
                        const int rows)
{
    const int whole = rows / SUMS * SUMS;
    for (int first = 0; first < whole; first += SUMS)
        add_rows(matrix, x, columns, out, first, SUMS, rows);
    if (whole < rows)
        add_rows(matrix, x, columns, out, whole, rows - whole, rows);
}

INLINE void store(const lanes *x, double *out, const int count)
{
    for (int b = 0; b < count; b++)
        *at(out, b) = x[b];
}

/* Forces of all tables at x; the pieces are fetched first if some x has left its own. */
INLINE void evaluate_tables(trk_explicit *s, const lanes *x, lanes *g, const int pb)
{
    const trk_explicit_pieces *p = &s->pieces;
    uint32_t left = 0;
    for (int b = 0; b < pb; b++)
        left |= find_left(x[b], *of(p->lower, b), *of(p->upper, b)) << b * WIDTH;
    if (__builtin_expect(left != 0, 0)) {
        store(x, s->scratch_x, pb);
        trk_explicit_fetch_pieces(s, s->scratch_x, left);
    }
    for (int b = 0; b < pb; b++) {
        lanes t = x[b] - *of(p->origin, b);
        g[b] = *of(p->c0, b) + t * (*of(p->c1, b) + t * (*of(p->c2, b) + t * *of(p->c3, b)));
    }
}

/* a := F - kappa q - C v - Z g; the forces of the tables are left in g. */
INLINE void accelerate(trk_explicit *s, const lanes *q, const lanes *v, const lanes *force,
                       const lanes *shift, lanes *a, lanes *g, const int nb, const int pb)
{
    lanes x[TABLES ? TABLES : 1], damping[STATES], pull[STATES];
    store(v, s->scratch_v, nb);
    for (int b = 0; b < nb; b++)
        damping[b] = pull[b] = zero;
    if (pb > 0) {
        for (int b = 0; b < pb; b++)
            x[b] = shift[b];
        if (s->springs > 0) {
            store(q, s->scratch_q, nb);
            add_product(s->from_q, s->scratch_q, s->n, x, pb);
        }
        add_product(s->from_v, s->scratch_v, s->n, x, pb);
        evaluate_tables(s, x, g, pb);
        store(g, s->scratch_g, pb);
    }
    add_product(s->damping, s->scratch_v, s->n, damping, nb);
    if (pb > 0)
        add_product(s->influence, s->scratch_g, s->tables, pull, nb);
    for (int b = 0; b < nb; b++)
        a[b] = force[b] - *of(s->kappa, b) * q[b] - damping[b] - pull[b];
}

/* Modal force and shifts of what acts in step k, at its middle (0) or end (1). */
INLINE void set_drive(const trk_explicit *s, const trk_explicit_run *run, int64_t k, int when,
                      lanes *force, lanes *shift, const int nb, const int pb)
{
    for (int b = 0; b < nb; b++)
        force[b] = *of(s->weight, b);
    for (int b = 0; b < pb; b++)
        shift[b] = zero;
    for (int i = 0; i < TRK_EXPLICIT_INPUTS; i++) {
        const double *input = run->input[when][i] + k * run->stride[i];
        add_product(s->drive[i], input, s->inputs[i], force, nb);
        if (pb > 0 && s->is_shifted)
            add_product(s->shift[i], input, s->inputs[i], shift, pb);
    }
}

INLINE int64_t take_steps(trk_explicit *s, const trk_explicit_run *run, const int nb, const int pb)
{
    const double h = s->h;
    double *row = s->row;
    const int width = 3 * nb + pb;
    lanes q[STATES], v[STATES], a[STATES], g[TABLES], force[2][STATES], shift[2][TABLES];
    int64_t k = 0;
    for (; k < run->count; k++) {
        lanes q_sum[STATES], v_sum[STATES];
        set_drive(s, run, k, 0, force[0], shift[0], nb, pb);
        set_drive(s, run, k, 1, force[1], shift[1], nb, pb);
        for (int b = 0; b < nb; b++) {
            v[b] = q_sum[b] = *of(row, nb + b);
            a[b] = v_sum[b] = *of(row, 2 * nb + b);
        }
        for (int stage = 0; stage < 3; stage++) { /* at h / 2, h / 2, h */
            const double part = stage < 2 ? h / 2 : h, weight = stage < 2 ? 2 : 1;
            for (int b = 0; b < nb; b++) {
                q[b] = *of(row, b) + part * v[b];
                v[b] = *of(row, nb + b) + part * a[b];
            }
            accelerate(s, q, v, force[stage / 2], shift[stage / 2], a, g, nb, pb);
            for (int b = 0; b < nb; b++) {
                q_sum[b] += weight * v[b];
                v_sum[b] += weight * a[b];
            }
        }
        for (int b = 0; b < nb; b++) {
            q[b] = *of(row, b) + h / 6 * q_sum[b];
            v[b] = *of(row, nb + b) + h / 6 * v_sum[b];
        }
        accelerate(s, q, v, force[1], shift[1], a, g, nb, pb);
        lanes check = zero;
        for (int b = 0; b < nb; b++)
            check += (q[b] + v[b] + a[b]) * 0;
        if (find_left(check, zero, zero + 1)) /* infinity and NaN times zero are NaN */
            return k;
        store(q, row, nb);
        store(v, row + nb * WIDTH, nb);
        store(a, row + 2 * nb * WIDTH, nb);
        store(g, row + 3 * nb * WIDTH, pb);
        if (run->rows)
            for (int b = 0; b < width; b++)
                *at(run->rows, k * width + b) = *of(row, b);
    }
    return k;
}

/* The sizes become constants, so that the sums stay in registers. */
int64_t KERNEL(trk_explicit *s, const trk_explicit_run *run)
{
    switch (10 * s->table_blocks + s->state_blocks) {
    case 1: return take_steps(s, run, 1 * PARTS, 0 * PARTS);
    case 2: return take_steps(s, run, 2 * PARTS, 0 * PARTS);
    case 4: return take_steps(s, run, 4 * PARTS, 0 * PARTS);
    case 11: return take_steps(s, run, 1 * PARTS, 1 * PARTS);
    case 12: return take_steps(s, run, 2 * PARTS, 1 * PARTS);
    case 14: return take_steps(s, run, 4 * PARTS, 1 * PARTS);
    case 31: return take_steps(s, run, 1 * PARTS, 3 * PARTS);
    case 32: return take_steps(s, run, 2 * PARTS, 3 * PARTS);
    default: return take_steps(s, run, 4 * PARTS, 3 * PARTS);
    }
}
