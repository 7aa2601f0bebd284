/* SPDX-License-Identifier: MIT */
/* Forming the constant matrices of the step in modal coordinates (NEWMARK.14 to .17). */
#include "newmark/modal.h"

#include "linalg/small.h"

#include <string.h>

static bool exists(const trk_model *model, const trk_newmark_options *options)
{
    bool plain = options->alpha_m == 0 && options->alpha_f == 0;
    for (int32_t k = 0; k < model->links.count; k++)
        plain = plain && model->laws[k].stiffness >= 0 && model->laws[k].damping >= 0;
    return plain;
}

/* All arrays of doubles, in one block; counting first (block NULL), then dealing out. */
static int64_t deal(trk_modal_form *f)
{
    int64_t n = f->n, p = f->tables, d = f->dampers, used = 0;
    struct {
        double **array;
        int64_t size;
    } arrays[] = {{&f->phi, n * n},
                  {&f->phi_inverse, n * n},
                  {&f->lambda, n},
                  {&f->inverse, n},
                  {&f->table_rows, p * n},
                  {&f->damper_rows, d * n},
                  {&f->reduced_rows, p * n},
                  {&f->damping, d * d},
                  {&f->coupling, p * p},
                  {&f->table_road, p * f->roads},
                  {&f->damper_road, d * f->roads},
                  {&f->reduced_road, p * f->roads},
                  {&f->height_force, f->roads * n},
                  {&f->port_force, f->ports * n},
                  {&f->weight, n}};
    for (size_t k = 0; k < sizeof arrays / sizeof *arrays; k++) {
        *arrays[k].array = f->block ? f->block + used : NULL;
        used += arrays[k].size;
    }
    return used;
}

static trk_status allocate(trk_modal_form *f, const trk_model *model)
{
    f->n = model->n;
    f->tables = model->nonlinear_count;
    for (int32_t k = 0; k < model->links.count; k++)
        f->dampers += model->laws[k].damping != 0;
    f->roads = model->names[TRK_PART_ROAD].count;
    f->ports = model->ports.count;
    f->block = trk_new(f->context, deal(f), sizeof *f->block);
    f->table = trk_new(f->context, f->tables, sizeof *f->table);
    f->damper_link = trk_new(f->context, f->dampers, sizeof *f->damper_link);
    if (!f->block || !f->table || !f->damper_link)
        return TRK_E_MEMORY;
    deal(f);
    return TRK_OK;
}

/* out += factor Phi^T row^T: a row of the model seen by the modes. */
static void add_row(const trk_modal_form *f, const trk_rows *rows, int32_t row, double factor,
                    double *out)
{
    for (int64_t k = rows->start[row]; k < rows->start[row + 1]; k++)
        for (int32_t i = 0; i < f->n; i++)
            out[i] += factor * rows->value[k] * f->phi[rows->column[k] * f->n + i];
}

static void list_links(trk_modal_form *f, const trk_model *model)
{
    int32_t d = 0;
    for (int32_t j = 0; j < f->tables; j++) {
        int32_t link = model->nonlinear[j];
        f->table[j] = (trk_modal_table){link, &model->laws[link]};
        add_row(f, &model->links, link, 1, f->table_rows + j * f->n);
        trk_rows_expand(&model->roads, link, f->roads, f->table_road + j * f->roads);
    }
    for (int32_t link = 0; link < model->links.count; link++) {
        if (model->laws[link].damping == 0)
            continue;
        f->damper_link[d] = link;
        add_row(f, &model->links, link, 1, f->damper_rows + d * f->n);
        trk_rows_expand(&model->roads, link, f->roads, f->damper_road + d * f->roads);
        d++;
    }
}

/* Phi^T B^T k G, Phi^T P, Phi^T w */
static void list_drives(trk_modal_form *f, const trk_model *model)
{
    const trk_rows *roads = &model->roads;
    for (int32_t link = 0; link < model->links.count; link++)
        for (int64_t k = roads->start[link]; k < roads->start[link + 1]; k++)
            add_row(f, &model->links, link, model->laws[link].stiffness * roads->value[k],
                    f->height_force + roads->column[k] * f->n);
    for (int32_t k = 0; k < f->ports; k++)
        add_row(f, &model->ports, k, 1, f->port_force + k * f->n);
    for (int32_t j = 0; j < f->n; j++)
        for (int32_t i = 0; i < f->n; i++)
            f->weight[i] += f->phi[j * f->n + i] * model->weight[j];
}

