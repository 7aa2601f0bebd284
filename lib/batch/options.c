/* SPDX-License-Identifier: MIT */
/* Options of a batch. */
#include "batch/batch.h"

#include "newmark/options.h"

#include <math.h>

static const trk_batch_options defaults = {
    .struct_size = sizeof defaults, .duration = 10, .record_every = 1, .threads = 1};

void trk_batch_options_init(trk_batch_options *options, size_t struct_size)
{
    trk_write_defaults(options, struct_size, &defaults, sizeof defaults);
}

static trk_status check(trk_context *context, const trk_batch_options *o)
{
    if (!isfinite(o->duration) || o->duration <= 0)
        return trk_fail(context, TRK_E_RANGE,
                        "trk_batch_options: duration is %g s; a finite number > 0 is needed",
                        o->duration);
    if (!isfinite(o->start))
        return trk_fail(context, TRK_E_RANGE,
                        "trk_batch_options: start is %g s; a finite number is needed", o->start);
    if (o->record_every < 1)
        return trk_fail(context, TRK_E_RANGE,
                        "trk_batch_options: record_every is %lld; at least 1 is needed",
                        (long long)o->record_every);
    if (o->threads < 1)
        return trk_fail(context, TRK_E_RANGE,
                        "trk_batch_options: threads is %d; at least 1 is needed", o->threads);
    if (o->sensor_count < 0 || (o->sensor_count > 0) != (o->sensors != NULL))
        return trk_fail(context, TRK_E_ARGUMENT,
                        "trk_batch_options: sensor_count is %d and sensors is %s; both or none",
                        o->sensor_count, o->sensors ? "given" : "NULL");
    return TRK_OK;
}

trk_status trk_batch_read_options(trk_context *context, const trk_newmark_options *newmark,
                                  const trk_batch_options *options,
                                  trk_newmark_options *out_newmark, trk_batch_options *out_options,
                                  int64_t *out_steps)
{
    *out_options = defaults;
    trk_status status = trk_newmark_read_options(context, newmark, out_newmark);
    if (status == TRK_OK)
        status = trk_read_options(context, "trk_batch_options", options, out_options,
                                  sizeof *out_options);
    if (status == TRK_OK)
        status = check(context, out_options);
    if (status != TRK_OK)
        return status;
    double steps = round(out_options->duration / out_newmark->step);
    if (steps < 1 || steps > 1e15)
        return trk_fail(
            context, TRK_E_RANGE,
            "trk_batch_options: duration %g s is %g steps of %g s; 1 to 1e15 are needed",
            out_options->duration, out_options->duration / out_newmark->step, out_newmark->step);
    *out_steps = (int64_t)steps;
    return TRK_OK;
}

int64_t trk_batch_samples(const trk_newmark_options *newmark, const trk_batch_options *options)
{
    trk_newmark_options known_newmark;
    trk_batch_options known;
    int64_t steps = 0;
    if (trk_batch_read_options(NULL, newmark, options, &known_newmark, &known, &steps) != TRK_OK)
        return 0;
    return steps / known.record_every + 1;
}
