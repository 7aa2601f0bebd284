/* SPDX-License-Identifier: MIT */
/* A study as a whole: create, destroy, names, settings. */
#include "study/study.h"

#include <math.h>
#include <string.h>

static const trk_study_options defaults = {.struct_size = sizeof defaults,
                                           .design = TRK_DESIGN_LATIN_HYPERCUBE,
                                           .points = 100,
                                           .seed = 1,
                                           .duration = 10,
                                           .record_every = 1};

void trk_study_options_init(trk_study_options *options, size_t struct_size)
{
    trk_write_defaults(options, struct_size, &defaults, sizeof defaults);
}

static trk_status check(trk_context *context, const trk_study_options *o)
{
    static const char what[] = "trk_study_options";
    if (o->design < TRK_DESIGN_FACTORIAL || o->design > TRK_DESIGN_MONTE_CARLO || o->reserved)
        return trk_fail(context, TRK_E_ARGUMENT,
                        "%s: design is %d, expected 1 to 3; reserved is %d, expected 0", what,
                        o->design, o->reserved);
    if (o->design != TRK_DESIGN_FACTORIAL && (o->points < 1 || o->points > TRK_MOST_CASES))
        return trk_fail(context, TRK_E_RANGE, "%s: points is %lld, expected 1 to 1e12", what,
                        (long long)o->points);
    if (!(o->duration > 0 && isfinite(o->duration)))
        return trk_fail(context, TRK_E_RANGE, "%s: duration is %g s, expected > 0 and finite", what,
                        o->duration);
    if (!isfinite(o->start))
        return trk_fail(context, TRK_E_RANGE, "%s: start is %g s, expected a finite number", what,
                        o->start);
    if (!(o->settle >= 0 && o->settle < o->duration))
        return trk_fail(context, TRK_E_RANGE,
                        "%s: settle is %g s, expected 0 to less than the duration of %g s", what,
                        o->settle, o->duration);
    if (o->record_every < 1)
        return trk_fail(context, TRK_E_RANGE, "%s: record_every is %lld, expected >= 1", what,
                        (long long)o->record_every);
    return TRK_OK;
}

static trk_status fill(trk_study *study, const trk_spec *spec, const trk_model_options *model,
                       const trk_study_options *options)
{
    trk_context *context = study->context;
    study->options = defaults;
    trk_model_options_init(&study->model_options, sizeof study->model_options);
    trk_newmark_options_init(&study->newmark, sizeof study->newmark);
    trk_spectrum_options_init(&study->spectrum, sizeof study->spectrum);
    trk_status status = trk_read_options(context, "trk_study_options", options, &study->options,
                                         sizeof study->options);
    if (status == TRK_OK)
        status = check(context, &study->options);
    if (status == TRK_OK)
        status = trk_read_options(context, "trk_model_options", model, &study->model_options,
                                  sizeof study->model_options);
    if (status == TRK_OK)
        status = trk_spec_copy(context, spec, &study->base);
    if (status == TRK_OK)
        status = trk_spec_copy(context, spec, &study->work);
    if (status == TRK_OK)
        status = trk_model_compile(context, spec, &study->model_options, &study->model);
    study->points = study->options.design == TRK_DESIGN_FACTORIAL ? 1 : study->options.points;
    return status;
}

trk_status trk_study_create(trk_context *context, const trk_spec *spec,
                            const trk_model_options *model, const trk_study_options *options,
                            trk_study **out_study)
{
    TRK_REQUIRE(context, out_study, "trk_study_create");
    *out_study = NULL;
    TRK_REQUIRE(context, context, "trk_study_create");
    TRK_REQUIRE(context, spec, "trk_study_create");
    trk_study *study = trk_new(context, 1, sizeof *study);
    if (!study)
        return TRK_E_MEMORY;
    study->context = context;
    trk_status status = fill(study, spec, model, options);
    if (status != TRK_OK) {
        trk_study_destroy(study);
        return status;
    }
    *out_study = study;
    return TRK_OK;
}

