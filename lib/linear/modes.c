/* SPDX-License-Identifier: MIT */
/* A set of modes: memory, energy, labels, queries. */
#include "linear/modes.h"

#include "model/model.h"

#include <float.h>
#include <math.h>
#include <string.h>

static const double two_pi = 6.283185307179586476925286766559;

trk_status trk_modes_allocate(trk_context *context, int32_t n, int32_t capacity, trk_modes **out)
{
    trk_modes *modes = trk_new(context, 1, sizeof *modes);
    *out = modes;
    if (!modes)
        return TRK_E_MEMORY;
    modes->context = context;
    modes->n = n;
    modes->lambda_re = trk_new(context, capacity, sizeof(double));
    modes->lambda_im = trk_new(context, capacity, sizeof(double));
    modes->re = trk_new(context, (int64_t)capacity * n, sizeof(double));
    modes->im = trk_new(context, (int64_t)capacity * n, sizeof(double));
    modes->share = trk_new(context, (int64_t)capacity * n, sizeof(double));
    modes->dominant = trk_new(context, capacity, sizeof(int32_t));
    modes->label = trk_new(context, capacity, sizeof(char *));
    return modes->lambda_re && modes->lambda_im && modes->re && modes->im && modes->share &&
                   modes->dominant && modes->label
               ? TRK_OK
               : TRK_E_MEMORY;
}

void trk_modes_destroy(trk_modes *modes)
{
    if (!modes)
        return;
    trk_context *context = modes->context;
    for (int32_t k = 0; modes->label && k < modes->count; k++)
        trk_free(context, modes->label[k]);
    trk_free(context, modes->lambda_re);
    trk_free(context, modes->lambda_im);
    trk_free(context, modes->re);
    trk_free(context, modes->im);
    trk_free(context, modes->share);
    trk_free(context, modes->dominant);
    trk_free(context, modes->label);
    trk_free(context, modes);
}

void trk_modes_clear_rounding(int32_t n, double *omega_squared)
{
    double largest = 0;
    for (int32_t k = 0; k < n; k++)
        largest = fmax(largest, fabs(omega_squared[k]));
    for (int32_t k = 0; k < n; k++)
        if (fabs(omega_squared[k]) <= n * DBL_EPSILON * largest)
            omega_squared[k] = 0;
}

void trk_modes_take_roots(trk_modes *modes)
{
    for (int32_t k = 0; k < modes->count; k++)
        modes->lambda_im[k] = copysign(sqrt(fabs(modes->lambda_im[k])), modes->lambda_im[k]);
}

/* Energy shares of one mode (LINEAR.4), row by row of the inertia; returns phi^H M phi. */
static double find_energy(const trk_model *model, const double *re, const double *im, double *share)
{
    const trk_rows *rows = &model->inertia;
    memset(share, 0, (size_t)model->n * sizeof *share);
    for (int32_t r = 0; r < rows->count; r++) {
        double x = model->mass[r] * trk_rows_dot(rows, r, re),
               y = model->mass[r] * trk_rows_dot(rows, r, im);
        for (int64_t k = rows->start[r]; k < rows->start[r + 1]; k++)
            share[rows->column[k]] +=
                rows->value[k] * (re[rows->column[k]] * x + im[rows->column[k]] * y);
    }
    double total = 0;
    for (int32_t i = 0; i < model->n; i++)
        total += share[i];
    for (int32_t i = 0; i < model->n; i++)
        share[i] /= total;
    return total;
}

/* Most energy; of shares equal up to rounding the first counts, so that labels do not flip. */
static int32_t find_dominant(int32_t n, const double *share)
{
    int32_t best = 0;
    for (int32_t i = 1; i < n; i++)
        if (share[i] > share[best] * (1 + 1e-9))
            best = i;
    return best;
}

/* Multiply a shape by a complex number: unit M norm, the dominant component real and positive. */
static void normalise(int32_t n, double norm, int32_t dominant, double *re, double *im)
{
    double size = hypot(re[dominant], im[dominant]) * sqrt(norm);
    double c = re[dominant] / size, s = -im[dominant] / size;
    for (int32_t i = 0; i < n; i++) {
        double x = re[i];
        re[i] = c * x - s * im[i];
        im[i] = s * x + c * im[i];
    }
    im[dominant] = 0;
}

trk_status trk_modes_finish(trk_modes *modes, const trk_model *model)
{
    int32_t n = modes->n;
    for (int32_t k = 0; k < modes->count; k++) {
        double *re = modes->re + (int64_t)k * n, *im = modes->im + (int64_t)k * n;
        double *share = modes->share + (int64_t)k * n;
        double norm = find_energy(model, re, im, share);
        modes->dominant[k] = find_dominant(n, share);
        normalise(n, norm, modes->dominant[k], re, im);
    }
    for (int32_t k = 0; k < modes->count; k++) {
        modes->label[k] =
            trk_copy_text(modes->context,
                          trk_model_part_name(model, TRK_PART_COORDINATE, modes->dominant[k] + 1));
        if (!modes->label[k])
            return TRK_E_MEMORY;
    }
    return TRK_OK;
}

static bool has(const trk_modes *modes, int32_t mode)
{
    return modes && mode >= 1 && mode <= modes->count;
}

int32_t trk_modes_count(const trk_modes *modes)
{
    return modes ? modes->count : 0;
}

double trk_modes_frequency(const trk_modes *modes, int32_t mode)
{
    if (!has(modes, mode))
        return NAN;
    double re = modes->lambda_re[mode - 1], im = modes->lambda_im[mode - 1];
    /* im < 0 marks an undamped mode whose omega^2 is negative. */
    return (im < 0 ? im : hypot(re, im)) / two_pi;
}

double trk_modes_damped_frequency(const trk_modes *modes, int32_t mode)
{
    return has(modes, mode) ? modes->lambda_im[mode - 1] / two_pi : NAN;
}

double trk_modes_damping_ratio(const trk_modes *modes, int32_t mode)
{
    if (!has(modes, mode))
        return NAN;
    double re = modes->lambda_re[mode - 1], size = hypot(re, modes->lambda_im[mode - 1]);
    return size > 0 ? -re / size : 0;
}

trk_status trk_modes_get_shape(const trk_modes *modes, int32_t mode, double *out_re, double *out_im)
{
    if (!has(modes, mode))
        return TRK_E_ARGUMENT;
    size_t size = (size_t)modes->n * sizeof(double);
    if (out_re)
        memcpy(out_re, modes->re + (int64_t)(mode - 1) * modes->n, size);
    if (out_im)
        memcpy(out_im, modes->im + (int64_t)(mode - 1) * modes->n, size);
    return TRK_OK;
}

trk_status trk_modes_get_energy(const trk_modes *modes, int32_t mode, double *out_share)
{
    if (!has(modes, mode) || !out_share)
        return TRK_E_ARGUMENT;
    memcpy(out_share, modes->share + (int64_t)(mode - 1) * modes->n,
           (size_t)modes->n * sizeof(double));
    return TRK_OK;
}

int32_t trk_modes_dominant(const trk_modes *modes, int32_t mode)
{
    return has(modes, mode) ? modes->dominant[mode - 1] + 1 : 0;
}

const char *trk_modes_label(const trk_modes *modes, int32_t mode)
{
    return has(modes, mode) ? modes->label[mode - 1] : NULL;
}
