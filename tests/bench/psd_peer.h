/* SPDX-License-Identifier: MIT */
/* Welch's PSD by FFTW: Hann window, constant detrend, as trk_psd() by default. */
#ifndef TRK_TESTS_BENCH_PSD_PEER_H
#define TRK_TESTS_BENCH_PSD_PEER_H

#include "bench.h"

typedef struct psd_peer psd_peer;

/* So many segments, `hop` samples from each to the next. Plans ahead (FFTW_MEASURE).
 * NULL: FFTW is not installed. */
psd_peer *psd_peer_create(int64_t segment_length, int64_t hop, int64_t segments);
void psd_peer_destroy(psd_peer *p);

void psd_peer_run(psd_peer *p, const double *x, double sample_rate, double *out_density);

#endif
