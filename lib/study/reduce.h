/* SPDX-License-Identifier: MIT */
/* Samples of a case become numbers as they come. */
#ifndef TRK_STUDY_REDUCE_H
#define TRK_STUDY_REDUCE_H

#include "spectrum/stream.h"
#include "study/study.h"

enum { TRK_MOMENT_BLOCK = 128 };

/* Extremes, mean and sum of squares about it, block by block (STUDY.7). */
typedef struct trk_moments {
    double block[TRK_MOMENT_BLOCK]; /* samples not counted yet              */
    int32_t held;
    int64_t count;
    double offset;        /* the first sample                               */
    double mean, squares; /* of the samples counted, less the offset; about their mean */
    double minimum, maximum;
} trk_moments;

void trk_moments_reset(trk_moments *moments);
void trk_moments_push(trk_moments *moments, int64_t count, const double *x);

/* Count what is left, once; then mean, squares, minimum and maximum are those of all samples. */
void trk_moments_finish(trk_moments *moments);

/* One channel of one case. */
typedef struct trk_reduction {
    trk_moments moments;
    trk_welch_stream stream; /* if the channel has a PSD */
} trk_reduction;

/* Memory of the reductions of one case [byte]. */
int64_t trk_reduction_size(const trk_study *study);

/* Reductions of a case, one for each channel, from zeroed memory. */
trk_status trk_reduction_create(const trk_study *study, trk_reduction *reductions);
void trk_reduction_free(const trk_study *study, trk_reduction *reductions);
void trk_reduction_reset(const trk_study *study, trk_reduction *reductions);

/* Take the samples first .. first + count - 1 of all channels, as a trk_batch_sink gets them.
 * buffer: of trk_welch_stream_push(), one pair for each thread. */
void trk_reduction_push(const trk_study *study, trk_reduction *reductions, int64_t first,
                        int64_t count, const double *values, double *const buffer[2]);

/*
 * Outputs of a case whose samples are complete. density: room for a PSD. TRK_E_RANGE: a
 * number is not finite.
 */
trk_status trk_reduction_finish(trk_study *study, trk_reduction *reductions, double *density,
                                double *out_values);

#endif
