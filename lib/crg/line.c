/* SPDX-License-Identifier: MIT */
/* From the numbers of the file to a surface: missing heights, reference line, banking (CRG.3). */
#include "crg/crg.h"

#include <math.h>

/* From the right to the left, then back; what is copied first gets the offset. */
static void fill_from_neighbours(double *row, int64_t count, double offset)
{
    for (int64_t k = 1; k < count; k++)
        if (isnan(row[k]) && !isnan(row[k - 1])) {
            const double height = row[k - 1] + offset;
            for (; k < count && isnan(row[k]); k++)
                row[k] = height;
        }
    int64_t first = 0;
    while (first < count && isnan(row[first]))
        first++;
    for (int64_t k = 0; k < first && first < count; k++)
        row[k] = row[first] + offset;
}

static void fill_missing(trk_crg *crg, trk_crg_missing missing, double offset)
{
    for (int64_t i = 0; i < crg->rows; i++) {
        double *row = crg->grid + i * crg->columns;
        if (missing == TRK_CRG_MISSING_NEIGHBOUR)
            fill_from_neighbours(row, crg->columns, offset);
        for (int64_t k = 0; missing == TRK_CRG_MISSING_ZERO && k < crg->columns; k++)
            row[k] = isnan(row[k]) ? offset : row[k];
    }
}

/* Slope that leads to a row; the first one leads nowhere. */
static double slope_to(const trk_crg_reader *r, int64_t row)
{
    return r->slope ? r->slope[row] : r->value[TRK_CRG_START_S] * r->value[TRK_CRG_SCALE_SLOPE];
}

/*
 * Sum of slopes from the start, CRG.3. With a given end also back from there, the two blended,
 * with the weights that the C library of ASAM uses: they matter only where the ends and the slopes
 * of the file contradict each other.
 */
static void integrate_line(const trk_crg_reader *r, double *z, int64_t rows)
{
    const double step = r->value[TRK_CRG_INCREMENT];
    z[0] = r->value[TRK_CRG_START_Z];
    if (!r->slope && r->value[TRK_CRG_START_S] == 0) {
        for (int64_t i = 1; i < rows; i++)
            z[i] = z[0];
        return;
    }
    if (!r->given[TRK_CRG_END_Z]) {
        for (int64_t i = 1; i < rows; i++)
            z[i] = z[i - 1] + slope_to(r, i) * step;
        return;
    }
    z[rows - 1] = r->value[TRK_CRG_END_Z];
    for (int64_t i = rows - 1; i > 1; i--)
        z[i - 1] = z[i] - slope_to(r, i) * step;
    for (int64_t i = 0; i + 2 < rows; i++) {
        const double weight = (double)i / (double)(rows - 1);
        z[i + 1] = (1 - weight) * (z[i] + slope_to(r, i + 1) * step) + weight * z[i + 1];
    }
}

static void scale(double *x, int64_t count, double factor)
{
    for (int64_t k = 0; x && k < count; k++)
        x[k] *= factor;
}

/* The file's number or the caller's choice, which count from different ends. */
static trk_status choose(const trk_crg_reader *r, trk_crg_key key, const char *name, int32_t choice,
                         int32_t most, int32_t otherwise, int32_t *out)
{
    const double mode = r->value[key];
    *out = choice ? choice : r->given[key] ? (int32_t)fmax(-1, fmin(mode, 99)) + 1 : otherwise;
    if (*out >= 1 && *out <= most)
        return TRK_OK;
    return trk_fail(r->context, TRK_E_SYNTAX, "%s: %s is %g, expected 0 to %d", r->text.name, name,
                    mode, (int)most - 1);
}

trk_status trk_crg_finish(trk_crg_reader *r, trk_crg_missing missing)
{
    trk_crg *crg = r->crg;
    trk_status status = choose(r, TRK_CRG_NAN_MODE, "GRID_NAN_MODE", missing,
                               TRK_CRG_MISSING_NEIGHBOUR, TRK_CRG_MISSING_NEIGHBOUR, &missing);
    if (status == TRK_OK)
        status = choose(r, TRK_CRG_BORDER_MODE_U, "BORDER_MODE_U", crg->border_u,
                        TRK_CRG_BORDER_REFLECT, TRK_CRG_BORDER_KEEP, &crg->border_u);
    if (status == TRK_OK)
        status = choose(r, TRK_CRG_BORDER_MODE_V, "BORDER_MODE_V", crg->border_v,
                        TRK_CRG_BORDER_REFLECT, TRK_CRG_BORDER_KEEP, &crg->border_v);
    if (status)
        return status;
    crg->u = r->value[TRK_CRG_START_U];
    crg->increment = r->value[TRK_CRG_INCREMENT];
    crg->offset_u = r->value[TRK_CRG_BORDER_OFFSET_U];
    crg->offset_v = r->value[TRK_CRG_BORDER_OFFSET_V];
    scale(crg->grid, crg->rows * crg->columns, r->value[TRK_CRG_SCALE_Z]);
    fill_missing(crg, missing, r->value[TRK_CRG_NAN_OFFSET]);
    scale(r->slope, crg->rows, r->value[TRK_CRG_SCALE_SLOPE]);
    crg->line = trk_new(r->context, crg->rows, sizeof *crg->line);
    if (!crg->line)
        return TRK_E_MEMORY;
    integrate_line(r, crg->line, crg->rows);
    if (!r->bank && r->value[TRK_CRG_START_B] != 0) {
        r->bank = trk_new(r->context, crg->rows, sizeof *r->bank);
        if (!r->bank)
            return TRK_E_MEMORY;
        for (int64_t i = 0; i < crg->rows; i++)
            r->bank[i] = r->value[TRK_CRG_START_B];
    }
    scale(r->bank, crg->rows, r->value[TRK_CRG_SCALE_BANKING]);
    crg->banking = r->bank;
    r->bank = NULL;
    return TRK_OK;
}