/* x s^-1 y^T */
static double through_modes(const trk_modal_form *f, const double *x, const double *y)
{
    double sum = 0;
    for (int32_t i = 0; i < f->n; i++)
        sum += x[i] * f->inverse[i] * y[i];
    return sum;
}

/*
 * A = (I + kappa c E)^-1 c with E = W_d s^-1 W_d^T: the forces of the damped links when each
 * sees what the others do. A column at a time; work has room for d^2 + d numbers.
 */
static bool eliminate_dampers(trk_modal_form *f, const trk_model *model, double *work)
{
    int32_t d = f->dampers;
    double *matrix = work, *column = work + d * d;
    for (int32_t k = 0; k < d; k++) {
        for (int32_t i = 0; i < d; i++) {
            double c = model->laws[f->damper_link[i]].damping;
            column[i] = i == k ? c : 0;
            for (int32_t j = 0; j < d; j++)
                matrix[i * d + j] = (i == j) + f->kappa * c *
                                                   through_modes(f, f->damper_rows + i * f->n,
                                                                 f->damper_rows + j * f->n);
        }
        if (!trk_small_solve(d, matrix, column))
            return false;
        for (int32_t i = 0; i < d; i++)
            f->damping[i * d + k] = column[i];
    }
    return true;
}

/* W' = W_p - H W_d, G' = G_p - H G_d with H = kappa W_p s^-1 W_d^T A; D = W' s^-1 W_p^T. */
static void reduce_rows(trk_modal_form *f)
{
    int32_t n = f->n, d = f->dampers;
    memcpy(f->reduced_rows, f->table_rows, (size_t)(f->tables * n) * sizeof(double));
    memcpy(f->reduced_road, f->table_road, (size_t)(f->tables * f->roads) * sizeof(double));
    for (int32_t j = 0; j < f->tables; j++) {
        double *row = f->reduced_rows + j * n;
        for (int32_t k = 0; k < d; k++) {
            double e = f->kappa * through_modes(f, f->table_rows + j * n, f->damper_rows + k * n);
            for (int32_t l = 0; l < d; l++) {
                double h = e * f->damping[k * d + l];
                for (int32_t i = 0; i < n; i++)
                    row[i] -= h * f->damper_rows[l * n + i];
                for (int32_t i = 0; i < f->roads; i++)
                    f->reduced_road[j * f->roads + i] -= h * f->damper_road[l * f->roads + i];
            }
        }
        for (int32_t k = 0; k < f->tables; k++)
            f->coupling[j * f->tables + k] = through_modes(f, row, f->table_rows + k * n);
    }
}

static trk_status fill(trk_modal_form *f, const trk_model *model,
                       const trk_newmark_options *options)
{
    trk_status status = allocate(f, model);
    if (status == TRK_OK)
        status = trk_modal_basis(f->context, model, f->phi, f->phi_inverse, f->lambda);
    if (status != TRK_OK)
        return status;
    f->h = options->step;
    f->beta = options->beta;
    f->gamma = options->gamma;
    f->kappa = options->gamma * options->step;
    f->r = options->beta * options->step / options->gamma;
    for (int32_t i = 0; i < f->n; i++)
        f->inverse[i] = 1 / (1 + f->beta * f->h * f->h * f->lambda[i]);
    list_links(f, model);
    list_drives(f, model);
    double *work = trk_new(f->context, (int64_t)f->dampers * (f->dampers + 1), sizeof *work);
    if (!work)
        return TRK_E_MEMORY;
    bool solved = eliminate_dampers(f, model, work);
    trk_free(f->context, work);
    reduce_rows(f);
    return solved ? TRK_OK : TRK_E_SINGULAR;
}

trk_status trk_modal_form_create(trk_context *context, const trk_model *model,
                                 const trk_newmark_options *options, trk_modal_form **out)
{
    *out = NULL;
    if (!exists(model, options))
        return TRK_OK;
    trk_modal_form *form = trk_new(context, 1, sizeof *form);
    if (!form)
        return TRK_E_MEMORY;
    form->context = context;
    trk_status status = fill(form, model, options);
    if (status == TRK_OK)
        *out = form;
    else
        trk_modal_form_destroy(form);
    return status == TRK_E_SINGULAR ? TRK_OK : status; /* the general path will say why */
}

void trk_modal_form_destroy(trk_modal_form *form)
{
    if (!form)
        return;
    trk_free(form->context, form->block);
    trk_free(form->context, form->table);
    trk_free(form->context, form->damper_link);
    trk_free(form->context, form);
}
