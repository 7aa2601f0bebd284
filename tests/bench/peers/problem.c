/* SPDX-License-Identifier: MIT */
#include "problem.h"

#include "model/model.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double pi = 3.14159265358979323846;

/* Solve M x = b for the columns of b (count of them, n apart) by Gauss elimination; M is lost. */
static void solve(int n, double *m, int count, double *b)
{
    for (int k = 0; k < n; k++)
        for (int i = 0; i < n; i++) {
            if (i == k)
                continue;
            double factor = m[i * n + k] / m[k * n + k];
            for (int j = k; j < n; j++)
                m[i * n + j] -= factor * m[k * n + j];
            for (int j = 0; j < count; j++)
                b[j * n + i] -= factor * b[j * n + k];
        }
    for (int j = 0; j < count; j++)
        for (int i = 0; i < n; i++)
            b[j * n + i] /= m[i * n + i];
}

/* Pieces of scale * curve, less its force at rest, straight beyond the ends. */
static void set_table(problem_table *t, const trk_curve *curve, double scale)
{
    double rest = trk_curve_value(curve, 0);
    t->points = (int)trk_curve_count(curve);
    if (t->points > PROBLEM_POINTS)
        exit(1);
    for (int k = 0; k < t->points; k++) {
        double x = trk_curve_x(curve)[k], *c = t->c[k + 1];
        t->x[k] = x;
        c[0] = scale * (trk_curve_y(curve)[k] - rest);
        c[1] = scale * trk_curve_slope(curve, x);
    }
    memcpy(t->c[0], t->c[1], sizeof t->c[0]);
    for (int k = 0; k + 1 < t->points; k++) {
        double h = t->x[k + 1] - t->x[k], *c = t->c[k + 1], *next = t->c[k + 2];
        double mean = (next[0] - c[0]) / h;
        c[2] = (3 * mean - 2 * c[1] - next[1]) / h;
        c[3] = (c[1] + next[1] - 2 * mean) / (h * h);
    }
}

static inline double table_force(problem_table *t, double x, double *slope)
{
    while (t->at > 0 && x < t->x[t->at - 1])
        t->at--;
    while (t->at < t->points && x >= t->x[t->at])
        t->at++;
    const double *c = t->c[t->at];
    double d = x - t->x[t->at > 0 ? t->at - 1 : 0];
    if (slope)
        *slope = c[1] + d * (2 * c[2] + 3 * c[3] * d);
    return c[0] + d * (c[1] + d * (c[2] + d * c[3]));
}

static void add_link(problem *p, int32_t link, double (*columns)[PROBLEM_MAX])
{
    const trk_model *model = p->rig->model;
    const trk_link_law *law = &model->laws[link];
    double b[PROBLEM_MAX] = {0}, g[RIG_ROADS] = {0}, road = 0;
    double(*force)[PROBLEM_MAX] = columns + 2 * p->n + 2;
    bench_must(p->rig->bench, trk_model_get_link_row(model, link + 1, b, g));
    for (int k = 0; k < p->rig->roads; k++)
        road += g[k] * p->rig->gain[k];
    for (int i = 0; i < p->n; i++) {
        for (int j = 0; j < p->n; j++) {
            columns[j][i] -= law->stiffness * b[i] * b[j];
            columns[p->n + j][i] -= law->damping * b[i] * b[j];
        }
        columns[2 * p->n][i] += law->stiffness * b[i] * road;
        columns[2 * p->n + 1][i] += law->damping * b[i] * road;
    }
    if (!law->damper)
        return;
    for (int i = 0; i < p->n; i++) {
        force[p->tables][i] = -b[i];
        ((double *)&p->rate_of[i])[p->tables] = b[i];
    }
    set_table(&p->table[p->tables++], law->damper, law->damper_scale);
}

static void set_vector(problem_vector *out, int n, const double *x)
{
    memcpy(out, x, (size_t)n * sizeof *x);
}

