/* SPDX-License-Identifier: MIT */
#include "plain_newton.h"

#include "model/model.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MAX = 16, POINTS = 192, MAX_ROADS = 4 };

/* Curve as cubic pieces, straight beyond the ends; `at` is where it was last. */
typedef struct spline {
    int points, at;
    double scale, offset, rest;
    double x[POINTS], c[POINTS + 1][4]; /* c[k + 1] from x[k] on, c[0] before x[0] */
} spline;

/* A force along a row: of the elongation, or of its rate. */
typedef struct element {
    bool damper;
    double b[MAX];
    spline curve;
} element;

struct plain_newton {
    int n, roads, elements;
    double h, beta, gamma, tolerance;
    int max_iterations;
    long long iterations;
    double m[MAX][MAX], c[MAX][MAX], k[MAX][MAX], s0[MAX][MAX]; /* linear parts */
    double ku[MAX][MAX_ROADS], cu[MAX][MAX_ROADS];              /* road to force */
    double q[MAX], v[MAX], a[MAX], past1[MAX], past2[MAX];
    element *element;
};

/* Pieces of a curve from its table and the slopes at its points. */
static bool extract(const trk_curve *curve, spline *s)
{
    int64_t count = trk_curve_count(curve);
    if (count > POINTS)
        return false;
    s->points = (int)count;
    for (int j = 0; j < s->points; j++) {
        double x = trk_curve_x(curve)[j], y = trk_curve_y(curve)[j], d = trk_curve_slope(curve, x);
        s->x[j] = x;
        double *c = s->c[j + 1];
        c[0] = y;
        c[1] = d;
        if (j == 0) {
            s->c[0][0] = y;
            s->c[0][1] = d;
        }
        if (j + 1 == s->points)
            break;
        double h = trk_curve_x(curve)[j + 1] - x, m = (trk_curve_y(curve)[j + 1] - y) / h;
        double d1 = trk_curve_slope(curve, trk_curve_x(curve)[j + 1]);
        c[2] = (3 * m - 2 * d - d1) / h;
        c[3] = (d + d1 - 2 * m) / (h * h);
    }
    return true;
}

static double evaluate(spline *s, double x, double *slope)
{
    x += s->offset;
    while (s->at > 0 && x < s->x[s->at - 1])
        s->at--;
    while (s->at < s->points && x >= s->x[s->at])
        s->at++;
    const double *c = s->c[s->at];
    double t = x - s->x[s->at > 0 ? s->at - 1 : 0];
    *slope = s->scale * (c[1] + t * (2 * c[2] + 3 * c[3] * t));
    return s->scale * (c[0] + t * (c[1] + t * (c[2] + t * c[3]))) - s->rest;
}

static bool add_element(plain_newton *f, const double *b, bool damper, const trk_curve *curve,
                        double scale, double offset)
{
    element *e = &f->element[f->elements++];
    double slope;
    e->damper = damper;
    memcpy(e->b, b, sizeof e->b);
    e->curve.scale = scale;
    e->curve.offset = offset;
    if (!extract(curve, &e->curve))
        return false;
    e->curve.rest = evaluate(&e->curve, 0, &slope); /* only the change of force acts */
    return true;
}

/* Linear part of a link into the matrices, its curves into elements. */
static bool add_link(plain_newton *f, const trk_model *model, int32_t link)
{
    const trk_link_law *law = &model->laws[link];
    double b[MAX] = {0}, g[MAX_ROADS] = {0};
    if (trk_model_get_link_row(model, link + 1, b, g) != TRK_OK)
        return false;
    for (int i = 0; i < f->n; i++) {
        for (int j = 0; j < f->n; j++) {
            f->k[i][j] += law->stiffness * b[i] * b[j];
            f->c[i][j] += law->damping * b[i] * b[j];
        }
        for (int j = 0; j < f->roads; j++) {
            f->ku[i][j] += law->stiffness * b[i] * g[j];
            f->cu[i][j] += law->damping * b[i] * g[j];
        }
    }
    for (int j = 0; j < f->roads; j++)
        if (g[j] != 0 && !trk_link_law_is_linear(law))
            return false;
    bool good = true;
    if (law->spring)
        good = add_element(f, b, false, law->spring, law->spring_scale, law->spring_offset);
    if (good && law->damper)
        good = add_element(f, b, true, law->damper, law->damper_scale, 0);
    return good;
}

void plain_newton_destroy(plain_newton *f)
{
    if (f)
        free(f->element);
    free(f);
}

/* Solve s x = r with the lower triangle of s, by Cholesky in place. */
static void cholesky_solve(int n, double s[MAX][MAX], double *x)
{
    for (int i = 0; i < n; i++) {
        for (int j = 0; j < i; j++) {
            double sum = s[i][j];
            for (int k = 0; k < j; k++)
                sum -= s[i][k] * s[j][k];
            s[i][j] = sum * s[j][j];
        }
        double sum = s[i][i];
        for (int k = 0; k < i; k++)
            sum -= s[i][k] * s[i][k];
        s[i][i] = 1 / sqrt(sum);
    }
    for (int i = 0; i < n; i++) {
        for (int k = 0; k < i; k++)
            x[i] -= s[i][k] * x[k];
        x[i] *= s[i][i];
    }
    for (int i = n; i-- > 0;) {
        for (int k = i + 1; k < n; k++)
            x[i] -= s[k][i] * x[k];
        x[i] *= s[i][i];
    }
}

