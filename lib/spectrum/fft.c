/* SPDX-License-Identifier: MIT */
/* Complex FFT: factorisation into Stockham passes, or Bluestein's convolution. */
#include "spectrum/fft.h"
#include "spectrum/roots.h"

#include <string.h>

enum { MAX_PASSES = 64 };

struct trk_fft {
    trk_context *context;
    const trk_fft_kernel *kernel;
    int64_t n;
    int64_t passes;
    trk_fft_pass pass[MAX_PASSES];
    double *table;         /* twiddle factors and radix roots of all passes       */
    struct trk_fft *inner; /* Bluestein: transform of the convolution, else NULL  */
    double *chirp;         /* exp(-i pi k^2 / n), n                               */
    double *filter;        /* conj of the transform of conj(chirp), / inner->n    */
};

/* Split n into radices, 8 and 4 first; returns what is left: 1, or a product of large primes. */
static int64_t factorise(trk_fft *fft)
{
    int64_t rest = fft->n, stride = 1;
    for (int64_t radix = 8; radix <= TRK_FFT_LARGEST_RADIX;) {
        /* 16 = 4 * 4 is cheaper than 8 * 2. */
        if (rest % radix || (radix == 8 && rest == 16)) {
            radix = radix == 8 ? 4 : radix == 4 ? 2 : radix == 2 ? 3 : radix + 2;
            continue;
        }
        rest /= radix;
        fft->pass[fft->passes++] =
            (trk_fft_pass){.radix = radix, .columns = rest, .stride = stride};
        stride *= radix;
    }
    return rest;
}

static int64_t pass_table(const trk_fft_pass *pass)
{
    return 2 * (pass->radix - 1) * pass->columns + 2 * pass->radix;
}

/* Fill the tables of all passes from the n-th roots of one. */
static void fill_passes(trk_fft *fft, const double *root)
{
    double *next = fft->table;
    for (trk_fft_pass *pass = fft->pass; pass < fft->pass + fft->passes; pass++) {
        const int64_t r = pass->radix;
        pass->twiddle = next;
        for (int64_t p = 0; p < pass->columns; p++)
            for (int64_t k = 1; k < r; k++, next += 2)
                memcpy(next, root + 2 * pass->stride * p * k, 2 * sizeof *next);
        pass->root = next;
        for (int64_t k = 0; k < r; k++, next += 2)
            memcpy(next, root + 2 * (fft->n / r) * k, 2 * sizeof *next);
    }
}

static trk_status plan_passes(trk_fft *fft)
{
    int64_t size = 0;
    for (int64_t i = 0; i < fft->passes; i++)
        size += pass_table(&fft->pass[i]);
    fft->table = trk_new(fft->context, size, sizeof *fft->table);
    double *root = fft->table ? trk_new(fft->context, 2 * fft->n, sizeof *root) : NULL;
    if (!root)
        return TRK_E_MEMORY;
    trk_roots_fill(fft->n, root);
    fill_passes(fft, root);
    trk_free(fft->context, root);
    return TRK_OK;
}

/* Smallest product of 2, 3 and 5 that is not below n. */
static int64_t smooth_length(int64_t n)
{
    int64_t best = 1;
    while (best < n)
        best *= 2;
    for (int64_t five = 1; five < best; five *= 5)
        for (int64_t three = five; three < best; three *= 3) {
            int64_t length = three;
            while (length < n)
                length *= 2;
            if (length < best)
                best = length;
        }
    return best;
}

/* Chirp, from the 2n-th roots of one: k^2 is reduced modulo 2n in integers. */
static trk_status fill_chirp(trk_fft *fft)
{
    const int64_t n = fft->n;
    double *root = trk_new(fft->context, 4 * n, sizeof *root);
    if (!root)
        return TRK_E_MEMORY;
    trk_roots_fill(2 * n, root);
    for (int64_t k = 0, square = 0; k < n; square = (square + 2 * k + 1) % (2 * n), k++)
        memcpy(fft->chirp + 2 * k, root + 2 * square, 2 * sizeof *root);
    trk_free(fft->context, root);
    return TRK_OK;
}

