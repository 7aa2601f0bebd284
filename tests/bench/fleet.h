/* SPDX-License-Identifier: MIT */
/* Variants of a vehicle, with tires up to 20 % stiffer, on one road. */
#ifndef TRK_TESTS_BENCH_FLEET_H
#define TRK_TESTS_BENCH_FLEET_H

#include "rig.h"

typedef struct fleet {
    const bench *bench;
    rig rig; /* of variant 0 */
    int32_t count, threads;
    int64_t record_every;
    trk_model **models;
    const trk_excitation **roads;
    double *square; /* count x sensors: sums of squares, what a study of RMS values keeps */
} fleet;

/* One thread, every step recorded. Ends the program on failure. */
void fleet_create(const bench *b, trk_vehicle vehicle, int32_t count, double seconds, fleet *out);
void fleet_destroy(fleet *f);

/* All variants by trk_batch_run(). */
void fleet_run(fleet *f);

/* One by trk_simulate(), and its sums of squares. */
void fleet_run_single(const fleet *f, int32_t variant, double *out_square);

/* Largest relative difference of a mean square of the first and the last variant. */
double fleet_error(const fleet *f);

#endif
