/* SPDX-License-Identifier: MIT */
/* The workspace of a group of variants: what follows from their common structure. */
#include "batch/lanes.h"

#include "curve/curve.h"

#include <string.h>

static int32_t count_tables(const trk_model *model, bool of_rate)
{
    int32_t count = 0;
    for (int32_t k = 0; k < model->links.count; k++)
        count += of_rate ? model->laws[k].damper != NULL : model->laws[k].spring != NULL;
    return count;
}

static int32_t road_of(const trk_model *model, int32_t link)
{
    const trk_rows *roads = &model->roads;
    return roads->start[link + 1] > roads->start[link] ? roads->column[roads->start[link]] : -1;
}

static int32_t count_road_links(const trk_model *model)
{
    int32_t count = 0;
    for (int32_t k = 0; k < model->links.count; k++)
        count += road_of(model, k) >= 0;
    return count;
}

/* With more rows than these, C in full is less work. */
static int32_t most_rows(const trk_model *model)
{
    return count_road_links(model) + model->n / 2 + 1;
}

bool trk_lanes_fit(const trk_model *model, const trk_newmark_options *options)
{
    return trk_model_find_law(model) < 0 && options->alpha_f == 0 && options->alpha_m == 0 &&
           options->beta > 0 && options->backend != TRK_BACKEND_SPARSE &&
           model->n <= TRK_LANES_MODES && most_rows(model) <= TRK_LANES_ROWS &&
           model->ports.count <= TRK_LANES_ROWS &&
           count_tables(model, true) + count_tables(model, false) <= TRK_LANES_TABLES;
}

static void list_tables(trk_lanes *s, const trk_model *model)
{
    for (int32_t of_rate = 1; of_rate >= 0; of_rate--) {
        for (int32_t k = 0; k < s->links; k++) {
            const trk_link_law *law = &model->laws[k];
            if (of_rate ? law->damper : law->spring)
                s->table[s->tables++] =
                    (trk_lanes_table){k, of_rate, !of_rate || !law->spring, road_of(model, k)};
        }
        if (of_rate)
            s->rate_tables = s->tables;
    }
}

/* Does a quantity read displacements (part 0), velocities (1) or accelerations (2)? */
static bool reads(trk_quantity quantity, int part)
{
    switch (quantity) {
    case TRK_QUANTITY_DISPLACEMENT:
    case TRK_QUANTITY_ELONGATION: return part == 0;
    case TRK_QUANTITY_VELOCITY:
    case TRK_QUANTITY_RATE: return part == 1;
    case TRK_QUANTITY_ACCELERATION: return part == 2;
    default: return part < 2; /* a force */
    }
}

static void list_sensors(trk_lanes *s, const trk_model *model)
{
    int32_t rows = 0;
    for (int part = 0; part < 3; part++) {
        int32_t before = rows;
        for (int32_t k = 0; k < s->sensors; k++)
            s->sensor[k].row[part] =
                reads(model->sensor_quantity[s->sensor[k].id], part) ? rows++ : -1;
        s->part_rows[part] = rows - before;
    }
    for (int32_t k = 0; k < s->sensors; k++) {
        trk_lanes_sensor *sensor = &s->sensor[k];
        int32_t link = model->sensor_link[sensor->id], found = 0;
        sensor->road = link >= 0 ? road_of(model, link) : -1;
        sensor->table[0] = sensor->table[1] = -1;
        for (int32_t t = 0; sensor->row[0] >= 0 && sensor->row[1] >= 0 && t < s->tables; t++)
            if (s->table[t].link == link)
                sensor->table[found++] = t;
    }
}

