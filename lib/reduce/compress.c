/* SPDX-License-Identifier: MIT */
/* QR decomposition, a row at a time (REDUCE.2). */
#include "reduce/compress.h"

#include <float.h>
#include <math.h>
#include <string.h>

trk_status trk_compressor_create(trk_context *context, int32_t width, trk_compressor *out)
{
    out->width = width;
    out->r = trk_new(context, (int64_t)width * width, sizeof *out->r);
    return out->r ? TRK_OK : TRK_E_MEMORY;
}

void trk_compressor_clear(trk_context *context, trk_compressor *compressor)
{
    trk_free(context, compressor->r);
    memset(compressor, 0, sizeof *compressor);
}

void trk_compressor_add(trk_compressor *compressor, double factor, double *w)
{
    int32_t n = compressor->width;
    double root = sqrt(factor);
    for (int32_t j = 0; j < n; j++)
        w[j] *= root;
    for (int32_t j = 0; j < n; j++) {
        double *r = compressor->r + (int64_t)j * n;
        if (w[j] == 0)
            continue;
        double size = hypot(r[j], w[j]), c = r[j] / size, s = w[j] / size;
        r[j] = size;
        for (int32_t k = j + 1; k < n; k++) {
            double x = r[k];
            r[k] = c * x + s * w[k];
            w[k] = c * w[k] - s * x;
        }
    }
}

void trk_compressor_finish(trk_compressor *compressor)
{
    int32_t n = compressor->width;
    for (int32_t j = 0; j < n; j++) {
        double square = 0;
        for (int32_t i = 0; i <= j; i++)
            square += compressor->r[(int64_t)i * n + j] * compressor->r[(int64_t)i * n + j];
        double rounding = 64 * DBL_EPSILON * sqrt(square);
        for (int32_t i = 0; i <= j; i++)
            if (fabs(compressor->r[(int64_t)i * n + j]) <= rounding)
                compressor->r[(int64_t)i * n + j] = 0;
    }
}

double trk_compressor_row(const trk_compressor *compressor, int32_t j, double *w)
{
    const double *r = compressor->r + (int64_t)j * compressor->width;
    double largest = 0;
    for (int32_t k = 0; k < compressor->width; k++)
        largest = fmax(largest, fabs(r[k]));
    for (int32_t k = 0; largest > 0 && k < compressor->width; k++)
        w[k] = r[k] / largest;
    return largest * largest;
}
