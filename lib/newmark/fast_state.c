/* SPDX-License-Identifier: MIT */
/* Between modal and physical state. */
#include "newmark/newmark.h"

#include "curve/curve.h"

#include <math.h>
#include <string.h>

void trk_fast_fetch(trk_fast_layer *layer, int32_t rows, const double *argument)
{
    for (int32_t k = 0; k < rows; k++) {
        if (argument[k] >= layer->lower[k] && argument[k] < layer->upper[k])
            continue;
        struct trk_fast_table *t = &layer->table[k];
        if (!t->curve) /* it is not a number: the step will be refused */
            continue;
        t->piece = trk_curve_locate(t->curve, argument[k] + t->offset, t->piece);
        const trk_piece *piece = &t->curve->pieces[t->piece];
        layer->lower[k] = piece->lower - t->offset;
        layer->upper[k] = piece->upper - t->offset;
        layer->origin[k] = piece->origin - t->offset;
        layer->c0[k] = t->scale * piece->c0 - t->rest;
        layer->c1[k] = t->scale * piece->c1;
        layer->c2[k] = t->scale * piece->c2;
        layer->c3[k] = t->scale * piece->c3;
    }
}

/* y := A x, A n x n row-major. */
static void transform(int32_t n, const double *a, const double *x, double *y)
{
    for (int32_t i = 0; i < n; i++) {
        y[i] = 0;
        for (int32_t k = 0; k < n; k++)
            y[i] += a[i * n + k] * x[k];
    }
}

/* v~, z and the rest of v_f of the step that follows v1 (kernel.h). */
static void prepare_next(trk_fast *s)
{
    for (int32_t i = 0; i < s->modes; i++) {
        s->v[i] = s->c1 * s->v1[i] + s->c2 * s->old_v[i];
        s->z[i] = s->old_z[i] + s->c3 * s->v1[i] + s->c4 * s->old_v[i];
        s->free[i] = s->v[i] - s->restoring[i] * (s->z[i] + s->r * s->v[i]);
    }
}

/* The rates of the rows enter the past; the forces set the limit of the next step. */
static void adopt_rows(trk_fast *s, const trk_newmark *stepper, bool steady)
{
    double force[TRK_FAST_ROWS] = {0}, largest = 0, *oldest = s->past[TRK_FAST_HISTORY - 1];
    for (int k = TRK_FAST_HISTORY - 1; k > 0; k--)
        s->past[k] = s->past[k - 1];
    s->past[0] = oldest;
    for (int32_t row = 0; row < s->rows; row++)
        s->past[0][row] =
            trk_newmark_rate(stepper, &stepper->now, stepper->model->nonlinear[s->first[row]]);
    for (int k = 1; steady && k < TRK_FAST_HISTORY; k++)
        memcpy(s->past[k], s->past[0], (size_t)s->rows * sizeof(double));
    for (int32_t j = 0; j < stepper->p; j++)
        force[s->lane[j]] += stepper->now.force[j];
    for (int32_t row = 0; row < s->rows; row++)
        largest = fmax(largest, fabs(force[row]));
    s->limit = fmax(s->tolerance * largest, s->floor);
}

void trk_fast_adopt(trk_fast *fast, const trk_newmark *stepper, bool steady)
{
    const trk_modal_form *f = fast->form;
    const trk_state *now = &stepper->now;
    transform(f->n, f->phi_inverse, now->v, fast->v1);
    transform(f->n, f->phi_inverse, now->a, fast->old_v);
    transform(f->n, f->phi_inverse, now->q, fast->old_z);
    for (int32_t i = 0; i < f->n; i++) {
        fast->old_v[i] = fast->v1[i] - f->kappa * fast->old_v[i];
        fast->old_z[i] -= f->r * fast->v1[i];
    }
    prepare_next(fast);
    adopt_rows(fast, stepper, steady);
    fast->is_ahead = false;
}

void trk_fast_get_motion(const trk_fast *fast, double *out_y, double *out_v, double *out_a)
{
    for (int32_t i = 0; i < fast->modes; i++) {
        out_y[i] = fast->old_z[i] + fast->r * fast->v1[i];
        out_v[i] = fast->v1[i];
        out_a[i] = (fast->v1[i] - fast->old_v[i]) * fast->inverse_kappa;
    }
}

typedef double pair __attribute__((vector_size(16)));

/* q, v, a := Phi times theirs, two coordinates at a time. */
void trk_fast_get_state(const trk_fast *fast, double *out_q, double *out_v, double *out_a)
{
    double y[TRK_FAST_MODES], v[TRK_FAST_MODES], a[TRK_FAST_MODES];
    pair sum[3][TRK_FAST_MODES / 2];
    const int32_t stride = fast->mode_stride / 2;
    const pair *column = (const pair *)fast->to_physical;
    trk_fast_get_motion(fast, y, v, a);
    for (int32_t i = 0; 2 * i < fast->modes; i++) {
        pair of[3] = {{0}};
        for (int32_t k = 0; k < fast->modes; k++) {
            of[0] += column[k * stride + i] * y[k];
            of[1] += column[k * stride + i] * v[k];
            of[2] += column[k * stride + i] * a[k];
        }
        for (int part = 0; part < 3; part++)
            sum[part][i] = of[part];
    }
    double *const out[] = {out_q, out_v, out_a};
    for (int part = 0; part < 3; part++)
        if (out[part])
            memcpy(out[part], sum[part], (size_t)fast->modes * sizeof(double));
}

void trk_fast_settle(const trk_newmark *stepper)
{
    trk_fast *s = stepper->fast;
    if (!s || !s->is_ahead)
        return;
    const trk_model *model = stepper->model;
    const trk_state *now = &stepper->now;
    trk_fast_get_state(s, now->q, now->v, now->a);
    for (int32_t j = 0; j < stepper->p; j++) {
        int32_t link = model->nonlinear[j];
        trk_law_point point;
        trk_link_law_evaluate(&model->laws[link], trk_newmark_elongation(stepper, now, link),
                              trk_newmark_rate(stepper, now, link), &stepper->hints[j], &point);
        now->force[j] = point.force;
    }
    s->is_ahead = false;
}
