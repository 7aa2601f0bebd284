/* SPDX-License-Identifier: MIT */
/* Which curves and laws of a spec are the same. */
#include "modelfile/shared.h"

#include <string.h>

enum { PLACES = 4 }; /* of curves at a link */

int64_t trk_curve_uses(const trk_spec *spec)
{
    return PLACES * (int64_t)trk_spec_count(spec, TRK_PART_LINK);
}

int64_t trk_law_uses(const trk_spec *spec)
{
    return trk_spec_count(spec, TRK_PART_LINK);
}

const trk_law *trk_law_use(const trk_spec *spec, int64_t use)
{
    trk_link_options link;
    trk_link_options_init(&link, sizeof link);
    return trk_spec_get_link(spec, (int32_t)use + 1, &link) == TRK_OK ? link.law : NULL;
}

const trk_curve *trk_curve_use(const trk_spec *spec, int64_t use)
{
    trk_link_options link;
    trk_stops_options stops;
    trk_link_options_init(&link, sizeof link);
    trk_stops_options_init(&stops, sizeof stops);
    if (trk_spec_get_link(spec, (int32_t)(use / PLACES) + 1, &link))
        return NULL;
    if (use % PLACES < 2)
        return use % PLACES == 0 ? link.spring_curve : link.damper_curve;
    if (trk_law_get_kind(link.law) != TRK_LAW_STOPS || trk_law_get_stops(link.law, &stops))
        return NULL;
    return use % PLACES == 2 ? stops.bump_curve : stops.rebound_curve;
}

static bool same_curve(const trk_curve *a, const trk_curve *b)
{
    if (!a || !b || a == b)
        return a == b;
    const int64_t count = trk_curve_count(a);
    const size_t size = (size_t)count * sizeof(double);
    return trk_curve_count(b) == count && strcmp(trk_curve_name(a), trk_curve_name(b)) == 0 &&
           trk_curve_interpolation(a) == trk_curve_interpolation(b) &&
           trk_curve_extrapolation(a) == trk_curve_extrapolation(b) &&
           memcmp(trk_curve_x(a), trk_curve_x(b), size) == 0 &&
           memcmp(trk_curve_y(a), trk_curve_y(b), size) == 0;
}

const trk_law_form *trk_law_read_form(const trk_law *law, trk_law_options *out_options)
{
    for (int k = 0; k < TRK_LAW_FORMS; k++)
        if (trk_law_forms[k].kind == trk_law_get_kind(law)) {
            trk_law_forms[k].init(out_options);
            return trk_law_forms[k].get(law, out_options) == TRK_OK ? &trk_law_forms[k] : NULL;
        }
    return NULL;
}

static const void *field_of(const trk_law_options *options, const trk_entry *entry)
{
    return (const char *)options + entry->offset;
}

static bool same_law(const trk_law *a, const trk_law *b)
{
    trk_law_options ours, theirs;
    const trk_law_form *form = trk_law_read_form(a, &ours);
    if (!form || form != trk_law_read_form(b, &theirs) ||
        strcmp(trk_law_name(a), trk_law_name(b)) != 0)
        return false;
    for (const trk_entry *entry = form->entries; entry->key; entry++) {
        const void *mine = field_of(&ours, entry), *other = field_of(&theirs, entry);
        if (entry->kind == TRK_ENTRY_CURVE
                ? !same_curve(*(const trk_curve *const *)mine, *(const trk_curve *const *)other)
                : memcmp(mine, other, sizeof(double)) != 0)
            return false;
    }
    return true;
}

/* First curve of that name; NULL for the empty one. */
static const trk_curve *first_curve(const trk_spec *spec, const char *name)
{
    for (int64_t k = 0; *name && k < trk_curve_uses(spec); k++) {
        const trk_curve *curve = trk_curve_use(spec, k);
        if (curve && strcmp(trk_curve_name(curve), name) == 0)
            return curve;
    }
    return NULL;
}

static const trk_law *first_law(const trk_spec *spec, const char *name)
{
    for (int64_t k = 0; *name && k < trk_law_uses(spec); k++) {
        const trk_law *law = trk_law_use(spec, k);
        if (law && strcmp(trk_law_name(law), name) == 0)
            return law;
    }
    return NULL;
}

bool trk_curve_leads(const trk_spec *spec, int64_t use)
{
    const trk_curve *curve = trk_curve_use(spec, use);
    return curve && first_curve(spec, trk_curve_name(curve)) == curve;
}

bool trk_law_leads(const trk_spec *spec, int64_t use)
{
    const trk_law *law = trk_law_use(spec, use);
    return law && first_law(spec, trk_law_name(law)) == law;
}

bool trk_curve_is_named(const trk_spec *spec, const trk_curve *curve)
{
    const trk_curve *first = first_curve(spec, trk_curve_name(curve));
    return first && same_curve(first, curve);
}

bool trk_law_is_named(const trk_spec *spec, const trk_law *law)
{
    const trk_law *first = first_law(spec, trk_law_name(law));
    return first && same_law(first, law);
}
