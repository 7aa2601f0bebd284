/* SPDX-License-Identifier: MIT */
/* What the plots show: spectra of the axles under every explanation, the loop of a spring. */
#include "thesis_revisited.h"

#include <math.h>
#include <stdlib.h>

void write_spectra(trk_context *context, const outcome *o, const char *directory,
                   trk_series *series[EXPLANATIONS][DAMPERS])
{
    enum { COLUMNS = MAX_AXLES * EXPLANATIONS * DAMPERS };
    double *column[COLUMNS];
    char name[128];
    trk_spectrum_options settings;
    int columns = 0;
    spectrum_settings(&settings, SMOOTH_OVERLAP);
    snprintf(name, sizeof name, "psd_%s.csv", o->model->name);
    FILE *file = open_result(directory, name);
    fputs("frequency_hz", file);
    for (int32_t k = 0; k < o->model->axles; k++)
        for (int e = 0; e < EXPLANATIONS; e++)
            for (int d = 0; d < DAMPERS && series[e][d]; d++) {
                const truck_axle *axle = &o->model->axle[k];
                fprintf(file, ",%s %s %s", axle->name, explanation_names[e], damper_names[d]);
                column[columns++] = psd_of(context, series[e][d], axle->sensor, &settings);
            }
    fputc('\n', file);
    double step = frequency_step(series[0][0], &settings);
    int64_t length = trk_psd_length(&settings, trk_series_samples(series[0][0]));
    for (int64_t i = 0; i < length && (double)i * step <= 22; i++) {
        fprintf(file, "%.6g", (double)i * step);
        for (int c = 0; c < columns; c++)
            fprintf(file, ",%.6g", column[c][i]);
        fputc('\n', file);
    }
    for (int c = 0; c < columns; c++)
        free(column[c]);
    fclose(file);
}

void write_loop(trk_context *context, const fit *fitted, const char *directory)
{
    enum { CYCLES = 4, CYCLE = 400, POINTS = CYCLES * CYCLE + 1 };
    static const double amplitude[CYCLES] = {5e-3, 5e-3, 2e-3, 5e-4}; /* [m] */
    static double e[POINTS], force[POINTS];
    trk_leaf_options leaf;
    trk_law *law;
    trk_leaf_options_init(&leaf, sizeof leaf);
    leaf.friction = fitted->parameter[FRONT_FRICTION].fitted;
    leaf.approach_bump = fitted->parameter[FRONT_APPROACH].fitted;
    for (int k = 0; k < POINTS; k++)
        e[k] = amplitude[k / CYCLE < CYCLES ? k / CYCLE : CYCLES - 1] *
               sin(2 * 3.14159265358979 * k / CYCLE);
    check(context, trk_law_create_leaf(context, "front spring", &leaf, &law));
    check(context, trk_law_trace(context, law, POINTS, 1e-3, e, force, NULL));
    trk_law_destroy(law);
    FILE *file = open_result(directory, "loop.csv");
    fputs("elongation_m,friction_n\n", file);
    for (int k = CYCLE; k < POINTS; k++) /* past the first rise from rest */
        fprintf(file, "%.6g,%.6g\n", e[k], force[k]);
    fclose(file);
}
