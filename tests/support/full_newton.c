/* SPDX-License-Identifier: MIT */
#include "full_newton.h"

#include "model/model.h"
#include "support.h"

struct full_newton {
    const trk_model *model;
    trk_newmark_options o;
    size_t n, links, roads, ports;
    double *mass, *b, *g, *p, *weight;            /* M, rows of B, G and P^T, w            */
    double *q, *v, *a, *r, *e, *rate, *force;     /* state; r(q, v, t) of (NEWMARK.1)      */
    double *q1, *v1, *a1, *r1, *residual, *trial; /* at the end of the step                */
    double *damping, *stiffness, *matrix;
    double *e_slope, *v_slope; /* tangents of the links where rest() was called last */
    double *memory, *memory1;  /* of the laws at the start and the end of the step   */
    double elapsed;            /* [s] since then, 0 at the start                     */
};

static double *zeros(size_t count)
{
    double *block = calloc(count + 1, sizeof *block);
    assert_non_null(block);
    return block;
}

static double dot(size_t n, const double *x, const double *y)
{
    double sum = 0;
    for (size_t i = 0; i < n; i++)
        sum += x[i] * y[i];
    return sum;
}

full_newton *full_newton_create(const trk_model *model, const trk_newmark_options *options)
{
    full_newton *f = calloc(1, sizeof *f);
    assert_non_null(f);
    f->model = model;
    f->o = *options;
    size_t n = f->n = (size_t)trk_model_count(model, TRK_PART_COORDINATE);
    size_t links = f->links = (size_t)trk_model_count(model, TRK_PART_LINK);
    size_t roads = f->roads = (size_t)trk_model_count(model, TRK_PART_ROAD);
    f->ports = (size_t)trk_model_count(model, TRK_PART_PORT);
    double **square[] = {&f->mass, &f->damping, &f->stiffness, &f->matrix};
    double **vector[] = {&f->weight, &f->q,  &f->v,  &f->a,        &f->r,    &f->q1,
                         &f->v1,     &f->a1, &f->r1, &f->residual, &f->trial};
    double **by_link[] = {&f->e, &f->rate, &f->force, &f->e_slope, &f->v_slope};
    for (size_t k = 0; k < sizeof square / sizeof *square; k++)
        *square[k] = zeros(n * n);
    for (size_t k = 0; k < sizeof vector / sizeof *vector; k++)
        *vector[k] = zeros(n);
    for (size_t k = 0; k < sizeof by_link / sizeof *by_link; k++)
        *by_link[k] = zeros(links);
    f->memory = zeros((size_t)model->memory[links]);
    f->memory1 = zeros((size_t)model->memory[links]);
    f->b = zeros(links * n);
    f->g = zeros(links * roads);
    f->p = zeros(f->ports * n);
    trk_model_get_mass(model, f->mass);
    trk_model_get_static(model, f->q, f->force);
    for (size_t k = 0; k < links; k++) {
        assert_int_equal(
            trk_model_get_link_row(model, (int32_t)k + 1, f->b + k * n, f->g + k * roads), TRK_OK);
        for (size_t i = 0; i < n; i++)
            f->weight[i] += f->force[k] * f->b[k * n + i]; /* equilibrium: w = B^T f */
    }
    for (size_t k = 0; k < f->ports; k++)
        assert_int_equal(trk_model_get_row(model, TRK_PART_PORT, (int32_t)k + 1, f->p + k * n),
                         TRK_OK);
    return f;
}

void full_newton_destroy(full_newton *f)
{
    double *blocks[] = {f->mass,    f->damping,  f->stiffness, f->matrix, f->weight, f->q,  f->v,
                        f->a,       f->r,        f->q1,        f->v1,     f->a1,     f->r1, f->e,
                        f->rate,    f->residual, f->trial,     f->force,  f->b,      f->g,  f->p,
                        f->e_slope, f->v_slope,  f->memory,    f->memory1};
    for (size_t k = 0; k < sizeof blocks / sizeof *blocks; k++)
        free(blocks[k]);
    free(f);
}

