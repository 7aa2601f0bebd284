/* SPDX-License-Identifier: MIT */
/* Steady spectra of an excitation by Welch's method on its inputs (LINEAR.11). */
#include "linear/random.h"

#include <math.h>
#include <string.h>

/* One call. */
typedef struct task {
    trk_context *context;
    const trk_excitation *excitation;
    double start, step;
    int64_t samples, length;
    const trk_spectrum_options *options;
    int32_t roads, ports, inputs;
    double *rows;      /* heights, then loads, as the excitation gives them            */
    double *sample;    /* inputs x samples                                             */
    int32_t *first;    /* by input: the first input with the same samples, -1: all zero */
    double *frequency; /* length                                                       */
    double *cross;     /* length complex numbers                                       */
    double *input;     /* length x inputs x inputs complex numbers                     */
} task;

static void take_samples(task *t)
{
    double *height = t->rows, *load = t->rows + t->samples * t->roads;
    trk_excitation_evaluate(t->excitation, t->samples, t->start, t->step, height, NULL, load);
    for (int64_t k = 0; k < t->samples; k++) {
        for (int32_t j = 0; j < t->roads; j++)
            t->sample[j * t->samples + k] = height[k * t->roads + j];
        for (int32_t j = 0; j < t->ports; j++)
            t->sample[(t->roads + j) * t->samples + k] = load[k * t->ports + j];
    }
}

/* Wheels of one axle often do the same, and most ports nothing: each spectrum once. */
static void find_copies(task *t)
{
    size_t size = (size_t)t->samples * sizeof(double);
    for (int32_t j = 0; j < t->inputs; j++) {
        const double *x = t->sample + j * t->samples;
        bool zero = true;
        for (int64_t k = 0; zero && k < t->samples; k++)
            zero = x[k] == 0;
        t->first[j] = zero ? -1 : 0;
        while (!zero && memcmp(t->sample + t->first[j] * t->samples, x, size) != 0)
            t->first[j]++;
    }
}

/* The cross spectrum of two inputs into all entries it belongs to. */
static trk_status fill(task *t, int32_t i, int32_t j)
{
    trk_status status = trk_csd(t->context, t->samples, t->sample + i * t->samples,
                                t->sample + j * t->samples, 1 / t->step, t->options, t->cross);
    for (int32_t a = 0; status == TRK_OK && a < t->inputs; a++)
        for (int32_t b = 0; b < t->inputs; b++)
            for (int64_t k = 0; k < t->length; k++) {
                double *entry = t->input + 2 * ((k * t->inputs + a) * t->inputs + b);
                bool straight = t->first[a] == i && t->first[b] == j;
                if (!straight && !(t->first[a] == j && t->first[b] == i))
                    break;
                entry[0] = t->cross[2 * k];
                entry[1] = straight ? t->cross[2 * k + 1] : -t->cross[2 * k + 1];
            }
    return status;
}

static trk_status find_spectra(task *t)
{
    take_samples(t);
    find_copies(t);
    trk_status status =
        trk_psd_frequencies(t->context, t->samples, 1 / t->step, t->options, t->frequency);
    for (int32_t i = 0; status == TRK_OK && i < t->inputs; i++)
        for (int32_t j = i; status == TRK_OK && j < t->inputs; j++)
            if (t->first[i] == i && t->first[j] == j)
                status = fill(t, i, j);
    return status;
}

static trk_status check(const task *t, const trk_model *model)
{
    if (trk_model_count(model, TRK_PART_ROAD) != t->roads ||
        trk_model_count(model, TRK_PART_PORT) != t->ports)
        return trk_fail(t->context, TRK_E_ARGUMENT,
                        "%s: the excitation has %d roads and %d ports, the model %d and %d",
                        trk_model_name(model), t->roads, t->ports,
                        trk_model_count(model, TRK_PART_ROAD),
                        trk_model_count(model, TRK_PART_PORT));
    if (!isfinite(t->start) || !isfinite(t->step) || t->step <= 0)
        return trk_fail(t->context, TRK_E_RANGE,
                        "trk_response_psd_excited: start is %g s and step %g s; finite numbers, "
                        "the step > 0, are needed",
                        t->start, t->step);
    return TRK_OK;
}

static trk_status allocate(task *t)
{
    int64_t inputs = t->inputs;
    if (inputs > 0 && t->samples > INT64_MAX / (2 * inputs * inputs))
        return trk_fail(t->context, TRK_E_MEMORY,
                        "trk_response_psd_excited: %lld samples of %lld inputs exceed the address "
                        "space",
                        (long long)t->samples, (long long)inputs);
    t->rows = trk_new(t->context, t->samples * inputs, sizeof(double));
    t->sample = trk_new(t->context, t->samples * inputs, sizeof(double));
    t->first = trk_new(t->context, inputs, sizeof *t->first);
    t->frequency = trk_new(t->context, t->length, sizeof(double));
    t->cross = trk_new(t->context, 2 * t->length, sizeof(double));
    t->input = trk_new(t->context, 2 * t->length * inputs * inputs, sizeof(double));
    return t->rows && t->sample && t->first && t->frequency && t->cross && t->input ? TRK_OK
                                                                                    : TRK_E_MEMORY;
}

static trk_status respond(task *t, const trk_model *model, const double *q, const double *v,
                          double *out_density, double *out_rms)
{
    trk_superposition s;
    trk_status status = trk_superposition_create(t->context, model, q, v, &s);
    if (status == TRK_OK)
        status = trk_random_response(&s, t->length, t->frequency, t->input, out_density);
    trk_superposition_clear(&s);
    double rate = 1 / t->step;
    for (int32_t k = 0; status == TRK_OK && out_rms && k < trk_model_count(model, TRK_PART_SENSOR);
         k++)
        status = trk_band_rms(t->context, t->length, out_density + k * t->length,
                              t->length > 1 ? t->frequency[1] : rate, 0, rate, &out_rms[k]);
    return status;
}

trk_status trk_response_psd_excited(trk_context *context, const trk_model *model, const double *q,
                                    const double *v, const trk_excitation *excitation, double start,
                                    double step, int64_t samples,
                                    const trk_spectrum_options *options, double *out_density,
                                    double *out_rms)
{
    TRK_REQUIRE(context, context, "trk_response_psd_excited");
    TRK_REQUIRE(context, model, "trk_response_psd_excited");
    TRK_REQUIRE(context, excitation, "trk_response_psd_excited");
    TRK_REQUIRE(context, out_density, "trk_response_psd_excited");
    task t = {.context = context,
              .excitation = excitation,
              .start = start,
              .step = step,
              .samples = samples,
              .options = options,
              .roads = trk_excitation_roads(excitation),
              .ports = trk_excitation_ports(excitation)};
    t.inputs = t.roads + t.ports;
    trk_status status = check(&t, model);
    if (status != TRK_OK)
        return status;
    double ignored = 0; /* a length of 0 has a reason, which this call tells */
    t.length = trk_psd_length(options, samples);
    if (t.length < 1)
        return trk_psd_frequencies(context, samples, 1 / step, options, &ignored);
    status = allocate(&t);
    if (status == TRK_OK)
        status = find_spectra(&t);
    if (status == TRK_OK)
        status = respond(&t, model, q, v, out_density, out_rms);
    void *blocks[] = {t.rows, t.sample, t.first, t.frequency, t.cross, t.input};
    for (size_t k = 0; k < sizeof blocks / sizeof *blocks; k++)
        trk_free(context, blocks[k]);
    return status;
}
