/* SPDX-License-Identifier: MIT */
/* Recorded roads: channels of CSV, ERD and RPC III files, and OpenCRG surfaces. */
#include "common/road.h"
#include "common/recording.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_WHEELS = 64 };

/* What the settings of a recorded road say. */
typedef struct wheels {
    double speed; /* [m/s]; 0: heights over time */
    double gain;
    int32_t road[MOST_WHEELS], channel[MOST_WHEELS]; /* ids; road: or TRK_ROAD_ALL, ... */
    int count;
} wheels;

static bool assign(road_reader *r, wheels *w, int32_t id, int32_t channel)
{
    if (w->count == MOST_WHEELS)
        return say(r->wrong, "more than %d channels of a road", MOST_WHEELS);
    w->road[w->count] = id;
    w->channel[w->count++] = channel;
    return true;
}

static bool read_wheel(road_reader *r, const trk_series *series, const char *name,
                       const char *value, wheels *w)
{
    static const char *const sides[] = {"all", "left", "right", NULL};
    static const int32_t side_ids[] = {TRK_ROAD_ALL, TRK_ROAD_LEFT, TRK_ROAD_RIGHT};
    const int side = text_index(sides, name);
    const int32_t id = side >= 0 ? side_ids[side] : trk_model_find(r->model, TRK_PART_ROAD, name);
    int32_t channel = trk_series_find(series, value);
    int64_t number;
    if (id == 0)
        return say(r->wrong,
                   "'%s' is neither a setting of a recorded road (speed, gain, all, left, "
                   "right) nor a road input of the vehicle",
                   name);
    if (channel == 0 && text_whole(value, &number) && number > 0 &&
        number <= trk_series_channels(series))
        channel = (int32_t)number;
    if (channel == 0)
        return say(r->wrong, "the recorded road has no channel '%s'", value);
    return assign(r, w, id, channel);
}

static bool read_settings(road_reader *r, const trk_series *series, char *rest, wheels *w)
{
    char *field;
    while ((field = text_field(&rest, ':'))) {
        char *value = field;
        text_field(&value, '=');
        double *number = strcmp(field, "speed") == 0  ? &w->speed
                         : strcmp(field, "gain") == 0 ? &w->gain
                                                      : NULL;
        if (number && !text_number(value, number))
            return say(r->wrong, "the setting '%s' of a road expects a number", field);
        if (!number && !read_wheel(r, series, field, value ? value : "", w))
            return false;
        if (number == &w->speed && !(w->speed > 0))
            return say(r->wrong, "the speed on a road must be above 0 km/h");
    }
    w->speed /= 3.6;
    return true;
}

/* Without a word about it: by name, or by number. */
static bool assign_channels(road_reader *r, const trk_series *series, wheels *w)
{
    const int32_t channels = trk_series_channels(series);
    for (int32_t k = 1; w->count == 0 || k <= trk_model_count(r->model, TRK_PART_ROAD); k++) {
        const char *name = trk_model_part_name(r->model, TRK_PART_ROAD, k);
        const int32_t channel = name ? trk_series_find(series, name) : 0;
        if (channel > 0 && !assign(r, w, k, channel))
            return false;
        if (!name)
            break;
    }
    if (w->count > 0)
        return true;
    if (channels == 1)
        return assign(r, w, TRK_ROAD_ALL, 1);
    if (channels == 2)
        return assign(r, w, TRK_ROAD_LEFT, 1) && assign(r, w, TRK_ROAD_RIGHT, 2);
    return say(r->wrong,
               "the recorded road has %d channels, none called as a road input: say "
               "which moves what, with all=, left=, right= or INPUT=",
               (int)channels);
}

/* Place of the foremost wheel. */
static double front_of(const trk_model *model)
{
    double front = -INFINITY;
    for (int32_t k = 1; k <= trk_model_count(model, TRK_PART_ROAD); k++) {
        double x;
        if (trk_model_get_road_place(model, k, &x, NULL) == TRK_OK && x > front)
            front = x;
    }
    return front;
}

