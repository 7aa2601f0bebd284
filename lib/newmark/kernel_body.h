/* SPDX-License-Identifier: MIT */
/*
 * Body of the step in modal coordinates, included once for each instruction set with KERNEL set
 * to the name of the function. Its vectors are as wide as the registers, its sums stay in them.
 */
#include "newmark/kernel_forces.h"

#define LARGEST 1e140 /* [any] of a velocity or displacement: accelerations stay finite */

#if defined(__AVX512DQ__)
#define SIZES TRK_FAST_SIZES_8
#elif defined(__AVX2__)
#define SIZES TRK_FAST_SIZES_4
#else
#define SIZES TRK_FAST_SIZES_2
#endif

/* v_f of (NEWMARK.15) into memory; the state comes last, as all else is known earlier. */
INLINE void drive(trk_fast *s, const double *u, const double *du, const double *load, const int nb)
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

/* Rates on the rows were the forces of the curves zero. */
INLINE void free_rates(const trk_fast *s, const double *du, lanes *x_free, const int pb)
{
    multiply(s->to_rows, s->work_modes, s->modes, x_free, pb);
    for (int32_t k = 0; s->on_rows && k < s->roads; k++)
        for (int b = 0; b < pb; b++)
            x_free[b] -= get(s->road_rows, k * pb + b) * du[k];
}

/* Elongations less r x. */
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
    lanes v[MODES], z[MODES], square = spread(0);
    for (int b = 0; b < nb; b++) {
        v[b] = s->c1 * v1[b] + s->c2 * get(s->v, b);
        z[b] = get(s->z, b) + s->c3 * v1[b] + s->c4 * get(s->v, b);
        square += v1[b] * v1[b] + z[b] * z[b];
    }
    if (any(~(lane_mask)(square <= spread(LARGEST * LARGEST))))
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
    double limit = s->tolerance * largest(size)[0];
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
    drive(s, u, du, load, nb);
    if (pb > 0) {
        guess(s, &p, pb);
        rest_of_elongations(s, u, du, e_rest, pb);
        linearise(s, e_rest, &p, pb);
        free_rates(s, du, x_free, pb);
    }
    multiply(s->to_modes, s->work_modes, s->modes, v1, nb); /* while the forces are solved for */
    if (pb > 0) {
        corrections = solve_forces(s, x_free, e_rest, &p, g, dx, pb);
        if (corrections < 0)
            return false;
        for (int b = 0; b < pb; b++)
            put(s->force, b, g[b]);
        for (int b = 0; s->layers > 1 && b < pb; b++)
            put(s->moved, b, dx[b]);
        multiply_rows(s->influence, s->force, s->rows, moved, nb, pb);
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
