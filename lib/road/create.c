/* SPDX-License-Identifier: MIT */
/* From options to the lines of all octaves (ROAD.3). */
#include "base/random.h"
#include "road/road.h"
#include "signal/turn.h"

static const double pi = 3.14159265358979323846;

static void set_cosines(trk_track *track)
{
    for (int32_t k = 0; k < TRK_ROAD_ANGLES; k++) {
        double sine;
        trk_turn_sincos(trk_turn_fraction((2 * k + 1) / (2.0 * TRK_ROAD_ANGLES)), &sine,
                        &track->cosine[k]);
    }
}

/* Anywhere within a block, so that no place of the road is at a certain place of all blocks. */
static double origin(int64_t seed, int32_t octave)
{
    uint32_t bits[4];
    trk_random_bits(seed, 0, (uint32_t)octave, TRK_PURPOSE_ROAD_ORIGIN, bits);
    return bits[0] * (TRK_ROAD_HOP * 0x1p-32);
}

static void set_octave(trk_octave *octave, const trk_road_options *o,
                       const trk_coherence_rule *rule, double top, bool lowest, bool right)
{
    octave->per_metre = 4 * top;
    octave->first = TRK_ROAD_LINES;
    for (int32_t j = TRK_ROAD_LINES - 1; j >= (lowest ? 0 : TRK_ROAD_SPARE); j--) {
        const double line = TRK_ROAD_FIRST_LINE + j, width = top * 2 / TRK_ROAD_HOP;
        const double n = (line + 0.5) * width, over = (line + 1) * width - o->low;
        const double share = over >= width ? 1 : over > 0 ? over / width : 0; /* in the band */
        const double turns = (line + 0.5) / (4.0 * TRK_ROAD_HOP);             /* half of n / grid */
        const double spline = trk_turn_sine(turns) / (2 * pi * turns);
        const double sixth = spline * spline * spline * spline * spline * spline;
        const double power = share * trk_road_power_law(o, n) * octave->per_metre;
        octave->amplitude[j] = sqrt(power / TRK_ROAD_HOP) / sixth;
        if (share > 0)
            octave->first = j / 4 * 4;
        if (right)
            octave->flip[j] = (uint16_t)floor((1 - trk_coherence_of(rule, n)) * 0x1p15 + 0.5);
        octave->flips |= octave->flip[j] > 0;
    }
}

static trk_status create(trk_context *context, const trk_road_options *o, bool right,
                         trk_signal **out_signal)
{
    trk_track *track = trk_new(context, 1, sizeof *track);
    if (!track)
        return TRK_E_MEMORY;
    track->signal.kind = &trk_track_kind;
    track->signal.context = context;
    track->seed = o->seed;
    track->contact_length = o->contact_length;
    track->ramp_start = o->ramp_start;
    track->ramp_length = o->ramp_length;
    track->farthest = 0x1p48 / o->high;
    const double reach = (double)TRK_ROAD_FIRST_LINE / (TRK_ROAD_FIRST_LINE + TRK_ROAD_SPARE);
    double top = o->high;
    do {
        track->octave_count++;
        top *= 0.5;
    } while (reach * top > o->low);
    track->octaves = trk_new(context, track->octave_count, sizeof *track->octaves);
    if (!track->octaves) {
        trk_signal_destroy(&track->signal);
        return TRK_E_MEMORY;
    }
    set_cosines(track);
    trk_coherence_rule rule;
    trk_coherence_rule_set(&rule, o);
    top = o->high;
    for (int32_t k = 0; k < track->octave_count; k++, top *= 0.5) {
        set_octave(&track->octaves[k], o, &rule, top, k + 1 == track->octave_count, right);
        track->octaves[k].origin = origin(o->seed, k);
    }
    *out_signal = &track->signal;
    return TRK_OK;
}

trk_status trk_road_create(trk_context *context, const trk_road_options *options,
                           trk_signal **out_left, trk_signal **out_right)
{
    if (out_right)
        *out_right = NULL;
    TRK_REQUIRE(context, out_left, "trk_road_create");
    *out_left = NULL;
    TRK_REQUIRE(context, context, "trk_road_create");
    trk_road_options o;
    trk_status status = trk_road_read_options(context, options, &o);
    if (status == TRK_OK)
        status = create(context, &o, false, out_left);
    if (status == TRK_OK && out_right) {
        status = create(context, &o, true, out_right);
        if (status) {
            trk_signal_destroy(*out_left);
            *out_left = NULL;
        }
    }
    return status;
}