/* Heights count from the first one, so that the run begins at rest. */
static bool add_channel(road_reader *r, const trk_series *series, const wheels *w, int k)
{
    const int64_t samples = trk_series_samples(series);
    const double *data = trk_series_data(series, w->channel[k]);
    double *height = need((size_t)samples, sizeof *height);
    for (int64_t i = 0; i < samples; i++)
        height[i] = w->gain * (data[i] - data[0]);
    trk_signal **signal = road_signal(r);
    const double begin = w->speed > 0 ? trk_series_start(series) : 0;
    r->status = trk_signal_create_samples(r->context, samples, begin, 1 / trk_series_rate(series),
                                          height, NULL, signal);
    if (r->status == TRK_OK && w->speed > 0)
        r->status = trk_excitation_add_profile(r->out->excitation, w->road[k], *signal, 1, w->speed,
                                               begin - front_of(r->model));
    else if (r->status == TRK_OK)
        r->status = trk_excitation_add_motion(r->out->excitation, w->road[k], *signal, 1, 0);
    free(height);
    return r->status == TRK_OK;
}

bool road_recorded(road_reader *r, const char *kind, char *rest)
{
    const char *path = text_field(&rest, ':');
    if (!path || !*path)
        return say(r->wrong, "a road of kind %s needs a file: %s:FILE", kind, kind);
    trk_series *series = NULL;
    wheels w = {.gain = 1};
    r->status = recording_read(r->context, path, kind, &series);
    bool made = r->status == TRK_OK && read_settings(r, series, rest, &w) &&
                (w.count > 0 || assign_channels(r, series, &w));
    for (int k = 0; k < w.count && made; k++)
        made = add_channel(r, series, &w, k);
    if (made)
        r->out->duration = (double)(trk_series_samples(series) - 1) / trk_series_rate(series) /
                           (w.speed > 0 ? w.speed : 1);
    trk_series_destroy(series);
    return made;
}

/* One path for every wheel; level with the place where the wheel begins. */
static bool add_path(road_reader *r, const trk_crg *crg, int32_t id, double speed, double offset)
{
    const double end[2] = {0, 1};
    double y = 0, u = 0;
    trk_signal **path = road_signal(r), **level = NULL;
    r->status = trk_model_get_road_place(r->model, id, NULL, &y);
    if (r->status == TRK_OK)
        r->status = trk_crg_extent(crg, &u, NULL, NULL, NULL);
    if (r->status == TRK_OK)
        r->status = trk_crg_profile(r->context, crg, y + offset, 0, path);
    if (r->status == TRK_OK) {
        const double first = -trk_signal_value(*path, u), height[2] = {first, first};
        trk_signal *profile = *path;
        level = road_signal(r); /* path is not valid any more */
        r->status = trk_signal_create_points(r->context, 2, end, height, level);
        if (r->status == TRK_OK)
            r->status = trk_excitation_add_motion(r->out->excitation, id, *level, 1, 0);
        if (r->status == TRK_OK)
            r->status = trk_excitation_add_profile(r->out->excitation, id, profile, 1, speed,
                                                   u - front_of(r->model));
    }
    return r->status == TRK_OK;
}

bool road_surface(road_reader *r, char *rest)
{
    static const char *const names[] = {"speed", "offset", NULL};
    double v[] = {80, 0}, step = 0;
    const char *path = text_field(&rest, ':');
    if (!path || !*path)
        return say(r->wrong, "a road of kind crg needs a file: crg:FILE");
    if (!road_settings(r, rest, names, v))
        return false;
    if (!(v[0] > 0))
        return say(r->wrong, "the speed on a road must be above 0 km/h");
    trk_crg *crg = NULL;
    r->status = trk_crg_read(r->context, path, NULL, &crg);
    for (int32_t k = 1; r->status == TRK_OK && k <= trk_model_count(r->model, TRK_PART_ROAD); k++)
        add_path(r, crg, k, v[0] / 3.6, v[1]);
    if (r->status == TRK_OK)
        r->status = trk_crg_extent(crg, NULL, &step, NULL, NULL);
    r->out->duration = (double)(trk_crg_rows(crg) - 1) * step / (v[0] / 3.6);
    trk_crg_destroy(crg);
    return r->status == TRK_OK;
}
