/* SPDX-License-Identifier: MIT */
/* What the trimmed tires do in the full sweep. */
#include "calibrate_tires.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { TIRE_SETS = METHODS + 1, CHANNELS = 6, SHOWN_PEAKS = 2 };
static const double sweep_amplitude = 0.001, resolved = 0.05;

/* A channel whose peaks the thesis prints: with original and with trimmed tires, and measured. */
typedef struct channel {
    const char *name, *original, *trimmed, *measured;
} channel;

static const channel channels[TRUCK_MODELS][CHANNELS] = {
    [QUARTER_FRONT] = {{"unsprung_z", "5.6", "13.8", "13.8"}, {"sprung_z", "2.0", "1.8", "1.6"}},
    [QUARTER_REAR] = {{"unsprung_z", "6.6", "10.2", "10"}, {"sprung_z", "6.4", "10", "10"}},
    [HALF_TRUCK] = {{"front_axle_z", "7", "13.4", "13.8"},
                    {"rear_axle_z", "6.8", "10", "10"},
                    {"cab_front_z", "1", "1.4", "1.8"},
                    {"frame_front_z", "1.2 6.4", "1.2 9.8", "1.8 10.4"}},
    [TRUCK_3D] = {{"front_axle_left_z", "low", "13.6", "13.8"},
                  {"rear_axle_left_z", "low", "9.8", "10"},
                  {"cab_front_left_z", "-", "1.2", "1.8"},
                  {"cab_rear_left_z", "-", "1.8", "1.6"},
                  {"frame_front_left_z", "-", "1 9.8", "1.8 10.4"},
                  {"frame_rear_left_z", "-", "1 9.8", "1.6 10"}},
};

/* Tires of set 0 are the original ones, of set k those of method k - 1. NULL: it has no answer. */
static trk_series *run_set(trk_context *context, const trimmed *t, int set)
{
    trk_spec *spec;
    if (set > 0 && t->by[set - 1].status != TRK_OK)
        return NULL;
    check(context, trk_spec_copy(context, t->spec, &spec));
    if (set > 0) {
        double factor[MAX_AXLES];
        for (int32_t k = 0; k < t->model->axles; k++)
            factor[k] = t->by[set - 1].factor[k].fitted;
        scale_tires(context, t->model, spec, factor);
    }
    trk_model *model = compile(context, spec);
    trk_series *series = run_sweep(context, model, sweep_amplitude);
    trk_model_destroy(model);
    return series;
}

/* PSDs of the axles with all sets of tires, by the largest of the original tires. */
static void write_psd(trk_context *context, const trimmed *t, trk_series *const *series,
                      const char *directory)
{
    char name[128];
    trk_spectrum_options settings;
    spectrum_settings(&settings, SMOOTH_OVERLAP);
    double *column[MAX_AXLES * TIRE_SETS] = {NULL}, step = frequency_step(series[0], &settings);
    int64_t length = trk_psd_length(&settings, trk_series_samples(series[0]));
    int columns = t->model->axles * TIRE_SETS;
    snprintf(name, sizeof name, "psd_%s_%s.csv", t->model->name, t->variant);
    FILE *file = open_result(directory, name);
    fputs("frequency_hz", file);
    for (int c = 0; c < columns; c++) {
        const truck_axle *axle = &t->model->axle[c / TIRE_SETS];
        int set = c % TIRE_SETS;
        fprintf(file, ",%s %s", axle->name, set ? methods[set - 1].name : "original");
        if (series[set])
            column[c] = psd_of(context, series[set], axle->sensor, &settings);
    }
    fputc('\n', file);
    for (int64_t i = 0; i < length && (double)i * step <= 22; i++) {
        fprintf(file, "%.6g", (double)i * step);
        for (int c = 0; c < columns; c++) {
            if (column[c])
                fprintf(file, ",%.6g", column[c][i]);
            else
                fputc(',', file);
        }
        fputc('\n', file);
    }
    for (int c = 0; c < columns; c++)
        free(column[c]);
    fclose(file);
}

/* "1.16 6.84", highest first. */
static void list_peaks(trk_context *context, const trk_series *series, const char *name, char *text,
                       size_t size)
{
    double frequency[SHOWN_PEAKS], height[SHOWN_PEAKS];
    int32_t count =
        find_peaks(context, series, name, 0.5, resolved, SHOWN_PEAKS, frequency, height);
    size_t used = 0;
    *text = '\0';
    for (int32_t k = 0; k < count; k++)
        used += (size_t)snprintf(text + used, size - used, "%s%.2f", k ? " " : "", frequency[k]);
}

void write_peaks_head(FILE *peaks)
{
    fputs("model,variant,channel,tires,peaks_hz,thesis_hz,measured_hz\n", peaks);
    printf(
        "\nPeaks [Hz] of the acceleration PSD on the road simulator, highest first, dampers of the "
        "thesis\n\n%-14s %-20s %-14s %-14s %-14s %-14s %-19s %s\n",
        "model", "channel", "original", "undamped", "damped", "psd_peak", "thesis", "measured");
}

static void write_peaks(trk_context *context, const trimmed *t, trk_series *const *series,
                        FILE *peaks)
{
    const channel *list = channels[t->model - truck_models];
    int shown = strcmp(t->variant, "thesis_dampers") == 0;
    for (int c = 0; c < CHANNELS && list[c].name; c++) {
        if (shown)
            printf("%-14s %-20s", t->model->name, list[c].name);
        for (int set = 0; set < TIRE_SETS; set++) {
            char text[64] = "";
            if (series[set])
                list_peaks(context, series[set], list[c].name, text, sizeof text);
            fprintf(peaks, "%s,%s,%s,%s,%s,%s,%s\n", t->model->name, t->variant, list[c].name,
                    set ? methods[set - 1].name : "original", text,
                    set ? list[c].trimmed : list[c].original, list[c].measured);
            if (shown)
                printf(" %-14s", text);
        }
        if (shown)
            printf(" %7s -> %-8s %s\n", list[c].original, list[c].trimmed, list[c].measured);
    }
}

/* How far the peaks of the axles are from those of the calibration. */
static double compare_peaks(trk_context *context, const trimmed *t, const trk_series *series)
{
    double worst = 0;
    for (int32_t k = 0; k < t->model->axles; k++) {
        double frequency, height;
        int32_t found = find_peaks(context, series, t->model->axle[k].sensor, axle_band[0], 0, 1,
                                   &frequency, &height);
        double difference = found ? fabs(frequency / t->by[METHODS - 1].after[k] - 1) : 1;
        worst = fmax(worst, difference);
    }
    return worst;
}

double write_spectra(trk_context *context, const trimmed *t, const char *directory, FILE *peaks)
{
    trk_series *series[TIRE_SETS];
    for (int set = 0; set < TIRE_SETS; set++)
        series[set] = run_set(context, t, set);
    write_psd(context, t, series, directory);
    write_peaks(context, t, series, peaks);
    double difference = series[METHODS] ? compare_peaks(context, t, series[METHODS]) : 0;
    for (int set = 0; set < TIRE_SETS; set++)
        trk_series_destroy(series[set]);
    return difference;
}
