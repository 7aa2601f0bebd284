/* SPDX-License-Identifier: MIT */
/* Welch's PSD of samples that come piece by piece: the memory does not depend on their number. */
#ifndef TRK_SPECTRUM_STREAM_H
#define TRK_SPECTRUM_STREAM_H

#include "spectrum/welch.h"

/*
 * One record on its way. It is transformed as many segments at a time as the kernel has
 * lanes, in the order of trk_psd(), so that the result is that of trk_psd() bit for bit.
 */
typedef struct trk_welch_stream {
    double *samples;  /* still needed: those of the next segments                */
    int64_t held;     /* number of them                                          */
    int64_t segments; /* transformed so far                                      */
    double *sum;      /* of |X|^2 over them, by lane; length * lanes             */
} trk_welch_stream;

/* Memory of a stream [byte]. */
int64_t trk_welch_stream_size(const trk_welch_plan *plan);

/* A stream without samples, in the context of the plan; on failure it holds nothing. */
trk_status trk_welch_stream_create(const trk_welch_plan *plan, trk_welch_stream *out_stream);
void trk_welch_stream_free(const trk_welch_plan *plan, trk_welch_stream *stream);
void trk_welch_stream_reset(const trk_welch_plan *plan, trk_welch_stream *stream);

/* Take count more samples. Allocates nothing; threads need a pair of buffers each, as
 * trk_welch_transform(). Samples beyond the length of the plan are ignored. */
void trk_welch_stream_push(const trk_welch_plan *plan, trk_welch_stream *stream, int64_t count,
                           const double *x, double *const buffer[2]);

/* PSD (SPECTRUM.3) of the whole record, once; the stream needs a reset afterwards. TRK_E_RANGE:
 * samples are missing, not finite or too large. */
trk_status trk_welch_stream_density(const trk_welch_plan *plan, const char *what,
                                    double sample_rate, trk_welch_stream *stream,
                                    double *out_density);

#endif
