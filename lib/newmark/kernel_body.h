/* SPDX-License-Identifier: MIT */
/*
 * Body of the step in modal coordinates, included once for each instruction set with KERNEL set
 * to the name of the function. Its vectors are as wide as the registers, its sums stay in them.
 */
#include "newmark/kernel.h"

#if defined(__SSE2__)
#include <immintrin.h>
#endif

#if defined(__AVX512DQ__)
enum { WIDTH = 8, GROUP = 6 };
#elif defined(__AVX2__)
enum { WIDTH = 4, GROUP = 6 };
#else
enum { WIDTH = 2, GROUP = 6 };
#endif

/* GROUP: vectors of rows that are summed at once, twice as many sums as that fit the registers. */
typedef double lanes __attribute__((vector_size(8 * WIDTH), may_alias));
typedef int64_t lane_mask __attribute__((vector_size(8 * WIDTH), may_alias));

#define INLINE static inline __attribute__((always_inline))

enum { MODES = TRK_FAST_MODES / WIDTH, ROWS = TRK_FAST_ROWS / WIDTH, SWEEPS = 8 };

#define LARGEST 1e290 /* [any] of a velocity or displacement: accelerations stay finite */

#if defined(__AVX512DQ__)
#define SIZES TRK_FAST_SIZES_8
#elif defined(__AVX2__)
#define SIZES TRK_FAST_SIZES_4
#else
#define SIZES TRK_FAST_SIZES_2
#endif

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
#if defined(__AVX512DQ__)
    return (lanes)_mm512_max_pd((__m512d)a, (__m512d)b);
#elif defined(__AVX2__)
    return (lanes)_mm256_max_pd((__m256d)a, (__m256d)b);
#elif defined(__SSE2__)
    return (lanes)_mm_max_pd((__m128d)a, (__m128d)b);
#else
    lane_mask m = a > b;
    return (lanes)(((lane_mask)a & m) | ((lane_mask)b & ~m));
#endif
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
#if defined(__AVX512DQ__)
    return _mm512_reduce_max_pd((__m512d)x);
#elif defined(__AVX2__)
    __m128d half =
        _mm_max_pd(_mm256_castpd256_pd128((__m256d)x), _mm256_extractf128_pd((__m256d)x, 1));
    return _mm_cvtsd_f64(_mm_max_sd(half, _mm_unpackhi_pd(half, half)));
#else
    return x[0] > x[1] ? x[0] : x[1];
#endif
}

INLINE lanes get(const double *array, int64_t block)
{
    return ((const lanes *)array)[block];
}

INLINE void put(double *array, int64_t block, lanes x)
{
    ((lanes *)array)[block] = x;
}

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

/* out += A x for few columns, off the path that a step waits for. */
INLINE void add(const double *matrix, const double *x, int32_t columns, lanes *out,
                const int blocks)
{
    for (int32_t k = 0; k < columns; k++)
        for (int b = 0; b < blocks; b++)
            out[b] += get(matrix, k * blocks + b) * x[k];
}

/* v_f of (NEWMARK.15) into memory; the state comes last, as all else is known earlier. */
INLINE void drive_modes(trk_fast *s, const double *u, const double *du, const double *load,
                        const int nb)
{
    lanes sum[MODES];
    for (int b = 0; b < nb; b++)
        sum[b] = get(s->weight, b);
    for (int32_t k = 0; k < s->roads; k++) {
        lanes d = u[k] + spread(s->ratio[k]) * du[k];
        for (int b = 0; b < nb; b++)
            sum[b] += get(s->height_drive, k * nb + b) * d;
    }
    if (s->on_velocity)
        add(s->velocity_drive, du, s->roads, sum, nb);
    add(s->load_drive, load, s->ports, sum, nb);
    for (int b = 0; b < nb; b++)
        put(s->work_modes, b, get(s->free, b) + sum[b]);
}

/* Value and slope of the tables of a layer; the pieces are fetched first if some x left its own. */
INLINE void evaluate_layer(trk_fast *s, trk_fast_layer *p, const lanes *x, lanes *value,
                           lanes *slope, const int pb)
{
    lane_mask left = (lane_mask){0};
    for (int b = 0; b < pb; b++)
        left |= (x[b] < get(p->lower, b)) | (x[b] >= get(p->upper, b));
    if (any(left)) {
        for (int b = 0; b < pb; b++)
            put(s->work_rows, b, x[b]);
        trk_fast_fetch(p, s->rows, s->work_rows);
    }
    for (int b = 0; b < pb; b++) {
        lanes t = x[b] - get(p->origin, b), c1 = get(p->c1, b), c2 = get(p->c2, b),
              c3 = get(p->c3, b);
        value[b] = get(p->c0, b) + t * (c1 + t * (c2 + t * c3));
        slope[b] = c1 + t * (2 * c2 + t * (3 * c3));
    }
}

