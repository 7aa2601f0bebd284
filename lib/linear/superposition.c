/* SPDX-License-Identifier: MIT */
/* Superposition of damped modes, checked by its residual (LINEAR.7, LINEAR.8). */
#include "linear/superposition.h"

#include "linalg/complex.h"
#include "linalg/eigen.h"
#include "model/model.h"

#include <math.h>
#include <string.h>

/* Residual of a response over the size of what it is the difference of; a direct solution
 * leaves about n epsilon. */
static const double residual_limit = 1e-12;

void trk_superposition_clear(trk_superposition *s)
{
    trk_modes_destroy(s->modes);
    void *blocks[] = {
        s->tangent.mass, s->link_stiffness, s->link_damping, s->push,       s->push_rate, s->share,
        s->share_rate,   s->matrix,         s->probe,        s->probe_push, s->q};
    for (size_t k = 0; k < sizeof blocks / sizeof *blocks; k++)
        trk_free(s->context, blocks[k]);
    memset(s, 0, sizeof *s);
}

static trk_status allocate(trk_superposition *s)
{
    trk_context *context = s->context;
    int64_t n = s->n, inputs = s->inputs, links = s->model->links.count;
    s->link_stiffness = trk_new(context, links, sizeof(double));
    s->link_damping = trk_new(context, links, sizeof(double));
    s->push = trk_new(context, inputs * n, sizeof(double));
    s->push_rate = trk_new(context, inputs * n, sizeof(double));
    s->share = trk_new(context, 2 * n * inputs, sizeof(double complex));
    s->share_rate = trk_new(context, 2 * n * inputs, sizeof(double complex));
    s->matrix = trk_new(context, n * n, sizeof(double complex));
    s->probe = trk_new(context, n, sizeof(double complex));
    s->probe_push = trk_new(context, n, sizeof(double complex));
    s->q = trk_new(context, inputs * n, sizeof(double complex));
    return s->link_stiffness && s->link_damping && s->push && s->push_rate && s->share &&
                   s->share_rate && s->matrix && s->probe && s->probe_push && s->q
               ? TRK_OK
               : TRK_E_MEMORY;
}

/* Forces on the coordinates: B^T (k + i w c) G of each road, P of each port (LINEAR.3). */
static void find_pushes(trk_superposition *s)
{
    const trk_model *model = s->model;
    int32_t roads = model->names[TRK_PART_ROAD].count;
    for (int32_t k = 0; k < model->links.count; k++)
        for (int64_t j = model->roads.start[k]; j < model->roads.start[k + 1]; j++) {
            int64_t place = (int64_t)model->roads.column[j] * s->n;
            double g = model->roads.value[j];
            trk_rows_add(&model->links, k, g * s->link_stiffness[k], s->push + place);
            trk_rows_add(&model->links, k, g * s->link_damping[k], s->push_rate + place);
        }
    for (int32_t k = 0; k < model->ports.count; k++)
        trk_rows_add(&model->ports, k, 1, s->push + (int64_t)(roads + k) * s->n);
}

/* a = phi^T (2 lambda M + C) phi, not conjugated (LINEAR.7). */
static double complex find_norm(const trk_superposition *s, int32_t mode)
{
    const double *re = s->modes->re + (int64_t)mode * s->n,
                 *im = s->modes->im + (int64_t)mode * s->n;
    double complex lambda = trk_complex(s->modes->lambda_re[mode], s->modes->lambda_im[mode]),
                   a = 0;
    for (int32_t i = 0; i < s->n; i++)
        for (int32_t j = 0; j < s->n; j++) {
            int64_t at = (int64_t)i * s->n + j;
            a += trk_complex(re[i], im[i]) * trk_complex(re[j], im[j]) *
                 (2 * lambda * s->tangent.mass[at] + s->tangent.damping[at]);
        }
    return a;
}

/* phi^T push / a. false: an eigenvalue without a norm, two modes that have become one. */
static bool project(trk_superposition *s)
{
    for (int32_t k = 0; k < s->modes->count; k++) {
        double complex a = find_norm(s, k);
        if (!(cabs(a) > 0))
            return false;
        for (int32_t j = 0; j < s->inputs; j++) {
            double complex sum = 0, sum_rate = 0;
            for (int32_t i = 0; i < s->n; i++) {
                int64_t at = (int64_t)k * s->n + i, from = (int64_t)j * s->n + i;
                sum += trk_complex(s->modes->re[at], s->modes->im[at]) * s->push[from];
                sum_rate += trk_complex(s->modes->re[at], s->modes->im[at]) * s->push_rate[from];
            }
            s->share[(int64_t)k * s->inputs + j] = sum / a;
            s->share_rate[(int64_t)k * s->inputs + j] = sum_rate / a;
        }
    }
    return true;
}

trk_status trk_superposition_create(trk_context *context, const trk_model *model, const double *q,
                                    const double *v, trk_superposition *out)
{
    *out = (trk_superposition){
        .context = context,
        .model = model,
        .n = model->n,
        .inputs = model->names[TRK_PART_ROAD].count + model->ports.count,
    };
    trk_status status = trk_modes_create_damped(context, model, q, v, &out->modes);
    if (status == TRK_OK)
        status = trk_tangent_create(context, model, q, v, &out->tangent);
    if (status == TRK_OK)
        status = allocate(out);
    if (status != TRK_OK)
        return status;
    for (int32_t k = 0; k < model->links.count; k++)
        trk_model_link_tangent(model, k, q, v, &out->link_stiffness[k], &out->link_damping[k]);
    find_pushes(out);
    if (!project(out)) {
        trk_modes_destroy(out->modes);
        out->modes = NULL;
    }
    return TRK_OK;
}