void trk_study_destroy(trk_study *study)
{
    if (!study)
        return;
    trk_context *context = study->context;
    (void)!trk_study_close_journal(study);
    trk_study_unready(study);
    for (int32_t k = 0; k < trk_study_outputs(study); k++) {
        trk_free(context, (double *)study->outputs[k].options.frequency);
        trk_free(context, (double *)study->outputs[k].options.weight);
        trk_free(context, study->outputs[k].unit);
    }
    trk_free(context, study->parameters);
    trk_free(context, study->outputs);
    trk_free(context, study->excitations);
    trk_free(context, study->actions);
    for (trk_study_part part = 1; part <= TRK_STUDY_PARTS; part++)
        trk_names_clear(context, &study->names[part]);
    trk_model_destroy(study->model);
    trk_spec_destroy(study->work);
    trk_spec_destroy(study->base);
    trk_free(context, study);
}

trk_status trk_study_change(trk_study *study, const char *function)
{
    if (study->journal.file)
        return trk_fail(study->context, TRK_E_ARGUMENT,
                        "%s: the study cannot change while its journal %s is open", function,
                        study->journal.path);
    trk_study_unready(study);
    return TRK_OK;
}

trk_status trk_study_set_newmark(trk_study *study, const trk_newmark_options *options)
{
    TRK_REQUIRE(NULL, study, "trk_study_set_newmark");
    trk_newmark_options o;
    trk_newmark_options_init(&o, sizeof o);
    trk_status status =
        trk_read_options(study->context, "trk_newmark_options", options, &o, sizeof o);
    if (status == TRK_OK)
        status = trk_study_change(study, "trk_study_set_newmark");
    if (status == TRK_OK)
        study->newmark = o;
    return status;
}

trk_status trk_study_set_spectrum(trk_study *study, const trk_spectrum_options *options)
{
    TRK_REQUIRE(NULL, study, "trk_study_set_spectrum");
    trk_spectrum_options o;
    trk_spectrum_options_init(&o, sizeof o);
    trk_status status =
        trk_read_options(study->context, "trk_spectrum_options", options, &o, sizeof o);
    if (status == TRK_OK && o.scaling != TRK_SCALING_DENSITY)
        status = trk_fail(study->context, TRK_E_ARGUMENT,
                          "trk_study_set_spectrum: scaling is %d, expected TRK_SCALING_DENSITY",
                          o.scaling);
    if (status == TRK_OK)
        status = trk_study_change(study, "trk_study_set_spectrum");
    if (status == TRK_OK)
        study->spectrum = o;
    return status;
}

trk_status trk_study_append(trk_study *study, trk_study_part part, const char *name, void **array,
                            size_t element_size)
{
    static const char *const words[] = {"part", "parameter", "output", "road"};
    trk_names *names = &study->names[part];
    if (names->count == TRK_MOST_PARTS)
        return trk_fail(study->context, TRK_E_RANGE, "a study has at most %d %ss",
                        (int)TRK_MOST_PARTS, words[part]);
    trk_status status = trk_grow(study->context, array, &study->capacity[part],
                                 (int64_t)names->count + 1, element_size);
    if (status == TRK_OK)
        status = trk_names_add(study->context, names, words[part], name);
    if (status == TRK_OK)
        memset((char *)*array + (size_t)(names->count - 1) * element_size, 0, element_size);
    return status;
}

int32_t trk_study_count(const trk_study *study, trk_study_part part)
{
    return study && part >= 1 && part <= TRK_STUDY_PARTS ? study->names[part].count : 0;
}

const char *trk_study_part_name(const trk_study *study, trk_study_part part, int32_t id)
{
    return study && part >= 1 && part <= TRK_STUDY_PARTS ? trk_names_text(&study->names[part], id)
                                                         : NULL;
}
