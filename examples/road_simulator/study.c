/* SPDX-License-Identifier: MIT */
/* Sweep 0.8 to 20 Hz in 480 s, three front-axle dampers, three models. */
#include "road_simulator.h"

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
    check(context,
          trk_vehicle_create_builtin(context, m->vehicle, TRK_VARIANT_THESIS_DAMPERS, &spec));
    for (int k = 0; k < 2 && m->front_damper[k]; k++)
        set_damper_scale(context, spec, m->front_damper[k], damper_scale);
    return compile(context, spec);
}

/* One line of the table for each accelerometer; no peak where symmetry leaves only rounding. */
static void write_rows(trk_context *context, const char *model, const char *configuration_name,
                       const trk_series *series, FILE *table)
{
    trk_spectrum_options settings;
    spectrum_settings(&settings, SMOOTH_OVERLAP);
    int64_t length = trk_psd_length(&settings, trk_series_samples(series));
    for (int32_t channel = 1; channel <= trk_series_channels(series); channel++) {
        const char *name = trk_series_name(series, channel);
        if (strcmp(trk_series_unit(series, channel), "m/s^2") != 0)
            continue;
        double frequency, rms = rms_of(series, name);
        char peak[32] = "";
        if (rms > 0) {
            int64_t found;
            double *density = psd_of(context, series, name, &settings);
            check(context,
                  trk_psd_peaks(context, length, density, frequency_step(series, &settings), NULL,
                                1, &frequency, NULL, NULL, &found));
            snprintf(peak, sizeof peak, "%.2f", frequency);
            free(density);
        }
        print_both(table, "%s,%s,%s,%s,%.6g\n", model, name, configuration_name, peak, rms);
    }
}

/* Spectra of the shown channels, normalised by the largest of the standard configuration. */
static void write_spectra(trk_context *context, const study_model *m, int count,
                          trk_series *const series[CONFIGURATIONS], const char *directory)
{
    char name[64];
    trk_spectrum_options settings;
    spectrum_settings(&settings, SMOOTH_OVERLAP);
    int64_t length = trk_psd_length(&settings, trk_series_samples(series[0]));
    double step = frequency_step(series[0], &settings);
    double *column[SHOWN * CONFIGURATIONS] = {NULL};
    int columns = 0;
    snprintf(name, sizeof name, "psd_%s.csv", m->name);
    FILE *file = open_result(directory, name);
    fputs("frequency_hz", file);
    for (int k = 0; k < SHOWN && m->shown[k]; k++) {
        double reference = 0;
        for (int c = 0; c < count; c++, columns++) {
            column[columns] = psd_of(context, series[c], m->shown[k], &settings);
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
    print_both(table, "model,channel,configuration,peak_hz,rms\n");
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
