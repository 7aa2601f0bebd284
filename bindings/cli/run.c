/* SPDX-License-Identifier: MIT */
/* Runs of a vehicle over a road. */
#include "run.h"
#include "names.h"
#include "common/text.h"
#include "common/watch.h"

#include <stdlib.h>
#include <string.h>

#define AT(field) offsetof(run_options, field)

const argument run_arguments[] = {
    {.help = "Run"},
    {"road", 'r', ARGUMENT_TEXT, AT(road), "KIND[:SETTING=VALUE...]", "the road; see below", 0},
    {"duration", 'd', ARGUMENT_NUMBER, AT(duration), "S",
     "default: as long as a recorded road lasts, else 10", 0},
    {"step", 0, ARGUMENT_NUMBER, AT(step), "S", "of the integration; default 0.001", 0},
    {"method", 0, ARGUMENT_CHOICE, AT(method), "newmark|rk4",
     "implicit, second order, for every model (default); explicit, fourth order", 0},
    {"every", 0, ARGUMENT_WHOLE, AT(every), "N", "record each Nth step; default 1", 0},
    {"sensors", 0, ARGUMENT_TEXT, AT(sensors), "NAME[,NAME...]",
     "only these; '*' stands for any text; default: all", 0},
    {0}};

run_options run_defaults(void)
{
    return (run_options){.step = 0.001, .every = 1};
}

int run_road(session *s, run_options *o, const trk_model *model, road *out_road)
{
    complaint wrong;
    trk_status status;
    *out_road = (road){0};
    if (!o->road)
        return session_usage(s, "--road is missing");
    const int code =
        o->sensors ? names_of_model(s, model, TRK_PART_SENSOR, o->sensors, NULL) : EXIT_DONE;
    if (code != EXIT_DONE)
        return code;
    const double duration = o->duration > 0 ? o->duration : 10;
    if (!road_open(s->context, model, o->road, duration, out_road, &wrong, &status))
        return wrong.text[0] ? session_usage(s, "%s, in '%s'", wrong.text, o->road)
                             : session_fail(s, status);
    if (o->duration == 0)
        o->duration = out_road->duration > 0 ? out_road->duration : 10;
    return EXIT_DONE;
}

int run_series(session *s, const run_options *o, const trk_model *model, const road *r,
               trk_series **out_series)
{
    trk_newmark_options newmark;
    trk_simulate_options run;
    progress bar = {.quiet = s->shared->quiet};
    trk_newmark_options_init(&newmark, sizeof newmark);
    trk_simulate_options_init(&run, sizeof run);
    newmark.step = o->step;
    run.duration = o->duration;
    run.record_every = o->every;
    run.method = o->method;
    watch_signals();
    const trk_status status = trk_simulate(s->context, model, r->excitation, &newmark, &run,
                                           progress_step, &bar, out_series);
    progress_end(&bar);
    return status == TRK_OK ? EXIT_DONE : session_fail(s, status);
}

int run_select(session *s, const char *patterns, trk_series **series)
{
    if (!patterns)
        return EXIT_DONE;
    const trk_series *all = *series;
    const int32_t channels = trk_series_channels(all);
    const int64_t samples = trk_series_samples(all);
    const char **names = need((size_t)channels, sizeof *names);
    bool *chosen = need((size_t)channels, sizeof *chosen);
    int32_t count = 0, to = 0;
    for (int32_t k = 0; k < channels; k++)
        names[k] = trk_series_name(all, k + 1);
    const int code = names_select(s, "channel", channels, names, patterns, chosen);
    for (int32_t k = 0; k < channels; k++)
        count += chosen[k];
    trk_series *some = NULL;
    trk_status status = TRK_OK;
    if (code == EXIT_DONE)
        status = trk_series_create(s->context, count, samples, trk_series_rate(all),
                                   trk_series_start(all), &some);
    for (int32_t k = 0; k < channels && some && status == TRK_OK; k++) {
        if (!chosen[k])
            continue;
        status = trk_series_label(some, ++to, names[k], trk_series_unit(all, k + 1));
        memcpy(trk_series_data_mutable(some, to), trk_series_data(all, k + 1),
               (size_t)samples * sizeof(double));
    }
    free(names);
    free(chosen);
    if (code == EXIT_DONE && status == TRK_OK) {
        trk_series_destroy(*series);
        *series = some;
        return EXIT_DONE;
    }
    trk_series_destroy(some);
    return code != EXIT_DONE ? code : session_fail(s, status);
}