/* G and dG/dx at x, e = e_rest + r x. */
INLINE void evaluate(trk_fast *s, const lanes *x, const lanes *e_rest, lanes *value, lanes *slope,
                     const int pb)
{
    lanes e[ROWS], v[ROWS], d[ROWS];
    if (s->layers == 1 && s->springs == 0) {
        evaluate_layer(s, s->layer, x, value, slope, pb);
        return;
    }
    for (int b = 0; b < pb; b++) {
        e[b] = e_rest[b] + s->r * x[b];
        value[b] = slope[b] = spread(0);
    }
    for (int32_t l = 0; l < s->layers; l++) {
        double scale = l < s->springs ? s->r : 1;
        evaluate_layer(s, &s->layer[l], l < s->springs ? e : x, v, d, pb);
        for (int b = 0; b < pb; b++) {
            lanes along = d[b] * scale;
            value[b] += v[b];
            slope[b] += along;
            put(s->layer_value, l * pb + b, v[b]);
            put(s->layer_slope, l * pb + b, along);
        }
    }
}

/* What one linearisation of the tables needs. */
typedef struct point {
    lanes x[ROWS], value[ROWS], slope[ROWS], inverse[ROWS];
    lanes at[ROWS]; /* x + K value */
} point;

INLINE void linearise(trk_fast *s, const lanes *e_rest, point *p, const int pb)
{
    evaluate(s, p->x, e_rest, p->value, p->slope, pb);
    for (int b = 0; b < pb; b++) {
        put(s->work_rows, b, p->value[b]);
        p->inverse[b] = 1 / (1 + p->slope[b] * get(s->diagonal, b));
    }
    multiply(s->coupling, s->work_rows, s->rows, p->at, pb);
    for (int b = 0; b < pb; b++)
        p->at[b] += p->x[b];
}

/*
 * (I + K S) dx = residual by sweeps that take the diagonal exactly, until what is left is below
 * a quarter of the limit (NEWMARK.19).
 */
INLINE bool solve_rates(trk_fast *s, const point *p, const lanes *residual, lanes *dx, const int pb)
{
    lanes last[ROWS], coupled[ROWS];
    for (int b = 0; b < pb; b++)
        last[b] = dx[b] = p->inverse[b] * residual[b];
    for (int sweep = 0;; sweep++) {
        lane_mask off = (lane_mask){0};
        for (int b = 0; b < pb; b++)
            off |= ~(lane_mask)(absolute(p->slope[b] * last[b]) * s->off_diagonal <=
                                spread(s->limit / 4)); /* true for NaN too */
        if (!any(off))
            return true;
        if (sweep == SWEEPS)
            return false;
        for (int b = 0; b < pb; b++)
            put(s->work_rows, b, p->slope[b] * dx[b]);
        multiply(s->coupling, s->work_rows, s->rows, coupled, pb);
        for (int b = 0; b < pb; b++) {
            last[b] = p->inverse[b] * (residual[b] - dx[b] - coupled[b]);
            dx[b] += last[b];
        }
    }
}

