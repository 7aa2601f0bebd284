/* SPDX-License-Identifier: MIT */
/* truckride simulate: drive a vehicle over a road and record its sensors. */
#define _POSIX_C_SOURCE 200809L
#include "output.h"
#include "plot.h"
#include "run.h"
#include "series.h"

#include <string.h>

typedef struct settings {
    run_options run;
    int32_t format;
} settings;

static const argument own[] = {
    {.help = "Output"},
    {"format", 'f', ARGUMENT_CHOICE, offsetof(settings, format), "csv|json|mat|rpc",
     "comma-separated, JSON, MATLAB level 5, MTS RPC III; default: as the\n"
     "suffix of FILE tells, else csv",
     SERIES_CSV},
    {"out", 'o', ARGUMENT_TEXT, offsetof(shared, out), "FILE",
     "write there; default - is standard output", 0},
    {0}};
static const argument *const tables[] = {run_arguments, shared_model,   own,
                                         shared_plot,   shared_general, NULL};

static int draw(session *s, const trk_model *model, const trk_series *series)
{
    plot_page page = {.title = trk_model_name(model),
                      .label = "time [s]",
                      .points = trk_series_samples(series),
                      .start = trk_series_start(series),
                      .step = 1 / trk_series_rate(series)};
    for (int32_t k = 1; k <= trk_series_channels(series); k++)
        plot_add(&page, trk_series_unit(series, k), false, trk_series_name(series, k),
                 trk_series_data(series, k), 1);
    const int code = plot_draw(s, s->shared->plot, &page);
    plot_free(&page);
    return code;
}

static int simulate(session *s, settings *o)
{
    trk_model *model = NULL;
    trk_series *series = NULL;
    road r = {0};
    int code = plot_check(s, s->shared->plot);
    if (code == EXIT_DONE)
        code = output_check(s, s->shared->out);
    if (code == EXIT_DONE)
        code = session_model(s, s->operands.word[0], NULL, &model);
    if (code == EXIT_DONE)
        code = run_road(s, &o->run, model, &r);
    if (code == EXIT_DONE)
        code = run_series(s, &o->run, model, &r, &series);
    if (code == EXIT_DONE)
        code = run_select(s, o->run.sensors, &series);
    if (code == EXIT_DONE)
        code = series_write(s, series, o->format);
    if (code == EXIT_DONE && s->shared->plot)
        code = draw(s, model, series);
    trk_series_destroy(series);
    road_close(&r);
    trk_model_destroy(model);
    return code;
}

static int run(session *s, int argc, char **argv)
{
    settings o = {.run = run_defaults()};
    int code;
    if (session_begin(s, &o, argc, argv, &code) && session_operands(s, 1, 1, "MODEL", &code))
        code = simulate(s, &o);
    session_end(s);
    return code;
}

extern const command simulate_command;
const command simulate_command = {
    "simulate",
    "drive over a road and record the sensors",
    "--road ROAD [OPTION...] MODEL",
    "Step a vehicle from rest over a road and write what its sensors measure, a line a sample.\n",
    "  truckride simulate builtin:reference_truck --road iso:class=B:speed=70 -o run.csv\n"
    "  truckride simulate truck.json --road step:height=0.03 --duration 4 \\\n"
    "      --sensors 'cab_*,*_tire_force' --plot kerb.png -o kerb.mat\n"
    "  truckride simulate truck.json --road csv:track.csv:speed=60 | truckride psd - --rms\n",
    tables,
    run,
    false,
};
