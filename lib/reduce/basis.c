/* SPDX-License-Identifier: MIT */
/* Craig-Bampton basis: static following and modes of fixed interface (REDUCE.1, REDUCE.3). */
#include "reduce/basis.h"

#include "reduce/free_modes.h"
#include "reduce/interior.h"

#include <math.h>
#include <string.h>

/* A deflection under a load that the modes have up to this part is rounding. */
static const double least_rest = 1e-11;

void trk_basis_clear(trk_basis *basis)
{
    trk_free(basis->context, basis->t);
    trk_free(basis->context, basis->stiffness);
    trk_free(basis->context, basis->mass);
    memset(basis, 0, sizeof *basis);
}

void trk_basis_project(const trk_basis *basis, const trk_component *component, const trk_rows *rows,
                       int32_t row, double *w)
{
    memset(w, 0, (size_t)basis->count * sizeof *w);
    for (int64_t k = rows->start[row]; k < rows->start[row + 1]; k++) {
        int32_t place = component->place[rows->column[k]];
        const double *t = basis->t + (int64_t)place * basis->count;
        for (int32_t j = 0; place >= 0 && j < basis->count; j++)
            w[j] += rows->value[k] * t[j];
    }
}

/* Column j of T is x on the interior. */
static void set_column(trk_basis *basis, const trk_component *c, int32_t j, const double *x)
{
    for (int32_t i = c->interface_count; i < c->count; i++)
        basis->t[(int64_t)i * basis->count + j] = x[i - c->interface_count];
}

static trk_status add_interface(trk_basis *basis, const trk_component *c, trk_interior *in,
                                double *x)
{
    trk_status status = TRK_OK;
    for (int32_t j = 0; status == TRK_OK && j < c->interface_count; j++) {
        basis->t[(int64_t)j * basis->count + j] = 1;
        status = trk_interior_follow(in, j, x);
        set_column(basis, c, j, x);
    }
    return status;
}

/* Sum of m (a x) (a y) over the inertia of the interior. */
static double mass_product(const trk_interior *in, const double *x, const double *y)
{
    double sum = 0;
    for (int32_t r = 0; r < in->inertia.count; r++)
        sum += in->mass[r] * trk_rows_dot(&in->inertia, r, x) * trk_rows_dot(&in->inertia, r, y);
    return sum;
}

/* The motions of the interior that are kept: modes, then rests (REDUCE.3); rows of phi. */
typedef struct motions {
    int32_t modes, count;
    double *phi; /* count x interior; room for all modes, the weight and all ports */
} motions;

/*
 * x, a force on the interior, becomes the deflection under it less what motions have of it; it
 * is one more of them unless that is rounding.
 */
static trk_status add_rest(const trk_interior *in, motions *m, double *x)
{
    trk_status status = trk_solver_solve(in->assembly.solver, x);
    double whole = status == TRK_OK ? mass_product(in, x, x) : 0;
    if (whole == 0)
        return status;
    for (int pass = 0; pass < 2; pass++)
        for (int32_t k = 0; k < m->count; k++) {
            const double *phi = m->phi + (int64_t)k * in->n;
            double share = mass_product(in, x, phi);
            for (int32_t i = 0; i < in->n; i++)
                x[i] -= share * phi[i];
        }
    double rest = mass_product(in, x, x);
    if (rest <= least_rest * least_rest * whole || m->count == in->n)
        return TRK_OK;
    for (int32_t i = 0; i < in->n; i++)
        x[i] /= sqrt(rest);
    m->count++;
    return TRK_OK;
}

/* Rests of the weight and of the ports, written behind the motions that are there. */
static trk_status add_rests(const trk_interior *in, motions *m)
{
    const trk_component *c = in->component;
    const trk_model *model = c->model;
    trk_status status = TRK_OK;
    for (int32_t load = -1; status == TRK_OK && load < model->ports.count; load++) {
        double *x = m->phi + (int64_t)m->count * in->n;
        memset(x, 0, (size_t)in->n * sizeof *x);
        for (int32_t i = 0; load < 0 && i < in->n; i++)
            x[i] = model->weight[c->coordinate[c->interface_count + i]];
        for (int64_t k = load < 0 ? 0 : model->ports.start[load];
             load >= 0 && k < model->ports.start[load + 1]; k++) {
            int32_t place = c->place[model->ports.column[k]] - c->interface_count;
            if (place >= 0)
                x[place] = model->ports.value[k];
        }
        status = add_rest(in, m, x);
    }
    return status;
}

