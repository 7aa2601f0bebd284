/* SPDX-License-Identifier: MIT */
/* Options of a road, and the classes of ISO 8608. */
#include "road/road.h"

static const trk_road_options defaults = {.struct_size = sizeof defaults,
                                          .unevenness = 16e-6,
                                          .waviness = 2,
                                          .low = 0.011,
                                          .high = 2.83,
                                          .seed = 1,
                                          .tracks = TRK_ROAD_TRACKS_ISOTROPIC,
                                          .track_width = 2,
                                          .coherence_decay = 1};

void trk_road_options_init(trk_road_options *options, size_t struct_size)
{
    trk_write_defaults(options, struct_size, &defaults, sizeof defaults);
}

double trk_road_class_unevenness(trk_road_class road_class)
{
    if (road_class < TRK_ROAD_CLASS_A || road_class > TRK_ROAD_CLASS_H)
        return 0;
    return 16e-6 * (double)((int64_t)1 << 2 * (road_class - TRK_ROAD_CLASS_A));
}

static trk_status check(trk_context *context, const trk_road_options *o)
{
    /* Within these limits nothing overflows. */
    const struct {
        const char *name;
        double value, least, most;
    } fields[] = {
        {"unevenness", o->unevenness, 0, 1e6},
        {"waviness", o->waviness, 1, 4},
        {"low", o->low, 1e-6, 1e4},
        {"high", o->high, 1e-6, 1e4},
        {"track_width", o->track_width, 0, 1e6},
        {"coherence_decay", o->coherence_decay, 0, 1e6},
        {"ramp_start", o->ramp_start, -1e12, 1e12},
        {"ramp_length", o->ramp_length, 0, 1e12},
    };
    for (size_t k = 0; k < sizeof fields / sizeof *fields; k++)
        if (!(fields[k].value >= fields[k].least && fields[k].value <= fields[k].most))
            return trk_fail(context, TRK_E_RANGE, "road: %s is %g, expected %g to %g",
                            fields[k].name, fields[k].value, fields[k].least, fields[k].most);
    if (!(o->low < o->high))
        return trk_fail(context, TRK_E_RANGE, "road: low is %g and high is %g, expected low < high",
                        o->low, o->high);
    const double length = o->contact_length, least = 0.001 / o->high, most = 250 / o->high;
    if (!(length == 0 || (length >= least && length <= most)))
        return trk_fail(context, TRK_E_RANGE,
                        "road: contact_length is %g, expected 0 or %g to %g for high = %g", length,
                        least, most, o->high);
    if (o->ramp_length > 0 && !(o->ramp_length >= 1e-6))
        return trk_fail(context, TRK_E_RANGE,
                        "road: ramp_length is %g, expected 0 or at least 1e-6", o->ramp_length);
    if (o->tracks < TRK_ROAD_TRACKS_ISOTROPIC || o->tracks > TRK_ROAD_TRACKS_INDEPENDENT)
        return trk_fail(context, TRK_E_ARGUMENT, "road: tracks is %d, expected %d to %d", o->tracks,
                        TRK_ROAD_TRACKS_ISOTROPIC, TRK_ROAD_TRACKS_INDEPENDENT);
    if (o->reserved)
        return trk_fail(context, TRK_E_OPTIONS, "road: reserved is %d, expected 0", o->reserved);
    return TRK_OK;
}

trk_status trk_road_read_options(trk_context *context, const trk_road_options *options,
                                 trk_road_options *out)
{
    *out = defaults;
    trk_status status = trk_read_options(context, "trk_road_options", options, out, sizeof *out);
    return status == TRK_OK ? check(context, out) : status;
}
