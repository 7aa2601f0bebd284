/* SPDX-License-Identifier: MIT */
/* Parts of a vehicle that do nothing, motions without damping. */
#include "check.h"
#include "common/text.h"

#include <stdarg.h>
#include <stdlib.h>

void check_warn(check_report *r, const check_subject *c, const char *format, ...)
{
    char text[400];
    va_list values;
    va_start(values, format);
    vsnprintf(text, sizeof text, format, values);
    va_end(values);
    table_text(r->warnings, c->label);
    table_text(r->warnings, text);
}

static bool has_force(const trk_link_options *o)
{
    return o->stiffness != 0 || o->damping != 0 || o->law ||
           (o->spring_curve && o->spring_scale != 0) || (o->damper_curve && o->damper_scale != 0);
}

static void check_links(check_report *r, const check_subject *c)
{
    const int32_t roads = trk_spec_count(c->spec, TRK_PART_ROAD);
    bool *used = need((size_t)roads, sizeof *used);
    for (int32_t k = 1; k <= trk_spec_count(c->spec, TRK_PART_LINK); k++) {
        trk_link_options o;
        trk_link_options_init(&o, sizeof o);
        if (trk_spec_get_link(c->spec, k, &o) != TRK_OK)
            continue;
        if (!has_force(&o))
            check_warn(r, c, "the link %s has no force: neither stiffness, damping, curve nor law",
                       trk_spec_part_name(c->spec, TRK_PART_LINK, k));
        if (o.from_road > 0)
            used[o.from_road - 1] = true;
    }
    for (int32_t k = 1; k <= roads; k++)
        if (!used[k - 1])
            check_warn(r, c, "no link stands on the road input %s",
                       trk_spec_part_name(c->spec, TRK_PART_ROAD, k));
    free(used);
}

void check_parts(check_report *r, const check_subject *c)
{
    check_links(r, c);
    if (trk_spec_count(c->spec, TRK_PART_ROAD) == 0)
        check_warn(r, c, "there is no road input: nothing moves this vehicle but loads");
    if (trk_spec_count(c->spec, TRK_PART_SENSOR) == 0)
        check_warn(r, c, "there is no sensor: simulate, psd and frf have nothing to show");
}