/* Product without the treatment of infinities, which costs most of the time. */
static inline double complex times(double complex a, double complex b)
{
    return trk_complex(creal(a) * creal(b) - cimag(a) * cimag(b),
                       creal(a) * cimag(b) + cimag(a) * creal(b));
}

/*
 * One mode and its conjugate: phi z + conj(phi) z' = Re phi (z + z') + Im phi i (z - z'). A real
 * eigenvalue stands alone.
 */
static void add_mode(trk_superposition *s, int32_t mode, double omega)
{
    int32_t n = s->n;
    double sigma = s->modes->lambda_re[mode], nu = s->modes->lambda_im[mode];
    const double *re = s->modes->re + (int64_t)mode * n, *im = s->modes->im + (int64_t)mode * n;
    double complex gain = 1 / trk_complex(-sigma, omega - nu),
                   mirror = 1 / trk_complex(-sigma, omega + nu);
    for (int32_t j = 0; j < s->inputs; j++) {
        int64_t at = (int64_t)mode * s->inputs + j;
        double complex x = s->share[at], y = s->share_rate[at],
                       iy = trk_complex(-cimag(y), creal(y));
        double complex z = times(x + omega * iy, gain), other = 0;
        double complex *q = s->q + (int64_t)j * n;
        if (nu == 0) {
            for (int32_t i = 0; i < n; i++)
                q[i] += re[i] * z;
            continue;
        }
        iy = trk_complex(cimag(y), creal(y)); /* i conj(y) */
        other = times(conj(x) + omega * iy, mirror);
        double complex sum = z + other,
                       difference = trk_complex(cimag(other - z), creal(z - other));
        for (int32_t i = 0; i < n; i++)
            q[i] += trk_complex(re[i] * creal(sum) + im[i] * creal(difference),
                                re[i] * cimag(sum) + im[i] * cimag(difference));
    }
}

/* Weights of the inputs in the residual, of size 1 and no pattern a response could share. */
static double complex weight(int32_t input)
{
    return trk_complex(cos(1 + 2.4 * input), sin(1 + 2.4 * input));
}

/*
 * The residual of one combination of all inputs over the size of its terms (LINEAR.8), the
 * equations divided by the root of their mass, which gives them one unit.
 */
static bool is_accurate(trk_superposition *s, double omega)
{
    int32_t n = s->n;
    memset(s->probe, 0, (size_t)n * sizeof *s->probe);
    memset(s->probe_push, 0, (size_t)n * sizeof *s->probe_push);
    for (int32_t j = 0; j < s->inputs; j++)
        for (int32_t i = 0; i < n; i++) {
            int64_t at = (int64_t)j * n + i;
            s->probe[i] += times(weight(j), s->q[at]);
            s->probe_push[i] +=
                times(weight(j), trk_complex(s->push[at], omega * s->push_rate[at]));
        }
    double largest_rest = 0, largest = 0;
    for (int32_t i = 0; i < n; i++) {
        double complex rest = s->probe_push[i];
        double unit = 1 / sqrt(s->tangent.mass[(int64_t)i * n + i]), size = cabs(rest);
        for (int32_t j = 0; j < n; j++) {
            int64_t at = (int64_t)i * n + j;
            double inertia = omega * omega * s->tangent.mass[at],
                   damping = omega * s->tangent.damping[at];
            rest -= times(trk_complex(s->tangent.stiffness[at] - inertia, damping), s->probe[j]);
            size += (fabs(s->tangent.stiffness[at]) + fabs(inertia) + fabs(damping)) *
                    (fabs(creal(s->probe[j])) + fabs(cimag(s->probe[j])));
        }
        largest_rest = fmax(largest_rest, unit * cabs(rest));
        largest = fmax(largest, unit * size);
        if (isnan(cabs(rest)))
            return false;
    }
    return largest_rest <= residual_limit * largest;
}

trk_status trk_superposition_solve_directly(trk_superposition *s, double omega)
{
    int64_t n = s->n;
    for (int64_t k = 0; k < n * s->inputs; k++)
        s->q[k] = trk_complex(s->push[k], omega * s->push_rate[k]);
    for (int64_t k = 0; k < n * n; k++)
        s->matrix[k] = trk_complex(s->tangent.stiffness[k] - omega * omega * s->tangent.mass[k],
                                   omega * s->tangent.damping[k]);
    s->direct++;
    trk_status status =
        trk_complex_solve(s->context, s->n, s->inputs, (double *)s->matrix, (double *)s->q);
    return status == TRK_E_SINGULAR
               ? trk_fail(s->context, status, "%s: an undamped resonance lies at %.9g Hz",
                          trk_model_name(s->model), omega / 6.283185307179586476925286766559)
               : status;
}

trk_status trk_superposition_solve(trk_superposition *s, double omega)
{
    if (s->inputs == 0)
        return TRK_OK;
    if (s->modes) {
        memset(s->q, 0, (size_t)s->n * (size_t)s->inputs * sizeof *s->q);
        for (int32_t k = 0; k < s->modes->count; k++)
            add_mode(s, k, omega);
        if (is_accurate(s, omega))
            return TRK_OK;
    }
    return trk_superposition_solve_directly(s, omega);
}
