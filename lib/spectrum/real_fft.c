/* SPDX-License-Identifier: MIT */
/* FFT of real sequences. */
#include "spectrum/fft.h"
#include "spectrum/roots.h"

struct trk_real_fft {
    trk_context *context;
    const trk_fft_kernel *kernel;
    int64_t n;
    trk_fft *complex; /* of length n / 2 if n is even, else n */
    double *root;     /* n-th roots of one; even n only       */
};

trk_status trk_real_fft_create(trk_context *context, int64_t n, const trk_fft_kernel *kernel,
                               trk_real_fft **out_fft)
{
    *out_fft = NULL;
    trk_real_fft *fft = trk_new(context, 1, sizeof *fft);
    if (!fft)
        return TRK_E_MEMORY;
    fft->context = context;
    fft->kernel = kernel;
    fft->n = n;
    trk_status status = trk_fft_create(context, n % 2 ? n : n / 2, kernel, &fft->complex);
    if (status == TRK_OK && n % 2 == 0) {
        fft->root = trk_new(context, 2 * n, sizeof *fft->root);
        status = fft->root ? TRK_OK : TRK_E_MEMORY;
    }
    if (status != TRK_OK) {
        trk_real_fft_destroy(fft);
        return status;
    }
    if (fft->root)
        trk_roots_fill(n, fft->root);
    *out_fft = fft;
    return TRK_OK;
}

void trk_real_fft_destroy(trk_real_fft *fft)
{
    if (!fft)
        return;
    trk_free(fft->context, fft->root);
    trk_fft_destroy(fft->complex);
    trk_free(fft->context, fft);
}

int64_t trk_real_fft_buffer(const trk_real_fft *fft)
{
    const int64_t result = 2 * fft->kernel->lanes * (fft->n / 2 + 1);
    const int64_t inner = trk_fft_buffer(fft->complex);
    return result > inner ? result : inner;
}

/* Make cells of rows of samples in place, with zero imaginary parts; backwards, since the
 * cells are twice as long. */
static void widen(int64_t n, int64_t lanes, double *data)
{
    for (int64_t k = n - 1; k >= 0; k--)
        for (int64_t l = 0; l < lanes; l++) {
            data[2 * lanes * k + l] = data[lanes * k + l];
            data[2 * lanes * k + lanes + l] = 0;
        }
}

double *trk_real_fft_forward(const trk_real_fft *fft, double *data, double *work)
{
    if (fft->n % 2) {
        widen(fft->n, fft->kernel->lanes, data);
        return trk_fft_forward(fft->complex, data, work);
    }
    /* Rows 2j and 2j + 1 of samples already are the real and imaginary part of cell j. */
    double *z = trk_fft_forward(fft->complex, data, work);
    double *spectrum = z == data ? work : data;
    fft->kernel->split_real(fft->n / 2, fft->root, z, spectrum);
    return spectrum;
}
