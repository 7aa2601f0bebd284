/* SPDX-License-Identifier: MIT */
/* The linear vehicle that moves most like the real one on a road. */
#include "psd.h"
#include "common/text.h"

#include <stdlib.h>

/* Heights of all roads, each for itself: road by road, `samples` long. */
static double *heights_of(const trk_excitation *excitation, int32_t roads, double step,
                          int64_t samples)
{
    double *rows = need((size_t)roads, (size_t)samples * sizeof *rows);
    double *columns = need((size_t)roads, (size_t)samples * sizeof *columns);
    trk_excitation_evaluate(excitation, samples, 0, step, rows, NULL, NULL);
    for (int64_t i = 0; i < samples; i++)
        for (int32_t r = 0; r < roads; r++)
            columns[r * samples + i] = rows[i * roads + r];
    free(rows);
    return columns;
}

/* Cross spectra of the roads as trk_model_linearise() takes them; ports rest. */
static trk_status cross_spectra(session *s, const double *height, int32_t roads, int32_t inputs,
                                double rate, int64_t samples, const trk_spectrum_options *options,
                                int64_t length, double *input)
{
    double *cross = need((size_t)length, 2 * sizeof *cross);
    trk_status status = TRK_OK;
    for (int32_t i = 0; i < roads; i++)
        for (int32_t j = i; j < roads && status == TRK_OK; j++) {
            status = trk_csd(s->context, samples, height + i * samples, height + j * samples, rate,
                             options, cross);
            for (int64_t k = 0; k < length && status == TRK_OK; k++)
                for (int part = 0; part < 2; part++)
                    input[2 * ((k * inputs + i) * inputs + j) + part] = cross[2 * k + part];
        }
    free(cross);
    return status;
}

trk_status psd_linearise(session *s, const trk_spectrum_options *options, int64_t samples,
                         double step, psd_spectra *p)
{
    const int32_t roads = trk_excitation_roads(p->road.excitation);
    const int32_t inputs = roads + trk_excitation_ports(p->road.excitation);
    double *height = heights_of(p->road.excitation, roads, step, samples);
    double *input = need((size_t)p->length, 2 * sizeof *input * (size_t)inputs * (size_t)inputs);
    double *frequency = need((size_t)p->length, sizeof *frequency);
    trk_model *linear = NULL;
    for (int64_t k = 0; k < p->length; k++)
        frequency[k] = (double)k * p->step;
    trk_status status =
        cross_spectra(s, height, roads, inputs, 1 / step, samples, options, p->length, input);
    if (status == TRK_OK)
        status = trk_model_linearise(s->context, p->model, p->length, frequency, input, NULL, NULL,
                                     NULL, NULL, &linear);
    free(height);
    free(input);
    free(frequency);
    if (status == TRK_OK) {
        trk_model_destroy(p->model);
        p->model = linear;
    }
    return status;
}
