/* SPDX-License-Identifier: MIT */
/*
 * Body of the lane kernels (BATCH.2 to BATCH.8), included once for each instruction set with
 * KERNEL set to the name of its table of functions. Nothing here depends on the lane.
 */
#include "batch/lanes.h"

#include <string.h>

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

/* Curvature of a table leaves something, too, where its neighbours leave nothing. */
static const double LEAST_CONTRACTION = 0.01;

typedef double lanes __attribute__((vector_size(8 * WIDTH), may_alias));
typedef int64_t lane_mask __attribute__((vector_size(8 * WIDTH), may_alias));

#define INLINE static inline __attribute__((always_inline))

enum {
    MOST_SWEEPS = 16,
    GROUP = 8,                     /* sums at a time: with x they fit the registers */
    TILE_ROWS = WIDTH == 8 ? 4 : 2 /* times the samples of a tile: sums in 32 or 16 registers */
};

INLINE lanes spread(double x)
{
    return (lanes){0} + x;
}

INLINE lanes absolute(lanes x)
{
    return (lanes)((lane_mask)x & INT64_MAX);
}

/* a > b ? a : b, so b where one is a NaN. */
INLINE lanes larger(lanes a, lanes b)
{
#if defined(__AVX512DQ__)
    return (lanes)_mm512_max_pd((__m512d)a, (__m512d)b);
#elif defined(__AVX2__)
    return (lanes)_mm256_max_pd((__m256d)a, (__m256d)b);
#else
    lane_mask m = a > b;
    return (lanes)(((lane_mask)a & m) | ((lane_mask)b & ~m));
#endif
}