/* Forces and tangents of all links, and the memory of their laws at the end of the step. */
static void find_forces(full_newton *f)
{
    for (size_t k = 0; k < f->links; k++) {
        const trk_link_law *law = &f->model->laws[k];
        size_t first = (size_t)f->model->memory[k];
        trk_law_hint hint = {0, 0};
        trk_law_point point;
        if (f->elapsed == 0)
            trk_link_law_relax(law, f->e[k], f->memory + first);
        trk_link_law_advance(law, f->memory + first, f->e[k], f->rate[k], f->elapsed, &hint, &point,
                             f->memory1 + first);
        f->force[k] = law->stiffness * f->e[k] + law->damping * f->rate[k] + point.force;
        f->e_slope[k] = law->stiffness + point.stiffness;
        f->v_slope[k] = law->damping + point.damping;
    }
}

/* r = B^T f - P p - w; returns the largest force. */
static double rest(full_newton *f, const double *q, const double *v, const double *height,
                   const double *velocity, const double *load, double *r)
{
    size_t n = f->n;
    double largest = 0;
    for (size_t k = 0; k < f->links; k++) {
        f->e[k] = dot(n, f->b + k * n, q) - dot(f->roads, f->g + k * f->roads, height);
        f->rate[k] = dot(n, f->b + k * n, v) - dot(f->roads, f->g + k * f->roads, velocity);
    }
    find_forces(f);
    for (size_t i = 0; i < n; i++) {
        r[i] = -f->weight[i];
        for (size_t k = 0; k < f->links; k++)
            r[i] += f->force[k] * f->b[k * n + i];
        for (size_t k = 0; k < f->ports; k++)
            r[i] -= load[k] * f->p[k * n + i];
    }
    for (size_t k = 0; k < f->links; k++)
        largest = fmax(largest, fabs(f->force[k]));
    return largest;
}

/* x := matrix^-1 x by Gauss elimination with row pivoting; the matrix is destroyed. */
static void solve(size_t n, double *matrix, double *x)
{
    for (size_t k = 0; k < n; k++) {
        size_t best = k;
        for (size_t i = k; i < n; i++)
            if (fabs(matrix[i * n + k]) > fabs(matrix[best * n + k]))
                best = i;
        for (size_t j = 0; j < n; j++) {
            double kept = matrix[k * n + j];
            matrix[k * n + j] = matrix[best * n + j];
            matrix[best * n + j] = kept;
        }
        double kept = x[k];
        x[k] = x[best];
        x[best] = kept;
        for (size_t i = k + 1; i < n; i++) {
            double factor = matrix[i * n + k] / matrix[k * n + k];
            for (size_t j = k; j < n; j++)
                matrix[i * n + j] -= factor * matrix[k * n + j];
            x[i] -= factor * x[k];
        }
    }
    for (size_t i = n; i-- > 0;) {
        for (size_t j = i + 1; j < n; j++)
            x[i] -= matrix[i * n + j] * x[j];
        x[i] /= matrix[i * n + i];
    }
}

void full_newton_start(full_newton *f, const double *height, const double *velocity,
                       const double *load)
{
    trk_model_get_static(f->model, f->q, NULL);
    memset(f->v, 0, f->n * sizeof *f->v);
    f->elapsed = 0;
    rest(f, f->q, f->v, height, velocity, load, f->r);
    memcpy(f->matrix, f->mass, f->n * f->n * sizeof *f->matrix);
    for (size_t i = 0; i < f->n; i++)
        f->a[i] = -f->r[i];
    solve(f->n, f->matrix, f->a);
}

/* Left side of (NEWMARK.1) at the acceleration f->a1 into f->residual; its size over the forces,
 * or over 1 N if those are small beside the rounding of tables of some kN. */