/* a := M^-1 (road forces - element forces) at q = v = 0, also as its past. */
static void start(plain_newton *f, const double *height, const double *velocity)
{
    double s[MAX][MAX];
    memcpy(s, f->m, sizeof s);
    for (int i = 0; i < f->n; i++)
        for (int j = 0; j < f->roads; j++)
            f->a[i] += f->ku[i][j] * height[j] + f->cu[i][j] * velocity[j];
    for (int k = 0; k < f->elements; k++) {
        double slope, force = evaluate(&f->element[k].curve, 0, &slope);
        for (int i = 0; i < f->n; i++)
            f->a[i] -= force * f->element[k].b[i];
    }
    cholesky_solve(f->n, s, f->a);
    memcpy(f->past1, f->a, sizeof f->a);
    memcpy(f->past2, f->a, sizeof f->a);
}

plain_newton *plain_newton_create(const trk_model *model, const trk_newmark_options *options,
                                  const double *height, const double *velocity)
{
    double mass[MAX * MAX];
    trk_newmark_options defaults;
    trk_newmark_options_init(&defaults, sizeof defaults);
    if (!options)
        options = &defaults;
    if (model->n > MAX || model->names[TRK_PART_ROAD].count > MAX_ROADS)
        return NULL;
    plain_newton *f = calloc(1, sizeof *f);
    if (!f)
        return NULL;
    f->element = calloc(2 * (size_t)model->links.count, sizeof *f->element);
    f->n = model->n;
    f->roads = model->names[TRK_PART_ROAD].count;
    f->h = options->step;
    f->beta = options->beta;
    f->gamma = options->gamma;
    f->tolerance = options->tolerance;
    f->max_iterations = options->max_iterations;
    bool good = f->element;
    for (int32_t k = 0; good && k < model->links.count; k++)
        good = add_link(f, model, k);
    if (!good) {
        plain_newton_destroy(f);
        return NULL;
    }
    trk_model_get_mass(model, mass);
    for (int i = 0; i < f->n; i++)
        for (int j = 0; j < f->n; j++) {
            f->m[i][j] = mass[i * f->n + j];
            f->s0[i][j] = f->m[i][j] + f->h * (f->gamma * f->c[i][j] + f->beta * f->h * f->k[i][j]);
        }
    start(f, height, velocity);
    return f;
}

/* r = M a + C v + K q - load + element forces, and the tangent; returns the largest force. */
static double assemble(plain_newton *f, const double *q, const double *v, const double *a,
                       const double *load, double *r, double s[MAX][MAX])
{
    int n = f->n;
    double largest = 0;
    for (int i = 0; i < n; i++) {
        double force = -load[i];
        for (int j = 0; j < n; j++)
            force += f->c[i][j] * v[j] + f->k[i][j] * q[j];
        largest = fmax(largest, fabs(force));
        for (int j = 0; j < n; j++)
            force += f->m[i][j] * a[j];
        r[i] = force;
    }
    memcpy(s, f->s0, sizeof f->s0);
    for (int k = 0; k < f->elements; k++) {
        element *e = &f->element[k];
        const double *x = e->damper ? v : q;
        double at = 0, slope;
        for (int i = 0; i < n; i++)
            at += e->b[i] * x[i];
        double force = evaluate(&e->curve, at, &slope);
        slope *= e->damper ? f->gamma * f->h : f->beta * f->h * f->h;
        largest = fmax(largest, fabs(force));
        for (int i = 0; i < n; i++) {
            r[i] += force * e->b[i];
            for (int j = 0; j <= i; j++)
                s[i][j] += slope * e->b[i] * e->b[j];
        }
    }
    return largest;
}

bool plain_newton_step(plain_newton *f, const double *height, const double *velocity)
{
    int n = f->n;
    double h = f->h, load[MAX], q0[MAX], v0[MAX], q[MAX], v[MAX], a[MAX], r[MAX], s[MAX][MAX];
    for (int i = 0; i < n; i++) {
        load[i] = 0;
        for (int j = 0; j < f->roads; j++)
            load[i] += f->ku[i][j] * height[j] + f->cu[i][j] * velocity[j];
        q0[i] = f->q[i] + h * f->v[i] + h * h * (0.5 - f->beta) * f->a[i];
        v0[i] = f->v[i] + h * (1 - f->gamma) * f->a[i];
        a[i] = 3 * (f->a[i] - f->past1[i]) + f->past2[i];
    }
    for (int iteration = 0; iteration <= f->max_iterations; iteration++) {
        for (int i = 0; i < n; i++) {
            q[i] = q0[i] + f->beta * h * h * a[i];
            v[i] = v0[i] + f->gamma * h * a[i];
        }
        double force = assemble(f, q, v, a, load, r, s), residual = 0;
        for (int i = 0; i < n; i++)
            residual = fmax(residual, fabs(r[i]));
        if (residual <= f->tolerance * force + 1e-11) {
            memcpy(f->past2, f->past1, sizeof a);
            memcpy(f->past1, f->a, sizeof a);
            memcpy(f->a, a, sizeof a);
            memcpy(f->q, q, sizeof q);
            memcpy(f->v, v, sizeof v);
            f->iterations += iteration;
            return true;
        }
        cholesky_solve(n, s, r);
        for (int i = 0; i < n; i++)
            a[i] -= r[i];
    }
    return false;
}

const double *plain_newton_q(const plain_newton *f)
{
    return f->q;
}

long long plain_newton_iterations(const plain_newton *f)
{
    return f->iterations;
}
