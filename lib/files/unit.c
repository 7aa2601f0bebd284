/* SPDX-License-Identifier: MIT */
/* Units that measured files use, in SI (FILES.5). */
#include "files/unit.h"

#include <string.h>
#include <truckride/files.h>

#include "base/base.h"

typedef struct unit {
    const char *name, *si;
    double factor;
} unit;

static const unit *find(const char *name)
{
    static const unit known[] = {
        {"m", "m", 1},
        {"um", "m", 1e-6},
        {"mm", "m", 1e-3},
        {"cm", "m", 1e-2},
        {"km", "m", 1e3},
        {"in", "m", 0.0254},
        {"inch", "m", 0.0254},
        {"inches", "m", 0.0254},
        {"ft", "m", 0.3048},
        {"feet", "m", 0.3048},
        {"mi", "m", 1609.344},
        {"s", "s", 1},
        {"sec", "s", 1},
        {"ms", "s", 1e-3},
        {"min", "s", 60},
        {"h", "s", 3600},
        {"m/s", "m/s", 1},
        {"mm/s", "m/s", 1e-3},
        {"cm/s", "m/s", 1e-2},
        {"km/h", "m/s", 1 / 3.6},
        {"mph", "m/s", 0.44704},
        {"m/s^2", "m/s^2", 1},
        {"m/s2", "m/s^2", 1},
        {"mm/s^2", "m/s^2", 1e-3},
        {"mm/s2", "m/s^2", 1e-3},
        {"g", "m/s^2", 9.80665},
        {"N", "N", 1},
        {"kN", "N", 1e3},
        {"lbf", "N", 4.4482216152605},
        {"rad", "rad", 1},
        {"deg", "rad", 0.017453292519943295}, /* pi / 180 */
        {"Nm", "N m", 1},
        {"N m", "N m", 1},
        {"kNm", "N m", 1e3},
        {"kN m", "N m", 1e3},
    };
    for (size_t k = 0; k < sizeof known / sizeof *known; k++)
        if (strcmp(known[k].name, name) == 0)
            return &known[k];
    return NULL;
}

double trk_unit_factor(const char *name, const char **out_si)
{
    const unit *found = find(name);
    *out_si = found ? found->si : name;
    return found ? found->factor : 0;
}

trk_status trk_series_to_si(trk_series *series)
{
    if (!series)
        return TRK_E_ARGUMENT;
    for (int32_t c = 1; c <= trk_series_channels(series); c++) {
        const char *si;
        const double factor = trk_unit_factor(trk_series_unit(series, c), &si);
        if (factor == 0 || strcmp(si, trk_series_unit(series, c)) == 0)
            continue;
        trk_status status = trk_series_label(series, c, trk_series_name(series, c), si);
        if (status)
            return status;
        double *x = trk_series_data_mutable(series, c);
        for (int64_t k = 0; k < trk_series_samples(series); k++)
            x[k] *= factor;
    }
    return TRK_OK;
}
