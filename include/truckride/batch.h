/* SPDX-License-Identifier: MIT */
/**
 * @file  truckride/batch.h
 * @brief Many variants of one model advanced together, over threads that the caller bounds.
 *
 * Variants have the same structure and differ in numbers: masses, stiffnesses, places, curves,
 * roads. Several of them are stepped side by side, one in each lane of a vector register
 * (BATCH.1), by each of a few threads. Each variant gets the result that trk_simulate() gives
 * it, to about 1e-10 of the peaks, and the same bits whatever else is in the batch, in
 * which order and on how many threads it runs.
 *
 * Memory: some 100 kB to 1 MB a thread, whatever the duration and the number of variants, and
 * four bytes a variant. All of it is taken by the calling thread before the others start.
 */
#ifndef TRUCKRIDE_BATCH_H
#define TRUCKRIDE_BATCH_H

#include <truckride/excitation.h>
#include <truckride/newmark.h>

/** Options of trk_batch_run(). */
typedef struct trk_batch_options {
    size_t  struct_size;  /**< [byte] set by trk_batch_options_init()                      */
    double  duration;     /**< [s] > 0, rounded to whole steps; default 10                 */
    double  start;        /**< [s] time at the beginning; default 0                        */
    int64_t record_every; /**< [-] record each such step, >= 1; default 1                  */
    int32_t threads;      /**< [-] most threads at work, the calling one among them, >= 1; default 1 */
    int32_t sensor_count; /**< [-] length of sensors, >= 0; default 0: all sensors         */
    const int32_t *sensors; /**< [-] ids of the sensors to record, in this order; default NULL */
} trk_batch_options;

/** Set every field to its default. Call as trk_batch_options_init(&o, sizeof o). */
TRK_API void trk_batch_options_init(trk_batch_options *options, size_t struct_size);

/**
 * Recorded samples of one variant each, as in trk_simulate(): the initial state and every
 * record_every-th step. 0 if an option is out of its range.
 *
 * @param newmark NULL for the defaults
 * @param options NULL for the defaults
 */
TRK_API int64_t trk_batch_samples(const trk_newmark_options *newmark,
                                  const trk_batch_options *options);

/**
 * Receives a block of recorded samples of one variant.
 *
 * Blocks of one variant come in the order of time, never two at once. Blocks of different
 * variants may come at the same time from different threads. The sink must not
 * use the context of the batch.
 *
 * @param user    as handed to trk_batch_run()
 * @param variant 0 .. count - 1: its place in the arrays of trk_batch_run()
 * @param first   number of the first sample of the block; 0 is the initial state
 * @param count   samples in the block, >= 1; not the same in every call
 * @param values  [unit of the sensor] sensors x count, sensor by sensor in the order of the
 *                options: sample k of the first is values[k], of the second values[count + k];
 *                valid during the call
 * @return 0 to go on, anything else to end this variant (its status is TRK_E_CANCELLED)
 */
typedef int32_t (*trk_batch_sink)(void *user, int32_t variant, int64_t first, int64_t count,
                                  const double *values);

/**
 * Run variants of one model from static equilibrium at rest, each over its excitation.
 *
 * A variant that fails gets its own status, the others go on. Of several failures the message
 * of the context tells that of the lowest variant.
 *
 * @param count       variants, >= 1
 * @param models      length count; borrowed. All have coordinates, links, roads, ports and
 *                    sensors of the same names in the same order, sensors of the same quantity,
 *                    and spring and damper curves at the same links.
 * @param excitations length count; borrowed. Where neighbours share one it is evaluated once.
 * @param newmark     NULL for average acceleration at 1 ms
 * @param options     NULL for 10 s, all steps recorded, one thread
 * @param sink        receives the samples
 * @param sink_user   handed to sink; borrowed
 * @param progress    called about a hundred times from the calling thread, as long as that has
 *                    variants to work on, and at the end; NULL for none
 * @param progress_user handed to progress; borrowed
 * @param out_status  of each variant, length count; NULL to skip. Not written when the arguments
 *                    are refused.
 * @return the status of the lowest variant that failed, TRK_OK if none did
 * @retval TRK_E_ARGUMENT  a pointer is NULL, count < 1, a variant differs in structure from the
 *                         first, or its excitation does not fit (the message names variant and
 *                         part); or there is no such sensor
 * @retval TRK_E_OPTIONS   options come from a newer header and set an unknown field
 * @retval TRK_E_RANGE     an option is out of its range
 * @retval TRK_E_MODEL     the models have no sensor
 * @retval TRK_E_CANCELLED progress returned non-zero (variants that had finished keep TRK_OK),
 *                         or the sink did for the variant named
 * @retval TRK_E_MEMORY    no memory
 * Further errors of a variant as trk_newmark_create() and trk_newmark_step().
 */
TRK_API trk_status trk_batch_run(trk_context *context, int32_t count, const trk_model *const *models,
                                 const trk_excitation *const *excitations,
                                 const trk_newmark_options *newmark,
                                 const trk_batch_options *options, trk_batch_sink sink,
                                 void *sink_user, trk_progress progress, void *progress_user,
                                 trk_status *out_status) TRK_MUST_CHECK;

#endif
