/* SPDX-License-Identifier: MIT */
/* Values and slopes of the curves on all rows at once. */
#ifndef TRK_NEWMARK_KERNEL_TABLES_H
#define TRK_NEWMARK_KERNEL_TABLES_H

#include "newmark/kernel_products.h"

/* Value and slope of the tables of a layer; the pieces are fetched first if some x left its own. */
INLINE void evaluate_layer(trk_fast *s, trk_fast_layer *p, const lanes *x, lanes *value,
                           lanes *slope, const int pb)
{
    lane_mask left = (lane_mask){0};
    for (int b = 0; b < pb; b++)
        left |= (x[b] < get(p->lower, b)) | (x[b] >= get(p->upper, b));
    if (any(left)) {
        for (int b = 0; b < pb; b++)
            put(s->work_rows, b, x[b]);
        trk_fast_fetch(p, s->rows, s->work_rows);
    }
    for (int b = 0; b < pb; b++) {
        lanes t = x[b] - get(p->origin, b), c1 = get(p->c1, b), c2 = get(p->c2, b),
              c3 = get(p->c3, b);
        value[b] = get(p->c0, b) + t * (c1 + t * (c2 + t * c3));
        slope[b] = c1 + t * (2 * c2 + t * (3 * c3));
    }
}

/* G and dG/dx at x, e = e_rest + r x. */
INLINE void evaluate(trk_fast *s, const lanes *x, const lanes *e_rest, lanes *value, lanes *slope,
                     const int pb)
{
    lanes e[ROWS], v[ROWS], d[ROWS];
    if (s->layers == 1 && s->springs == 0) {
        evaluate_layer(s, s->layer, x, value, slope, pb);
        return;
    }
    for (int b = 0; b < pb; b++) {
        e[b] = e_rest[b] + s->r * x[b];
        value[b] = slope[b] = spread(0);
    }
    for (int32_t l = 0; l < s->layers; l++) {
        double scale = l < s->springs ? s->r : 1;
        evaluate_layer(s, &s->layer[l], l < s->springs ? e : x, v, d, pb);
        for (int b = 0; b < pb; b++) {
            lanes along = d[b] * scale;
            value[b] += v[b];
            slope[b] += along;
            put(s->layer_value, l * pb + b, v[b]);
            put(s->layer_slope, l * pb + b, along);
        }
    }
}

#endif
