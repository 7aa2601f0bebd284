/* SPDX-License-Identifier: MIT */
/**
 * @file  truckride/study.h
 * @brief Parameter studies: many cases of one vehicle, reduced to a few numbers each, over
 *        threads, machines and interruptions.
 *
 * A study holds a copy of a spec, parameters that act on its links and bodies, a design that
 * gives every case its parameters, roads that every point of the design is driven over, and
 * outputs: numbers taken from the run of a case, a band RMS of a sensor for example. With E
 * roads, case k (counted from 0) is point floor(k / E) of the design on road k mod E + 1.
 *
 * The parameters of a case depend on the seed and the number of the case alone, its outputs
 * on nothing but the case (STUDY.1). So a study may be run in one go, in shards on several
 * machines, or be killed and resumed from its journal: the table is the same, bit for
 * bit, as long as the processors choose the same arithmetic (docs/clusters.md).
 *
 * Memory: per case its outputs and one status; beside that some cases in flight at a time,
 * whose samples are reduced as they come, so that it does not depend on the duration.
 */
#ifndef TRUCKRIDE_STUDY_H
#define TRUCKRIDE_STUDY_H

#include <truckride/batch.h>
#include <truckride/spectrum.h>

/** Variants of a vehicle, what is run on each, and their results. */
typedef struct trk_study trk_study;

/** How the points of a study fill the space of its parameters. */
typedef int32_t trk_design;
enum {
    TRK_DESIGN_FACTORIAL       = 1, /**< every level of every parameter with every other; the last one varies fastest */
    TRK_DESIGN_LATIN_HYPERCUBE = 2, /**< each parameter visits each of n equally probable strata once (STUDY.4) */
    TRK_DESIGN_MONTE_CARLO     = 3  /**< independent points; more cases keep the first ones */
};

/** Options of trk_study_create(). */
typedef struct trk_study_options {
    size_t     struct_size;  /**< [byte] set by trk_study_options_init()                            */
    trk_design design;       /**< [-] default TRK_DESIGN_LATIN_HYPERCUBE                            */
    int32_t    reserved;     /**< [-] must be 0                                                     */
    int64_t    points;       /**< [-] of the design, 1 to 1e12; not used by a factorial; default 100 */
    int64_t    seed;         /**< [-] of the random designs; default 1                              */
    double     duration;     /**< [s] of a run, > 0; default 10                                     */
    double     start;        /**< [s] time at the beginning; default 0                              */
    double     settle;       /**< [s] at the beginning that no output looks at, >= 0; default 0     */
    int64_t    record_every; /**< [-] outputs see each such step, >= 1; default 1                   */
} trk_study_options;

/** Distribution of a parameter, between its bounds. */
typedef int32_t trk_distribution;
enum {
    TRK_DISTRIBUTION_UNIFORM     = 0, /**< even                                                     */
    TRK_DISTRIBUTION_LOG_UNIFORM = 1, /**< the logarithm is even                                    */
    TRK_DISTRIBUTION_NORMAL      = 2, /**< normal with mean and deviation, cut off at the bounds    */
    TRK_DISTRIBUTION_LOG_NORMAL  = 3  /**< the logarithm is normal with mean and deviation, cut off */
};

/** Options of trk_study_add_parameter(). */
typedef struct trk_study_parameter_options {
    size_t           struct_size;  /**< [byte] set by trk_study_parameter_options_init()            */
    trk_distribution distribution; /**< [-] default TRK_DISTRIBUTION_UNIFORM                        */
    trk_meaning      meaning;      /**< [-] default TRK_MEANING_FACTOR                              */
    double           lower;        /**< [- or unit of the value] >= 0, > 0 if logarithmic; default 0.8 */
    double           upper;        /**< [- or unit of the value] > lower, finite; default 1.2       */
    double           mean;         /**< [- or unit of the value] if normal: mean before cutting off; of the logarithm if log-normal; default 1 */
    double           deviation;    /**< [- or unit of the value] if normal: standard deviation > 0, likewise; default 0.1 */
    int32_t          levels;       /**< [-] of a factorial, 1 to 1000000 (STUDY.6); default 3        */
    int32_t          reserved;     /**< [-] must be 0                                               */
} trk_study_parameter_options;