/* Transform of the periodic conjugate chirp with a one-lane plan. */
static trk_status fill_filter(trk_fft *fft)
{
    const int64_t n = fft->n, m = fft->inner->n;
    trk_fft *single = NULL;
    double *work = trk_new(fft->context, 4 * m, sizeof *work);
    trk_status status =
        work ? trk_fft_create(fft->context, m, &trk_fft_kernel_scalar, &single) : TRK_E_MEMORY;
    if (status == TRK_OK) {
        for (int64_t k = 0; k < n; k++) {
            const int64_t mirror = k ? m - k : 0;
            work[2 * k] = work[2 * mirror] = fft->chirp[2 * k];
            work[2 * k + 1] = work[2 * mirror + 1] = -fft->chirp[2 * k + 1];
        }
        const double *transform = trk_fft_forward(single, work, work + 2 * m);
        for (int64_t k = 0; k < m; k++) {
            fft->filter[2 * k] = transform[2 * k] / (double)m;
            fft->filter[2 * k + 1] = -transform[2 * k + 1] / (double)m;
        }
    }
    trk_fft_destroy(single);
    trk_free(fft->context, work);
    return status;
}

static trk_status plan_bluestein(trk_fft *fft)
{
    trk_status status =
        trk_fft_create(fft->context, smooth_length(2 * fft->n - 1), fft->kernel, &fft->inner);
    if (status != TRK_OK)
        return status;
    fft->chirp = trk_new(fft->context, 2 * fft->n, sizeof *fft->chirp);
    if (fft->chirp)
        fft->filter = trk_new(fft->context, 2 * fft->inner->n, sizeof *fft->filter);
    if (!fft->filter)
        return TRK_E_MEMORY;
    status = fill_chirp(fft);
    return status == TRK_OK ? fill_filter(fft) : status;
}

trk_status trk_fft_create(trk_context *context, int64_t n, const trk_fft_kernel *kernel,
                          trk_fft **out_fft)
{
    *out_fft = NULL;
    trk_fft *fft = trk_new(context, 1, sizeof *fft);
    if (!fft)
        return TRK_E_MEMORY;
    fft->context = context;
    fft->kernel = kernel;
    fft->n = n;
    trk_status status = factorise(fft) == 1 ? plan_passes(fft) : plan_bluestein(fft);
    if (status != TRK_OK) {
        trk_fft_destroy(fft);
        return status;
    }
    *out_fft = fft;
    return TRK_OK;
}

void trk_fft_destroy(trk_fft *fft)
{
    if (!fft)
        return;
    trk_fft_destroy(fft->inner);
    trk_free(fft->context, fft->filter);
    trk_free(fft->context, fft->chirp);
    trk_free(fft->context, fft->table);
    trk_free(fft->context, fft);
}

int64_t trk_fft_buffer(const trk_fft *fft)
{
    return 2 * fft->kernel->lanes * (fft->inner ? fft->inner->n : fft->n);
}

static double *run_passes(const trk_fft *fft, double *x, double *y)
{
    const trk_fft_kernel *kernel = fft->kernel;
    for (const trk_fft_pass *pass = fft->pass; pass < fft->pass + fft->passes; pass++) {
        switch (pass->radix) {
        case 2: kernel->radix2(pass, x, y); break;
        case 3: kernel->radix3(pass, x, y); break;
        case 4: kernel->radix4(pass, x, y); break;
        case 5: kernel->radix5(pass, x, y); break;
        case 8: kernel->radix8(pass, x, y); break;
        default: kernel->general(pass, x, y); break;
        }
        double *swap = x;
        x = y;
        y = swap;
    }
    return x;
}

double *trk_fft_forward(const trk_fft *fft, double *data, double *work)
{
    if (!fft->inner)
        return run_passes(fft, data, work);

    /* (SPECTRUM.12); the inverse transform is conj(forward(conj(.))) / m, with the
     * conjugations in the two products and 1 / m in the filter. */
    const trk_fft_kernel *kernel = fft->kernel;
    const int64_t n = fft->n, m = fft->inner->n, cell = 2 * kernel->lanes;
    kernel->multiply(n, fft->chirp, data);
    memset(data + n * cell, 0, (size_t)((m - n) * cell) * sizeof *data);
    double *z = run_passes(fft->inner, data, work);
    kernel->conjugate_multiply(m, fft->filter, z);
    z = run_passes(fft->inner, z, z == data ? work : data);
    kernel->conjugate_multiply(n, fft->chirp, z);
    return z;
}