/* Is the quadratic rest of the tables below half the limit (NEWMARK.19)? */
INLINE bool is_straight(const trk_fast *s, const lanes *dx, const int pb)
{
    lane_mask off = (lane_mask){0};
    for (int b = 0; b < pb; b++) {
        lanes way = absolute(dx[b]) + get(s->reach, b) * s->limit;
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

/* Forces of the tables and rates; returns the number of corrections or -1. */
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
        if (is_straight(s, dx, pb) || add_bend(s, p, dx, g, pb))
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

/* The guess of the rates: a quartic through the last five. */
INLINE void guess(const trk_fast *s, point *p, const int pb)
{
    for (int b = 0; b < pb; b++)
        p->x[b] = 5 * (get(s->past[0], b) - get(s->past[3], b)) +
                  10 * (get(s->past[2], b) - get(s->past[1], b)) + get(s->past[4], b);
}

/* Elongations less r x, and what roads do to the rows themselves. */
INLINE void rest_of_elongations(trk_fast *s, const double *u, const double *du, lanes *e_rest,
                                const int pb)
{
    for (int b = 0; b < pb; b++)
        e_rest[b] = spread(0);
    if (s->springs == 0)
        return;
    multiply(s->elongation, s->z, s->modes, e_rest, pb);
    for (int32_t k = 0; s->on_rows && k < s->roads; k++)
        for (int b = 0; b < pb; b++)
            e_rest[b] -= get(s->road_rows, k * pb + b) * (u[k] - s->r * du[k]);
}

/* The raw state as trk_newmark_record() hands it out: v~ and z are still those that led to v1. */
INLINE void record(const trk_fast *s, const lanes *v1, const lanes *g, const lanes *dx, double *out,
                   const int nb, const int pb)
{
    const int64_t part = (s->modes + TRK_FAST_PADDING - 1) / TRK_FAST_PADDING * TRK_FAST_PADDING;
    const int64_t row = (s->rows + TRK_FAST_PADDING - 1) / TRK_FAST_PADDING * TRK_FAST_PADDING;
    for (int b = 0; b < nb && b * WIDTH < part; b++) {
        put(out, b, get(s->z, b) + s->r * v1[b]);
        put(out + part, b, v1[b]);
        put(out + 2 * part, b, (v1[b] - get(s->v, b)) * s->inverse_kappa);
    }
    out += 3 * part;
    for (int b = 0; s->layers == 1 && b < pb && b * WIDTH < row; b++)
        put(out, b, g[b]);
    for (int32_t l = 0; s->layers > 1 && l < s->layers; l++)
        for (int b = 0; b < pb && b * WIDTH < row; b++)
            put(out + l * row, b,
                get(s->layer_value, l * pb + b) + get(s->layer_slope, l * pb + b) * dx[b]);
}

/* The state becomes that of the next step (kernel.h); false: not finite, nothing happened. */
INLINE bool commit(trk_fast *s, const lanes *v1, const int nb)
{
    lanes v[MODES], z[MODES];
    lane_mask off = (lane_mask){0};
    for (int b = 0; b < nb; b++) {
        v[b] = s->c1 * v1[b] + s->c2 * get(s->v, b);
        z[b] = get(s->z, b) + s->c3 * v1[b] + s->c4 * get(s->v, b);
        off |= ~(lane_mask)(absolute(v1[b]) <= spread(LARGEST));
        off |= ~(lane_mask)(absolute(z[b]) <= spread(LARGEST));
    }
    if (any(off))
        return false;
    for (int b = 0; b < nb; b++) {
        put(s->v1, b, v1[b]);
        put(s->old_v, b, v[b]);
        put(s->old_z, b, z[b]);
        put(s->free, b, v[b] - get(s->restoring, b) * (z[b] + s->r * v[b]));
    }
    double *before = s->v;
    s->v = s->old_v;
    s->old_v = before;
    before = s->z;
    s->z = s->old_z;
    s->old_z = before;
    return true;
}

/* The rates enter the past, the forces set the limit of the next step. */
INLINE void remember(trk_fast *s, const point *p, const lanes *dx, const lanes *g,
                     int32_t corrections, const int pb)
{
    lanes size = spread(0);
    double *oldest = s->past[TRK_FAST_HISTORY - 1];
    for (int k = TRK_FAST_HISTORY - 1; k > 0; k--)
        s->past[k] = s->past[k - 1];
    s->past[0] = oldest;
    for (int b = 0; b < pb; b++) {
        put(oldest, b, p->x[b] + dx[b]);
        size = larger(size, absolute(g[b]));
    }
    double limit = s->tolerance * largest_lane(size);
    s->limit = limit > s->floor ? limit : s->floor;
    s->iterations += corrections;
    if (corrections > s->max_iterations) {
        s->max_iterations = corrections;
        for (int b = 0; b < pb; b++)
            put(s->worst, b, absolute(p->slope[b] * dx[b]));
    }
}

INLINE bool take_step(trk_fast *s, const double *u, const double *du, const double *load,
                      double *out_row, const int nb, const int pb)
{
    lanes v1[MODES], moved[MODES];
    lanes x_free[ROWS], e_rest[ROWS], g[ROWS], dx[ROWS];
    int32_t corrections = 0;
    point p;
    drive_modes(s, u, du, load, nb);
    if (pb > 0) {
        guess(s, &p, pb);
        rest_of_elongations(s, u, du, e_rest, pb);
        linearise(s, e_rest, &p, pb);
        multiply(s->to_rows, s->work_modes, s->modes, x_free, pb);
        for (int32_t k = 0; s->on_rows && k < s->roads; k++)
            for (int b = 0; b < pb; b++)
                x_free[b] -= get(s->road_rows, k * pb + b) * du[k];
    }
    multiply(s->to_modes, s->work_modes, s->modes, v1, nb); /* while the forces are solved for */
    if (pb > 0) {
        corrections = solve_forces(s, x_free, e_rest, &p, g, dx, pb);
        if (corrections < 0)
            return false;
        for (int b = 0; b < pb; b++)
            put(s->force, b, g[b]);
    }
    if (pb > 0) {
        multiply(s->influence, s->force, s->rows, moved, nb);
        for (int b = 0; b < nb; b++)
            v1[b] -= moved[b];
    }
    if (out_row)
        record(s, v1, g, dx, out_row, nb, pb);
    if (!commit(s, v1, nb))
        return false;
    if (pb > 0)
        remember(s, &p, dx, g, corrections, pb);
    return true;
}

INLINE int64_t take_steps(trk_fast *s, const trk_fast_run *run, const int nb, const int pb)
{
    for (int64_t k = 0; k < run->count; k++)
        if (!take_step(s, run->height + k * run->height_stride,
                       run->velocity + k * run->velocity_stride, run->load + k * run->load_stride,
                       run->out_rows ? run->out_rows + k * run->row_width : NULL, nb, pb))
            return k;
    return run->count;
}

/* The sizes become constants, so that the sums stay in registers. */
int64_t KERNEL(trk_fast *fast, const trk_fast_run *run)
{
#define SIZE(modes, rows)                                                                          \
    case 100 * modes + rows: return take_steps(fast, run, modes, rows);
    switch (100 * fast->mode_blocks + fast->row_blocks) {
        SIZES(SIZE)
    default: return 0; /* trk_fast_choose_size() knows no other size */
    }
}