static double imbalance(full_newton *f, const double *height, const double *velocity,
                        const double *load)
{
    const trk_newmark_options *o = &f->o;
    double h = o->step, size = 0;
    for (size_t i = 0; i < f->n; i++) {
        f->q1[i] = f->q[i] + h * f->v[i] + h * h * ((0.5 - o->beta) * f->a[i] + o->beta * f->a1[i]);
        f->v1[i] = f->v[i] + h * ((1 - o->gamma) * f->a[i] + o->gamma * f->a1[i]);
    }
    double largest = rest(f, f->q1, f->v1, height, velocity, load, f->r1);
    for (size_t i = 0; i < f->n; i++) {
        f->residual[i] = (1 - o->alpha_f) * f->r1[i] + o->alpha_f * f->r[i] +
                         (1 - o->alpha_m) * dot(f->n, f->mass + i * f->n, f->a1) +
                         o->alpha_m * dot(f->n, f->mass + i * f->n, f->a);
        size = fmax(size, fabs(f->residual[i]));
    }
    return size / fmax(largest, 1);
}

/* f->trial = -(whole tangent)^-1 residual. */
static void newton_direction(full_newton *f)
{
    const trk_newmark_options *o = &f->o;
    size_t n = f->n;
    for (size_t i = 0; i < n; i++)
        for (size_t j = 0; j < n; j++) {
            f->damping[i * n + j] = f->stiffness[i * n + j] = 0;
            for (size_t k = 0; k < f->links; k++) {
                double square = f->b[k * n + i] * f->b[k * n + j];
                f->damping[i * n + j] += f->v_slope[k] * square;
                f->stiffness[i * n + j] += f->e_slope[k] * square;
            }
        }
    for (size_t k = 0; k < f->n * f->n; k++)
        f->matrix[k] = (1 - o->alpha_m) * f->mass[k] +
                       (1 - o->alpha_f) * o->step *
                           (o->gamma * f->damping[k] + o->beta * o->step * f->stiffness[k]);
    for (size_t i = 0; i < f->n; i++)
        f->trial[i] = -f->residual[i];
    solve(f->n, f->matrix, f->trial);
}

void full_newton_step(full_newton *f, const double *height, const double *velocity,
                      const double *load)
{
    f->elapsed = f->o.step;
    memcpy(f->a1, f->a, f->n * sizeof *f->a1);
    double size = imbalance(f, height, velocity, load);
    for (int iteration = 0; iteration < 50 && size > 1e-15; iteration++) {
        newton_direction(f);
        double before = size;
        for (size_t i = 0; i < f->n; i++)
            f->a1[i] += f->trial[i];
        size = imbalance(f, height, velocity, load);
        for (int halving = 0; halving < 10 && size > before && before > 1e-12; halving++) {
            for (size_t i = 0; i < f->n; i++)
                f->a1[i] -= f->trial[i] /= 2;
            size = imbalance(f, height, velocity, load);
        }
        if (size > before / 2 && size < 1e-12)
            break;
    }
    assert_true(size < 1e-12);
    memcpy(f->memory, f->memory1, (size_t)f->model->memory[f->links] * sizeof *f->memory);
    memcpy(f->q, f->q1, f->n * sizeof *f->q);
    memcpy(f->v, f->v1, f->n * sizeof *f->v);
    memcpy(f->a, f->a1, f->n * sizeof *f->a);
    memcpy(f->r, f->r1, f->n * sizeof *f->r);
}

void full_newton_get(const full_newton *f, double *q, double *v, double *a, double *force)
{
    if (q)
        memcpy(q, f->q, f->n * sizeof *q);
    if (v)
        memcpy(v, f->v, f->n * sizeof *v);
    if (a)
        memcpy(a, f->a, f->n * sizeof *a);
    if (force)
        memcpy(force, f->force, f->links * sizeof *force);
}
