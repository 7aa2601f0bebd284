/* SPDX-License-Identifier: MIT */
/* The other suspect: a frame that bends. The same truck with its frame as it is, and made rigid. */
#include "thesis_revisited.h"

#include <stdlib.h>
#include <string.h>

enum { FLEXIBLE, STIFF, FRAMES, SHOWN = 3, TEXT = 48 };
static const char *const frame_names[FRAMES] = {"flexible", "rigid"};
static const double stiffer = 1e3; /* factor on the beams that makes the frame as good as rigid */

/* Where the thesis measured, and its peaks. */
static const struct {
    const char *sensor, *measured;
} places[] = {{"frame_front_left_z", "1.8 10.4"},
              {"frame_rear_axle_left_z", "1.6 10"},
              {"front_axle_left_z", "13.8"},
              {"rear_axle_left_z", "10"},
              {"cab_front_left_z", "1.8"}};
enum { PLACES = sizeof places / sizeof *places };

/* First modes that bend or twist the frame: most of their energy is in its nodes. */
static void print_modes(trk_context *context, const trk_model *model, FILE *out)
{
    trk_modes *modes;
    check(context, trk_modes_create_lowest(context, model, NULL, 24, &modes));
    print_both(out, "   modes of the frame:");
    for (int32_t k = 1; k <= trk_modes_count(modes); k++)
        if (strncmp(trk_modes_label(modes, k), "frame.", 6) == 0)
            print_both(out, " %.2f", trk_modes_frequency(modes, k));
    print_both(out, " Hz\n");
    trk_modes_destroy(modes);
}

/* "8.49 1.94", highest first. */
static void list_peaks(trk_context *context, const trk_series *series, int place, char *text,
                       size_t size)
{
    double frequency[SHOWN], height[SHOWN];
    int32_t found =
        find_peaks(context, series, places[place].sensor, 0.5, 0.05, SHOWN, frequency, height);
    size_t used = 0;
    *text = '\0';
    for (int32_t k = 0; k < found; k++)
        used += (size_t)snprintf(text + used, size - used, "%s%.2f", k ? " " : "", frequency[k]);
}

static void write_peaks(char (*text)[PLACES][TEXT], const char *directory, FILE *findings)
{
    FILE *table = open_result(directory, "frame_peaks.csv");
    fputs("channel,frame,peaks_hz,measured_hz\n", table);
    print_both(findings, "   peaks [Hz], highest first: %-22s %-18s %-18s %s\n", "",
               "flexible frame", "rigid frame", "measured");
    for (int place = 0; place < PLACES; place++) {
        for (int f = 0; f < FRAMES; f++)
            fprintf(table, "%s,%s,%s,%s\n", places[place].sensor, frame_names[f], text[f][place],
                    places[place].measured);
        print_both(findings, "   %-49s %-18s %-18s %s\n", places[place].sensor,
                   text[FLEXIBLE][place], text[STIFF][place], places[place].measured);
    }
    fclose(table);
}

static void write_frame_spectra(trk_context *context, trk_series *const *series,
                                const char *directory)
{
    double *column[PLACES * FRAMES];
    trk_spectrum_options settings;
    spectrum_settings(&settings, SMOOTH_OVERLAP);
    FILE *file = open_result(directory, "frame_psd.csv");
    fputs("frequency_hz", file);
    for (int c = 0; c < PLACES * FRAMES; c++) {
        fprintf(file, ",%s %s", places[c / FRAMES].sensor, frame_names[c % FRAMES]);
        column[c] = psd_of(context, series[c % FRAMES], places[c / FRAMES].sensor, &settings);
    }
    fputc('\n', file);
    double step = frequency_step(series[0], &settings);
    int64_t length = trk_psd_length(&settings, trk_series_samples(series[0]));
    for (int64_t i = 0; i < length && (double)i * step <= 22; i++) {
        fprintf(file, "%.6g", (double)i * step);
        for (int c = 0; c < PLACES * FRAMES; c++)
            fprintf(file, ",%.6g", column[c][i]);
        fputc('\n', file);
    }
    for (int c = 0; c < PLACES * FRAMES; c++)
        free(column[c]);
    fclose(file);
}

void compare_frames(trk_context *context, const char *path, const char *directory, FILE *findings)
{
    trk_series *series[FRAMES];
    static char text[FRAMES][PLACES][TEXT];
    print_both(findings, "\nDoes the frame's flexibility? %s\n", path);
    for (int f = 0; f < FRAMES; f++) {
        trk_spec *spec;
        check(context, trk_model_file_read(context, path, &spec));
        if (f == STIFF)
            check(context, trk_spec_vary(spec, TRK_FIELD_BENDING, "frame.*", TRK_MEANING_FACTOR,
                                         stiffer, NULL));
        trk_model *model = compile(context, spec);
        if (f == FLEXIBLE)
            print_modes(context, model, findings);
        series[f] = run_sweep(context, model, sweep_amplitude);
        for (int place = 0; place < PLACES; place++)
            list_peaks(context, series[f], place, text[f][place], TEXT);
        trk_model_destroy(model);
    }
    write_peaks(text, directory, findings);
    write_frame_spectra(context, series, directory);
    for (int f = 0; f < FRAMES; f++)
        trk_series_destroy(series[f]);
}
