/* SPDX-License-Identifier: MIT */
/* Random response from a superposition that is at hand. */
#ifndef TRK_LINEAR_RANDOM_H
#define TRK_LINEAR_RANDOM_H

#include "linear/superposition.h"

/* trk_response_psd() without its checks and RMS. */
trk_status trk_random_response(trk_superposition *s, int64_t count, const double *frequency,
                               const double *input, double *out_density);

/* Complex elongation of a link, 0-based, for unit input j, from the response at hand. */
double complex trk_random_elongation(const trk_superposition *s, int32_t link, int32_t input);

/* sum over i, j of conj(h_i) h_j S_ij >= 0 for the spectra of the inputs at one frequency. */
double trk_random_form(int32_t inputs, const double complex *h, const double *input);

/* TRK_E_RANGE unless frequencies and spectra are those of trk_response_psd(). */
trk_status trk_random_check(trk_context *context, const char *what, const trk_model *model,
                            int64_t count, const double *frequency, const double *input);

#endif
