/* SPDX-License-Identifier: MIT */
/* Inside of a batch run. */
#ifndef TRK_BATCH_BATCH_H
#define TRK_BATCH_BATCH_H

#include "batch/arena.h"
#include "batch/lanes.h"
#include <truckride/batch.h>

#include <pthread.h>
#include <stdatomic.h>

/* One call of trk_batch_run(); what is not atomic does not change while threads run. */
typedef struct trk_batch {
    trk_context *context;
    int32_t count;
    const trk_model *const *models;
    const trk_excitation *const *excitations;
    trk_newmark_options newmark;
    trk_batch_options options;
    int64_t steps;
    int32_t sensors, *sensor;       /* number and 0-based ids of what is recorded  */
    const trk_lanes_kernel *kernel; /* NULL: all variants through the stepper      */
    trk_batch_sink sink;
    void *sink_user;
    trk_progress progress;
    void *progress_user;
    double next_report;     /* fraction; used by the calling thread only       */
    trk_status *status;     /* count                                           */
    atomic_int next;        /* the first variant that nobody has taken         */
    atomic_int cancelled;   /* by progress                                     */
    atomic_ullong advanced; /* steps of all variants                           */
} trk_batch;

/* One thread's share. */
typedef struct trk_batch_worker {
    trk_batch *batch;
    bool calls_progress;              /* it is the calling thread                   */
    trk_arena arena;                  /* for one variant's stepper or scratch       */
    trk_lanes *lanes;                 /* NULL without a kernel                      */
    double *height, *velocity, *load; /* BLOCK x roads, roads, ports                */
    double *values;                   /* sensors x BLOCK, sensor by sensor          */
    double *row;                      /* sensors: one sample                        */
    double *kept;                     /* width x 2 n: q, v of lanes that go on alone */
    int32_t failed;                   /* lowest variant that failed, count: none    */
    char *message;                    /* about it                                   */
    pthread_t thread;
} trk_batch_worker;

enum { TRK_BATCH_MESSAGE = 512 };

/* Where a variant goes on that the lanes could not take further; q NULL: from the beginning. */
typedef struct trk_batch_origin {
    int64_t step;
    const double *q, *v;
} trk_batch_origin;

/* Read and check options; steps of the run. */
trk_status trk_batch_read_options(trk_context *context, const trk_newmark_options *newmark,
                                  const trk_batch_options *options,
                                  trk_newmark_options *out_newmark, trk_batch_options *out_options,
                                  int64_t *out_steps);

/* Have all models the structure of the first, and all excitations their roads and ports? */
trk_status trk_batch_check_structure(const trk_batch *batch);

/* Road and loads at the ends of the steps first + 1 .. first + count. */
void trk_batch_drive(const trk_batch_worker *worker, const trk_excitation *excitation,
                     int64_t first, int64_t count);

/* Run variants first .. first + count - 1, at most the width of a group, in lanes. */
void trk_batch_run_group(trk_batch_worker *worker, int32_t first, int32_t count);

/* Run one variant with the stepper. */
void trk_batch_run_alone(trk_batch_worker *worker, int32_t variant, trk_batch_origin origin);

/* Take variants until none is left. */
void trk_batch_work(trk_batch_worker *worker);

/* Count steps as done, ask progress. false: the run is cancelled. */
bool trk_batch_account(trk_batch_worker *worker, int64_t steps);

/* End a variant with a status; `cause` is kept if no lower one of this worker failed. */
void trk_batch_end(trk_batch_worker *worker, int32_t variant, trk_status status, const char *cause);

/* End it as cancelled by its sink in front of a sample. */
void trk_batch_end_by_sink(trk_batch_worker *worker, int32_t variant, int64_t sample);

/* trk_batch_run() with a kernel by number (lanes.h); NONE takes the stepper for all. */
trk_status trk_batch_run_with(int32_t kernel, trk_context *context, int32_t count,
                              const trk_model *const *models,
                              const trk_excitation *const *excitations,
                              const trk_newmark_options *newmark, const trk_batch_options *options,
                              trk_batch_sink sink, void *sink_user, trk_progress progress,
                              void *progress_user, trk_status *out_status);

#endif
