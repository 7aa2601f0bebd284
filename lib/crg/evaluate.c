/* SPDX-License-Identifier: MIT */
/* Heights of a surface (CRG.1), its borders as in the C library of ASAM (CRG.4). */
#include "crg/crg.h"

#include <math.h>

static const double border_tolerance = 1e-8; /* [m] so far beyond the grid is still its border */

/* A place along one axis, moved into the grid where the border mode says so. */
typedef struct place {
    double x;
    bool outside, none, zero;
} place;

static place find_place(double x, double first, double last, trk_crg_border border)
{
    place p = {fmin(fmax(x, first), last), false, false, false};
    const double beyond = x < first ? first - x : x - last, length = last - first;
    if (!(beyond > border_tolerance))
        return p;
    p.outside = border <= TRK_CRG_BORDER_KEEP;
    p.none = border == TRK_CRG_BORDER_NONE || !isfinite(x);
    p.zero = border == TRK_CRG_BORDER_ZERO;
    if (!isfinite(x) || border < TRK_CRG_BORDER_REPEAT)
        return p;
    double turn = fmod(x - first, border == TRK_CRG_BORDER_REPEAT ? length : 2 * length);
    if (turn < 0)
        turn += border == TRK_CRG_BORDER_REPEAT ? length : 2 * length;
    p.x = first + (turn > length ? 2 * length - turn : turn);
    return p;
}

/* Interval of v and the fraction in it. */
static int64_t find_column(const trk_crg *crg, double v, double *out_fraction)
{
    int64_t low = 0, high = crg->columns - 1;
    if (crg->even) {
        const double step = (crg->v[high] - crg->v[0]) / (double)high;
        low = (int64_t)((v - crg->v[0]) / step);
        low = low > high - 1 ? high - 1 : low;
    }
    while (!crg->even && high - low > 1) {
        const int64_t middle = low + (high - low) / 2;
        if (v < crg->v[middle])
            high = middle;
        else
            low = middle;
    }
    *out_fraction = fmin(1, (v - crg->v[low]) / (crg->v[low + 1] - crg->v[low]));
    return low;
}

/* A missing height beside a place that it has no part in does no harm. */
static double mix(double a, double b, double fraction)
{
    return fraction == 0 ? a : fraction == 1 ? b : a + fraction * (b - a);
}

/* CRG.1 between two rows. v: place in the grid. */
static double interpolate(const trk_crg *crg, int64_t row, double fraction, const place *v)
{
    double z = 0, across;
    if (!v->zero) {
        const double *g = crg->grid + row * crg->columns + find_column(crg, v->x, &across);
        const double *h = g + crg->columns;
        z = mix(mix(g[0], h[0], fraction), mix(g[1], h[1], fraction), across);
    }
    z += mix(crg->line[row], crg->line[row + 1], fraction);
    if (crg->banking)
        z += v->x * mix(crg->banking[row], crg->banking[row + 1], fraction);
    return z;
}

double trk_crg_height(const trk_crg *crg, double u, double v)
{
    if (!crg || isnan(u) || isnan(v))
        return NAN;
    const double end = crg->u + (double)(crg->rows - 1) * crg->increment;
    const place along = find_place(u, crg->u, end, crg->border_u);
    place across = find_place(v, crg->v[0], crg->v[crg->columns - 1], crg->border_v);
    if (along.none || across.none)
        return NAN;
    /* Both offsets once a border counts; u decides alone where both do. */
    double offset = along.outside ? crg->offset_u : 0;
    offset += across.outside ? crg->offset_v : 0;
    if (along.zero || (across.zero && !along.outside))
        return offset;
    const double rows = (along.x - crg->u) / crg->increment;
    int64_t row = (int64_t)rows;
    row = row > crg->rows - 2 ? crg->rows - 2 : row;
    return interpolate(crg, row, fmin(rows - (double)row, 1), &across) + offset;
}

double trk_crg_row_height(const trk_crg *crg, int64_t row, double v)
{
    const place across = find_place(v, crg->v[0], crg->v[crg->columns - 1], crg->border_v);
    const int64_t from = row < crg->rows - 1 ? row : row - 1;
    if (across.none || across.zero)
        return across.none ? NAN : crg->offset_v;
    return interpolate(crg, from, (double)(row - from), &across) +
           (across.outside ? crg->offset_v : 0);
}

int64_t trk_crg_rows(const trk_crg *crg)
{
    return crg ? crg->rows : 0;
}

int64_t trk_crg_columns(const trk_crg *crg)
{
    return crg ? crg->columns : 0;
}

trk_status trk_crg_extent(const trk_crg *crg, double *out_u, double *out_increment,
                          double *out_right, double *out_left)
{
    if (!crg)
        return TRK_E_ARGUMENT;
    double *const out[] = {out_u, out_increment, out_right, out_left};
    const double value[] = {crg->u, crg->increment, crg->v[0], crg->v[crg->columns - 1]};
    for (int k = 0; k < 4; k++)
        if (out[k])
            *out[k] = value[k];
    return TRK_OK;
}
