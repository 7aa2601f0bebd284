/* SPDX-License-Identifier: MIT */
/* Outputs and roads of a study. */
#include "study/study.h"

#include <math.h>
#include <string.h>

static const trk_study_output_options defaults = {.struct_size = sizeof defaults,
                                                  .kind = TRK_OUTPUT_RMS};

void trk_study_output_options_init(trk_study_output_options *options, size_t struct_size)
{
    trk_write_defaults(options, struct_size, &defaults, sizeof defaults);
}

static trk_status check_weight(trk_context *context, const char *name,
                               const trk_study_output_options *o)
{
    if (o->count < 1 || !o->frequency || !o->weight)
        return trk_fail(context, TRK_E_ARGUMENT,
                        "output '%s': a weighted RMS needs frequency and weight, count >= 1", name);
    for (int64_t k = 0; k < o->count; k++)
        if (!(o->frequency[k] > (k ? o->frequency[k - 1] : 0) && isfinite(o->frequency[k]) &&
              o->weight[k] > 0 && isfinite(o->weight[k])))
            return trk_fail(context, TRK_E_RANGE,
                            "output '%s': point %lld of the weight is %g at %g Hz, expected > 0 at "
                            "rising frequencies > 0",
                            name, (long long)k, o->weight[k], o->frequency[k]);
    return TRK_OK;
}

static trk_status check(const trk_study *study, const char *name, const trk_study_output_options *o)
{
    trk_context *context = study->context;
    if (o->kind < TRK_OUTPUT_MAXIMUM || o->kind > TRK_OUTPUT_WEIGHTED_RMS || o->reserved)
        return trk_fail(context, TRK_E_ARGUMENT,
                        "output '%s': kind is %d, expected 1 to %d; reserved is %d, expected 0",
                        name, o->kind, (int)TRK_OUTPUT_WEIGHTED_RMS, o->reserved);
    if (!o->sensor)
        return trk_fail(context, TRK_E_ARGUMENT, "output '%s': the sensor is not given", name);
    if (!trk_model_find(study->model, TRK_PART_SENSOR, o->sensor))
        return trk_fail(context, TRK_E_NAME, "output '%s': '%s' has no sensor '%s'", name,
                        trk_model_name(study->model), o->sensor);
    if (!(o->low >= 0 && isfinite(o->low) && isfinite(o->high) &&
          (o->high == 0 || o->high > o->low)))
        return trk_fail(context, TRK_E_RANGE,
                        "output '%s': band is %g to %g Hz, expected 0 <= low < high, or high 0",
                        name, o->low, o->high);
    return o->kind == TRK_OUTPUT_WEIGHTED_RMS ? check_weight(context, name, o) : TRK_OK;
}

/* "m/s^2", "Hz" or "(m/s^2)^2/Hz" */
static char *unit_of(const trk_study *study, const trk_design_output *output)
{
    const char *unit = trk_model_unit(study->model, TRK_PART_SENSOR, output->sensor);
    const trk_output kind = output->options.kind;
    const char *format = kind == TRK_OUTPUT_PSD_PEAK_FREQUENCY ? "Hz"
                         : kind != TRK_OUTPUT_PSD_PEAK_HEIGHT  ? "%s"
                         : strpbrk(unit, "/ ^")                ? "(%s)^2/Hz"
                                                               : "%s^2/Hz";
    const char *place = strstr(format, "%s");
    const size_t before = place ? (size_t)(place - format) : strlen(format);
    char text[96];
    trk_format(text, sizeof text, "%.*s%s%s", (int)before, format, place ? unit : "",
               place ? place + 2 : "");
    return trk_copy_text(study->context, text);
}

static double *copy_numbers(trk_context *context, int64_t count, const double *numbers)
{
    double *copy = trk_new(context, count, sizeof *copy);
    if (copy)
        memcpy(copy, numbers, (size_t)count * sizeof *copy);
    return copy;
}

