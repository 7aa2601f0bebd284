/* SPDX-License-Identifier: MIT */
/*
 * Inside of a study. What it is: spec, parameters, roads, outputs (create.c, parameter.c,
 * output.c). Before the first case it is made ready (ready.c): counted, fingerprinted, room for
 * the results. A case is: its point of the design (design.c), its spec and model (point.c), its run
 * reduced on the fly (reduce.c), its outputs (results.c), its line in the journal (journal.c).
 */
#ifndef TRK_STUDY_STUDY_H
#define TRK_STUDY_STUDY_H

#include "base/names.h"
#include "spectrum/welch.h"
#include <truckride/study.h>

#include <stdio.h>

enum { TRK_STUDY_PARTS = TRK_STUDY_EXCITATION, TRK_MOST_PARTS = 4096 };

#define TRK_MOST_CASES INT64_C(1000000000000)

typedef struct trk_design_parameter {
    trk_study_parameter_options options;
    double first, last; /* probabilities at the bounds, if (log-)normal       */
    double sign;        /* -1: of the mirror image, so that both are small     */
    int32_t actions;    /* that belong to it                                  */
} trk_design_parameter;

/* One field of one part that a parameter acts on. */
typedef struct trk_action {
    int32_t parameter; /* 0-based            */
    trk_field field;
    int32_t part; /* id of the link or body */
    double power;
} trk_action;

typedef struct trk_design_output {
    trk_study_output_options options; /* arrays owned, sensor NULL                  */
    int32_t sensor;                   /* id                                         */
    int32_t channel;                  /* of trk_study.channels, once ready          */
    double *gain;                     /* weighted RMS, once ready: square of the weight by bin */
    char *unit;
} trk_design_output;

/* A sensor that outputs look at. */
typedef struct trk_channel {
    int32_t sensor; /* id                  */
    bool psd;       /* some output wants it */
} trk_channel;

typedef struct trk_journal {
    FILE *file; /* NULL: none is open */
    char *path;
    char *line;  /* room for one      */
    bool broken; /* a write failed: what follows would stand behind a torn line */
} trk_journal;

struct trk_study {
    trk_context *context;
    trk_spec *base, *work; /* as given; with the parameters of the last case */
    trk_model_options model_options;
    trk_model *model; /* of the base spec: names, units, counts           */
    trk_study_options options;
    trk_newmark_options newmark;
    trk_spectrum_options spectrum;
    trk_names names[TRK_STUDY_PARTS + 1]; /* by trk_study_part; [0] is empty */
    int64_t capacity[TRK_STUDY_PARTS + 1];
    trk_design_parameter *parameters;
    trk_design_output *outputs;
    const trk_excitation **excitations; /* borrowed */
    trk_action *actions;
    int32_t action_count;
    int64_t action_capacity;
    int64_t points; /* of the design */
    /* Once ready. */
    bool ready;
    uint64_t fingerprint;
    double sample_rate;       /* [Hz] of the recorded samples            */
    int64_t skipped, samples; /* recorded while settling; after it       */
    trk_channel *channels;
    int32_t channel_count;
    bool psd;
    trk_welch_plan plan; /* if psd */
    double *values;      /* cases x outputs                         */
    int32_t *state;      /* of each case: 0, or its status + 1 once finished */
    int64_t finished;
    trk_journal journal;
};

static inline int32_t trk_study_parameters(const trk_study *study)
{
    return study->names[TRK_STUDY_PARAMETER].count;
}

static inline int32_t trk_study_outputs(const trk_study *study)
{
    return study->names[TRK_STUDY_OUTPUT].count;
}

/* May the study change? Then its results are dropped. */
trk_status trk_study_change(trk_study *study, const char *function);

/* Free all that is there once ready. */
void trk_study_unready(trk_study *study);

/* Make it ready, if it is not. */
trk_status trk_study_prepare(trk_study *study, const char *function);

/* Everything that determines the results (STUDY.10). */
trk_status trk_study_hash(trk_study *study, uint64_t *out_fingerprint);

/* Add a part: name, and room for it in *array, zeroed. Nothing may fail afterwards. */
trk_status trk_study_append(trk_study *study, trk_study_part part, const char *name, void **array,
                            size_t element_size);

/* TRK_E_ARGUMENT unless there is such a case. */
trk_status trk_study_check_case(const trk_study *study, const char *function, int64_t number);

/* Value of a parameter (0-based) at probability u, 0 <= u <= 1 (STUDY.5). */
double trk_study_quantile(const trk_design_parameter *parameter, double u);

/* Parameters of a point of the design. */
void trk_study_point(const trk_study *study, int64_t point, double *out_parameters);

/* Compile the model of a case; the caller destroys it. `parameters` is scratch. */
trk_status trk_study_compile(trk_study *study, int64_t number, double *parameters,
                             trk_model **out_model);

/* Is it a status that a single case can end with, while the study goes on? */
bool trk_study_is_outcome(trk_status status);

/* Keep the result of a case; values NULL if it failed. In memory only. */
void trk_study_store(trk_study *study, int64_t number, trk_status status, const double *values);

/* Does the case stand with exactly this result? */
bool trk_study_agrees(const trk_study *study, int64_t number, trk_status status,
                      const double *values);

/* Append a finished case to the journal, if one is open; and bring what was appended to the
 * system. TRK_E_FILE: it cannot be written. */
trk_status trk_journal_append(trk_study *study, int64_t number);
trk_status trk_journal_flush(trk_study *study);

#endif
