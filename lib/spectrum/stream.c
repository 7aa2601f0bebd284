/* SPDX-License-Identifier: MIT */
/* Welch's PSD piece by piece. */
#include "spectrum/stream.h"

#include <string.h>

/* Samples of `segments` segments that follow one another. */
static int64_t span(const trk_welch_plan *plan, int64_t segments)
{
    return plan->settings.options.segment_length + (segments - 1) * plan->settings.step;
}

static int64_t sums(const trk_welch_plan *plan)
{
    return plan->settings.length * plan->kernel->lanes;
}

int64_t trk_welch_stream_size(const trk_welch_plan *plan)
{
    return (span(plan, plan->kernel->lanes) + sums(plan)) * (int64_t)sizeof(double);
}

trk_status trk_welch_stream_create(const trk_welch_plan *plan, trk_welch_stream *out_stream)
{
    *out_stream = (trk_welch_stream){
        .samples = trk_new(plan->context, span(plan, plan->kernel->lanes), sizeof(double)),
        .sum = trk_new(plan->context, sums(plan), sizeof(double))};
    if (out_stream->samples && out_stream->sum)
        return TRK_OK;
    trk_welch_stream_free(plan, out_stream);
    return TRK_E_MEMORY;
}

void trk_welch_stream_free(const trk_welch_plan *plan, trk_welch_stream *stream)
{
    trk_free(plan->context, stream->samples);
    trk_free(plan->context, stream->sum);
    *stream = (trk_welch_stream){0};
}

void trk_welch_stream_reset(const trk_welch_plan *plan, trk_welch_stream *stream)
{
    stream->held = stream->segments = 0;
    memset(stream->sum, 0, (size_t)sums(plan) * sizeof *stream->sum);
}

void trk_welch_stream_push(const trk_welch_plan *plan, trk_welch_stream *stream, int64_t count,
                           const double *x, double *const buffer[2])
{
    while (count > 0) {
        const int64_t left = plan->settings.segments - stream->segments;
        const int64_t together = left < plan->kernel->lanes ? left : plan->kernel->lanes;
        if (together == 0)
            return;
        const int64_t needed = span(plan, together) - stream->held;
        const int64_t taken = count < needed ? count : needed;
        memcpy(stream->samples + stream->held, x, (size_t)taken * sizeof *x);
        stream->held += taken;
        x += taken;
        count -= taken;
        if (taken < needed)
            return;
        const double *X = trk_welch_transform(plan, together, stream->samples, buffer);
        plan->kernel->add_power(plan->settings.length, X, stream->sum);
        stream->segments += together;
        const int64_t used = together * plan->settings.step;
        stream->held -= used;
        memmove(stream->samples, stream->samples + used, (size_t)stream->held * sizeof *x);
    }
}

trk_status trk_welch_stream_density(const trk_welch_plan *plan, const char *what,
                                    double sample_rate, trk_welch_stream *stream,
                                    double *out_density)
{
    if (stream->segments < plan->settings.segments)
        return trk_fail(plan->context, TRK_E_RANGE,
                        "%s: the record ends within segment %lld of %lld", what,
                        (long long)stream->segments + 1, (long long)plan->settings.segments);
    if (!trk_welch_reduce(plan, plan->settings.length, stream->sum))
        return trk_fail(plan->context, TRK_E_RANGE,
                        "%s: a sample is not finite or its square overflows", what);
    return trk_welch_write(plan, what, sample_rate, 1, stream->sum, out_density);
}
