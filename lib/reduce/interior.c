/* SPDX-License-Identifier: MIT */
/* Interior of a component with its interface held. */
#include "reduce/interior.h"

#include <string.h>

/* A row being restricted. */
typedef struct scratch {
    int32_t *column;
    double *value;
} scratch;

void trk_interior_clear(trk_interior *interior)
{
    trk_context *context = interior->component->context;
    if (interior->assembly.context)
        trk_assembly_clear(&interior->assembly);
    trk_rows_clear(context, &interior->links);
    trk_rows_clear(context, &interior->inertia);
    trk_free(context, interior->link);
    trk_free(context, interior->stiffness);
    trk_free(context, interior->mass);
    trk_free(context, interior->rest);
}

/* Append the interior columns of a row to `out`; *out_any false: it has none. */
static trk_status restrict_row(const trk_component *c, const trk_rows *rows, int32_t row,
                               const scratch *s, trk_rows *out, bool *out_any)
{
    int32_t count = 0;
    for (int64_t k = rows->start[row]; k < rows->start[row + 1]; k++) {
        int32_t place = c->place[rows->column[k]] - c->interface_count;
        if (place < 0)
            continue;
        s->column[count] = place;
        s->value[count++] = rows->value[k];
    }
    *out_any = count > 0;
    return count > 0 ? trk_rows_append(c->context, out, count, s->column, s->value) : TRK_OK;
}

static trk_status restrict_rows(trk_interior *in, const scratch *s)
{
    const trk_component *c = in->component;
    const trk_model *model = c->model;
    trk_status status = TRK_OK;
    bool any;
    for (int32_t k = 0; status == TRK_OK && k < model->links.count; k++) {
        status = restrict_row(c, &model->links, k, s, &in->links, &any);
        if (status == TRK_OK && any) {
            in->link[in->links.count - 1] = k;
            in->stiffness[in->links.count - 1] = c->stiffness[k];
        }
    }
    for (int32_t r = 0; status == TRK_OK && r < model->inertia.count; r++) {
        status = restrict_row(c, &model->inertia, r, s, &in->inertia, &any);
        if (status == TRK_OK && any)
            in->mass[in->inertia.count - 1] = model->mass[r];
    }
    return status;
}

/* Rows without an entry leave `start` of an empty list NULL. */
static trk_status begin(trk_context *context, trk_rows *rows)
{
    return trk_grow(context, (void **)&rows->start, &rows->row_capacity, 1, sizeof *rows->start);
}

static trk_status allocate(trk_interior *in, scratch *s)
{
    const trk_component *c = in->component;
    trk_context *context = c->context;
    in->link = trk_new(context, c->model->links.count, sizeof *in->link);
    in->stiffness = trk_new(context, c->model->links.count, sizeof(double));
    in->mass = trk_new(context, c->model->inertia.count, sizeof(double));
    in->rest = trk_new(context, in->n, sizeof(double));
    s->column = trk_new(context, in->n, sizeof *s->column);
    s->value = trk_new(context, in->n, sizeof *s->value);
    if (!in->link || !in->stiffness || !in->mass || !in->rest || !s->column || !s->value)
        return TRK_E_MEMORY;
    trk_status status = begin(context, &in->links);
    return status == TRK_OK ? begin(context, &in->inertia) : status;
}

static trk_status factorize(trk_interior *in)
{
    const trk_component *c = in->component;
    int32_t bad;
    trk_status status = trk_assembly_create(c->context, TRK_BACKEND_AUTO, in->n, &in->inertia,
                                            in->mass, &in->links, &in->assembly);
    if (status == TRK_OK)
        status = trk_assembly_factorize(&in->assembly, 0, in->stiffness, &bad);
    return status == TRK_E_SINGULAR
               ? trk_fail(c->context, status,
                          "%s: reduction: with its interface held, the component moves freely at "
                          "'%s'",
                          c->model->name, trk_component_name(c, c->interface_count + bad))
               : status;
}

trk_status trk_interior_create(const trk_component *component, trk_interior *out)
{
    *out =
        (trk_interior){.component = component, .n = component->count - component->interface_count};
    scratch s = {NULL, NULL};
    trk_status status = allocate(out, &s);
    if (status == TRK_OK)
        status = restrict_rows(out, &s);
    if (status == TRK_OK)
        status = factorize(out);
    trk_free(component->context, s.column);
    trk_free(component->context, s.value);
    return status;
}

/* Entry of a row of the model at a coordinate. */
static double entry(const trk_rows *rows, int32_t row, int32_t column)
{
    for (int64_t k = rows->start[row]; k < rows->start[row + 1]; k++)
        if (rows->column[k] == column)
            return rows->value[k];
    return 0;
}

trk_status trk_interior_follow(trk_interior *interior, int32_t interface, double *x)
{
    const trk_component *c = interior->component;
    memset(x, 0, (size_t)interior->n * sizeof *x);
    for (int pass = 0; pass < 2; pass++) {
        memset(interior->rest, 0, (size_t)interior->n * sizeof *interior->rest);
        for (int32_t k = 0; k < interior->links.count; k++) {
            double e = entry(&c->model->links, interior->link[k], c->coordinate[interface]) +
                       trk_rows_dot(&interior->links, k, x);
            if (e != 0)
                trk_rows_add(&interior->links, k, -interior->stiffness[k] * e, interior->rest);
        }
        trk_status status = trk_solver_solve(interior->assembly.solver, interior->rest);
        if (status != TRK_OK)
            return status;
        for (int32_t i = 0; i < interior->n; i++)
            x[i] += interior->rest[i];
    }
    return TRK_OK;
}

trk_status trk_interior_modes(const trk_interior *interior, int32_t count, double *lambda,
                              double *phi)
{
    const trk_vibration rows = {.name = interior->component->model->name,
                                .n = interior->n,
                                .inertia = &interior->inertia,
                                .mass = interior->mass,
                                .links = &interior->links,
                                .tangent = interior->stiffness};
    return trk_vibration_lowest(interior->component->context, &rows, count, lambda, phi);
}