/** What an output takes from the samples of a sensor after settling. */
typedef int32_t trk_output;
enum {
    TRK_OUTPUT_MAXIMUM            = 1,  /**< largest value                                      */
    TRK_OUTPUT_MINIMUM            = 2,  /**< smallest value                                     */
    TRK_OUTPUT_PEAK               = 3,  /**< largest magnitude                                  */
    TRK_OUTPUT_MEAN               = 4,  /**< mean                                               */
    TRK_OUTPUT_RMS                = 5,  /**< root of the mean square                            */
    TRK_OUTPUT_DEVIATION          = 6,  /**< RMS about the mean                                 */
    TRK_OUTPUT_BAND_RMS           = 7,  /**< trk_band_rms() of the PSD                          */
    TRK_OUTPUT_PSD_PEAK_FREQUENCY = 8,  /**< [Hz] of the highest peak of the PSD in the band; NaN if there is none */
    TRK_OUTPUT_PSD_PEAK_HEIGHT    = 9,  /**< PSD there                                          */
    TRK_OUTPUT_WEIGHTED_RMS       = 10  /**< RMS of the PSD times the square of a weight (STUDY.9) */
};

/** Options of trk_study_add_output(). */
typedef struct trk_study_output_options {
    size_t        struct_size; /**< [byte] set by trk_study_output_options_init()                      */
    trk_output    kind;        /**< [-] default TRK_OUTPUT_RMS                                         */
    int32_t       reserved;    /**< [-] must be 0                                                      */
    const char   *sensor;      /**< name of a sensor of the vehicle                                    */
    double        low;         /**< [Hz] band RMS, peaks: lower end of the band, >= 0; default 0       */
    double        high;        /**< [Hz] band RMS, peaks: upper end, > low; default 0: no end          */
    int64_t       count;       /**< [-] weighted RMS: points of the weight, >= 1                       */
    const double *frequency;   /**< [Hz] weighted RMS: > 0, rising, length count; copied               */
    const double *weight;      /**< [-] weighted RMS: > 0, length count; straight in the logarithms between the points, 0 outside; copied */
} trk_study_output_options;

/** Options of trk_study_run(). */
typedef struct trk_study_run_options {
    size_t  struct_size; /**< [byte] set by trk_study_run_options_init()                              */
    int32_t threads;     /**< [-] most threads at work, >= 1; default 1                               */
    int32_t chunk;       /**< [-] cases computed together, >= 1; default 0: 16 a thread, fewer if their
                              reductions would take more than 128 MiB                                */
    int32_t shard;       /**< [-] part of the study to run, 1 to shards: the cases k with k mod shards = shard - 1; default 1 */
    int32_t shards;      /**< [-] >= 1; default 1: all of it                                          */
} trk_study_run_options;

/** Set every field to its default. Call as trk_X_options_init(&o, sizeof o). */
TRK_API void trk_study_options_init(trk_study_options *options, size_t struct_size);
TRK_API void trk_study_parameter_options_init(trk_study_parameter_options *options, size_t struct_size);
TRK_API void trk_study_output_options_init(trk_study_output_options *options, size_t struct_size);
TRK_API void trk_study_run_options_init(trk_study_run_options *options, size_t struct_size);

/**
 * Create a study without parameters, roads and outputs.
 *
 * @param spec      copied; factors refer to its values
 * @param model     how its models are compiled; NULL for no gravity
 * @param options   NULL for 100 points of a Latin hypercube, 10 s each
 * @param out_study owned by caller; NULL on failure
 * @retval TRK_E_ARGUMENT a pointer is NULL, or there is no such design
 * @retval TRK_E_OPTIONS  options come from a newer header and set an unknown field
 * @retval TRK_E_RANGE    an option is out of its range
 * Further errors as trk_model_compile() with the spec as given.
 */
