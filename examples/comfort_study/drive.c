/* SPDX-License-Identifier: MIT */
/* All cases of a truck side by side on two threads. */
#include "comfort_study.h"

#include <stdlib.h>
#include <string.h>

const double settling = 20, duration = 240;

int case_of(int class, int speed, int damper)
{
    return (class * SPEEDS + speed) * DAMPERS + damper;
}

typedef struct recording {
    double *x;
    int64_t samples;
} recording;

static int32_t keep(void *user, int32_t variant, int64_t first, int64_t count, const double *values)
{
    const recording *r = user;
    for (int64_t c = 0; c < CHANNELS; c++)
        memcpy(r->x + (variant * CHANNELS + c) * r->samples + first, values + c * count,
               (size_t)count * sizeof *values);
    return 0;
}

double *drive_all(trk_context *context, int truck, int64_t *out_samples)
{
    trk_model *trucks[DAMPERS];
    const trk_model *models[CASES];
    const trk_excitation *excitations[CASES];
    drive drives[CLASSES][SPEEDS];
    int32_t sensors[CHANNELS];
    trk_batch_options options;
    recording kept;
    for (int d = 0; d < DAMPERS; d++)
        trucks[d] = create_truck(context, truck, d);
    for (int class = 0; class < CLASSES; class ++)
        for (int speed = 0; speed < SPEEDS; speed++) {
            create_drive(context, trucks[0], class, speed, &drives[class][speed]);
            for (int d = 0; d < DAMPERS; d++) {
                models[case_of(class, speed, d)] = trucks[d];
                excitations[case_of(class, speed, d)] = drives[class][speed].excitation;
            }
        }
    for (int c = 0; c < CHANNELS; c++)
        sensors[c] = sensor_of(trucks[0], c);
    trk_batch_options_init(&options, sizeof options);
    options.duration = settling + duration;
    options.record_every = RECORD_EVERY;
    options.threads = 2;
    options.sensor_count = CHANNELS;
    options.sensors = sensors;
    kept.samples = trk_batch_samples(NULL, &options);
    kept.x = allocate((size_t)(CASES * CHANNELS * kept.samples) * sizeof *kept.x);
    check(context, trk_batch_run(context, CASES, models, excitations, NULL, &options, keep, &kept,
                                 NULL, NULL, NULL));
    for (int k = 0; k < CLASSES * SPEEDS; k++)
        destroy_drive(&drives[k / SPEEDS][k % SPEEDS]);
    for (int d = 0; d < DAMPERS; d++)
        trk_model_destroy(trucks[d]);
    *out_samples = kept.samples;
    return kept.x;
}
