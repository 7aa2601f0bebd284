/* SPDX-License-Identifier: MIT */
/* The road-simulator run and its spectra. */
#include "common/common.h"

#include <math.h>
#include <stdlib.h>

/* The models answer above it too, with harmonics of their dampers. */
static const double sweep_end = 20; /* [Hz] */

trk_model *compile(trk_context *context, trk_spec *spec)
{
    trk_model *model;
    check(context, trk_model_compile(context, spec, NULL, &model));
    trk_spec_destroy(spec);
    return model;
}

void set_damper_scale(trk_context *context, trk_spec *spec, const char *link, double scale)
{
    trk_link_options damper;
    int32_t id = trk_spec_find(spec, TRK_PART_LINK, link);
    trk_link_options_init(&damper, sizeof damper);
    check(context, trk_spec_get_link(spec, id, &damper));
    damper.damper_scale = scale;
    check(context, trk_spec_set_link(spec, id, &damper));
}

trk_excitation *create_sweep(trk_context *context, const trk_model *model,
                             const trk_sweep_options *options, trk_signal **out_signal)
{
    trk_excitation *excitation;
    check(context, trk_signal_create_sweep(context, options, out_signal));
    check(context, trk_excitation_create(context, model, &excitation));
    check(context, trk_excitation_add_motion(excitation, TRK_ROAD_ALL, *out_signal, 1, 0));
    return excitation;
}

trk_series *run_sweep(trk_context *context, const trk_model *model, double amplitude)
{
    trk_sweep_options sweep;
    trk_simulate_options run;
    trk_signal *signal;
    trk_series *series;
    trk_sweep_options_init(&sweep, sizeof sweep);
    trk_simulate_options_init(&run, sizeof run);
    sweep.amplitude = amplitude;
    run.duration = sweep.duration;
    trk_excitation *excitation = create_sweep(context, model, &sweep, &signal);
    check(context, trk_simulate(context, model, excitation, NULL, &run, NULL, NULL, &series));
    trk_excitation_destroy(excitation);
    trk_signal_destroy(signal);
    return series;
}

void spectrum_settings(trk_spectrum_options *settings, double overlap)
{
    trk_spectrum_options_init(settings, sizeof *settings);
    settings->segment_length = 8192;
    settings->overlap = overlap;
}

double frequency_step(const trk_series *series, const trk_spectrum_options *settings)
{
    return trk_series_rate(series) / (double)settings->segment_length;
}

double *psd_of(trk_context *context, const trk_series *series, const char *channel,
               const trk_spectrum_options *settings)
{
    int64_t samples = trk_series_samples(series);
    double *density = allocate((size_t)trk_psd_length(settings, samples) * sizeof *density);
    check(context,
          trk_psd(context, samples, trk_series_data(series, trk_series_find(series, channel)),
                  trk_series_rate(series), settings, density));
    return density;
}

int32_t find_peaks(trk_context *context, const trk_series *series, const char *channel, double from,
                   double part, int32_t capacity, double *out_frequency, double *out_height)
{
    trk_spectrum_options settings;
    trk_peak_options apart;
    spectrum_settings(&settings, SMOOTH_OVERLAP);
    trk_peak_options_init(&apart, sizeof apart);
    apart.minimum_distance = 1;
    double *density = psd_of(context, series, channel, &settings);
    double step = frequency_step(series, &settings), frequency[16], height[16], prominence[16];
    int64_t length = trk_psd_length(&settings, trk_series_samples(series)), found;
    check(context, trk_psd_peaks(context, length, density, step, &apart, 16, frequency, height,
                                 prominence, &found));
    int32_t count = 0;
    for (int64_t k = 0; k < found && k < 16 && count < capacity; k++) {
        if (frequency[k] < from || frequency[k] > sweep_end || prominence[k] < part * height[k])
            continue;
        out_frequency[count] = frequency[k];
        out_height[count++] = height[k];
    }
    free(density);
    return count;
}

double rms_of(const trk_series *series, const char *channel)
{
    const double *x = trk_series_data(series, trk_series_find(series, channel));
    int64_t samples = trk_series_samples(series);
    double square = 0;
    for (int64_t k = 0; k < samples; k++)
        square += x[k] * x[k];
    double rms = sqrt(square / (double)samples);
    return rms > 1e-9 ? rms : 0;
}