TRK_API trk_status trk_study_create(trk_context *context, const trk_spec *spec,
                                    const trk_model_options *model,
                                    const trk_study_options *options,
                                    trk_study **out_study) TRK_MUST_CHECK;

/** Free a study; an open journal is closed. NULL is allowed. */
TRK_API void trk_study_destroy(trk_study *study);

/*
 * The functions from here to trk_study_add_excitation() change what the study is: they drop
 * results computed so far, and are refused (TRK_E_ARGUMENT) while a journal is open.
 */

/**
 * Choose how runs are integrated and how PSDs are estimated; without, the defaults of
 * both. A PSD needs TRK_SCALING_DENSITY. Errors as trk_newmark_create() and trk_psd() name
 * them may also appear only when the study is run.
 *
 * @param options copied; NULL for the defaults
 * @retval TRK_E_ARGUMENT study is NULL, the scaling is another, or a journal is open
 * @retval TRK_E_OPTIONS  options come from a newer header and set an unknown field
 */
TRK_API trk_status trk_study_set_newmark(trk_study *study,
                                         const trk_newmark_options *options) TRK_MUST_CHECK;
TRK_API trk_status trk_study_set_spectrum(trk_study *study,
                                          const trk_spectrum_options *options) TRK_MUST_CHECK;

/**
 * Add a parameter. It does nothing until trk_study_act_on().
 *
 * @param name          for the table; not empty, not used by another parameter; copied
 * @param options       NULL for a factor, even from 0.8 to 1.2
 * @param out_parameter receives the id; NULL to skip
 * @retval TRK_E_ARGUMENT study is NULL, an option has an unknown value, or a journal is open
 * @retval TRK_E_OPTIONS  options come from a newer header and set an unknown field
 * @retval TRK_E_RANGE    an option is out of its range, nothing of the distribution lies
 *                        between the bounds, or the design has more than 1e12 points
 * @retval TRK_E_NAME     the name is empty or taken
 * @retval TRK_E_MEMORY   no memory
 */
TRK_API trk_status trk_study_add_parameter(trk_study *study, const char *name,
                                           const trk_study_parameter_options *options,
                                           int32_t *out_parameter) TRK_MUST_CHECK;

/**
 * Let a parameter p act: value = p^power times the value of the spec, or, with
 * TRK_MEANING_VALUE, value = p^power. Several calls tie several parts to one parameter.
 * Arguments and errors as trk_calibration_act_on().
 *
 * @param parameter id
 * @param pattern   name of the link or body; '*' stands for any text: "front_*_tire"
 * @param power     [-] finite, not 0; 1 is usual
 * @param out_count receives the number of parts that matched; NULL to skip
 * @retval TRK_E_ARGUMENT a pointer is NULL, there is no such parameter or field, or a journal is open
 * @retval TRK_E_RANGE    power is 0 or not finite
 * @retval TRK_E_NAME     nothing matches the pattern
 * @retval TRK_E_MODEL    a part that matches is already acted on in this field, or has nothing
 *                        there to scale or, with TRK_MEANING_VALUE, not one number to replace
 * @retval TRK_E_MEMORY   no memory
 */
TRK_API trk_status trk_study_act_on(trk_study *study, int32_t parameter, trk_field field,
                                    const char *pattern, double power,
                                    int32_t *out_count) TRK_MUST_CHECK;

/**
 * Add an output.
 *
 * @param name       for the table; not empty, not used by another output; copied
 * @param options    the sensor must be given
 * @param out_output receives the id; NULL to skip
 * @retval TRK_E_ARGUMENT a pointer is NULL, an unknown kind, what the kind needs is missing, or
 *                        a journal is open
 * @retval TRK_E_OPTIONS  options come from a newer header and set an unknown field
 * @retval TRK_E_RANGE    an option is out of its range
 * @retval TRK_E_NAME     the name is empty or taken, or there is no such sensor
 * @retval TRK_E_MEMORY   no memory
 */
