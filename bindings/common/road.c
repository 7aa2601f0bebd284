/* SPDX-License-Identifier: MIT */
/* Roads of one word: generated ones here, recorded ones in road_file.c. */
#include "common/road.h"

#include <stdlib.h>
#include <string.h>

const char road_help[] =
    "Roads are words KIND[:SETTING=VALUE...]:\n"
    "  iso      random road of ISO 8608 under both tracks, level for the first metres:\n"
    "           class=A to H (default B), speed [km/h] (80), seed (1), waviness (2)\n"
    "  sweep    sine sweep of all wheels: from (0.8), to (20) [Hz], duration [s] (the run),\n"
    "           amplitude [m at 1 Hz] (0.001), exponent of its fall over frequency (1)\n"
    "  sine     sine of all wheels: frequency [Hz] (1.5), amplitude [m] (0.01)\n"
    "  step     smooth step of all wheels: start (1), length (0.1) [s], height [m] (0.05)\n"
    "  csv, erd, rpc:FILE   recorded heights over time [s] or, with speed=KM/H, over distance "
    "[m].\n"
    "           One channel moves all wheels, two the left and the right ones, channels named as\n"
    "           road inputs these; or say so: all=, left=, right= or INPUT=CHANNEL, by name or\n"
    "           number. gain=FACTOR. Each wheel begins at height zero. No colon in FILE.\n"
    "  crg:FILE OpenCRG surface: speed [km/h] (80), offset [m to the left] (0)\n";

trk_signal **road_signal(road_reader *r)
{
    road *o = r->out;
    if (o->signals == o->room) {
        const int room = o->room ? 2 * o->room : 8;
        trk_signal **larger = need((size_t)room, sizeof *larger);
        if (o->signals > 0)
            memcpy(larger, o->signal, (size_t)o->signals * sizeof *larger);
        free(o->signal);
        o->signal = larger;
        o->room = room;
    }
    return &o->signal[o->signals++];
}

bool road_settings(road_reader *r, char *rest, const char *const *names, double *value)
{
    char *field;
    while ((field = text_field(&rest, ':'))) {
        char *number = field;
        text_field(&number, '=');
        const int k = text_index(names, field);
        if (k < 0 && text_nearest(names, field))
            return say(r->wrong, "unknown setting '%s' of a road; did you mean '%s'?", field,
                       text_nearest(names, field));
        if (k < 0)
            return say(r->wrong, "unknown setting '%s' of a road", field);
        if (!text_number(number, &value[k]))
            return say(r->wrong, "the setting '%s' of a road expects a number, not '%s'", field,
                       number ? number : "");
    }
    return true;
}

/* All wheels follow the last signal over time. */
static bool move_all(road_reader *r, trk_signal *const *signal)
{
    if (r->status == TRK_OK)
        r->status = trk_excitation_add_motion(r->out->excitation, TRK_ROAD_ALL, *signal, 1, 0);
    return r->status == TRK_OK;
}

static bool add_sweep(road_reader *r, char *rest, double duration)
{
    static const char *const names[] = {"from", "to", "duration", "amplitude", "exponent", NULL};
    trk_sweep_options o;
    trk_sweep_options_init(&o, sizeof o);
    double v[] = {o.start_frequency, o.end_frequency, duration, o.amplitude, o.amplitude_exponent};
    if (!road_settings(r, rest, names, v))
        return false;
    o.start_frequency = v[0];
    o.end_frequency = v[1];
    o.duration = v[2];
    o.amplitude = v[3];
    o.amplitude_exponent = v[4];
    trk_signal **signal = road_signal(r);
    r->status = trk_signal_create_sweep(r->context, &o, signal);
    return move_all(r, signal);
}

static bool add_sine(road_reader *r, char *rest)
{
    static const char *const names[] = {"frequency", "amplitude", NULL};
    double v[] = {1.5, 0.01};
    if (!road_settings(r, rest, names, v))
        return false;
    trk_signal **signal = road_signal(r);
    r->status = trk_signal_create_sine(r->context, v[1], v[0], 0, 0, signal);
    return move_all(r, signal);
}