INLINE lanes only(lane_mask m, lanes x)
{
    return (lanes)((lane_mask)x & m);
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

INLINE const lanes *at(const double *array)
{
    return (const lanes *)array;
}

/* out := W x for `count` rows of W, of a constant number. */
INLINE void dot_rows(const lanes *matrix, int32_t n, const lanes *x, lanes *out, int32_t first,
                     const int count)
{
    const lanes *row = matrix + first * n;
    lanes sum[GROUP];
    for (int k = 0; k < count; k++)
        sum[k] = row[k * n] * x[0];
    for (int32_t j = 1; j < n; j++)
        for (int k = 0; k < count; k++)
            sum[k] += row[k * n + j] * x[j];
    for (int k = 0; k < count; k++)
        out[first + k] = sum[k];
}

/* function(..., first, count) for numbers 0 .. n - 1 in groups of a constant count. */
#define FOR_GROUPS(n, function, ...)                                                               \
    {                                                                                              \
        int32_t first = 0;                                                                         \
        for (; first + GROUP <= (n); first += GROUP)                                               \
            function(__VA_ARGS__, first, GROUP);                                                   \
        switch ((n)-first) {                                                                       \
        case 1: function(__VA_ARGS__, first, 1); break;                                            \
        case 2: function(__VA_ARGS__, first, 2); break;                                            \
        case 3: function(__VA_ARGS__, first, 3); break;                                            \
        case 4: function(__VA_ARGS__, first, 4); break;                                            \
        case 5: function(__VA_ARGS__, first, 5); break;                                            \
        case 6: function(__VA_ARGS__, first, 6); break;                                            \
        case 7: function(__VA_ARGS__, first, 7); break;                                            \
        default: break;                                                                            \
        }                                                                                          \
    }

/* out := W x, W count x n. */
INLINE void multiply(const double *matrix, int32_t count, int32_t n, const lanes *x,
                     lanes *out){FOR_GROUPS(count, dot_rows, at(matrix), n, x, out)}

/* sum[k] -= column k . f for `count` columns, of a constant number, of W: rows x n. */
INLINE void dot_columns(const lanes *column, const int count, int32_t rows, int32_t n,
                        const lanes *f, lanes *sum)
{
    for (int32_t r = 0; r < rows; r++)
        for (int k = 0; k < count; k++)
            sum[k] -= column[r * n + k] * f[r];
}

/* What a step works with: the predicted state, then the end of the step. */
typedef struct motion {
    lanes x[TRK_LANES_MODES], v[TRK_LANES_MODES], a[TRK_LANES_MODES];
} motion;

/* Number j of step k of an array of drives with `count` a step. */
INLINE lanes drive_at(const trk_lanes *s, const double *drive, int64_t k, int32_t count, int32_t j)
{
    return s->shared ? spread(drive[k * count + j]) : at(drive)[k * count + j];
}

INLINE lanes road(const trk_lanes *s, const double *drive, int64_t k, int32_t j)
{
    return drive_at(s, drive, k, s->roads, j);
}

/* What acts on the modes beside springs, by rows: links in `f`, then loads. */
INLINE void find_actions(const trk_lanes *s, int64_t k, const lanes *z, lanes *f, lanes *load)
{
    if (s->dense) {
        for (int32_t j = 0; j < s->rows; j++)
            f[j] = spread(0);
    } else {
        multiply(s->row, s->rows, s->n, z, f);
        for (int32_t j = 0; j < s->rows; j++)
            f[j] *= at(s->row_damping)[j];
    }
    for (int32_t j = 0; j < s->road_links; j++)
        f[j] -= at(s->row_height)[j] * road(s, s->height, k, s->row_road[j]) +
                at(s->row_rate)[j] * road(s, s->velocity, k, s->row_road[j]);
    for (int32_t j = 0; s->loaded && j < s->ports; j++)
        load[j] = -drive_at(s, s->load, k, s->ports, j);
}

/* a of (BATCH.3) without table forces, from the predicted state, for `count` modes. */
INLINE void free_modes(const trk_lanes *s, motion *m, const lanes *z, const lanes *f,
                       const lanes *load, int32_t first, const int count)
{
    lanes sum[GROUP];
    int32_t n = s->n;
    for (int k = 0; k < count; k++)
        sum[k] = at(s->weight)[first + k] - at(s->tau)[first + k] * m->x[first + k];
    dot_columns(at(s->row) + first, count, s->rows, n, f, sum);
    if (s->dense) /* C is symmetric */
        dot_columns(at(s->damping) + first, count, n, n, z, sum);
    if (s->loaded)
        dot_columns(at(s->port) + first, count, s->ports, n, load, sum);
    for (int k = 0; k < count; k++)
        m->a[first + k] = sum[k] * at(s->inverse)[first + k];
}

INLINE void free_acceleration(const trk_lanes *s, int64_t k, motion *m)
{
    lanes z[TRK_LANES_MODES], f[TRK_LANES_ROWS], load[TRK_LANES_ROWS];
    double inverse_r = 1 / s->r;
    for (int32_t i = 0; i < s->n; i++)
        z[i] = m->v[i] - inverse_r * m->x[i];
    find_actions(s, k, z, f, load);
    FOR_GROUPS(s->n, free_modes, s, m, z, f, load)
}

/* Arguments of the tables were their forces zero (BATCH.4). */
INLINE void free_arguments(const trk_lanes *s, int64_t k, const motion *m, lanes *x)
{
    lanes end[TRK_LANES_MODES];
    int32_t n = s->n, rates = s->rate_tables;
    if (rates > 0) {
        for (int32_t i = 0; i < n; i++)
            end[i] = m->v[i] + s->gh * m->a[i];
        multiply(s->table_row, rates, n, end, x);
    }
    if (rates < s->tables) {
        for (int32_t i = 0; i < n; i++)
            end[i] = m->x[i] + s->bh2 * m->a[i];
        multiply(s->table_row + (int64_t)rates * n * WIDTH, s->tables - rates, n, end, x + rates);
    }
    for (int32_t t = 0; t < s->tables; t++)
        if (s->table[t].road >= 0)
            x[t] -= at(s->table_road)[t] *
                    road(s, s->table[t].of_rate ? s->velocity : s->height, k, s->table[t].road);
}

/* Fetch pieces that some x has left. */
INLINE void fetch(const trk_lanes *s, const lanes *x)
{
    const lanes *lower = at(s->piece.lower), *upper = at(s->piece.upper);
    lane_mask left = (lane_mask){0};
    for (int32_t t = 0; t < s->tables; t++)
        left |= (x[t] < lower[t]) | (x[t] >= upper[t]);
    if (!any(left))
        return;
    for (int32_t t = 0; t < s->tables; t++)
        if (any((x[t] < lower[t]) | (x[t] >= upper[t])))
            trk_lanes_fetch(s, t, (const double *)&x[t]);
}

/* Force of a table at x. */
INLINE lanes value_at(const trk_lanes *s, int32_t t, lanes x)
{
    const trk_lanes_pieces *p = &s->piece;
    lanes d = x - at(p->origin)[t];
    return at(p->c0)[t] + d * (at(p->c1)[t] + d * (at(p->c2)[t] + d * at(p->c3)[t]));
}

INLINE lanes slope_at(const trk_lanes *s, int32_t t, lanes x)
{
    const trk_lanes_pieces *p = &s->piece;
    lanes d = x - at(p->origin)[t];
    return at(p->c1)[t] + d * (2 * at(p->c2)[t] + d * (3 * at(p->c3)[t]));
}

/* The table forces on their way through a step. */
typedef struct forces {
    double *past[4]; /* in the last steps, the latest first */
    lanes x[TRK_LANES_TABLES], g[TRK_LANES_TABLES];
    lanes inverse[TRK_LANES_TABLES]; /* of 1 + slope E_tt                                     */
    lanes change[TRK_LANES_TABLES], product[TRK_LANES_TABLES];
    lanes contraction; /* mismatch that a correction of 1 may leave                           */
} forces;

/* Start from a cubic through the last four forces; linearise there. */
INLINE void start_forces(const trk_lanes *s, forces *f)
{
    int32_t p = s->tables;
    for (int32_t t = 0; t < p; t++)
        f->g[t] =
            4 * (at(f->past[0])[t] + at(f->past[2])[t]) - 6 * at(f->past[1])[t] - at(f->past[3])[t];
    multiply(s->coupling, p, p, f->g, f->product);
    for (int32_t t = 0; t < p; t++)
        f->x[t] -= f->product[t];
    fetch(s, f->x);
    f->contraction = spread(LEAST_CONTRACTION);
    for (int32_t t = 0; t < p; t++) {
        lanes slope = slope_at(s, t, f->x[t]);
        f->inverse[t] = 1 / (1 + slope * at(s->coupling)[t * p + t]);
        f->contraction = larger(absolute(slope) * at(s->neighbours)[t], f->contraction);
    }
}

/* g += change for lanes that go on; returns its largest entry. */
INLINE lanes correct_forces(const trk_lanes *s, forces *f, lane_mask going)
{
    lanes largest = spread(0);
    for (int32_t t = 0; t < s->tables; t++) {
        lanes change = only(going, (value_at(s, t, f->x[t]) - f->g[t]) * f->inverse[t]);
        f->change[t] = change;
        f->g[t] += change;
        largest = larger(absolute(change), largest); /* a NaN stays out: it shows in the state */
    }
    return largest;
}

/*
 * g = table(x), x = x_free - E g (BATCH.5), by sweeps (BATCH.6) that take the diagonal of the tangent
 * exactly. A lane whose last correction was small enough keeps its g while others go on.
 */
INLINE void solve_forces(const trk_lanes *s, forces *f)
{
    int32_t p = s->tables;
    lanes wanted = s->tolerance * *at(s->largest), limit = larger(*at(s->floor), wanted);
    lane_mask going = *at(s->failed) == 0;
    start_forces(s, f);
    for (int32_t sweep = 1;; sweep++) {
        lanes left = f->contraction * correct_forces(s, f, going);
        going &= left > limit;
        if (!any(going))
            return;
        if (sweep == MOST_SWEEPS) {
            *(lanes *)s->failed += only(going, spread(1));
            return;
        }
        multiply(s->coupling, p, p, f->change, f->product);
        for (int32_t t = 0; t < p; t++)
            f->x[t] -= f->product[t];
        fetch(s, f->x);
    }
}

/* (NEWMARK.2), (NEWMARK.3) with a1 = 0. */
INLINE void predict(const trk_lanes *s, motion *m)
{
    for (int32_t i = 0; i < s->n; i++) {
        lanes v = at(s->v)[i], a = at(s->a)[i];
        m->x[i] = at(s->x)[i] + s->h * v + s->q_predict * a;
        m->v[i] = v + s->v_predict * a;
    }
}

/* Table forces g become the latest; the oldest are dropped. */
INLINE void keep_forces(const trk_lanes *s, forces *f)
{
    double *latest = f->past[3];
    for (int past = 3; past > 0; past--)
        f->past[past] = f->past[past - 1];
    f->past[0] = latest;
    lanes largest = spread(0);
    for (int32_t t = 0; t < s->tables; t++) {
        ((lanes *)latest)[t] = f->g[t];
        largest = larger(absolute(f->g[t]), largest);
    }
    *(lanes *)s->largest = largest;
}

/* The end of the step for `count` modes (BATCH.5). */
INLINE void finish_modes(const trk_lanes *s, const motion *m, const lanes *g, int32_t first,
                         const int count)
{
    lanes sum[GROUP];
    for (int k = 0; k < count; k++)
        sum[k] = spread(0);
    dot_columns(at(s->table_row) + first, count, s->tables, s->n, g, sum);
    for (int k = 0; k < count; k++) {
        int32_t i = first + k;
        lanes a = m->a[i] + at(s->inverse)[i] * sum[k];
        ((lanes *)s->a)[i] = a;
        ((lanes *)s->x)[i] = m->x[i] + s->bh2 * a;
        ((lanes *)s->v)[i] = m->v[i] + s->gh * a;
    }
}

INLINE void finish(const trk_lanes *s, const motion *m,
                   const lanes *g){FOR_GROUPS(s->n, finish_modes, s, m, g)}

INLINE void take_step(const trk_lanes *s, int64_t k, forces *f)
{
    motion m;
    predict(s, &m);
    free_acceleration(s, k, &m);
    if (s->tables > 0) {
        free_arguments(s, k, &m, f->x);
        solve_forces(s, f);
        keep_forces(s, f);
    }
    finish(s, &m, f->g);
}

/* Samples of this block: read for all sensors, and in the tile with the steps they belong to. */
typedef struct recorder {
    int64_t samples, step[TRK_LANES_TILE];
    int32_t used;
} recorder;

/* out[row][k] := row . part of sample k, for `count` rows, of a constant number, and a whole tile. */
INLINE void dot_tile(const lanes *matrix, int32_t n, const lanes *part, int32_t stride, lanes *out,
                     int32_t first, const int count)
{
    const lanes *row = matrix + first * n;
    lanes sum[TILE_ROWS][TRK_LANES_TILE] = {{{0}}};
    for (int32_t j = 0; j < n; j++)
        for (int k = 0; k < TRK_LANES_TILE; k++) {
            const lanes value = part[k * stride + j];
            for (int i = 0; i < count; i++)
                sum[i][k] += row[i * n + j] * value;
        }
    for (int i = 0; i < count; i++)
        for (int k = 0; k < TRK_LANES_TILE; k++)
            out[(first + i) * TRK_LANES_TILE + k] = sum[i][k];
}

/* All rows on one part of the state. */
INLINE void multiply_tile(const lanes *matrix, int32_t count, int32_t n, const lanes *part,
                          int32_t stride, lanes *out)
{
    int32_t first = 0;
    for (; first + TILE_ROWS <= count; first += TILE_ROWS)
        dot_tile(matrix, n, part, stride, out, first, TILE_ROWS);
    for (; first < count; first++)
        dot_tile(matrix, n, part, stride, out, first, 1);
}

/* Product of a sensor's row on some part at sample k; zero if it has none. */
INLINE lanes product_at(const trk_lanes *s, int32_t row, int64_t k)
{
    return row >= 0 ? at(s->products)[row * TRK_LANES_TILE + k] : spread(0);
}

/* Value of a sensor at sample k of the tile (BATCH.8). */
INLINE lanes read_sensor(const trk_lanes *s, const recorder *r, int32_t j, int32_t k)
{
    const trk_lanes_sensor *sensor = &s->sensor[j];
    lanes value = product_at(s, sensor->row[0], k);
    if (sensor->row[1] >= 0)
        value += product_at(s, sensor->row[1], k);
    if (sensor->row[2] >= 0)
        value += product_at(s, sensor->row[2], k);
    if (sensor->road >= 0)
        value += at(s->sensor_height)[j] * road(s, s->height, r->step[k], sensor->road) +
                 at(s->sensor_rate)[j] * road(s, s->velocity, r->step[k], sensor->road);
    for (int t = 0; t < 2 && sensor->table[t] >= 0; t++)
        value += at(s->tile)[k * (3 * s->n + s->tables) + 3 * s->n + sensor->table[t]];
    return value;
}

/* All sensors at the samples of the tile, behind those that the block has. */
INLINE void read_tile(const trk_lanes *s, recorder *r)
{
    int32_t n = s->n, row = 0;
    for (int part = 0; part < 3; part++) {
        multiply_tile(at(s->sensor_rows) + row * n, s->part_rows[part], n, at(s->tile) + part * n,
                      3 * n + s->tables, (lanes *)s->products + row * TRK_LANES_TILE);
        row += s->part_rows[part];
    }
    for (int32_t j = 0; j < s->sensors; j++) {
        lanes value[TRK_LANES_TILE] = {{0}};
        double *out = s->recorded + (int64_t)j * TRK_LANES_BLOCK + r->samples;
        for (int32_t k = 0; k < r->used; k++)
            value[k] = read_sensor(s, r, j, k);
        for (int l = 0; l < WIDTH; l++)
            for (int k = 0; k < TRK_LANES_TILE; k++)
                out[(int64_t)l * s->sensors * TRK_LANES_BLOCK + k] = value[k][l];
    }
    r->samples += r->used;
    r->used = 0;
}

/* The present state, at the end of step k of the block, into the tile. */
INLINE void record(const trk_lanes *s, recorder *r, const double *force, int64_t k)
{
    int32_t n = s->n;
    lanes *sample = (lanes *)s->tile + r->used * (3 * n + s->tables);
    for (int32_t i = 0; i < n; i++) {
        sample[i] = at(s->x)[i];
        sample[n + i] = at(s->v)[i];
        sample[2 * n + i] = at(s->a)[i];
    }
    for (int32_t t = 0; t < s->tables; t++)
        sample[3 * n + t] = at(force)[t];
    r->step[r->used++] = k;
    if (r->used == TRK_LANES_TILE)
        read_tile(s, r);
}

static void advance(trk_lanes *lanes_of_group, int64_t count)
{
    const trk_lanes s = *lanes_of_group; /* a copy that no store below can change */
    recorder r = {0};
    forces f;
    memcpy(f.past, s.force, sizeof f.past);
    int64_t until_record = s.until_record;
    for (int64_t k = 0; k < count; k++) {
        take_step(&s, k, &f);
        if (--until_record == 0) {
            until_record = s.record_every;
            record(&s, &r, f.past[0], k);
        }
    }
    if (r.used > 0)
        read_tile(&s, &r);
    memcpy(lanes_of_group->force, f.past, sizeof f.past);
    lanes_of_group->until_record = until_record;
    lanes_of_group->samples = r.samples;
}

static void record_now(trk_lanes *s)
{
    recorder r = {0};
    record(s, &r, s->force[0], 0);
    read_tile(s, &r);
    s->samples = r.samples;
}

const trk_lanes_kernel KERNEL = {WIDTH, advance, record_now};