/* All arrays of doubles, in one block; counting first (block NULL), then dealing out. */
static int64_t deal(trk_lanes *s)
{
    int64_t n = s->n, p = s->tables, used = 0,
            sensor_rows = s->part_rows[0] + s->part_rows[1] + s->part_rows[2];
    struct {
        double **array;
        int64_t size;
    } arrays[] = {{&s->x, n},
                  {&s->v, n},
                  {&s->a, n},
                  {&s->force[0], p},
                  {&s->force[1], p},
                  {&s->force[2], p},
                  {&s->force[3], p},
                  {&s->largest, 1},
                  {&s->floor, 1},
                  {&s->failed, 1},
                  {&s->tau, n},
                  {&s->inverse, n},
                  {&s->row_damping, s->most_rows},
                  {&s->row_height, s->road_links},
                  {&s->row_rate, s->road_links},
                  {&s->row, s->most_rows * n},
                  {&s->damping, n * n},
                  {&s->table_row, p * n},
                  {&s->coupling, p * p},
                  {&s->neighbours, p},
                  {&s->table_road, p},
                  {&s->piece.lower, p},
                  {&s->piece.upper, p},
                  {&s->piece.origin, p},
                  {&s->piece.c0, p},
                  {&s->piece.c1, p},
                  {&s->piece.c2, p},
                  {&s->piece.c3, p},
                  {&s->weight, n},
                  {&s->port, s->ports * n},
                  {&s->tile, TRK_LANES_TILE * (3 * n + p)},
                  {&s->sensor_rows, sensor_rows * n},
                  {&s->products, sensor_rows * TRK_LANES_TILE},
                  {&s->sensor_height, s->sensors},
                  {&s->sensor_rate, s->sensors},
                  {&s->before_x, n},
                  {&s->before_v, n},
                  {&s->psi, n * n},
                  {&s->by_lane, (int64_t)TRK_LANES_BLOCK * (2 * s->roads + s->ports)},
                  {&s->recorded, (int64_t)TRK_LANES_BLOCK * s->sensors}};
    for (size_t k = 0; k < sizeof arrays / sizeof *arrays; k++) {
        *arrays[k].array = s->block ? s->block + used : NULL;
        used += arrays[k].size * s->width;
    }
    return used;
}

static void set_step(trk_lanes *s, const trk_newmark_options *o)
{
    s->h = o->step;
    s->q_predict = o->step * o->step * (0.5 - o->beta);
    s->v_predict = o->step * (1 - o->gamma);
    s->bh2 = o->beta * o->step * o->step;
    s->gh = o->gamma * o->step;
    s->r = o->beta * o->step / o->gamma;
    s->tolerance = o->tolerance;
}

trk_status trk_lanes_create(trk_context *context, const trk_model *model,
                            const trk_newmark_options *options, int64_t record_every,
                            int32_t sensors, const int32_t *sensor, int32_t width, trk_lanes **out)
{
    *out = NULL;
    trk_lanes *s = trk_new(context, 1, sizeof *s);
    if (!s)
        return TRK_E_MEMORY;
    s->context = context;
    s->width = width;
    s->n = model->n;
    s->roads = model->names[TRK_PART_ROAD].count;
    s->ports = model->ports.count;
    s->links = model->links.count;
    s->sensors = sensors;
    s->record_every = record_every;
    set_step(s, options);
    list_tables(s, model);
    s->road_links = count_road_links(model);
    s->most_rows = most_rows(model);
    s->sensor = trk_new(context, s->sensors, sizeof *s->sensor);
    s->row_link = trk_new(context, s->most_rows, sizeof *s->row_link);
    s->row_road = trk_new(context, s->road_links, sizeof *s->row_road);
    s->curve = trk_new(context, (int64_t)s->tables * width, sizeof *s->curve);
    if (s->sensor && s->row_link && s->row_road && s->curve) {
        for (int32_t k = 0; k < sensors; k++)
            s->sensor[k].id = sensor[k];
        list_sensors(s, model);
        s->block_size = deal(s);
        s->block = trk_new(context, s->block_size, sizeof *s->block);
    }
    if (!s->block) {
        trk_lanes_destroy(s);
        return TRK_E_MEMORY;
    }
    deal(s);
    *out = s;
    return TRK_OK;
}

void trk_lanes_destroy(trk_lanes *lanes)
{
    if (!lanes)
        return;
    trk_free(lanes->context, lanes->sensor);
    trk_free(lanes->context, lanes->row_link);
    trk_free(lanes->context, lanes->row_road);
    trk_free(lanes->context, lanes->curve);
    trk_free(lanes->context, lanes->block);
    trk_free(lanes->context, lanes);
}

bool trk_lanes_alike(const trk_model *a, const trk_model *b)
{
    for (int32_t k = 0; k < a->links.count; k++)
        if ((a->laws[k].damping != 0) != (b->laws[k].damping != 0))
            return false;
    return true;
}