static trk_status fill(trk_basis *basis, const trk_component *c, trk_interior *in, const motions *m)
{
    double *x = trk_new(c->context, in->n, sizeof *x);
    if (!x)
        return TRK_E_MEMORY;
    trk_status status = add_interface(basis, c, in, x);
    for (int32_t k = 0; k < m->count; k++)
        set_column(basis, c, c->interface_count + k, m->phi + (int64_t)k * in->n);
    trk_free(c->context, x);
    return status;
}

static trk_status allocate(trk_basis *basis, const trk_component *c)
{
    basis->t = trk_new(c->context, (int64_t)c->count * basis->count, sizeof(double));
    basis->stiffness = trk_new(c->context, basis->count, sizeof(double));
    basis->mass = trk_new(c->context, basis->count, sizeof(double));
    return basis->t && basis->stiffness && basis->mass ? TRK_OK : TRK_E_MEMORY;
}

static trk_status create(const trk_component *c, trk_interior *in,
                         const trk_reduce_options *options, trk_basis *basis)
{
    motions m = {.modes = options->modes < in->n ? options->modes : in->n};
    int64_t most = (int64_t)m.modes + 2 + c->model->ports.count;
    m.count = m.modes;
    m.phi = trk_new(c->context, most * in->n, sizeof *m.phi);
    double *lambda = trk_new(c->context, m.modes, sizeof *lambda);
    trk_status status = m.phi && lambda ? TRK_OK : TRK_E_MEMORY;
    if (status == TRK_OK && m.modes > 0)
        status = trk_interior_modes(in, m.modes, lambda, m.phi);
    if (status == TRK_OK)
        status = add_rests(in, &m);
    basis->kept = c->interface_count;
    basis->count = c->interface_count + m.count;
    if (status == TRK_OK)
        status = allocate(basis, c);
    if (status == TRK_OK)
        status = fill(basis, c, in, &m);
    trk_free(c->context, m.phi);
    trk_free(c->context, lambda);
    return status;
}

/*
 * Each mode moves its farthest translating coordinate by 1 (or, without one, its farthest
 * rotation), so that its coordinate is that displacement.
 */
static void scale_modes(trk_basis *basis, const trk_component *c)
{
    for (int32_t j = basis->kept; j < basis->count; j++) {
        double far[2] = {0, 0};
        for (int32_t i = 0; i < c->count; i++) {
            double x = basis->t[(int64_t)i * basis->count + j];
            double *most = &far[c->model->is_rotation[c->coordinate[i]]];
            if (fabs(x) > fabs(*most) * (1 + 1e-9))
                *most = x;
        }
        double size = fabs(far[0]) > 1e-6 * fabs(far[1]) ? far[0] : far[1];
        for (int32_t i = 0; i < c->count; i++)
            basis->t[(int64_t)i * basis->count + j] /= size;
    }
}

/* Stiffness and mass of the modes, from the rows of the component. */
static trk_status weigh_modes(trk_basis *basis, const trk_component *c)
{
    const trk_model *model = c->model;
    double *w = trk_new(c->context, basis->count, sizeof *w);
    if (!w)
        return TRK_E_MEMORY;
    for (int32_t k = 0; k < model->links.count; k++)
        if (trk_component_touches(c, &model->links, k)) {
            trk_basis_project(basis, c, &model->links, k, w);
            for (int32_t j = basis->kept; j < basis->count; j++)
                basis->stiffness[j] += c->stiffness[k] * w[j] * w[j];
        }
    for (int32_t r = 0; r < model->inertia.count; r++)
        if (trk_component_touches(c, &model->inertia, r)) {
            trk_basis_project(basis, c, &model->inertia, r, w);
            for (int32_t j = basis->kept; j < basis->count; j++)
                basis->mass[j] += model->mass[r] * w[j] * w[j];
        }
    trk_free(c->context, w);
    return TRK_OK;
}

trk_status trk_basis_create(const trk_component *component, const trk_reduce_options *options,
                            trk_basis *out)
{
    *out = (trk_basis){.context = component->context};
    trk_interior interior;
    trk_status status = trk_interior_create(component, &interior);
    if (status == TRK_OK)
        status = create(component, &interior, options, out);
    trk_interior_clear(&interior);
    if (status == TRK_OK && options->interface_modes > 0)
        status = trk_basis_use_free_modes(out, component, options->interface_modes);
    if (status != TRK_OK)
        return status;
    scale_modes(out, component);
    return weigh_modes(out, component);
}
