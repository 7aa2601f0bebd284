/* SPDX-License-Identifier: MIT */
/*
 * A built-in vehicle on a road simulator: the thesis's sweep, ten times as high, squeezed into
 * the given time, with another gain under every wheel so that all coordinates move.
 */
#ifndef TRK_TESTS_BENCH_RIG_H
#define TRK_TESTS_BENCH_RIG_H

#include "bench.h"

enum { RIG_ALL_SENSORS = -1, RIG_COORDINATES = 16, RIG_ROADS = 4, RIG_EVERY = 10 };

typedef struct rig {
    const bench *bench;
    trk_signal *sweep;
    trk_model *model;
    trk_excitation *road;
    int32_t n, roads, links, curves, sensors;
    double seconds, gain[RIG_ROADS];
    int64_t steps;             /* of 1 ms                                              */
    double *height, *velocity; /* (steps + 1) x roads, the first row at t = 0          */
} rig;

/* sensors: keep the first so many, or RIG_ALL_SENSORS. Ends the program on failure. */
void rig_create(const bench *b, trk_vehicle vehicle, trk_variant variant, int32_t sensors,
                double seconds, rig *out);
void rig_destroy(rig *r);

/* The same with inter-leaf friction on every axle spring: 2500 N with an approach of 2 mm. */
void rig_create_on_leaves(const bench *b, trk_vehicle vehicle, trk_variant variant, double seconds,
                          rig *out);

/* A stepper at rest, in balance with the road at t = 0. */
trk_newmark *rig_stepper(const rig *r, double step);

/* Take all steps of 1 ms, the road given; [s]. out_q receives every RIG_EVERY-th state,
 * (steps / RIG_EVERY + 1) x n; NULL to skip. */
double rig_drive(const rig *r, trk_newmark *stepper, double *out_q);

/* The same with a new stepper, average acceleration at 1 ms. */
double rig_run_stepper(const rig *r, double *out_q, trk_newmark_statistics *out_statistics);

/* The same run by trk_simulate(), with excitation and sensors; [s]. */
double rig_run_simulate(const rig *r);

#endif
