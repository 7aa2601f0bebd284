/* SPDX-License-Identifier: MIT */
/* The numbers of one variant, into its lane (BATCH.1 to BATCH.5). */
#include "batch/lanes.h"

#include "newmark/modal.h"

#include <float.h>
#include <math.h>
#include <string.h>

/* One variant on its way into a lane. */
typedef struct filling {
    trk_lanes *s;
    int32_t lane;
    const trk_model *model;
    double *psi;         /* n x n, coordinate x mode    */
    double *psi_inverse; /* psi^T M                     */
    double *tau;         /* n                           */
    double *rows;        /* B psi, links x n            */
    double *column;      /* n                           */
} filling;

static void set(const filling *f, double *array, int64_t index, double value)
{
    array[index * f->s->width + f->lane] = value;
}

/*
 * psi of (BATCH.1): the modes of a model whose links have the stiffness k + c / r. false:
 * there are none.
 */
static trk_status find_basis(const filling *f, trk_context *context, bool *out_fits)
{
    trk_model stiffened = *f->model;
    trk_link_law *laws = trk_new(context, f->s->links, sizeof *laws);
    if (!laws)
        return TRK_E_MEMORY;
    bool fits = true;
    for (int32_t k = 0; k < f->s->links; k++) {
        laws[k] = f->model->laws[k];
        laws[k].stiffness += laws[k].damping / f->s->r;
        fits = fits && laws[k].stiffness >= 0;
    }
    stiffened.laws = laws;
    trk_status status =
        fits ? trk_modal_basis(context, &stiffened, f->psi, f->psi_inverse, f->tau) : TRK_OK;
    trk_free(context, laws);
    *out_fits = fits && status == TRK_OK;
    return status == TRK_E_SINGULAR ? TRK_OK : status;
}

/* out += factor row psi */
static void add_modal(const filling *f, const trk_rows *rows, int32_t row, double factor,
                      double *out)
{
    int32_t n = f->s->n;
    for (int64_t k = rows->start[row]; k < rows->start[row + 1]; k++)
        for (int32_t i = 0; i < n; i++)
            out[i] += factor * rows->value[k] * f->psi[rows->column[k] * n + i];
}

/* A row of n numbers into place `row` of an array of rows. */
static void set_row(const filling *f, double *array, int64_t row, double factor,
                    const double *values)
{
    for (int32_t i = 0; i < f->s->n; i++)
        set(f, array, row * f->s->n + i, factor * values[i]);
}

/* G of a link: it has one entry, or none. */
static double road_gain(const trk_model *model, int32_t link)
{
    const trk_rows *roads = &model->roads;
    return roads->start[link + 1] > roads->start[link] ? roads->value[roads->start[link]] : 0;
}

static void set_linear(const filling *f)
{
    trk_lanes *s = f->s;
    int32_t n = s->n;
    for (int32_t i = 0; i < n; i++) {
        set(f, s->tau, i, f->tau[i]);
        set(f, s->inverse, i, 1 / (1 + s->bh2 * f->tau[i]));
        for (int32_t j = 0; j < n; j++)
            set(f, s->psi, (int64_t)i * n + j, f->psi[i * n + j]);
    }
    for (int32_t k = 0; k < s->links; k++)
        add_modal(f, &f->model->links, k, 1, f->rows + (int64_t)k * n);
    for (int32_t k = 0; k < s->rows; k++) {
        const trk_link_law *law = &f->model->laws[s->row_link[k]];
        set_row(f, s->row, k, 1, f->rows + (int64_t)s->row_link[k] * n);
        set(f, s->row_damping, k, law->damping);
        if (k < s->road_links) {
            double gain = road_gain(f->model, s->row_link[k]);
            set(f, s->row_height, k, law->stiffness * gain);
            set(f, s->row_rate, k, law->damping * gain);
        }
    }
    for (int32_t i = 0; s->dense && i < n; i++) {
        memset(f->column, 0, (size_t)n * sizeof *f->column);
        for (int32_t k = 0; k < s->links; k++) {
            const double *row = f->rows + (int64_t)k * n;
            for (int32_t j = 0; j < n; j++)
                f->column[j] += f->model->laws[k].damping * row[i] * row[j];
        }
        set_row(f, s->damping, i, 1, f->column);
    }
}

static void set_loads(const filling *f)
{
    trk_lanes *s = f->s;
    for (int32_t k = 0; k < s->ports; k++) {
        memset(f->column, 0, (size_t)s->n * sizeof *f->column);
        add_modal(f, &f->model->ports, k, 1, f->column);
        set_row(f, s->port, k, 1, f->column);
    }
    for (int32_t i = 0; i < s->n; i++) {
        double sum = 0;
        for (int32_t j = 0; j < s->n; j++)
            sum += f->psi[j * s->n + i] * f->model->weight[j];
        set(f, s->weight, i, sum);
    }
}

static double largest_of(const trk_curve *curve)
{
    double largest = 0;
    for (int64_t k = 0; curve && k < trk_curve_count(curve); k++)
        largest = fmax(largest, fabs(trk_curve_y(curve)[k]));
    return largest;
}