problem *problem_create(const rig *r)
{
    enum { COLUMNS = 2 * PROBLEM_MAX + 2 + PROBLEM_TABLES };
    double columns[COLUMNS][PROBLEM_MAX] = {{0}}, packed[COLUMNS * PROBLEM_MAX],
           mass[PROBLEM_MAX * PROBLEM_MAX];
    problem *p = (problem *)bench_zeros((int64_t)(sizeof *p / sizeof(double) + 1));
    int n = r->n;
    if (n > PROBLEM_MAX || r->curves > PROBLEM_TABLES)
        exit(1);
    *p = (problem){.rig = r, .n = n, .seconds = r->seconds, .samples = r->steps / PROBLEM_EVERY};
    p->frequency = 0.8;
    p->growth = log(20 / 0.8) / r->seconds;
    p->amplitude = 1e-3;
    for (int32_t k = 0; k < r->links; k++)
        add_link(p, k, columns);
    int count = 2 * n + 2 + p->tables;
    for (int k = 0; k < count; k++)
        memcpy(packed + k * n, columns[k], (size_t)n * sizeof(double));
    trk_model_get_mass(r->model, mass);
    solve(n, mass, count, packed);
    for (int k = 0; k < 2 * n; k++)
        set_vector(&p->linear[k], n, packed + k * n);
    set_vector(&p->of_height, n, packed + 2 * n * n);
    set_vector(&p->of_rate, n, packed + (2 * n + 1) * n);
    for (int k = 0; k < p->tables; k++)
        set_vector(&p->of_force[k], n, packed + (2 * n + 2 + k) * n);
    return p;
}

void problem_destroy(problem *p)
{
    free(p);
}

void problem_road(const problem *p, double t, double *height, double *rate)
{
    double ratio = exp(p->growth * t), f = p->frequency * ratio, a = p->amplitude / f;
    double phase = 2 * pi * p->frequency / p->growth * (ratio - 1), s = sin(phase);
    *height = a * s;
    *rate = a * (2 * pi * f * cos(phase) - p->growth * s);
}

void problem_acceleration(problem *p, const double *y, double height, double rate, double *a)
{
    int n = p->n;
    problem_lanes low = p->of_height.part[0] * height + p->of_rate.part[0] * rate,
                  high = p->of_height.part[1] * height + p->of_rate.part[1] * rate, x = {0};
    for (int j = 0; j < 2 * n; j++) {
        low += p->linear[j].part[0] * y[j];
        high += p->linear[j].part[1] * y[j];
    }
    for (int j = 0; j < n; j++)
        x += p->rate_of[j] * y[n + j];
    for (int k = 0; k < p->tables; k++) {
        double force = table_force(&p->table[k], x[k], NULL);
        low += p->of_force[k].part[0] * force;
        high += p->of_force[k].part[1] * force;
    }
    problem_vector sum = {{low, high}};
    memcpy(a, &sum, (size_t)n * sizeof *a);
    p->evaluations++;
}

void problem_derivative(problem *p, double t, const double *y, double *out)
{
    double height, rate;
    problem_road(p, t, &height, &rate);
    memcpy(out, y + p->n, (size_t)p->n * sizeof *out);
    problem_acceleration(p, y, height, rate, out + p->n);
}

void problem_jacobian(problem *p, const double *y, double *out)
{
    int n = p->n;
    problem_lanes x = {0};
    for (int j = 0; j < n; j++)
        x += p->rate_of[j] * y[n + j];
    memset(out, 0, (size_t)(4 * n * n) * sizeof *out);
    for (int j = 0; j < 2 * n; j++)
        memcpy(out + 2 * n * j + n, &p->linear[j], (size_t)n * sizeof *out);
    for (int j = 0; j < n; j++)
        out[2 * n * (n + j) + j] = 1;
    for (int k = 0; k < p->tables; k++) {
        double slope;
        table_force(&p->table[k], x[k], &slope);
        const double *column = (const double *)&p->of_force[k];
        for (int j = 0; j < n; j++) {
            double factor = slope * ((const double *)&p->rate_of[j])[k];
            for (int i = 0; factor != 0 && i < n; i++)
                out[2 * n * (n + j) + n + i] += factor * column[i];
        }
    }
}
