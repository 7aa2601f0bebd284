/* SPDX-License-Identifier: MIT */
/* Sweep 0.8 to 20 Hz in 480 s, three front-axle dampers, three models. */
#include "road_simulator.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A front-axle damper: the scale of its curve. */
typedef struct configuration {
    const char *name;
    double damper_scale;
} configuration;

static const configuration configurations[] = {{"standard", 1}, {"harder", 2}, {"undamped", 0}};
enum { CONFIGURATIONS = 3, SHOWN = 4 };

/* A model, its front-axle dampers if any, and the channels whose spectra are plotted. */
typedef struct study_model {
    const char *name;
    trk_vehicle vehicle;
    const char *front_damper[2];
    const char *shown[SHOWN];
} study_model;

static const study_model models[] = {
    {"quarter_front", TRK_VEHICLE_REFERENCE_FRONT, {"damper", NULL}, {"unsprung_z", "sprung_z"}},
    {"quarter_rear", TRK_VEHICLE_REFERENCE_REAR, {NULL}, {"unsprung_z", "sprung_z"}},
    {"half_truck",
     TRK_VEHICLE_REFERENCE_HALF,
     {"front_damper", NULL},
     {"front_axle_z", "rear_axle_z", "frame_front_z", "cab_front_z"}},
    {"truck_3d",
     TRK_VEHICLE_REFERENCE_TRUCK,
     {"front_left_damper", "front_right_damper"},
     {"front_axle_left_z", "rear_axle_left_z", "frame_front_left_z", "cab_front_left_z"}},
};
enum { MODELS = sizeof models / sizeof *models };

static trk_model *create_model(trk_context *context, const study_model *m, double damper_scale)
{
    trk_spec *spec;
    trk_model *model;
    check(context, trk_vehicle_create_builtin(context, m->vehicle, TRK_VARIANT_THESIS_DAMPERS, &spec));
    for (int k = 0; k < 2 && m->front_damper[k]; k++) {
        trk_link_options damper;
        int32_t id = trk_spec_find(spec, TRK_PART_LINK, m->front_damper[k]);
        trk_link_options_init(&damper, sizeof damper);
        check(context, trk_spec_get_link(spec, id, &damper));
        damper.damper_scale = damper_scale;
        check(context, trk_spec_set_link(spec, id, &damper));
    }
    check(context, trk_model_compile(context, spec, NULL, &model));
    trk_spec_destroy(spec);
    return model;
}

/* All wheels in phase, as on the rig. */
static trk_series *run_sweep(trk_context *context, const trk_model *model, double amplitude)
{
    trk_sweep_options sweep;
    trk_sweep_options_init(&sweep, sizeof sweep);
    sweep.amplitude = amplitude;
    trk_simulate_options run;
    trk_simulate_options_init(&run, sizeof run);
    run.duration = sweep.duration;
    trk_signal *signal;
    trk_excitation *excitation;
    trk_series *series;
    check(context, trk_signal_create_sweep(context, &sweep, &signal));
    check(context, trk_excitation_create(context, model, &excitation));
    check(context, trk_excitation_add_motion(excitation, TRK_ROAD_ALL, signal, 1, 0));
    check(context, trk_simulate(context, model, excitation, NULL, &run, NULL, NULL, &series));
    trk_excitation_destroy(excitation);
    trk_signal_destroy(signal);
    return series;
}

/* Segments of 8.192 s: 0.12 Hz apart. The sweep passes each frequency once, so all times must
 * weigh the same: squared Hann windows add up to a constant from 75 % overlap on. */
static void spectrum_settings(trk_spectrum_options *settings)
{
    trk_spectrum_options_init(settings, sizeof *settings);
    settings->segment_length = 8192;
    settings->overlap = 0.75;
}

static double *psd_of(trk_context *context, const trk_series *series, int32_t channel)
{
    trk_spectrum_options settings;
    spectrum_settings(&settings);
    int64_t samples = trk_series_samples(series);
    double *density = malloc((size_t)trk_psd_length(&settings, samples) * sizeof *density);
    if (!density)
        exit(1);
    check(context, trk_psd(context, samples, trk_series_data(series, channel), trk_series_rate(series),
                           &settings, density));
    return density;
}