static bool add_step(road_reader *r, char *rest)
{
    static const char *const names[] = {"start", "length", "height", NULL};
    double v[] = {1, 0.1, 0.05};
    if (!road_settings(r, rest, names, v))
        return false;
    trk_signal **signal = road_signal(r);
    r->status = trk_signal_create_step(r->context, v[0], v[1], v[2], signal);
    return move_all(r, signal);
}

/* A random road of ISO 8608 under both tracks, from level ground on; speed in km/h. */
static bool add_iso(road_reader *r, char *rest)
{
    static const char *const names[] = {"class", "speed", "seed", "waviness", NULL};
    double v[] = {2, 80, 1, 2};
    const double run_in = 20;
    for (char *letter = rest; letter && (letter = strstr(letter, "class=")); letter += 6)
        if (letter[6] >= 'A' && letter[6] <= 'H')
            letter[6] = (char)(letter[6] - 'A' + '1');
    if (!road_settings(r, rest, names, v))
        return false;
    if (!(v[0] >= 1 && v[0] <= 8 && v[0] == (int)v[0]))
        return say(r->wrong, "the class of a road is a letter from A to H");
    if (!(v[1] > 0))
        return say(r->wrong, "the speed on a road must be above 0 km/h");
    if (!(v[2] > -9e15 && v[2] < 9e15 && v[2] == (double)(int64_t)v[2]))
        return say(r->wrong, "the seed of a road is a whole number");
    trk_road_options o;
    trk_road_options_init(&o, sizeof o);
    o.unevenness = trk_road_class_unevenness((int)v[0]);
    o.waviness = v[3];
    o.seed = (int64_t)v[2];
    o.ramp_length = run_in;
    trk_signal *track[2];
    r->status = trk_road_create(r->context, &o, &track[0], &track[1]);
    for (int side = 0; r->status == TRK_OK && side < 2; side++)
        *road_signal(r) = track[side];
    for (int side = 0; r->status == TRK_OK && side < 2; side++)
        r->status =
            trk_excitation_add_profile(r->out->excitation, side ? TRK_ROAD_RIGHT : TRK_ROAD_LEFT,
                                       track[side], 1, v[1] / 3.6, 0);
    return r->status == TRK_OK;
}

static bool add_kind(road_reader *r, const char *kind, char *rest, double duration)
{
    static const char *const kinds[] = {"iso", "sweep", "sine", "step", "csv",
                                        "erd", "rpc",   "crg",  NULL};
    switch (text_index(kinds, kind)) {
    case 0: return add_iso(r, rest);
    case 1: return add_sweep(r, rest, duration);
    case 2: return add_sine(r, rest);
    case 3: return add_step(r, rest);
    case 7: return road_surface(r, rest);
    case -1: break;
    default: return road_recorded(r, kind, rest);
    }
    const char *nearest = text_nearest(kinds, kind);
    if (nearest)
        return say(r->wrong, "there is no kind of road '%s'; did you mean '%s'?", kind, nearest);
    return say(r->wrong,
               "there is no kind of road '%s', but iso, sweep, sine, step, csv, erd, "
               "rpc and crg",
               kind);
}

bool road_open(trk_context *context, const trk_model *model, const char *text, double duration,
               road *out, complaint *wrong, trk_status *out_status)
{
    *out = (road){0};
    wrong->text[0] = 0;
    road_reader reader = {context, model, out, wrong, TRK_OK};
    reader.status = trk_excitation_create(context, model, &out->excitation);
    char *copy = text_copy(text), *rest = copy;
    const char *kind = text_field(&rest, ':');
    const bool made = reader.status == TRK_OK && add_kind(&reader, kind, rest, duration);
    free(copy);
    *out_status = reader.status;
    return made;
}

void road_close(road *r)
{
    trk_excitation_destroy(r->excitation);
    for (int k = 0; k < r->signals; k++)
        trk_signal_destroy(r->signal[k]);
    free(r->signal);
    *r = (road){0};
}
