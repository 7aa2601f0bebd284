/* SPDX-License-Identifier: MIT */
/* Where spectra come from. */
#include "psd.h"
#include "common/recording.h"
#include "common/text.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

void psd_close(psd_spectra *p)
{
    free(p->channel);
    free(p->density);
    trk_series_destroy(p->series);
    road_close(&p->road);
    trk_model_destroy(p->model);
    *p = (psd_spectra){0};
}

static trk_spectrum_options estimate(const psd_settings *o)
{
    trk_spectrum_options options;
    trk_spectrum_options_init(&options, sizeof options);
    options.segment_length = o->segment;
    options.overlap = o->overlap;
    options.window = o->window;
    return options;
}

/* Lengths, and the room for the densities of all channels. */
static void make_room(psd_spectra *p, const trk_spectrum_options *options, int64_t samples,
                      double rate, int channels)
{
    const int64_t whole = samples < 4096 ? samples : 4096;
    const int64_t segment = options->segment_length > 0 ? options->segment_length : whole;
    p->length = trk_psd_length(options, samples);
    p->step = rate / (double)segment;
    p->channels = channels;
    p->channel = need((size_t)channels, sizeof *p->channel);
    p->density = need((size_t)channels * (size_t)p->length, sizeof *p->density);
}

/* Weighting is for accelerations: other channels are left out. */
static bool is_wanted(const psd_settings *o, const char *unit)
{
    return o->weighting == 0 || strcmp(unit, "m/s^2") == 0 || strcmp(unit, "rad/s^2") == 0;
}

static int of_series(session *s, const psd_settings *o, psd_spectra *p)
{
    const trk_spectrum_options options = estimate(o);
    const int64_t samples = trk_series_samples(p->series);
    const double rate = trk_series_rate(p->series);
    int used = 0;
    make_room(p, &options, samples, rate, trk_series_channels(p->series));
    for (int32_t k = 1; k <= trk_series_channels(p->series); k++) {
        const psd_channel c = {trk_series_name(p->series, k), trk_series_unit(p->series, k)};
        if (!is_wanted(o, c.unit))
            continue;
        p->channel[used] = c;
        const trk_status status = trk_psd(s->context, samples, trk_series_data(p->series, k), rate,
                                          &options, p->density + (size_t)used * (size_t)p->length);
        if (status != TRK_OK)
            return session_fail(s, status);
        used++;
    }
    p->channels = used;
    return EXIT_DONE;
}

int psd_of_recording(session *s, const psd_settings *o, psd_spectra *p)
{
    const char *path = s->operands.word[0];
    const trk_status status = recording_read(s->context, path, NULL, &p->series);
    if (status != TRK_OK)
        return session_fail(s, status);
    const int code = run_select(s, o->run.sensors, &p->series);
    return code == EXIT_DONE ? of_series(s, o, p) : code;
}

/* As the run would give it, but from the transfer functions of a linear model. */
static int of_model(session *s, const psd_settings *o, psd_spectra *p)
{
    const trk_spectrum_options options = estimate(o);
    const int32_t sensors = trk_model_count(p->model, TRK_PART_SENSOR);
    const double step = o->run.step * (double)o->run.every;
    const double steps = round(o->run.duration / o->run.step) / (double)o->run.every;
    if (!(steps >= 1 && steps < 1e9))
        return session_usage(s, "--duration, --step and --every give no run");
    const int64_t samples = 1 + (int64_t)(steps + 1e-9);
    int used = 0;
    make_room(p, &options, samples, 1 / step, sensors);
    trk_status status = TRK_OK;
    if (o->linearise)
        status = psd_linearise(s, &options, samples, step, p);
    if (status == TRK_OK)
        status = trk_response_psd_excited(s->context, p->model, NULL, NULL, p->road.excitation, 0,
                                          step, samples, &options, p->density, NULL);
    if (status != TRK_OK)
        return session_fail(s, status);
    for (int32_t k = 1; k <= sensors; k++) {
        const psd_channel c = {trk_model_part_name(p->model, TRK_PART_SENSOR, k),
                               trk_model_unit(p->model, TRK_PART_SENSOR, k)};
        if (!is_wanted(o, c.unit) || (o->run.sensors && !text_match_any(o->run.sensors, c.name)))
            continue;
        p->channel[used] = c;
        memmove(p->density + (size_t)used * (size_t)p->length,
                p->density + (size_t)(k - 1) * (size_t)p->length,
                (size_t)p->length * sizeof(double));
        used++;
    }
    p->channels = used;
    return EXIT_DONE;
}

int psd_of_run(session *s, psd_settings *o, psd_spectra *p)
{
    int code = session_model(s, s->operands.word[0], NULL, &p->model);
    if (code == EXIT_DONE)
        code = run_road(s, &o->run, p->model, &p->road);
    if (code == EXIT_DONE && (o->linear || o->linearise))
        return of_model(s, o, p);
    if (code == EXIT_DONE)
        code = run_series(s, &o->run, p->model, &p->road, &p->series);
    if (code == EXIT_DONE)
        code = run_select(s, o->run.sensors, &p->series);
    return code == EXIT_DONE ? of_series(s, o, p) : code;
}