/* One line of the table for each accelerometer; no peak where symmetry leaves only rounding. */
static void write_rows(trk_context *context, const char *model, const char *configuration_name,
                       const trk_series *series, FILE *table)
{
    trk_spectrum_options settings;
    spectrum_settings(&settings);
    int64_t samples = trk_series_samples(series), length = trk_psd_length(&settings, samples);
    double step = trk_series_rate(series) / (double)settings.segment_length;
    for (int32_t channel = 1; channel <= trk_series_channels(series); channel++) {
        const char *name = trk_series_name(series, channel);
        if (strcmp(trk_series_unit(series, channel), "m/s^2") != 0)
            continue;
        const double *x = trk_series_data(series, channel);
        double square = 0, frequency = 0;
        for (int64_t k = 0; k < samples; k++)
            square += x[k] * x[k];
        double rms = sqrt(square / (double)samples);
        char line[512], peak[32] = "";
        if (rms > 1e-9) {
            int64_t found;
            double *density = psd_of(context, series, channel);
            check(context, trk_psd_peaks(context, length, density, step, NULL, 1, &frequency, NULL,
                                         NULL, &found));
            snprintf(peak, sizeof peak, "%.2f", frequency);
            free(density);
        }
        snprintf(line, sizeof line, "%s,%s,%s,%s,%.6g\n", model, name, configuration_name, peak,
                 rms > 1e-9 ? rms : 0.0);
        fputs(line, stdout);
        fputs(line, table);
    }
}

/* Spectra of the shown channels, normalised by the largest of the standard configuration. */
static void write_spectra(trk_context *context, const study_model *m, int count,
                          trk_series *const series[CONFIGURATIONS], const char *directory)
{
    char name[64];
    trk_spectrum_options settings;
    spectrum_settings(&settings);
    int64_t length = trk_psd_length(&settings, trk_series_samples(series[0]));
    double step = trk_series_rate(series[0]) / (double)settings.segment_length;
    double *column[SHOWN * CONFIGURATIONS] = {NULL};
    int columns = 0;
    snprintf(name, sizeof name, "psd_%s.csv", m->name);
    FILE *file = open_result(directory, name);
    fputs("frequency_hz", file);
    for (int k = 0; k < SHOWN && m->shown[k]; k++) {
        double reference = 0;
        for (int c = 0; c < count; c++, columns++) {
            column[columns] = psd_of(context, series[c], trk_series_find(series[c], m->shown[k]));
            check(context, trk_psd_normalise(context, length, column[columns], reference,
                                             column[columns], c == 0 ? &reference : NULL));
            fprintf(file, ",%s %s", m->shown[k], configurations[c].name);
        }
    }
    fputc('\n', file);
    for (int64_t i = 0; i < length && (double)i * step <= 30; i++) {
        fprintf(file, "%.6g", (double)i * step);
        for (int k = 0; k < columns; k++)
            fprintf(file, ",%.6g", column[k][i]);
        fputc('\n', file);
    }
    for (int k = 0; k < columns; k++)
        free(column[k]);
    fclose(file);
}

/* 50 Hz hold all that the sweep excites. */
static void write_signals(trk_context *context, const char *model, const char *configuration_name,
                          const trk_series *series, const char *directory)
{
    char path[4096];
    trk_series *slow;
    snprintf(path, sizeof path, "%s/time_%s_%s.csv", directory, model, configuration_name);
    check(context, trk_series_resample(context, series, 50, &slow));
    check(context, trk_series_write_csv(context, slow, path, 1));
    trk_series_destroy(slow);
}

void run_study(trk_context *context, const char *directory, double amplitude)
{
    FILE *table = open_result(directory, "peaks.csv");
    fputs("model,channel,configuration,peak_hz,rms\n", stdout);
    fputs("model,channel,configuration,peak_hz,rms\n", table);
    for (int m = 0; m < MODELS; m++) {
        trk_series *series[CONFIGURATIONS];
        int count = models[m].front_damper[0] ? CONFIGURATIONS : 1;
        for (int c = 0; c < count; c++) {
            trk_model *model = create_model(context, &models[m], configurations[c].damper_scale);
            series[c] = run_sweep(context, model, amplitude);
            write_rows(context, models[m].name, configurations[c].name, series[c], table);
            write_signals(context, models[m].name, configurations[c].name, series[c], directory);
            trk_model_destroy(model);
        }
        write_spectra(context, &models[m], count, series, directory);
        for (int c = 0; c < count; c++)
            trk_series_destroy(series[c]);
    }
    fclose(table);
}