static void clear(trk_context *context, trk_design_output *output)
{
    trk_free(context, (double *)output->options.frequency);
    trk_free(context, (double *)output->options.weight);
    trk_free(context, output->unit);
}

/* What the output owns. */
static trk_status fill(const trk_study *study, const trk_study_output_options *o,
                       trk_design_output *out)
{
    *out = (trk_design_output){.options = *o};
    out->sensor = trk_model_find(study->model, TRK_PART_SENSOR, o->sensor);
    out->options.sensor = NULL;
    out->options.frequency = out->options.weight = NULL;
    out->unit = unit_of(study, out);
    bool complete = out->unit != NULL;
    if (complete && o->kind == TRK_OUTPUT_WEIGHTED_RMS) {
        out->options.frequency = copy_numbers(study->context, o->count, o->frequency);
        out->options.weight = copy_numbers(study->context, o->count, o->weight);
        complete = out->options.frequency && out->options.weight;
    }
    if (complete)
        return TRK_OK;
    clear(study->context, out);
    return TRK_E_MEMORY;
}

trk_status trk_study_add_output(trk_study *study, const char *name,
                                const trk_study_output_options *options, int32_t *out_output)
{
    TRK_REQUIRE(NULL, study, "trk_study_add_output");
    trk_context *context = study->context;
    TRK_REQUIRE(context, options, "trk_study_add_output");
    trk_study_output_options o = defaults;
    trk_design_output output;
    trk_status status =
        trk_read_options(context, "trk_study_output_options", options, &o, sizeof o);
    if (status == TRK_OK)
        status = check(study, name ? name : "", &o);
    if (status == TRK_OK)
        status = trk_study_change(study, "trk_study_add_output");
    if (status == TRK_OK)
        status = fill(study, &o, &output);
    if (status != TRK_OK)
        return status;
    status =
        trk_study_append(study, TRK_STUDY_OUTPUT, name, (void **)&study->outputs, sizeof output);
    if (status != TRK_OK) {
        clear(context, &output);
        return status;
    }
    study->outputs[trk_study_outputs(study) - 1] = output;
    if (out_output)
        *out_output = trk_study_outputs(study);
    return TRK_OK;
}

const char *trk_study_output_unit(const trk_study *study, int32_t output)
{
    return output >= 1 && output <= trk_study_count(study, TRK_STUDY_OUTPUT)
               ? study->outputs[output - 1].unit
               : NULL;
}

trk_status trk_study_add_excitation(trk_study *study, const char *name,
                                    const trk_excitation *excitation, int32_t *out_excitation)
{
    static const char what[] = "trk_study_add_excitation";
    TRK_REQUIRE(NULL, study, "trk_study_add_excitation");
    trk_context *context = study->context;
    TRK_REQUIRE(context, excitation, "trk_study_add_excitation");
    const int32_t roads = trk_model_count(study->model, TRK_PART_ROAD),
                  ports = trk_model_count(study->model, TRK_PART_PORT),
                  count = trk_study_count(study, TRK_STUDY_EXCITATION);
    if (trk_excitation_roads(excitation) != roads || trk_excitation_ports(excitation) != ports)
        return trk_fail(
            context, TRK_E_ARGUMENT, "%s: '%s' has %d roads and %d ports, '%s' %d and %d", what,
            name ? name : "", trk_excitation_roads(excitation), trk_excitation_ports(excitation),
            trk_model_name(study->model), roads, ports);
    if (study->points > TRK_MOST_CASES / (count + 1))
        return trk_fail(context, TRK_E_RANGE,
                        "%s: with %d roads the study has more than 1e12 cases", what, count + 1);
    trk_status status = trk_study_change(study, what);
    if (status == TRK_OK)
        status = trk_study_append(study, TRK_STUDY_EXCITATION, name, (void **)&study->excitations,
                                  sizeof excitation);
    if (status != TRK_OK)
        return status;
    study->excitations[count] = excitation;
    if (out_excitation)
        *out_excitation = count + 1;
    return TRK_OK;
}
