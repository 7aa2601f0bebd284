/* SPDX-License-Identifier: MIT */
/* Is a ladder frame well described? */
#include "frame/ladder.h"

#include <math.h>

static trk_status require_range(trk_context *context, const char *name, const char *field,
                                double value, bool good, const char *wanted)
{
    return good ? TRK_OK
                : trk_fail(context, TRK_E_RANGE, "frame '%s': %s is %g; %s is needed", name, field,
                           value, wanted);
}

static trk_status check_numbers(trk_context *context, const char *name, const trk_frame_options *o)
{
    const struct {
        const char *field;
        double value;
        bool good;
        const char *wanted;
    } list[] = {
        {"stations", o->stations, o->stations >= 2, "at least 2"},
        {"crosses", o->crosses, o->crosses >= 1, "at least 1"},
        {"half_width", o->half_width, isfinite(o->half_width) && o->half_width > 0,
         "a finite number > 0"},
        {"z", o->z, isfinite(o->z), "a finite number"},
        {"longest", o->longest, isfinite(o->longest) && o->longest >= 0, "a finite number >= 0"},
        {"member_elements", o->member_elements, o->member_elements >= 1, "at least 1"},
        {"reserved", o->reserved, o->reserved == 0, "0"},
    };
    trk_status status = TRK_OK;
    for (size_t k = 0; status == TRK_OK && k < sizeof list / sizeof *list; k++)
        status = require_range(context, name, list[k].field, list[k].value, list[k].good,
                               list[k].wanted);
    return status;
}

static trk_status check_stations(trk_context *context, const char *name, const trk_frame_options *o)
{
    for (int32_t k = 0; k < o->stations; k++)
        if (!isfinite(o->station[k]))
            return trk_fail(context, TRK_E_RANGE,
                            "frame '%s': station %d is %g; a finite number is needed", name, k + 1,
                            o->station[k]);
    const bool rise = o->station[1] > o->station[0];
    for (int32_t k = 1; k < o->stations; k++)
        if (o->station[k] == o->station[k - 1] || (o->station[k] > o->station[k - 1]) != rise)
            return trk_fail(context, TRK_E_RANGE,
                            "frame '%s': station %d is %g m after %g m; stations must all rise or "
                            "all fall",
                            name, k + 1, o->station[k], o->station[k - 1]);
    return TRK_OK;
}

int32_t trk_frame_station(const trk_frame_options *o, double x)
{
    const double close = 1e-9 * fabs(o->station[o->stations - 1] - o->station[0]);
    for (int32_t k = 0; k < o->stations; k++)
        if (fabs(o->station[k] - x) <= close)
            return k;
    return -1;
}

static trk_status check_crosses(trk_context *context, const char *name, const trk_frame_options *o)
{
    for (int32_t k = 0; k < o->crosses; k++) {
        const int32_t at = trk_frame_station(o, o->cross[k]);
        if (at < 0)
            return trk_fail(context, TRK_E_RANGE,
                            "frame '%s': cross member %d at %g m is not at a station", name, k + 1,
                            o->cross[k]);
        for (int32_t other = 0; other < k; other++)
            if (trk_frame_station(o, o->cross[other]) == at)
                return trk_fail(context, TRK_E_RANGE,
                                "frame '%s': cross members %d and %d are both at %g m", name,
                                other + 1, k + 1, o->cross[k]);
    }
    return TRK_OK;
}

static trk_status check_size(trk_context *context, const char *name, const trk_frame_options *o)
{
    const double nodes = trk_frame_count(o) + (double)o->crosses * o->member_elements;
    return require_range(context, name, "the number of nodes", nodes, nodes <= TRK_FRAME_NODES,
                         "at most 1000000");
}

trk_status trk_frame_check(trk_context *context, const char *name, const trk_frame_options *o)
{
    trk_status status = check_numbers(context, name, o);
    if (status == TRK_OK)
        status = check_stations(context, name, o);
    if (status == TRK_OK)
        status = check_crosses(context, name, o);
    return status == TRK_OK ? check_size(context, name, o) : status;
}
