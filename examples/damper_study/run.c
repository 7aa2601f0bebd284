/* SPDX-License-Identifier: MIT */
/* Three front-axle dampers in the sweep. */
#include "damper_study.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

const char *const configuration_names[CONFIGURATIONS] = {"standard", "harder", "undamped"};
const double resonance[2] = {8, 20};

static const double scale[CONFIGURATIONS] = {1, 2, 0};
static const double sweep_amplitude = 0.001;
static const int model_of[STUDIED] = {QUARTER_FRONT, HALF_TRUCK, TRUCK_3D};

static const char *const sensors[STUDIED][PLACES] = {
    [QUARTER] = {[FRONT_AXLE] = "unsprung_z", [FRAME] = "sprung_z"},
    [HALF] = {"front_axle_z", "rear_axle_z", "frame_front_z", "cab_front_z", "cab_rear_z"},
    [FULL] = {"front_axle_left_z", "rear_axle_left_z", "frame_front_left_z", "cab_front_left_z",
              "cab_rear_left_z"},
};

const char *sensor_at(int studied, int place)
{
    return sensors[studied][place];
}

static trk_spec *create_trimmed(trk_context *context, study *s)
{
    const double start[MAX_AXLES] = {1, 1};
    trk_spec *spec;
    trimming tires;
    check(context, trk_vehicle_create_builtin(context, s->model->vehicle,
                                              TRK_VARIANT_THESIS_DAMPERS, &spec));
    trim_tires(context, s->model, spec, TRK_TARGET_UNDAMPED_FREQUENCY, start, NULL, NULL, &tires);
    check(context, tires.status);
    for (int32_t k = 0; k < s->model->axles; k++)
        s->factor[k] = tires.factor[k].fitted;
    scale_tires(context, s->model, spec, s->factor);
    return spec;
}

/* Damped frequency and damping ratio of the mode with most energy in the front axle. */
static void find_axle_mode(trk_context *context, const trk_model *model, const char *coordinate,
                           double *out_frequency, double *out_ratio)
{
    trk_modes *modes;
    double share[16], most = 0;
    int32_t id = trk_model_find(model, TRK_PART_COORDINATE, coordinate);
    check(context, trk_modes_create_damped(context, model, NULL, NULL, &modes));
    for (int32_t k = 1; k <= trk_modes_count(modes); k++) {
        check(context, trk_modes_get_energy(modes, k, share));
        if (share[id - 1] > most && trk_modes_damped_frequency(modes, k) > 0) {
            most = share[id - 1];
            *out_frequency = trk_modes_damped_frequency(modes, k);
            *out_ratio = trk_modes_damping_ratio(modes, k);
        }
    }
    trk_modes_destroy(modes);
}

static void look(trk_context *context, const trk_series *series, int studied, int place,
                 response *out)
{
    const char *sensor = sensors[studied][place];
    trk_spectrum_options settings;
    spectrum_settings(&settings, SMOOTH_OVERLAP);
    double *density = psd_of(context, series, sensor, &settings);
    int64_t length = trk_psd_length(&settings, trk_series_samples(series));
    double from = place == FRONT_AXLE || place == REAR_AXLE ? axle_band[0] : 0.5;
    if (!find_peaks(context, series, sensor, from, 0.05, 1, &out->peak, &out->height))
        out->peak = out->height = NAN;
    out->rms = rms_of(series, sensor);
    check(context, trk_band_rms(context, length, density, frequency_step(series, &settings),
                                resonance[0], resonance[1], &out->axle_rms));
    free(density);
}

/* PSDs of all places, by the largest of the standard damper at that place. */
static void write_spectra(trk_context *context, int studied, const char *model,
                          trk_series *const *series, const char *directory)
{
    char name[64];
    trk_spectrum_options settings;
    spectrum_settings(&settings, SMOOTH_OVERLAP);
    double *column[PLACES * CONFIGURATIONS], step = frequency_step(series[0], &settings);
    int64_t length = trk_psd_length(&settings, trk_series_samples(series[0]));
    int columns = 0;
    snprintf(name, sizeof name, "damper_psd_%s.csv", model);
    FILE *file = open_result(directory, name);
    fputs("frequency_hz", file);
    for (int place = 0; place < PLACES; place++)
        for (int c = 0; sensors[studied][place] && c < CONFIGURATIONS; c++) {
            column[columns++] = psd_of(context, series[c], sensors[studied][place], &settings);
            fprintf(file, ",%s %s", sensors[studied][place], configuration_names[c]);
        }
    fputc('\n', file);
    for (int64_t i = 0; i < length && (double)i * step <= 25; i++) {
        fprintf(file, "%.6g", (double)i * step);
        for (int k = 0; k < columns; k++)
            fprintf(file, ",%.6g", column[k][i]);
        fputc('\n', file);
    }
    for (int k = 0; k < columns; k++)
        free(column[k]);
    fclose(file);
}

void run_configurations(trk_context *context, int studied, const char *directory, study *out)
{
    trk_series *series[CONFIGURATIONS];
    memset(out, 0, sizeof *out);
    out->model = &truck_models[model_of[studied]];
    trk_spec *trimmed = create_trimmed(context, out);
    for (int c = 0; c < CONFIGURATIONS; c++) {
        trk_spec *spec;
        check(context, trk_spec_copy(context, trimmed, &spec));
        scale_front_dampers(context, out->model, spec, scale[c]);
        trk_model *model = compile(context, spec);
        find_axle_mode(context, model, out->model->axle[0].coordinate, &out->eigenfrequency[c],
                       &out->damping_ratio[c]);
        series[c] = run_sweep(context, model, sweep_amplitude);
        for (int place = 0; place < PLACES; place++)
            if (sensors[studied][place])
                look(context, series[c], studied, place, &out->seen[c][place]);
        trk_model_destroy(model);
    }
    write_spectra(context, studied, out->model->name, series, directory);
    for (int c = 0; c < CONFIGURATIONS; c++)
        trk_series_destroy(series[c]);
    trk_spec_destroy(trimmed);
}

void write_damper_curves(trk_context *context, const char *directory)
{
    trk_curve *curve;
    check(context,
          trk_vehicle_create_curve(context, TRK_TABLE_THESIS_FRONT_AXLE_DAMPER, NULL, &curve));
    FILE *file = open_result(directory, "damper_curves.csv");
    fputs("velocity_m_s,standard,harder,undamped\n", file);
    for (int k = -50; k <= 50; k++) {
        double velocity = 0.01 * k, force = trk_curve_value(curve, velocity);
        fprintf(file, "%.2f,%.6g,%.6g,%.6g\n", velocity, scale[STANDARD] * force,
                scale[HARDER] * force, scale[UNDAMPED] * fabs(force));
    }
    fclose(file);
    trk_curve_destroy(curve);
}
