/* SPDX-License-Identifier: MIT */
/* The state of the modal steps, the pieces of its tables, and the choice of the kernel. */
#include "rungekutta/modal.h"

#include "base/processor.h"
#include "curve/curve.h"

#include <math.h>
#include <string.h>

/* out := A x, A n x n row-major. */
static void transform(int32_t n, const double *a, const double *x, double *out)
{
    for (int32_t i = 0; i < n; i++) {
        double sum = 0;
        for (int32_t j = 0; j < n; j++)
            sum += a[(int64_t)i * n + j] * x[j];
        out[i] = sum;
    }
}

void trk_explicit_set_state(trk_explicit *s, const trk_model *model, const double *q,
                            const double *v, const double *a, const double *height,
                            const double *velocity)
{
    const double *parts[] = {q, v, a};
    int64_t part = trk_explicit_part(s);
    for (int k = 0; k < 3; k++)
        transform(s->n, s->inverse, parts[k], s->row + k * part);
    for (int32_t k = 0; k < s->tables; k++) {
        const trk_explicit_table *t = &s->table[k];
        double x = trk_rows_dot(&model->links, t->link, t->of_rate ? v : q) -
                   trk_rows_dot(&model->roads, t->link, t->of_rate ? velocity : height);
        s->row[3 * part + k] = t->scale * trk_curve_value(t->curve, x + t->offset) - t->rest;
    }
}

void trk_explicit_get_part(const trk_explicit *s, int part, double *out)
{
    transform(s->n, s->phi, s->row + part * trk_explicit_part(s), out);
}

void trk_explicit_fetch_pieces(trk_explicit *s, const double *x, uint32_t left)
{
    const trk_explicit_pieces *p = &s->pieces;
    for (int32_t k = 0; left; k++, left >>= 1) {
        if (!(left & 1))
            continue;
        const trk_piece *piece = s->table[k].piece;
        while (x[k] < piece->lower)
            piece--;
        while (x[k] >= piece->upper && piece->upper < INFINITY)
            piece++;
        s->table[k].piece = piece;
        p->lower[k] = piece->lower;
        p->upper[k] = piece->upper;
        p->origin[k] = piece->origin;
        p->c0[k] = piece->c0;
        p->c1[k] = piece->c1;
        p->c2[k] = piece->c2;
        p->c3[k] = piece->c3;
    }
}

trk_explicit_kernel trk_explicit_choose_kernel(void)
{
#ifdef TRUCKRIDE_X86_KERNELS
    if (trk_processor() == TRK_PROCESSOR_AVX512)
        return trk_explicit_kernel_avx512;
    if (trk_processor() == TRK_PROCESSOR_AVX2)
        return trk_explicit_kernel_avx2;
#endif
    return trk_explicit_kernel_base;
}