static void set_tables(const filling *f)
{
    trk_lanes *s = f->s;
    double floor = 0;
    for (int32_t t = 0; t < s->tables; t++) {
        const trk_lanes_table *table = &s->table[t];
        const trk_link_law *law = &f->model->laws[table->link];
        const double *row = f->rows + (int64_t)table->link * s->n;
        double others = 0, rest = table->first ? law->rest : 0,
               kappa = table->of_rate ? s->gh : s->bh2;
        s->curve[t * s->width + f->lane] =
            table->of_rate
                ? (trk_lanes_curve){law->damper, law->damper_scale, 0, rest, 0}
                : (trk_lanes_curve){law->spring, law->spring_scale, law->spring_offset, rest, 0};
        set(f, s->piece.lower, t, INFINITY); /* nothing fetched yet */
        set(f, s->piece.upper, t, INFINITY);
        set_row(f, s->table_row, t, 1, row);
        set(f, s->table_road, t, road_gain(f->model, table->link));
        for (int32_t u = 0; u < s->tables; u++) {
            const double *other = f->rows + (int64_t)s->table[u].link * s->n;
            double sum = 0;
            for (int32_t i = 0; i < s->n; i++)
                sum += row[i] * other[i] / (1 + s->bh2 * f->tau[i]);
            set(f, s->coupling, (int64_t)t * s->tables + u, kappa * sum);
            others += u == t ? 0 : fabs(kappa * sum);
        }
        set(f, s->neighbours, t, others);
        floor = fmax(floor, law->spring_scale * largest_of(law->spring) +
                                law->damper_scale * largest_of(law->damper));
    }
    set(f, s->floor, 0, 8 * DBL_EPSILON * floor);
}

static void set_sensors(const filling *f)
{
    trk_lanes *s = f->s;
    for (int32_t k = 0; k < s->sensors; k++) {
        const trk_lanes_sensor *sensor = &s->sensor[k];
        int32_t link = f->model->sensor_link[sensor->id];
        double factor[3] = {sensor->row[0] >= 0, sensor->row[1] >= 0, 1};
        const double *values = f->column;
        if (link < 0) {
            memset(f->column, 0, (size_t)s->n * sizeof *f->column);
            add_modal(f, &f->model->sensors, sensor->id, 1, f->column);
        } else {
            const trk_link_law *law = &f->model->laws[link];
            values = f->rows + (int64_t)link * s->n;
            if (sensor->row[0] >= 0 && sensor->row[1] >= 0) { /* a force */
                factor[0] = law->stiffness;
                factor[1] = law->damping;
            }
            set(f, s->sensor_height, k, -factor[0] * road_gain(f->model, link));
            set(f, s->sensor_rate, k, -factor[1] * road_gain(f->model, link));
        }
        for (int part = 0; part < 3; part++)
            if (sensor->row[part] >= 0)
                set_row(f, s->sensor_rows, sensor->row[part], factor[part], values);
    }
}

/* x = psi^T M q of static equilibrium, v = 0, and a = psi^T r from the balance of forces. */
static void set_state(const filling *f, const double *height, const double *velocity,
                      const double *load)
{
    trk_lanes *s = f->s;
    const trk_model *model = f->model;
    int32_t n = s->n;
    memcpy(f->column, model->weight, (size_t)n * sizeof *f->column);
    for (int32_t k = 0; k < s->ports; k++)
        trk_rows_add(&model->ports, k, load[k], f->column);
    for (int32_t k = 0; k < s->links; k++) {
        double e = trk_rows_dot(&model->links, k, model->static_q) -
                   trk_rows_dot(&model->roads, k, height);
        double rate = -trk_rows_dot(&model->roads, k, velocity);
        trk_rows_add(&model->links, k, -trk_link_law_force(&model->laws[k], e, rate), f->column);
        for (int32_t t = 0; t < s->tables; t++) {
            const trk_lanes_curve *c = &s->curve[t * s->width + f->lane];
            if (s->table[t].link != k)
                continue;
            double x = s->table[t].of_rate ? rate : e;
            double force = c->scale * trk_curve_value(c->curve, x + c->offset) - c->rest;
            for (int past = 0; past < 4; past++)
                set(f, s->force[past], t, force);
        }
    }
    for (int32_t i = 0; i < n; i++) {
        double x = 0, a = 0;
        for (int32_t j = 0; j < n; j++) {
            x += f->psi_inverse[i * n + j] * model->static_q[j];
            a += f->psi[j * n + i] * f->column[j];
        }
        set(f, s->x, i, x);
        set(f, s->v, i, 0);
        set(f, s->a, i, a);
    }
}

trk_status trk_lanes_fill(trk_lanes *s, int32_t lane, trk_context *context, const trk_model *model,
                          const double *height, const double *velocity, const double *load,
                          bool *out_fits)
{
    int64_t n = s->n;
    *out_fits = false;
    double *work = trk_new(context, 2 * n * n + 2 * n + s->links * n, sizeof *work);
    if (!work)
        return TRK_E_MEMORY;
    filling f = {.s = s, .lane = lane, .model = model, .psi = work, .psi_inverse = work + n * n};
    f.tau = f.psi_inverse + n * n;
    f.column = f.tau + n;
    f.rows = f.column + n;
    trk_status status = find_basis(&f, context, out_fits);
    if (status == TRK_OK && *out_fits) {
        set_linear(&f);
        set_loads(&f);
        set_tables(&f);
        set_sensors(&f);
        set_state(&f, height, velocity, load);
    }
    trk_free(context, work);
    return status;
}