void trk_lanes_start(trk_lanes *s, const trk_model *model)
{
    memset(s->block, 0, (size_t)s->block_size * sizeof *s->block);
    s->loaded = false;
    s->until_record = s->record_every;
    s->samples = 0;
    int32_t damped = 0;
    for (int32_t k = 0; k < s->links; k++)
        damped += road_of(model, k) < 0 && model->laws[k].damping != 0;
    /* n^2 products and a row back for each road, against two rows for each link. */
    s->dense = s->n + s->road_links < 2 * (s->road_links + damped);
    s->rows = 0;
    for (int32_t k = 0; k < s->links; k++)
        if (road_of(model, k) >= 0) {
            s->row_road[s->rows] = road_of(model, k);
            s->row_link[s->rows++] = k;
        }
    for (int32_t k = 0; !s->dense && k < s->links; k++)
        if (road_of(model, k) < 0 && model->laws[k].damping != 0)
            s->row_link[s->rows++] = k;
}

void trk_lanes_copy(trk_lanes *s, int32_t from, int32_t to)
{
    for (double *number = s->block; number < s->block + s->block_size; number += s->width)
        number[to] = number[from];
    for (int32_t t = 0; t < s->tables; t++)
        s->curve[t * s->width + to] = s->curve[t * s->width + from];
}

void trk_lanes_keep(trk_lanes *s)
{
    memcpy(s->before_x, s->x, (size_t)(s->n * s->width) * sizeof *s->x);
    memcpy(s->before_v, s->v, (size_t)(s->n * s->width) * sizeof *s->v);
}

void trk_lanes_get_kept(const trk_lanes *s, int32_t lane, double *out_q, double *out_v)
{
    for (int32_t i = 0; i < s->n; i++) {
        out_q[i] = out_v[i] = 0;
        for (int32_t j = 0; j < s->n; j++) {
            double psi = s->psi[(i * s->n + j) * s->width + lane];
            out_q[i] += psi * s->before_x[j * s->width + lane];
            out_v[i] += psi * s->before_v[j * s->width + lane];
        }
    }
}

void trk_lanes_fetch(const trk_lanes *s, int32_t table, const double *x)
{
    const trk_lanes_pieces *p = &s->piece;
    for (int32_t lane = 0; lane < s->width; lane++) {
        int32_t k = table * s->width + lane;
        if (!(x[lane] < p->lower[k] || x[lane] >= p->upper[k]))
            continue;
        trk_lanes_curve *c = &s->curve[k];
        c->hint = trk_curve_locate(c->curve, x[lane] + c->offset, c->hint);
        const trk_piece *piece = &c->curve->pieces[c->hint];
        p->lower[k] = piece->lower - c->offset;
        p->upper[k] = piece->upper - c->offset;
        p->origin[k] = piece->origin - c->offset;
        p->c0[k] = c->scale * piece->c0 - c->rest;
        p->c1[k] = c->scale * piece->c1;
        p->c2[k] = c->scale * piece->c2;
        p->c3[k] = c->scale * piece->c3;
    }
}

#ifdef TRUCKRIDE_X86_KERNELS
/* Are the numbers that a step reads of eight variants far more than a first-level cache holds? */
static bool is_large(const trk_model *model)
{
    enum { MOST = 48 * 1024 };
    int64_t n = model->n, p = count_tables(model, true) + count_tables(model, false);
    return (n * (8 + most_rows(model) + p) + p * (p + 7)) * 8 * (int64_t)sizeof(double) > MOST;
}
#endif

const trk_lanes_kernel *trk_lanes_find_kernel(int32_t kernel, const trk_model *model)
{
#ifdef TRUCKRIDE_X86_KERNELS
    bool avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    bool avx512 = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq");
    if (kernel == TRK_BATCH_KERNEL_BEST && avx2 && is_large(model))
        kernel = TRK_BATCH_KERNEL_AVX2;
    if (avx512 && (kernel == TRK_BATCH_KERNEL_AVX512 || kernel == TRK_BATCH_KERNEL_BEST))
        return &trk_lanes_avx512;
    if (avx2 && (kernel == TRK_BATCH_KERNEL_AVX2 || kernel == TRK_BATCH_KERNEL_BEST))
        return &trk_lanes_avx2;
#else
    (void)model;
#endif
    if (kernel == TRK_BATCH_KERNEL_PORTABLE || kernel == TRK_BATCH_KERNEL_BEST)
        return &trk_lanes_portable;
    return NULL;
}
