/* SPDX-License-Identifier: MIT */
#include "psd_peer.h"

#ifdef BENCH_WITH_FFTW
#include <complex.h>
#include <fftw3.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

struct psd_peer {
    int64_t length, hop, segments;
    double *window, *in, power; /* sum of the squares of the window */
    fftw_complex *out;
    fftw_plan plan;
};

psd_peer *psd_peer_create(int64_t segment_length, int64_t hop, int64_t segments)
{
    psd_peer *p = calloc(1, sizeof *p);
    if (!p)
        return NULL;
    p->length = segment_length;
    p->hop = hop;
    p->segments = segments;
    p->window = fftw_alloc_real((size_t)segment_length);
    p->in = fftw_alloc_real((size_t)segment_length);
    p->out = fftw_alloc_complex((size_t)segment_length / 2 + 1);
    p->plan = fftw_plan_dft_r2c_1d((int)segment_length, p->in, p->out, FFTW_MEASURE);
    for (int64_t k = 0; k < segment_length; k++) {
        p->window[k] =
            0.5 - 0.5 * cos(2 * 3.14159265358979323846 * (double)k / (double)segment_length);
        p->power += p->window[k] * p->window[k];
    }
    return p;
}

void psd_peer_destroy(psd_peer *p)
{
    if (!p)
        return;
    fftw_destroy_plan(p->plan);
    fftw_free(p->window);
    fftw_free(p->in);
    fftw_free(p->out);
    free(p);
}

void psd_peer_run(psd_peer *p, const double *x, double sample_rate, double *out_density)
{
    int64_t bins = p->length / 2 + 1;
    double scale = 2 / (sample_rate * p->power * (double)p->segments);
    memset(out_density, 0, (size_t)bins * sizeof *out_density);
    for (int64_t s = 0; s < p->segments; s++) {
        const double *from = x + s * p->hop;
        double mean = 0;
        for (int64_t k = 0; k < p->length; k++)
            mean += from[k];
        mean /= (double)p->length;
        for (int64_t k = 0; k < p->length; k++)
            p->in[k] = (from[k] - mean) * p->window[k];
        fftw_execute(p->plan);
        for (int64_t k = 0; k < bins; k++)
            out_density[k] +=
                creal(p->out[k]) * creal(p->out[k]) + cimag(p->out[k]) * cimag(p->out[k]);
    }
    for (int64_t k = 0; k < bins; k++)
        out_density[k] *= k == 0 || 2 * k == p->length ? scale / 2 : scale;
}
#else
psd_peer *psd_peer_create(int64_t segment_length, int64_t hop, int64_t segments)
{
    (void)segment_length, (void)hop, (void)segments;
    return NULL;
}

void psd_peer_destroy(psd_peer *p)
{
    (void)p;
}

void psd_peer_run(psd_peer *p, const double *x, double sample_rate, double *out_density)
{
    (void)p, (void)x, (void)sample_rate, (void)out_density;
}
#endif