TRK_API trk_status trk_study_add_output(trk_study *study, const char *name,
                                        const trk_study_output_options *options,
                                        int32_t *out_output) TRK_MUST_CHECK;

/**
 * Add a road that every point of the design is driven over.
 *
 * @param name           for the table; not empty, not used by another road; copied
 * @param excitation     borrowed, with its signals; must not change any more
 * @param out_excitation receives the id; NULL to skip
 * @retval TRK_E_ARGUMENT a pointer is NULL, the excitation does not fit the vehicle, or a
 *                        journal is open
 * @retval TRK_E_RANGE    the study would have more than 1e12 cases
 * @retval TRK_E_NAME     the name is empty or taken
 * @retval TRK_E_MEMORY   no memory
 */
TRK_API trk_status trk_study_add_excitation(trk_study *study, const char *name,
                                            const trk_excitation *excitation,
                                            int32_t *out_excitation) TRK_MUST_CHECK;

/** Kinds of named parts of a study. */
typedef int32_t trk_study_part;
enum {
    TRK_STUDY_PARAMETER  = 1, /**< parameter           */
    TRK_STUDY_OUTPUT     = 2, /**< output              */
    TRK_STUDY_EXCITATION = 3  /**< road, an excitation */
};

/** Number of parts of a kind; 0 for an unknown kind. */
TRK_API int32_t trk_study_count(const trk_study *study, trk_study_part part);

/** Name of a part, NULL if there is none; owned by the study. */
TRK_API const char *trk_study_part_name(const trk_study *study, trk_study_part part, int32_t id);

/** Unit of an output, "m/s^2" or "(m/s^2)^2/Hz"; NULL if there is none; owned by the study. */
TRK_API const char *trk_study_output_unit(const trk_study *study, int32_t output);

/** Number of cases: points of the design times roads (at least 1). */
TRK_API int64_t trk_study_cases(const trk_study *study);

/**
 * Parameters and road of a case (STUDY.1 to STUDY.6).
 *
 * @param number         of the case, 0 to trk_study_cases() - 1
 * @param out_parameters [- or unit of the value] length parameters; NULL to skip
 * @param out_excitation id of the road, 0 if there is none yet; NULL to skip
 * @retval TRK_E_ARGUMENT study is NULL or there is no such case
 */
TRK_API trk_status trk_study_get_case(const trk_study *study, int64_t number,
                                      double *out_parameters,
                                      int32_t *out_excitation) TRK_MUST_CHECK;

/**
 * Number that tells this study from others: it covers version, spec, options, parameters,
 * roads sample by sample, outputs and, unless the design is Monte Carlo, the number of points.
 *
 * @param out_fingerprint any bits
 * Errors as trk_study_run().
 */
TRK_API trk_status trk_study_get_fingerprint(trk_study *study,
                                             int64_t *out_fingerprint) TRK_MUST_CHECK;

/**
 * Run all cases of a shard that are not finished. A case that fails, because its model is not
 * valid or its motion does not converge, is finished with that status and NaN outputs, and the
 * others go on; the context's log hears why.
 *
 * @param options  NULL for all cases on one thread
 * @param progress called now and then with the fraction of these cases; NULL for none
 * @param user     handed to progress; borrowed
 * @retval TRK_E_ARGUMENT  study is NULL; it has no road or no output; or a parameter acts on nothing
 * @retval TRK_E_OPTIONS   options come from a newer header and set an unknown field
 * @retval TRK_E_RANGE     an option is out of its range, settling takes the whole run, or what is
 *                         left is shorter than a segment of the PSD
 * @retval TRK_E_CANCELLED progress returned non-zero; finished cases are kept
 * @retval TRK_E_FILE      the journal cannot be written; the cases are kept in memory
 * @retval TRK_E_MEMORY    no memory; finished cases are kept
 * Further errors as trk_batch_run().
 */
TRK_API trk_status trk_study_run(trk_study *study, const trk_study_run_options *options,
                                 trk_progress progress, void *user) TRK_MUST_CHECK;

