/* SPDX-License-Identifier: MIT */
/* The modal form, laid out in columns for registers of a width. */
#include "newmark/newmark.h"

#include "curve/curve.h"

#include <float.h>
#include <math.h>
#include <string.h>

#define PAIR(modes, rows) {modes, rows},

void trk_fast_choose_size(int32_t width, int32_t modes, int32_t rows, int32_t *out_mode_blocks,
                          int32_t *out_row_blocks)
{
    static const int32_t two[][2] = {TRK_FAST_SIZES_2(PAIR)}, four[][2] = {TRK_FAST_SIZES_4(PAIR)},
                         eight[][2] = {TRK_FAST_SIZES_8(PAIR)};
    const int32_t(*size)[2] = width == 2 ? two : width == 4 ? four : eight;
    while ((*size)[0] * width < modes || (*size)[1] * width < rows)
        size++; /* the last one holds TRK_FAST_MODES and TRK_FAST_ROWS */
    *out_mode_blocks = (*size)[0];
    *out_row_blocks = (*size)[1];
}

/* Velocities: W', W_p, D, Z, with one row for all links that share it. */
static void pack_rows(trk_fast *s, int32_t modes, int32_t rows)
{
    const trk_modal_form *f = s->form;
    for (int32_t row = 0; row < s->rows; row++) {
        int32_t j = s->first[row];
        for (int32_t i = 0; i < f->n; i++) {
            s->to_rows[i * rows + row] = f->reduced_rows[j * f->n + i];
            s->elongation[i * rows + row] = f->table_rows[j * f->n + i];
            s->influence[row * modes + i] =
                f->kappa * f->inverse[i] * f->reduced_rows[j * f->n + i];
        }
        for (int32_t k = 0; k < s->rows; k++)
            s->coupling[k * rows + row] = f->kappa * f->coupling[j * f->tables + s->first[k]];
        s->diagonal[row] = s->coupling[row * rows + row];
        for (int32_t k = 0; k < f->roads; k++) {
            s->road_rows[k * rows + row] = f->table_road[j * f->roads + k];
            s->on_rows |= f->table_road[j * f->roads + k] != 0;
        }
    }
}

/* T = I - kappa s^-1 W_d^T A W_d */
static void pack_modes(trk_fast *s, int32_t modes)
{
    const trk_modal_form *f = s->form;
    for (int32_t i = 0; i < f->n; i++) {
        double scale = f->kappa * f->inverse[i];
        s->to_modes[i * modes + i] = 1;
        for (int32_t j = 0; j < f->n; j++)
            s->to_physical[i * modes + j] = f->phi[j * f->n + i];
        for (int32_t k = 0; k < f->dampers; k++)
            for (int32_t l = 0; l < f->dampers; l++)
                for (int32_t j = 0; j < f->n; j++)
                    s->to_modes[j * modes + i] -= scale * f->damper_rows[k * f->n + i] *
                                                  f->damping[k * f->dampers + l] *
                                                  f->damper_rows[l * f->n + j];
        s->weight[i] = scale * f->weight[i];
        s->restoring[i] = scale * f->lambda[i];
        for (int32_t k = 0; k < f->roads; k++)
            s->height_drive[k * modes + i] = scale * f->height_force[k * f->n + i];
        for (int32_t k = 0; k < f->ports; k++)
            s->load_drive[k * modes + i] = scale * f->port_force[k * f->n + i];
    }
}

/*
 * What the velocity of a road does through linear dampers, kappa s^-1 W_d^T c G_d. As a rule that
 * is a multiple of what its height does, as both act through one tire.
 */
static void pack_velocity_drive(trk_fast *s, const trk_model *model, int32_t modes)
{
    const trk_modal_form *f = s->form;
    for (int32_t road = 0; road < f->roads; road++) {
        double *height = s->height_drive + road * modes,
               *velocity = s->velocity_drive + road * modes;
        double along = 0, square = 0, largest = 0, off = 0;
        for (int32_t k = 0; k < f->dampers; k++)
            for (int32_t i = 0; i < f->n; i++)
                velocity[i] += f->kappa * f->inverse[i] * f->damper_rows[k * f->n + i] *
                               model->laws[f->damper_link[k]].damping *
                               f->damper_road[k * f->roads + road];
        for (int32_t i = 0; i < f->n; i++) {
            along += height[i] * velocity[i];
            square += height[i] * height[i];
            largest = fmax(largest, fabs(velocity[i]));
        }
        s->ratio[road] = square > 0 ? along / square : 0;
        for (int32_t i = 0; i < f->n; i++)
            off = fmax(off, fabs(velocity[i] - s->ratio[road] * height[i]));
        if (off <= 16 * DBL_EPSILON * largest) {
            memset(velocity, 0, (size_t)modes * sizeof *velocity);
        } else {
            s->ratio[road] = 0;
            s->on_velocity = true;
        }
    }
}

/* Largest second derivative of a curve; infinite if it has corners. */
static double largest_curvature(const trk_curve *curve)
{
    double largest = 0,
           corner = 1e-10 * fmax(fabs(curve->slope_minimum), fabs(curve->slope_maximum));
    double slope = curve->pieces[0].c1;
    for (int32_t k = 1; k <= curve->count; k++) {
        const trk_piece *p = &curve->pieces[k];
        bool last = k == curve->count;
        double t0 = last ? 0 : p->lower - p->origin, t1 = last ? 0 : p->upper - p->origin;
        if (fabs(p->c1 + t0 * (2 * p->c2 + 3 * p->c3 * t0) - slope) > corner)
            return INFINITY;
        slope = p->c1 + t1 * (2 * p->c2 + 3 * p->c3 * t1);
        largest =
            fmax(largest, fmax(fabs(2 * p->c2 + 6 * p->c3 * t0), fabs(2 * p->c2 + 6 * p->c3 * t1)));
    }
    return largest;
}

/* C, b of (NEWMARK.19), and the bound of (NEWMARK.20). */
static void pack_bounds(trk_fast *s, int32_t rows)
{
    s->whole_row = 0;
    for (int32_t row = 0; row < s->rows; row++) {
        double slope = 0;
        s->curvature[row] = s->reach[row] = 0;
        for (int32_t l = 0; l < s->layers; l++) {
            const struct trk_fast_table *t = &s->layer[l].table[row];
            if (!t->curve)
                continue;
            double along = l < s->springs ? s->r : 1;
            slope += along * fabs(t->scale) *
                     fmax(fabs(t->curve->slope_minimum), fabs(t->curve->slope_maximum));
            s->curvature[row] += along * along * fabs(t->scale) * largest_curvature(t->curve);
        }
        for (int32_t k = 0; k < s->rows; k++)
            s->reach[row] += k == row ? 0 : fabs(s->coupling[k * rows + row]);
        s->whole_row = fmax(s->whole_row, slope * (s->reach[row] + fabs(s->diagonal[row])));
    }
}

/* Lanes without a table hold one of zeros that is never left; the others fetch theirs. */
static void clear_pieces(trk_fast *s)
{
    for (int32_t l = 0; l < s->layers; l++) {
        trk_fast_layer *p = &s->layer[l];
        double *arrays[] = {p->origin, p->c0, p->c1, p->c2, p->c3};
        for (int32_t row = 0; row < s->row_lanes; row++) {
            bool empty = !p->table[row].curve;
            p->lower[row] = empty ? -INFINITY : INFINITY;
            p->upper[row] = INFINITY;
            for (size_t k = 0; k < sizeof arrays / sizeof *arrays; k++)
                arrays[k][row] = 0;
        }
    }
}

void trk_fast_pack(trk_fast *fast, const trk_newmark *stepper, int32_t width)
{
    trk_fast_choose_size(width, fast->modes, fast->rows, &fast->mode_blocks, &fast->row_blocks);
    int32_t modes = fast->mode_blocks * width, rows = fast->row_blocks * width;
    memset(fast->block, 0, (size_t)fast->size * sizeof *fast->block);
    pack_rows(fast, modes, rows);
    pack_modes(fast, modes);
    pack_velocity_drive(fast, stepper->model, modes);
    pack_bounds(fast, rows);
    fast->mode_stride = modes;
    fast->row_stride = rows;
    clear_pieces(fast);
}