/**
 * Run given cases, those that are finished left out: for schedulers of the caller.
 *
 * @param count   [-] >= 0
 * @param numbers of the cases, length count
 * @param options shard and shards are not used; NULL for one thread
 * @retval TRK_E_ARGUMENT there is no such case, or count < 0
 * Further arguments and errors as trk_study_run().
 */
TRK_API trk_status trk_study_run_cases(trk_study *study, int64_t count, const int64_t *numbers,
                                       const trk_study_run_options *options,
                                       trk_progress progress, void *user) TRK_MUST_CHECK;

/**
 * Hand in the result of a case computed elsewhere by the same study, as
 * trk_study_get_outputs() gave it there. It goes into the journal, too.
 *
 * @param number  of the case
 * @param status  of the case
 * @param values  [unit of the output] length outputs
 * @retval TRK_E_ARGUMENT a pointer is NULL, there is no such case, the status is none that a case can
 *                        have, or the case is finished with other values
 * @retval TRK_E_FILE     the journal cannot be written
 * Further errors as trk_study_run().
 */
TRK_API trk_status trk_study_set_outputs(trk_study *study, int64_t number, trk_status status,
                                         const double *values) TRK_MUST_CHECK;

/** Number of finished cases. */
TRK_API int64_t trk_study_finished(const trk_study *study);

/** 1 if the case is finished, else 0. */
TRK_API int32_t trk_study_is_finished(const trk_study *study, int64_t number);

/**
 * Outputs of a finished case.
 *
 * @param number     of the case
 * @param out_values [unit of the output] length outputs, NaN if it failed; NULL to skip
 * @param out_status of the case; NULL to skip
 * @retval TRK_E_ARGUMENT study is NULL, there is no such case, or it is not finished
 */
TRK_API trk_status trk_study_get_outputs(const trk_study *study, int64_t number,
                                         double *out_values, trk_status *out_status) TRK_MUST_CHECK;

/**
 * Keep finished cases in a file from now on: one line a case with a checksum (STUDY.10),
 * written after every chunk. Cases that the file holds already are taken from it; damaged
 * lines at its end, as a killed process leaves them, are cut off. A new file gets the cases
 * finished so far. The file is locked against a second process.
 *
 * @param path file; copied
 * @retval TRK_E_ARGUMENT a pointer is NULL, a journal is open, the file belongs to another
 *                        study, or to a larger Monte Carlo study
 * @retval TRK_E_SYNTAX   the file is no journal, or is damaged before its end; the message
 *                        names the line
 * @retval TRK_E_FILE     it cannot be read or written, or another process uses it
 * Further errors as trk_study_run().
 */
TRK_API trk_status trk_study_open_journal(trk_study *study, const char *path) TRK_MUST_CHECK;

/** Close the journal, if any. @retval TRK_E_ARGUMENT study is NULL @retval TRK_E_FILE its last
 *  lines could not be written */
TRK_API trk_status trk_study_close_journal(trk_study *study) TRK_MUST_CHECK;

/**
 * Take the cases from a journal, e.g. of a shard, and leave the file as it is. Several may be
 * loaded, in any order; what was read before a failure stays.
 *
 * @retval TRK_E_ARGUMENT a pointer is NULL, or the file belongs to another study
 * @retval TRK_E_SYNTAX   the file is no journal, is damaged before its end, or gives a case
 *                        another result than it has
 * @retval TRK_E_FILE     it cannot be read
 * Further errors as trk_study_run().
 */
TRK_API trk_status trk_study_load(trk_study *study, const char *path) TRK_MUST_CHECK;

/**
 * Write a table of the finished cases (CSV, RFC 4180): case, road, parameters, outputs with
 * their units, status; 17 digits, so that every number reads back as it was.
 *
 * @param path is replaced
 * @retval TRK_E_ARGUMENT a pointer is NULL
 * @retval TRK_E_FILE     it cannot be written
 * @retval TRK_E_MEMORY   no memory
 */
TRK_API trk_status trk_study_write_csv(trk_study *study, const char *path) TRK_MUST_CHECK;

#endif
